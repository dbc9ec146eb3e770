"""The state of the pipeline that the variants take for granted: the manifest's ``state``."""

from __future__ import annotations

from shadercache.manifest.pass_model import StateEntry

_CACHES = "a cache holds numbers of which every bit counts"
_SAME = "passes must draw the same fragments"
_WHOLE = "one triangle covers the target"

_OFF = (
    StateEntry("blending and logic operations", "off", _CACHES),
    StateEntry(
        "multisampling, sample masks, sample shading and alpha to coverage",
        "off",
        "a pixel has one payload, and coverage must not differ between passes",
    ),
    StateEntry("rasterizer discard", "off", "something is drawn"),
)
_TARGETS = (
    StateEntry("colour mask", "on", "all four channels of each target are written"),
    StateEntry(
        "conversion to sRGB on writing, and dithering",
        "equal",
        "they concern the colour target alone, and no pass reads colours back: caches have formats "
        "without either",
    ),
    StateEntry(
        "scissor test",
        "equal",
        "what lies outside is not drawn, and not stored; caches are cleared without it",
    ),
    StateEntry(
        "stencil test",
        "equal",
        "with no writes: a pass must not change what the test of the next one finds",
    ),
)
_GEOMETRY = (
    StateEntry("depth test and writes", "on", "with the function of the pass (depth.test)"),
    StateEntry(
        "depth range, clamp, bias (polygon offset) and clip control",
        "equal",
        "passes compare depths bit by bit",
    ),
    StateEntry("face culling and winding", "equal", _SAME),
    StateEntry("polygon mode and width of lines", "equal", _SAME),
    StateEntry("clip and cull distances", "equal", _SAME),
    StateEntry("provoking vertex", "equal", "flat varyings come from it"),
    StateEntry(
        "primitives, restart index and order of draws", "equal", "the first of equal depths wins"
    ),
)
_TRIANGLE = (
    StateEntry(
        "depth test and writes",
        "on",
        "with the function of the pass (depth.test): what a pass has drawn or left open decides "
        "what the next one draws",
    ),
    StateEntry("face culling, clip distances and depth bias", "off", _WHOLE),
    StateEntry("polygon mode", "fill", _WHOLE),
)


def state_of(full_screen: bool) -> tuple[StateEntry, ...]:
    """The state, for the engine's objects or for one full-screen triangle."""
    return (*(_TRIANGLE if full_screen else _GEOMETRY), *_TARGETS, *_OFF)
