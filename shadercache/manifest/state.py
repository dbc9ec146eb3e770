"""The state of the pipeline that the variants take for granted: the manifest's ``state``.

``equal`` is: in every pass of a frame, in the debug program, and as where the shader is drawn
without a cache.
"""

from __future__ import annotations

from typing import NamedTuple

_CACHES = "a cache holds numbers of which every bit counts"


class State(NamedTuple):
    """Something an engine sets, and what it must be."""

    state: str
    must: str
    why: str


_OFF = (
    State("blending and logic operations", "off", _CACHES),
    State(
        "multisampling, sample masks, sample shading and alpha to coverage",
        "off",
        "a pixel has one payload, and coverage must not differ between passes",
    ),
    State("rasterizer discard", "off", "something is drawn"),
)
_TARGETS = (
    State("colour mask", "on", "all four channels of each target are written"),
    State(
        "conversion to sRGB on writing, and dithering",
        "equal",
        "they concern the colour target alone, and no pass reads colours back: caches have formats "
        "without either",
    ),
    State(
        "scissor test",
        "equal",
        "what lies outside is not drawn, and not stored; caches are cleared without it",
    ),
    State(
        "stencil test",
        "equal",
        "with no writes: a pass must not change what the test of the next one finds",
    ),
)
_GEOMETRY = (
    State("depth test and writes", "on", "with the function of the pass (depth.test)"),
    State(
        "depth range, clamp, bias (polygon offset) and clip control",
        "equal",
        "passes compare depths bit by bit",
    ),
    State("face culling and winding", "equal", "passes must draw the same fragments"),
    State("polygon mode and width of lines", "equal", "passes must draw the same fragments"),
    State("clip and cull distances", "equal", "passes must draw the same fragments"),
    State("provoking vertex", "equal", "flat varyings come from it"),
    State(
        "primitives, restart index and order of draws", "equal", "the first of equal depths wins"
    ),
)
_TRIANGLE = (
    State(
        "depth test and writes",
        "on",
        "with the function of the pass (depth.test): what a pass has drawn or left open decides "
        "what the next one draws",
    ),
    State("face culling, clip distances and depth bias", "off", "one triangle covers the target"),
    State("polygon mode", "fill", "one triangle covers the target"),
)


def state_of(full_screen: bool) -> list[dict[str, str]]:
    """The state, for the engine's objects or for one full-screen triangle."""
    own = _TRIANGLE if full_screen else _GEOMETRY
    return [item._asdict() for item in (*own, *_TARGETS, *_OFF)]
