"""The sentences at the top of a report."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from msgspec import structs

from shadercache.report.page.page_group import PageGroup, page_groups
from shadercache.report.page.page_summary import error_in_words, summary
from shadercache.sweep.row import Failure, Row


def measured(row: Row, speedup: float, rmse: float) -> Row:
    """The row with another ratio and error."""
    assert row.result is not None
    ratio = structs.replace(
        row.result.times.ratio, median=speedup, low=speedup * 0.99, high=speedup * 1.01
    )
    times = structs.replace(row.result.times, ratio=ratio)
    image = structs.replace(row.result.image, rmse=rmse)
    return structs.replace(row, outcome=structs.replace(row.result, times=times, image=image))


@pytest.fixture
def variants(made_rows: list[Row]) -> list[Row]:
    return [row for row in made_rows if row.kind == "variant" and row.result is not None]


@pytest.fixture
def peers(made_rows: list[Row]) -> list[Row]:
    return [row for row in made_rows if row.kind == "peer"]


def group(rows: Sequence[Row]) -> PageGroup:
    (found,) = page_groups(rows)
    return found


def test_the_fastest_with_a_small_error_comes_first(variants: list[Row]) -> None:
    speeds = (1.2, 0.004), (1.7, 0.006), (2.6, 0.02)
    rows = [measured(row, *speed) for row, speed in zip(variants, speeds, strict=False)]
    first, second, *_ = summary(group(rows))
    assert "is 1.70× as fast [1.68–1.72] at an RMSE of .006*" in first
    assert "the fastest of 2 variants whose error stays below .01, of 3 in all." in first
    assert "is 2.60× as fast [2.57–2.63] at an RMSE of .02." in second


@pytest.mark.parametrize(
    ("speedup", "rmse", "what"),
    [(0.9, 0.001, "The fastest of them is"), (1.5, 0.02, "The nearest image is that of")],
)
def test_where_nothing_is_gained_that_comes_first(
    variants: list[Row], speedup: float, rmse: float, what: str
) -> None:
    first = summary(group([measured(variants[0], speedup, rmse)]))[0]
    start = "*No variant with an RMSE below .01 is faster than the original.* "
    assert first.startswith(start + what)
    assert f"{speedup:.2f}× as fast" in first


@pytest.mark.parametrize(
    ("speeds", "words"),
    [
        (
            [(1.5, 0.01), (2.0, 0.02), (3.0, 0.03)],
            "below an RMSE of .01 nothing is faster than the original, then the fastest is "
            "from .01 on caching (1.50×), from .02 on half resolution (2.00×) and "
            "from .03 on half resolution, by depth (3.00×).",
        ),
        (
            [(2.0, 0.02), (0.9, 0.01), (3.0, 0.03)],
            "from .02 on caching (2.00×) and from .03 on half resolution, by depth (3.00×).",
        ),
        ([(3.0, 0.001), (1.5, 0.01), (2.0, 0.03)], "the fastest is from .001 on caching (3.00×)."),
        ([(0.9, 0.001), (0.8, 0.01), (0.7, 0.03)], "Neither caching nor a peer is faster"),
    ],
)
def test_who_wins_where(
    variants: list[Row], peers: list[Row], speeds: list[tuple[float, float]], words: str
) -> None:
    rows = [measured(row, *speed) for row, speed in zip([variants[0], *peers], speeds, strict=True)]
    assert any(words in sentence for sentence in summary(group(rows)))


def test_failures_are_counted_by_kind(made_rows: list[Row]) -> None:
    said = summary(group(made_rows))
    assert said[-1] == "There are 4 configurations without a result: 4 that took too long."
    failed = [row for row in made_rows if row.failure is not None]
    other = structs.replace(failed[0], outcome=Failure("rejected", "SC601", "no"))
    said = summary(group([*failed[:1], other]))
    assert said[0].startswith("No configuration of this sweep has a result")
    assert said[-1].endswith("1 that took too long and 1 that the driver does not take.")


def test_peers_alone_are_no_sweep(peers: list[Row]) -> None:
    assert summary(group(peers))[0].startswith("*This store holds peers only*")


def test_the_certainty_is_that_of_the_intervals(variants: list[Row]) -> None:
    rows = [measured(row, 1.5, 0.001) for row in variants[:5]]
    assert any("half of them are known to ±1.0 %" in sentence for sentence in summary(group(rows)))


@pytest.mark.parametrize(
    ("error", "words"), [(0.0, "0"), (0.0064, ".0064"), (0.0271, ".027"), (1e-5, "1e-05")]
)
def test_errors_in_words(error: float, words: str) -> None:
    assert error_in_words(error) == words


def test_sizes_and_machines_are_kept_apart(made_rows: list[Row]) -> None:
    row = made_rows[0]
    other = structs.replace(row, machine=structs.replace(row.machine, cores=64))
    small = structs.replace(row, scene=structs.replace(row.scene, size=(32, 32)))
    assert [len(one.rows) for one in page_groups([row, other, small, row])] == [2, 1, 1]
