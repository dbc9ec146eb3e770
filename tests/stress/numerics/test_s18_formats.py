"""S18: formats and encodings of depth from 1e-3 to 1e5, all in one table.

What the default settings must do is S4's; here all the others are told beside them, and each cell
whose rounding is beyond the tolerance must be one that SC431 warns of.
"""

from __future__ import annotations

import pytest

from shadercache.caching.configuration import DEFAULT_EPSILON, CacheFormat, DepthKind
from shadercache.emit.depth_range import resolved_until
from shadercache.gpu.context import Gpu

from .criteria import Criteria
from .depths import DEPTHS, FORMATS, RANGES, told

pytestmark = pytest.mark.xdist_group("gl")


@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("form", FORMATS)
def test_what_cannot_be_told_apart_is_warned_of(
    gpu: Gpu, stress: Criteria, form: CacheFormat, depth: DepthKind
) -> None:
    for planes in RANGES if stress.deep else RANGES[1:3]:
        found = told(gpu, form, depth, "relative", planes, 24 if stress.deep else 6)
        until = resolved_until(depth, form, DEFAULT_EPSILON, *planes)
        stress.tell(f"{planes}: false misses at rest / in motion / false hits", str(found))
        if until >= planes[1]:
            stress.none(f"{planes}: wrong", found.resting + found.moving + found.hits)
