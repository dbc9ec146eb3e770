"""Trends that hold are confirmed, trends that do not are refuted: on made-up measurements."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import pytest

from bench.papers import (
    ages,
    alignment,
    figure5,
    figure8,
    figure9,
    figure10,
    figure11,
    figure12,
    filters,
)
from bench.papers.claims import CLAIMS, Verdict
from bench.papers.suite import EXPERIMENTS
from shadercache.caching.algorithms import USUAL

from .made_up import curves, facts, turns

NODES = 24
HITS = 0.95

Shares = Callable[[float], dict[str, float]]
"""The shares of the original's time of the series of a node, by its P/T."""


def by_claim(verdicts: Sequence[Verdict]) -> dict[str, bool | None]:
    return {verdict.claim: verdict.confirmed for verdict in verdicts}


def papers(ratio: float) -> dict[str, float]:
    """As the papers found it: three passes lie at what is left to compute and a little more."""
    left = 0.1 + 0.9 * (1.0 - HITS * ratio)
    return {"1-pass": 1.05, "2-pass": left + 0.35 - 0.25 * ratio, "3-pass": left + 0.05}


def opposite(ratio: float) -> dict[str, float]:
    """One pass is best, more with a low P/T; the overhead of three grows with P/T."""
    return {"1-pass": 0.4 + 0.2 * ratio, "2-pass": 0.8 + 0.9 * ratio, "3-pass": 0.9 + 0.5 * ratio}


def figure_8(
    shares: Shares, targets: float, outlier: Mapping[int, float], count: int = NODES
) -> figure8.Figure8:
    """Nodes of P/T from 0 to .95; an ``outlier`` is dearer by its number, and has overlap."""
    batches = []
    for number in range(count):
        ratio = 0.95 * number / (count - 1)
        extra = outlier.get(number, 0.0)
        node = facts(number, ratio, overlap=0.5 if extra > 0.0 else 0.0)
        times = {name: share + abs(extra) for name, share in shares(ratio).items()}
        times |= {"payload": 0.1 + 0.9 * ratio, "two targets": targets}
        labelled = {figure8.label(node, what): share for what, share in times.items()}
        batches.append(figure8.Batch((node,), turns(labelled)))
    return figure8.Figure8((figure8.SceneTimes("dragon", HITS, tuple(batches)),))


def test_figure_8_as_the_papers_have_it() -> None:
    data = figure_8(papers, targets=1.3, outlier={4: 0.3, 9: 0.3})
    assert by_claim(figure8.judge(data)) == dict.fromkeys(
        ("T1", "T2", "T3", "T4", "T5", "T6", "T7"), True
    )


def test_figure_8_otherwise() -> None:
    # Below zero: dearer without overlap.
    data = figure_8(opposite, targets=1.02, outlier={4: -0.9, 9: -0.9})
    assert by_claim(figure8.judge(data)) == dict.fromkeys(
        ("T1", "T2", "T3", "T4", "T5", "T6", "T7"), False
    )


def test_of_few_nodes_figure_8_says_nothing() -> None:
    found = by_claim(figure8.judge(figure_8(papers, 1.3, {}, count=5)))
    assert set(found.values()) == {None}


def test_times_within_the_interval_are_no_win() -> None:
    """All three alike: three passes neither win nor lose anywhere."""
    data = figure_8(lambda ratio: dict.fromkeys(USUAL, 0.8), 1.3, {})
    found = by_claim(figure8.judge(data))
    assert found["T1"] is False and found["T2"] is False


HYPERBOLA = [0.3 + 1.2 / n for n in figure9.PERIODS]
EXPONENTIAL = [0.3 + 0.6 * float(np.exp(-0.2 * (n - 1.0))) for n in figure9.PERIODS]


def figure_9(
    curve: Sequence[float], by_block: Mapping[int, float], noise: float = 0.002
) -> figure9.Figure9:
    shares = {
        name: share
        for block, factor in by_block.items()
        for name, share in curves(
            {name: [factor * one for one in curve] for name in USUAL},
            figure9.PERIODS,
            block,
        ).items()
    }
    return figure9.Figure9(figure9.PERIODS, tuple(by_block), turns(shares, noise=noise))


PAPERS_BLOCKS = {1: 1.3, 2: 1.0, 4: 1.0, 8: 1.0}


