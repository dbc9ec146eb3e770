"""Laws 1 to 4 on shaders that are written at random, other ones each night.

``./dev stress`` tries 2,000 of them. A failing run is repeated by ``SHADERCACHE_SEED``.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from laws.slices import NIGHTLY, VARIABLE, amount, seed

from shadercache.caching.algorithms import NAMES
from shadercache.gpu.context import Gpu

from .dialects import DIALECTS
from .suite import REGRESSIONS, Coverage, check_shaders
from .trial import try_shader

pytestmark = [pytest.mark.xdist_group("generated"), pytest.mark.timeout(900)]

COUNTS = {
    "gl330": amount(9, 60),
    "gl120": amount(2, 14),
    "es100": amount(2, 14),
    "es300": amount(2, 14),
}

CONSTRUCTS = (
    *("?:", "&&", "arithmetic", "integer", "matrix", "struct", "array", "swizzle", "conversion"),
    *("if", "else", "for", "while", "switch", "jump", "return", "discard", "call", "overload"),
    *("inout argument", "out argument", "global", "const global", "shadowed name"),
    *("compound assignment", "swizzled l-value", "texture", "textureLod", "precision"),
    *("story", "carried by a global", "carried by a part", "carried by a function"),
    *("carried under a condition", "sink: a function", "sink: a function by a global"),
)
"""Constructs without which a night's shaders would prove too little."""

ALGORITHMS = (*NAMES, "of a set")
CODES = ("offered", *(f"SC{number}" for number in (301, 302, 303, 304, 307, 308)))


def test_laws_1_to_4(gpu: Gpu) -> None:
    print(f"{VARIABLE}={seed()}")
    coverage = Coverage()
    for dialect in DIALECTS:
        check_shaders(gpu, dialect, COUNTS[dialect], seed(), coverage)
    print(coverage.table())
    if not os.environ.get(NIGHTLY):
        return  # too few to have everything
    missing = [name for name in CONSTRUCTS if not coverage.constructs[name]]
    missing += [code for code in CODES if not coverage.codes[code]]
    missing += [name for name in ALGORITHMS if not coverage.algorithms[name]]
    assert not missing, "never occurred"
    assert coverage.nodes > coverage.shaders.total(), "too few legal nodes"
    assert coverage.not_finite <= 0.05 * coverage.shaders.total()
    assert coverage.turned_down <= 0.02 * coverage.shaders.total()


@pytest.mark.parametrize("file", sorted(REGRESSIONS.glob("*.frag")), ids=lambda file: file.stem)
def test_what_broke_once(file: Path, gpu: Gpu) -> None:
    """Every legal node of the small shaders that broke a law or the compiler."""
    dialect = DIALECTS[file.name.split("-")[0]]
    report = try_shader(gpu, file.read_text(encoding="utf-8"), dialect, lambda legal, _: legal)
    assert not report.problems
