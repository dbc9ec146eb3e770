"""S4 and S18: depth formats and encodings, from 1e-3 to 1e5."""

from __future__ import annotations

import os

import pytest

from shadercache.caching.configuration import CacheFormat, DepthKind
from shadercache.gpu.context import Gpu

from .criteria import Criteria
from .depths import DEPTHS, FORMATS, RANGES, told

pytestmark = pytest.mark.xdist_group("gl")

DEEP = os.environ.get("SHADERCACHE_STRESS") == "deep"
STEPS = 40 if DEEP else 6


@pytest.mark.parametrize("planes", RANGES, ids=str)
@pytest.mark.parametrize("form", FORMATS)
def test_the_default_is_never_fooled(
    gpu: Gpu, stress: Criteria, form: CacheFormat, planes: tuple[float, float]
) -> None:
    found = told(gpu, form, "inverse-w", "relative", planes, STEPS)
    assert found.asked > STEPS // 2
    stress.none(f"false hits of {2 * found.asked}", found.hits)
    stress.none(f"false misses at rest, of {found.asked}", found.resting)
    stress.none(f"false misses in motion, of {found.asked}", found.moving)


@pytest.mark.parametrize("planes", RANGES if DEEP else RANGES[1:2], ids=str)
@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("form", FORMATS)
def test_twice_the_least_separation_is_told_apart(
    gpu: Gpu, stress: Criteria, form: CacheFormat, depth: DepthKind, planes: tuple[float, float]
) -> None:
    found = told(gpu, form, depth, "akeley-su", planes, STEPS)
    stress.none(f"false hits at twice the least separation, of {2 * found.asked}", found.hits)
    stress.tell("false misses at rest", f"{found.resting} of {found.asked}")


def test_less_than_the_tolerance_is_not(gpu: Gpu) -> None:
    """What the others say would mean nothing else."""
    assert told(gpu, "rgba32f", "inverse-w", "relative", (0.1, 100.0), 4, apart=0.5).hits == 8