@pytest.mark.parametrize(
    ("curve", "blocks", "expected"),
    [
        (HYPERBOLA, PAPERS_BLOCKS, {"T8": True, "T8b": False, "T9": True, "T10": True}),
        (EXPONENTIAL, PAPERS_BLOCKS, {"T8": True, "T8b": True, "T9": True, "T10": True}),
        (
            HYPERBOLA[::-1],
            {1: 1.0, 2: 1.3, 4: 1.0, 8: 0.9},
            {"T8": False, "T8b": None, "T9": False, "T10": False},
        ),
    ],
    ids=["hyperbola", "exponential", "rising"],
)
def test_figure_9(
    curve: Sequence[float], blocks: Mapping[int, float], expected: dict[str, bool | None]
) -> None:
    assert by_claim(figure9.judge(figure_9(curve, blocks))) == expected


def test_wide_intervals_leave_figure_9_open() -> None:
    flat = [0.8] * len(figure9.PERIODS)
    found = by_claim(figure9.judge(figure_9(flat, dict.fromkeys((1, 2, 4, 8), 1.0), noise=0.5)))
    assert found["T9"] is None and found["T10"] is None


def test_laws_that_intervals_hide_are_not_told_apart() -> None:
    found = by_claim(figure9.judge(figure_9(HYPERBOLA, PAPERS_BLOCKS, noise=0.1)))
    assert found["T8b"] is None


def figure_10(one: float, two: float, three: Callable[[float], float]) -> figure10.Figure10:
    """``one`` and ``two`` are flat; ``three`` is a curve over the share of hits."""
    periods, mu = figure10.PERIODS, 0.95
    rates = [mu * (1.0 - 1.0 / n) for n in periods]
    shares = {"3-pass all hits": 0.4}
    for block in figure10.BLOCKS:
        times = {"1-pass": [one] * len(periods), "2-pass": [two] * len(periods)}
        times["3-pass"] = [three(rate) for rate in rates]
        shares |= curves(times, periods, block)
    shares |= {f"all hits {name}": 0.4 for name in USUAL}
    return figure10.Figure10(periods, figure10.BLOCKS, mu, turns(shares))


def test_figure_10_as_the_course_has_it() -> None:
    data = figure_10(0.97, 1.2, lambda rate: 0.4 * rate + 0.9 * (1.0 - rate))
    assert by_claim(figure10.judge(data)) == dict.fromkeys(("T11", "T12a", "T12b", "T13"), True)


def test_figure_10_otherwise() -> None:
    data = figure_10(0.6, 0.9, lambda rate: 1.3 - 0.2 * rate)
    assert by_claim(figure10.judge(data)) == dict.fromkeys(("T11", "T12a", "T12b", "T13"), False)


PLACES = {"A": (0.4, 0.0, 0.6, 0.008), "B": (0.1, 0.0, 1.0, 0.03), "C": (0.97, 0.0, 0.4, 0.04)}
"""Of each cluster: static P/T, overlap, share of the original's time and error at the end."""


def figure_11(
    places: Mapping[str, tuple[float, float, float, float]], rising: Callable[[float], float]
) -> figure11.Figure11:
    """Five nodes at each place; errors follow ``rising`` (1 at the longest period)."""
    batches = []
    for at, (ratio, overlap, share, error) in enumerate(places.values()):
        for number in range(5):
            node = facts(10 * at + number, ratio, overlap)
            names = {period: figure11.label(node, period) for period in figure11.PERIODS}
            times = {name: share + 0.3 / period for period, name in names.items()}
            errors = {name: error * rising(period) for period, name in names.items()}
            batches.append(figure11.ErrorBatch((node,), turns(times, errors=errors)))
    return figure11.Figure11(figure11.PERIODS, tuple(batches))


def saturating(period: float) -> float:
    return float(1.0 - np.exp(-0.2 * (period - 1.0)))


def test_figure_11_as_the_course_has_it() -> None:
    data = figure_11(PLACES | {"D": (0.9, 0.8, 0.95, 0.01)}, saturating)
    found = figure11.clusters(figure11.paths(data))
    assert {name: len(curves) for name, curves in found.items()} == dict.fromkeys("ABCD", 5)
    assert by_claim(figure11.judge(data)) == {"T14a": True, "T14b": True}


