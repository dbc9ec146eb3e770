"""The state of the pipeline that the variants take for granted: the manifest's ``state``.

``equal`` is: in every pass of a frame, in the debug program, and as where the shader is drawn
without a cache.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

from shadercache.manifest.pass_model import StateEntry

_CACHES = "a cache holds numbers of which every bit counts"


Must: TypeAlias = Literal["off", "on", "equal", "fill"]


def _state(state: str, must: Must, why: str) -> StateEntry:
    return StateEntry(state=state, must=must, why=why)


_OFF = (
    _state("blending and logic operations", "off", _CACHES),
    _state(
        "multisampling, sample masks, sample shading and alpha to coverage",
        "off",
        "a pixel has one payload, and coverage must not differ between passes",
    ),
    _state("rasterizer discard", "off", "something is drawn"),
)
_TARGETS = (
    _state("colour mask", "on", "all four channels of each target are written"),
    _state(
        "conversion to sRGB on writing, and dithering",
        "equal",
        "they concern the colour target alone, and no pass reads colours back: caches have formats "
        "without either",
    ),
    _state(
        "scissor test",
        "equal",
        "what lies outside is not drawn, and not stored; caches are cleared without it",
    ),
    _state(
        "stencil test",
        "equal",
        "with no writes: a pass must not change what the test of the next one finds",
    ),
)
_GEOMETRY = (
    _state("depth test and writes", "on", "with the function of the pass (depth.test)"),
    _state(
        "depth range, clamp, bias (polygon offset) and clip control",
        "equal",
        "passes compare depths bit by bit",
    ),
    _state("face culling and winding", "equal", "passes must draw the same fragments"),
    _state("polygon mode and width of lines", "equal", "passes must draw the same fragments"),
    _state("clip and cull distances", "equal", "passes must draw the same fragments"),
    _state("provoking vertex", "equal", "flat varyings come from it"),
    _state(
        "primitives, restart index and order of draws", "equal", "the first of equal depths wins"
    ),
)
_TRIANGLE = (
    _state(
        "depth test and writes",
        "on",
        "with the function of the pass (depth.test): what a pass has drawn or left open decides "
        "what the next one draws",
    ),
    _state("face culling, clip distances and depth bias", "off", "one triangle covers the target"),
    _state("polygon mode", "fill", "one triangle covers the target"),
)


def state_of(full_screen: bool) -> tuple[StateEntry, ...]:
    """The state, for the engine's objects or for one full-screen triangle."""
    own = _TRIANGLE if full_screen else _GEOMETRY
    return (*own, *_TARGETS, *_OFF)
