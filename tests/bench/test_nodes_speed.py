"""``./dev bench-emit``: the shaders whose nodes are listed, and what is told of that."""

from __future__ import annotations

from bench.nodes_speed import PARTS, field_of, listing_table, listing_targets
from shadercache.compiler import analyse


def test_the_shaders_grow_by_whole_parts() -> None:
    one, two, three = (field_of(parts) for parts in (4, 8, 12))
    assert one.text.count("float part_") == 4
    nodes = [len(analyse(source).nodes) for source in (one, two, three)]
    assert nodes[2] - nodes[1] == nodes[1] - nodes[0] > 1_000


def test_the_largest_is_as_large_as_the_target_says() -> None:
    parts = PARTS[-1]
    small = [len(analyse(field_of(count)).nodes) for count in (1, 2)]
    assert 75_000 < small[0] + (parts - 1) * (small[1] - small[0]) < 77_000
    assert 20_000 < len(field_of(parts).text) < 28_000


def test_targets_are_those_of_the_largest() -> None:
    row = {"characters": 1, "nodes": 10, "analyse": 1.0, "seconds of --offered": 1.0}
    rows = [row | {"seconds": 1.0, "printed": 10**6}, row | {"seconds": 6.0, "printed": 30 * 10**6}]
    assert [(row["value"], row["target"], row["met"]) for row in listing_targets(rows)] == [
        (6.0, "<= 5", False),
        (30.0, "<= 20", False),
    ]
    assert "30.0" in listing_table(rows)