def test_figure_11_otherwise() -> None:
    """D is the fastest, and errors jump up and down."""
    data = figure_11(
        PLACES | {"D": (0.9, 0.8, 0.2, 0.01)}, lambda period: 1.0 if period in (2, 32) else 0.2
    )
    assert by_claim(figure11.judge(data)) == {"T14a": False, "T14b": False}


def test_errors_that_go_on_growing_do_not_saturate() -> None:
    data = figure_11(PLACES | {"D": (0.9, 0.8, 0.95, 0.01)}, lambda period: period / 32.0)
    assert by_claim(figure11.judge(data))["T14a"] is False


@pytest.mark.parametrize(
    ("time", "rmse", "reached"),
    [(0.1, 0.003, True), (0.3, 0.003, False), (0.1, 0.02, False)],
    ids=["fast and near", "slow", "far"],
)
def test_figure_12(time: float, rmse: float, reached: bool) -> None:
    name = "2-pass n32 k4"
    drawn = figure12.ExampleTimes("N6", 64, turns({name: time}, errors={name: rmse}))
    found = by_claim(figure12.judge(figure12.Figure12((drawn,))))
    assert found == {"N6": reached}


@pytest.mark.parametrize(
    ("factor", "noise", "slower"), [(1.2, 0.002, True), (1.0, 0.002, False), (1.0, 0.3, None)]
)
def test_alignment(factor: float, noise: float, slower: bool | None) -> None:
    shares = {}
    for block in alignment.BLOCKS:
        for period in alignment.PERIODS:
            for name in USUAL:
                label = f"{name} n{period} k{block}"
                shares |= {label: 0.7, f"{label} shifted": 0.7 * factor}
    data = alignment.Alignment(alignment.PERIODS, alignment.BLOCKS, turns(shares, noise=noise))
    assert by_claim(alignment.judge(data)) == {"T15": slower}


def refresh_map(refresh: float, depth: float, split: int, hidden: int) -> figure5.RefreshMap:
    shares = {"refresh": refresh, "depth": depth, "outside": 0.0, "hit": 1.0 - refresh - depth}
    found = shares["hit"] / (1.0 - refresh)
    return figure5.RefreshMap(4, shares, found, 100, split, 1000, hidden, b"")


def test_figure_5() -> None:
    names = ("N1", "N2", "N3", "N4")
    good = figure5.Figure5(64, {}, (refresh_map(1 / 32, 0.03, 0, 950),))
    assert by_claim(figure5.judge(good)) == dict.fromkeys(names, True)
    bad = figure5.Figure5(64, {}, (refresh_map(1 / 16, 0.3, 3, 500),))
    assert by_claim(figure5.judge(bad)) == dict.fromkeys(names, False)


def test_ages() -> None:
    guarded = ages.OldestAges(((0.0, 0.0), (1.0, 0.0)), (32.0, 31.0), (40.0, 191.0))
    assert by_claim(ages.judge(guarded)) == {"N8": True}
    grown = ages.OldestAges(((0.0, 0.0), (1.0, 0.0)), (32.0, 34.0), (40.0, 191.0))
    assert by_claim(ages.judge(grown)) == {"N8": False}


@pytest.mark.parametrize(
    ("blurs", "less"),
    [((0.3, 0.15, 0.19), True), ((0.3, 0.15, 0.25), False), ((0.0, 0.1, 0.1), None)],
)
def test_filters(blurs: tuple[float, ...], less: bool | None) -> None:
    data = filters.Blurs(filters.KINDS, blurs, (0.01, 0.01, 0.01))
    assert by_claim(filters.judge(data)) == {"N9": less}


def test_every_claim_has_one_experiment() -> None:
    """What the experiments judge is what the page lists, once each."""
    judged = [
        *figure5.judge(figure5.Figure5(64, {}, (refresh_map(1 / 32, 0.03, 0, 950),))),
        *figure8.judge(figure_8(papers, 1.3, {})),
        *figure9.judge(figure_9(HYPERBOLA, PAPERS_BLOCKS)),
        *figure10.judge(figure_10(0.97, 1.2, lambda rate: 1.0 - rate)),
        *figure11.judge(figure_11(PLACES, saturating)),
    ]
    others = {"T15", "N5", "N6", "N7", "N8", "N9"}
    assert sorted([verdict.claim for verdict in judged]) == sorted(CLAIMS.keys() - others)
    assert len({experiment.name for experiment in EXPERIMENTS}) == len(EXPERIMENTS)
