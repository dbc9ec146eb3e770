"""Laws 1 to 4 on the real renderer for some nodes of each corpus scene, others each night.

``./dev verify-all`` takes them all. A failing run is repeated by ``SHADERCACHE_SEED``, which the
failure names.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing

import pytest
from laws.slices import VARIABLE, amount, day_slice, nodes_of_day, seed

from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.cache_settings import configured
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.verdict import MAX_TIES, Difference, Verdict, worst_of
from shadercache.verify.verifier import Verifier

NODES = amount(4, 24)
"""Of each scene, besides those that the scene names."""

FEW = amount(1, 4)
"""The same where there are several objects, and every frame takes longer."""

SCENES = [
    pytest.param(name, count, marks=pytest.mark.xdist_group(f"laws-{name}"))
    for name, count in (
        ("dragon", NODES),
        ("trashcan", NODES),
        ("heroine", FEW),
        ("colonnade", FEW),
        ("chess", FEW),
        ("meadow", FEW),
    )
]


@pytest.mark.parametrize(("name", "count"), SCENES)
def test_laws_1_to_4(
    name: str, count: int, gpu: Gpu, record_property: Callable[[str, object], None]
) -> None:
    scene, analysis = _load(name)
    day = seed()
    record_property(VARIABLE, day)
    print(f"{VARIABLE}={day}")
    legal = [node for node in analysis.nodes if node.legal]
    assert set(scene.nodes.values()) <= {node.id for node in legal}, "a name of no legal node"
    nodes = nodes_of_day(legal, scene.nodes, day, count)
    cached = configured(scene, Configuration(), None)
    with closing(Verifier(gpu, (scene, analysis), configuration=cached)) as verifier:
        assert verifier.references.ties <= MAX_TIES
        assert verifier.round_trip().exact, f"law 1 is broken: {verifier.round_trip()}"
        verdicts = [verifier.check(node) for node in nodes]
    for verdict in verdicts:
        print(_plain(verdict))
    broken = [_report(verdict) for verdict in verdicts if verdict.broken]
    assert not broken, "\n".join([f"{VARIABLE}={day} repeats this", *broken])


@pytest.mark.parametrize("name", ("dragon", "trashcan"))
def test_the_slices_cover_every_node(name: str) -> None:
    nodes = [node for node in _load(name)[1].nodes if node.legal]
    days = range(739_000, 739_000 + len(nodes))
    slices = [day_slice(nodes, day, NODES) for day in days]
    assert {node.id for found in slices for node in found} == {node.id for node in nodes}
    assert all(NODES // 2 < len(found) <= NODES for found in slices)
    turns = next(count for count in range(1, len(days)) if slices[count] == slices[0])
    assert sum(map(len, slices[:turns])) == len(nodes), "each has its turn once in a round"


def test_named_nodes_are_always_there() -> None:
    nodes = [node for node in _load("dragon")[1].nodes if node.legal]
    named = {"one": nodes[3].id, "two": nodes[4].id, "gone": "main.0-00000000"}
    for day in range(3):
        found = nodes_of_day(nodes, named, day, NODES)
        assert {nodes[3], nodes[4]} <= set(found)
        assert len(found) == len(set(found)) <= NODES + 2
        assert nodes_of_day(nodes, {}, day, NODES) == day_slice(nodes, day, NODES)


def test_the_environment_sets_the_seed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "12")
    assert seed() == 12


def _load(name: str) -> tuple[Scene, Analysis]:
    return analyse_scene(load_scene(data_path("corpus", name, "scene.toml")))


def _report(verdict: Verdict) -> str:
    lines = [f"  {law}: {_figures(found)}" for law, found in verdict.inexact.items()]
    return "\n".join([f"{verdict.node} in {verdict.path}: {verdict.text}", *lines])


def _plain(verdict: Verdict) -> str:
    worst = worst_of(verdict.plain.values())
    return f"{verdict.node} in {verdict.path}: plain mode {_figures(worst)}"


def _figures(found: Difference) -> str:
    return (
        f"largest difference {found.maximum:.3g}, p99.9 {found.p999:.3g}, "
        f"{found.changed:.3%} of pixels changed"
    )
