"""What is said of a measurement above its table."""

from __future__ import annotations

import re

import pytest

from shadercache.caching.configuration import Configuration
from shadercache.cli.measuring import result_table, summary
from shadercache.measure.image_error import ErrorStats
from shadercache.measure.measurement import (
    Group,
    Measurement,
    MeasureOptions,
    NodeResult,
    VariantResult,
)
from shadercache.measure.metrics.perceived import Perceived
from shadercache.measure.statistics import Ratio, Reached, StopRule, timing


def variant(perceived: Perceived | None = None) -> VariantResult:
    return VariantResult(
        timing=timing([0.01, 0.01, 0.02]),
        speedup=Ratio(2.0, 1.9, 2.1, 2.0),
        error=ErrorStats(0.01, 0.02, 0.03, 40.0, 100),
        frame_rmse=(),
        perceived=perceived,
        configuration=Configuration(("a",)),
        reset=1.0,
        outcomes={},
        burst=0.0,
        hit_rates=(0.5,),
        work={},
        floor=None,
        efficiency=None,
        bytes_per_pixel=16.0,
        outputs=(),
    )


def node(label: str, measured: float, static: float | None, *variants: VariantResult) -> NodeResult:
    return NodeResult(
        label=label,
        node_id=label,
        path="main",
        text="x",
        type="float",
        mode="plain",
        equal=1,
        static_ratio=static,
        ratio=measured,
        payload=None,
        hit=None,
        variants=variants or (variant(),),
    )


def measurement(
    options: MeasureOptions, nodes: tuple[NodeResult, ...], *reached: Reached
) -> Measurement:
    times = timing([0.02, 0.02])
    groups = tuple(
        Group(times, times, one, nodes if place == 0 else ()) for place, one in enumerate(reached)
    )
    return Measurement("scene", (64, 64), options, "clock", 0.5, groups, ())


NODES = (node("a", 0.2, 0.3), node("b", 0.5, 0.4), node("c", 0.9, 0.8))
NARROW, CAPPED = Reached(0.02, 24, 3.2, False), Reached(0.047, 15, 30.0, True)
RULE = MeasureOptions(16, stop=StopRule())


def test_what_was_reached_is_told() -> None:
    told = summary(measurement(RULE, NODES, NARROW))
    precision = "every ratio to within 2.0% (half of its 95 % interval)"
    assert f"{precision}, from 24 timed frames in 3 s" in told
    assert "ran out of time" not in told
    assert "errors over covered pixels of frames 9-16" in told


def test_who_ran_out_of_time_is_told() -> None:
    told = summary(measurement(RULE, NODES, CAPPED))
    assert re.search(r"4\.7%.* from 15 timed frames in 30 s; the run ran out of time", told)
    told = summary(measurement(RULE, NODES, CAPPED, NARROW))
    assert re.search(r"from 15-24 timed frames in 33 s; 1 of 2 batches ran out of time", told)


@pytest.mark.parametrize(
    ("nodes", "told"),
    [(NODES, "rank correlation 1.00"), (NODES[:2], ""), ((node("a", 0.2, None), *NODES[1:]), "")],
)
def test_the_rank_correlation_is_told_where_there_is_one(
    nodes: tuple[NodeResult, ...], told: str
) -> None:
    text = summary(measurement(RULE, nodes, NARROW))
    assert ("rank correlation" in text) == bool(told) and told in text


def test_the_table_has_what_was_perceived() -> None:
    seen = variant(Perceived(4, 0.98, None, 0.003, 2.5, ()))
    asked = measurement(MeasureOptions(16, perceptual=True), (node("a", 0.2, 0.3, seen),), NARROW)
    heading, row = result_table(asked, lambda one: one.label).splitlines()
    assert heading.split()[-4:] == ["SSIM", "FLIP", "flicker", "pattern"]
    assert row.split()[-3:] == ["0.9800", "0.0030", "2.5000"], "FLIP is missing, and left empty"
    assert row.split()[:3] == ["a", "0.200", "0.300"]
    assert heading.index("tail") > heading.index("ratio") and " 1.98 " in row
