"""Tunings with made-up numbers, and pages of them: nothing is drawn or measured."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from shadercache.caching.configuration import Configuration, Filter
from shadercache.caching.outcomes import OUTCOMES
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.image_error import ErrorStats
from shadercache.measure.measurement import Probe, Shot
from shadercache.measure.result_files import plain
from shadercache.paths import data_path
from shadercache.report.tuning_page.plan_shots import PlanShot
from shadercache.report.tuning_page.tuned_texts import texts_of
from shadercache.report.tuning_page.tuning_page import TunedPictures, tuning_page
from shadercache.tuning.families import Family, Plan
from shadercache.tuning.groups import ShaderGroup, groups_of
from shadercache.tuning.models import TimeModel, fit_error, fit_hits, fit_time
from shadercache.tuning.values import Pool, Value, pool_of

SIZE = 48, 32
WHERE = {
    "date": "2008-06-23T12:00:00+00:00",
    "gl": {"renderer": "made up", "vendor": "nobody", "version": "4.5", "software": True},
    "cpu": "a made-up processor",
    "cores": 2,
    "system": "none",
    "python": "3",
}
PERIODS = 2, 3, 4, 6, 8, 12, 16, 24, 48
WAYS: Sequence[dict[str, Any]] = (
    {},
    {"algorithm": "parked"},
    {"algorithm": "3-pass", "payload_rate": "half"},
    {"filter": Filter("carried")},
)


@dataclass(frozen=True, eq=False)
class Made:
    """What ``tune --json`` would print, the families that it tells of, and the scene."""

    found: dict[str, Any]
    families: list[Family]
    linker: Linker

    def plan(self, *parts: Sequence[int]) -> Plan:
        """A plan from the numbers of families and their periods."""
        return Plan(tuple((self.families[number], period) for number, period in parts))

    def page(self, pictures: TunedPictures | None = None) -> bytes:
        """Its page."""
        texts = texts_of(self.found, self.linker)
        return tuning_page(self.found, pictures or TunedPictures(), texts)

    def having(self, **changes: Any) -> Made:
        """Another one, of which something else was found."""
        families = self.families if changes.get("families", True) else []
        return Made(self.found | changes, families, self.linker)


def made_tuning(
    linker: Linker, limits: Sequence[float], metric: str = "rmse", values: int = 3
) -> Made:
    """Families of some values of each group in four ways, with models of made-up measurements; the
    first bound has no answer, the others what is predicted to be the fastest within them."""
    groups = groups_of(linker)
    pools = {group: pool_of(group, linker.scene) for group in groups}
    families = [one for group in groups for one in _families(group, pools[group], values)]
    for family in families:  # all groups together save less than everything
        family.time = _slower(family.time, len(groups))
    made = Made({}, families, linker)
    proven = [_proven(made, [[1, period]]) for period in (3, 12)[: len(limits) - 1]]
    nothing = {"proven": None, "assignment": None, "why": "what is near enough is no faster"}
    answers = [{"bound": limits[0], **nothing}] + [
        {"bound": limit, "proven": at, "assignment": [], "why": ""}
        for at, limit in enumerate(limits[1:])
    ]
    hits = fit_hits([2, 4], [0.48, 0.71])
    found = {
        "schema_version": 1,
        "environment": WHERE,
        "scene": linker.scene.name,
        "title": linker.scene.title,
        "size": [512, 512],
        "metric": metric,
        "bounds": list(limits),
        "budget": {"seconds": 60.0, "spent": 48.0},
        "original": 0.08,
        "combinations": 1_234_567,
        "drawn": 29,
        "periods": list(PERIODS),
        "groups": [
            {
                "fragment": group.name,
                "objects": group.objects,
                "hits": hits,
                "left_out": pools[group].left_out,
                "values": [_value(group, value) for value in pools[group].values],
                "not_drawn": [
                    _value(group, value) | {"foretold": 0.7}
                    for value in pools[group].values[values:]
                ],
            }
            for group in groups
        ],
        "families": [_told(family, pools[family.group].values) for family in families],
        "finalists": [_finalist(made, [[0, 4]]), _finalist(made, [[1, 8]])],
        "proven": proven,
        "answers": answers,
        "failed": [],
    }
    return Made(plain(found), families, linker)


def _families(group: ShaderGroup, pool: Pool, values: int) -> Iterator[Family]:
    periods = np.array([2, 3, 5, 9, 14])
    for place, value in enumerate(pool.values[:values]):
        rank = place + 0.37 * group.number  # no two groups are alike
        for way, choices in enumerate(WAYS):
            base = replace(Configuration(), nodes=value.ids, **choices).with_refresh(1)
            family = Family(group, value, base, scale=1.0 + 0.1 * rank, haste=1.4)
            errors = 0.02 / (1 + rank) * -np.expm1(-(0.05 + 0.04 * way) * (periods - 1.0))
            family.error = fit_error(periods, errors)
            if base.divisor > 1:  # this follows no exponential
                uneven = [0.004, *(0.0055 + 0.0001 * (periods % 3))]
                family.error = fit_error([1, *periods], uneven)
            hit, miss = 0.35 + 0.12 * rank + 0.02 * way, 1.3 - 0.1 * way
            rates = 0.95 * (1.0 - 1.0 / np.array([2.0, 500.0]))
            family.time = fit_time([2, 500], list(rates * hit + (1.0 - rates) * miss), 0.95)
            yield family


def _slower(time: TimeModel, groups: int) -> TimeModel:
    hit, miss = (
        replace(one, value=1.0 - (1.0 - one.value) / groups) for one in (time.hit, time.miss)
    )
    return replace(time, hit=hit, miss=miss)


def _value(group: ShaderGroup, value: Value) -> dict[str, Any]:
    source = group.analysis.fragment
    spans = [node.expr.span for node in value.nodes]
    return {
        "ids": value.ids,
        "text": value.text,
        "type": value.nodes[0].type.name,
        "places": [[*source.position(span.start), *source.position(span.end)] for span in spans],
        "share": value.share,
        "changes": sorted(value.changes),
    }


def _told(family: Family, values: Sequence[Value]) -> dict[str, Any]:
    names = "time", "error", "scale"
    return {
        "group": family.group.number,
        "value": values.index(family.value),
        "configuration": family.base.to_json(),
        "haste": family.guarded_haste,
    } | {name: getattr(family, name) for name in names}


def _drawn(share: float, error: float) -> dict[str, Any]:
    speed = 1.0 / share
    ratio = {"median": speed, "low": 0.97 * speed, "high": 1.04 * speed, "total": speed}
    return {"speedup": ratio, "mean": 0.9 * error, "worst": error}


def _finalist(made: Made, parts: list[list[int]]) -> dict[str, Any]:
    plan = made.plan(*parts)
    predicted = {"share": plan.share, "error": plan.error}
    return {
        "plan": parts,
        "without": [],
        "predicted": predicted,
        "drawn": _drawn(1.03 * plan.share, plan.error),
    }


def _proven(made: Made, parts: list[list[int]]) -> dict[str, Any]:
    plan = made.plan(*parts)
    slow = {"name": "another part of the path", "start": 32, "step": 1}
    fast = {"name": "twice as fast", "start": 17, "step": 2}
    slow |= _drawn(1.02 * plan.share, plan.error)
    fast |= _drawn(1.04 * plan.share, plan.hasty_error)
    least = {key: fast[key] for key in ("speedup", "mean", "worst")}
    return {"plan": parts, "without": [], "passages": [slow, fast], **least}


def made_pictures(plans: Sequence[tuple[tuple[int, int], ...]]) -> TunedPictures:
    """Pictures of plans: a slope, a little brighter with each plan; payloads of values of the first
    group."""
    width, height = SIZE
    slope = np.linspace(0, 200, width, dtype=np.uint8)
    original = np.repeat(np.repeat(slope[None, :, None], height, 0), 3, 2)
    mask = np.full((height, width), OUTCOMES["hit"], np.uint8)
    mask[: height // 4] = OUTCOMES["refresh"]
    shots = []
    for number, plan in enumerate(plans):
        probe = Probe(mask, OUTCOMES, None, plan[0][1])
        cached = original + np.uint8(1 + number)
        shot = Shot("", Configuration(), original, cached, probe)
        shots.append(
            PlanShot(plan, (), 52, shot, ErrorStats(0.004 * (1 + number), 0.01, 0.1, 40.0, 99))
        )
    payloads = {(0, value): original[:, ::-1] for value in range(3)}
    return TunedPictures(original, shots, payloads)


def opened(name: str) -> Linker:
    """A scene of the corpus."""
    return Linker(*open_scene(Path(data_path("corpus", name, "scene.toml"))))


@pytest.fixture(scope="session")
def dragon() -> Linker:
    return opened("dragon")


@pytest.fixture(scope="session")
def made(dragon: Linker) -> Made:
    """One shader, three bounds."""
    return made_tuning(dragon, (0.0005, 0.005, 0.02))


@pytest.fixture(scope="session")
def colonnade() -> Made:
    """Two shaders, of which one is that of a single object."""
    return made_tuning(opened("colonnade"), (0.0005, 0.01), values=2)
