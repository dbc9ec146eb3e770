"""How far depths can be told apart."""

from __future__ import annotations

import pytest
from shaders import analysed, find

from shadercache.caching.configuration import CacheFormat, DepthKind
from shadercache.emit.depth_range import depth_warnings, resolved_until
from tests.configured import configured, rewritten


@pytest.mark.parametrize(
    ("depth", "form", "until"),
    [
        ("inverse-w", "rgba16f", 1e5),
        ("inverse-w", "rgba32f", 1e5),
        ("linear", "rgba16f", 65504.0),
        ("ndc", "rgba16f", 0.61),
        ("ndc", "rgba32f", 3356.0),
    ],
)
def test_how_far_a_pair_reaches(depth: DepthKind, form: CacheFormat, until: float) -> None:
    found = resolved_until(depth, form, 1e-3, 0.1, 1e5)
    assert found == pytest.approx(until, rel=0.05)


def test_what_cannot_be_told_apart_is_warned_of() -> None:
    options = configured(depth="linear")
    assert depth_warnings(options, 1.0, 1e3) == ()
    [warning] = depth_warnings(options, 1.0, 1e5)
    assert (warning.code, warning.severity) == ("SC431", "warning")
    assert "beyond w = 6.55e+04" in warning.message


def test_rewriting_warns_where_it_needs_no_scene() -> None:
    analysis = analysed("vec3 n = sin(v_position); o_color = vec4(n * u_tint, 1.0);")
    node = find(analysis, "sin(v_position)")
    cached = configured(filter="bilinear", depth="ndc")
    emission = rewritten(analysis, node, cached, unprofitable=True)
    assert [note.code for note in emission.notes] == ["SC431"]
    assert rewritten(analysis, node, unprofitable=True).notes == ()
