"""Manifests put together from what was emitted.

The published schema is ``manifest.schema.json`` in the folder above.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from hashlib import sha256
from typing import Any

from shadercache import __version__
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.sets import is_skipped
from shadercache.emit.layout import Layout, extras_of
from shadercache.emit.program_set import Pass, ProgramSet
from shadercache.emit.runtime import outcomes
from shadercache.emit.uniforms import added_uniforms
from shadercache.options import (
    PREVIOUS_CLIP,
    CacheOptions,
    MappingKind,
    Options,
    marks_depths,
    written_cache_options,
)
from shadercache.source import Source

SCHEMA_VERSION = 1

CLEAR = (0.0, 0.0, 0.0, -1.0)
"""Of an empty cache texel: depths are positive where something is drawn, so -1 matches nothing."""

CLEAR_BITS = (0.0, 0.0, 0.0, 0.0)
"""Where texels are unsigned integers: a depth of zero matches nothing either."""

CLEAR_MARKED = (0.0, 0.0, 0.0, 0.0)
"""Where the sign of a depth is a mark: no depth is zero."""

CLEAR_NDC = (0.0, 0.0, 0.0, 2.0)
"""Where depths lie between -1 and 1."""

CLEAR_NDC_BITS = (0.0, 0.0, 0.0, float(0x40000000))
"""The same as an unsigned integer: the bits of 2."""

_DEPTHS = {"inverse-w": "16/w", "ndc": "z/w", "linear": "w"}

_ALWAYS = ("previous-cache", "current-cache", "previous-cache-2", "current-cache-2", "epsilon")
"""Roles that are told whether or not a program of the variants at hand has them."""

_CHANNELS = ("x", "xy", "xyz", "xyzw")

FRAME = (
    "Swap the two caches: what was written in the last frame is the previous cache now.",
    "Clear the depth buffer to 1, the colour target to the background, and the cache that is "
    "written in this frame to cache.clear.",
    "Set the uniforms. A name among the values of 'previous' gets what its key had in the last "
    "frame (of a jittered projection: with the jitter of this frame, which is no motion); the "
    "clock is the frame number modulo the period, reduced on the CPU.",
    "Draw the passes of the variant in order. All objects finish a pass before the next begins; "
    "those that are not cached come first, with no cache attached, so that nothing they hide is "
    "stored. Bind targets[i] at colour attachment i; do not blend.",
)

FRAME_OF_TWO = (
    "What is said of a cache holds for its second texture (cache.second) as well; both are cleared "
    "to values of their own."
)

RESET = (
    "On the first frame, and whenever the last frame does not show the same scene (camera cut, "
    "resize, new projection, reloaded shader, lost context): clear both caches to cache.clear. "
    "After a resize or a lost context make them anew first, as large as the target.",
    "Draw only the passes with on_reset true: what was stored is not looked up, and the image is "
    "the original's.",
    "One and three passes may then be drawn as the one of two passes with on_reset true: image and "
    "cache are the same, no branch is in the way, and the geometry is drawn once.",
    "An object that the last frame did not show, or that jumps, is drawn so by itself; the caches "
    "stay as they are.",
    "A cut that is not told is drawn rightly up to what passes the hit test by chance, and costs "
    "look-ups that find nothing.",
)

FULL_SCREEN = {"geometry": "full-screen triangle", "mode": "triangles", "vertices": 3}
"""Three vertices without attributes: the vertex shaders make their positions."""

WHOLE_TARGET = "a viewport that covers the whole target and begins at (0, 0), as large as the cache"
PART_OF_TARGET = "a viewport inside of the target, which is as large as the cache"

RELIES_ON = (
    "opaque geometry, drawn without blending, alpha to coverage or multisampling",
    "the depth function 'less' in the application, with depth cleared to 1; for any other, "
    "depth_functions says what the passes' are and what depth is cleared to",
    "one colour output; colours are written as the shader computes them, with no conversion to "
    "sRGB between the passes",
    WHOLE_TARGET,
    "the same geometry, in the same order, in every pass of a frame",
)


_FORWARD: dict[str, Any] = {"less": "less", "lequal": "lequal", "clear": 1}
_REVERSED: dict[str, Any] = {"less": "greater", "lequal": "gequal", "clear": 0}

DEPTH_FUNCTIONS: dict[str, dict[str, Any]] = {
    "less": _FORWARD,
    "lequal": _FORWARD,
    "greater": _REVERSED,
    "gequal": _REVERSED,
    "equal": _FORWARD,
}
"""An application's depth function -> what a pass's ``depth.test`` is there.

An application with ``equal`` has drawn depth first; the variants do without that."""


def build_manifest(
    fragment: Source,
    vertex: Source,
    nodes: Sequence[Candidate],
    options: Options,
    programs: ProgramSet,
    renamed: Mapping[str, str],
) -> dict[str, Any]:
    """The manifest of a program set; ``renamed`` leads from the user's names to the variants'."""
    assert programs.original is not None and programs.debug is not None
    assert programs.payload is not None
    layout = Layout(tuple(node.type for node in nodes), extras=extras_of(options.cache))
    declared = _declared(programs)
    relies = list(RELIES_ON)
    if options.cache.viewport:
        relies[relies.index(WHOLE_TARGET)] = PART_OF_TARGET
    if options.cache.depth != "ndc":
        relies.append("a perspective projection: in an orthographic one w tells no depth")
    if programs.unchanging:
        names = ", ".join(programs.unchanging)
        relies.append(f"these decide the position and do not change between frames: {names}")
    if options.fetches == "level" and 1 in programs.variants:
        relies.append(
            "isotropic texture filtering: one pass asks for levels of detail, then fetches at these"
        )
    return {
        "schema_version": SCHEMA_VERSION,
        "generator": f"shadercache {__version__}",
        "source": {"fragment": _source(fragment), "vertex": _source(vertex)},
        "nodes": [
            _node(fragment, node, place) for node, place in zip(nodes, layout.places, strict=True)
        ],
        "mode": options.mode,
        "color": {"output": programs.color, "location": 0},
        "cache": _cache(layout, options),
        "uniforms": [
            entry
            for entry in added_uniforms(programs.prefix, layout, options)
            if entry["name"] in declared or entry["role"] in _ALWAYS
        ],
        "renamed": dict(renamed),
        "previous": programs.previous,
        "original": _pass(programs.original),
        "variants": [
            {"algorithm": f"{number}-pass", "passes": [_pass(item) for item in passes]}
            for number, passes in programs.variants.items()
        ],
        "refused": [
            {"algorithm": f"{number}-pass", "reason": reason}
            for number, reason in programs.refused.items()
        ],
        "payload": _pass(programs.payload),
        "debug": _pass(programs.debug) | {"values": outcomes(options.cache)},
        "frame": [*FRAME, *[FRAME_OF_TWO] * layout.second],
        "reset": list(RESET),
        "relies_on": relies,
        "depth_functions": {name: dict(found) for name, found in DEPTH_FUNCTIONS.items()},
    }


def with_mapping(
    manifest: dict[str, Any],
    mapping: MappingKind,
    full_screen: bool,
    unchanged: Sequence[str] | None,
) -> dict[str, Any]:
    """The manifest with where payloads are found, and what is drawn.

    ``unchanged``: while which inputs do not change is reuse exact? (``None``: not said.)
    """
    how: dict[str, Any] = {"kind": mapping}
    relies: list[str] = []
    if unchanged is not None:
        how["exact_while_unchanged"] = list(unchanged)
        names = ", ".join(unchanged)
        relies = [f"reuse is exact while these do not change: {names}"] * bool(unchanged)
    if mapping == "user":
        relies = [f"{PREVIOUS_CLIP}() says where the last frame showed what a pixel shows now"]
    draw = FULL_SCREEN if full_screen else {"geometry": "objects"}
    return manifest | {
        "mapping": how,
        "draw": dict(draw),
        "relies_on": [*manifest["relies_on"], *relies],
    }


def original_manifest(programs: ProgramSet, options: Options) -> dict[str, Any]:
    """The part of a manifest that says how to draw the unchanged shader."""
    assert programs.original is not None
    return {
        "schema_version": SCHEMA_VERSION,
        "mode": options.mode,
        "original": _pass(programs.original),
    }


def _declared(programs: ProgramSet) -> set[str]:
    """The uniforms that any program declares."""
    passes = [item for variant in programs.variants.values() for item in variant]
    passes += [item for item in (programs.debug, programs.payload) if item is not None]
    return {name for item in passes for name in item.uniforms}


def _cache(layout: Layout, options: Options) -> dict[str, Any]:
    formats = layout.formats(options.cache_format)
    first, rest = layout.payload_channels
    depth = _DEPTHS[options.cache.depth]
    cache: dict[str, Any] = {
        "format": formats[0],
        "buffers": 2,
        "clear": list(_clear(layout, options.cache)),
        "filter": "nearest",
        "wrap": "clamp-to-edge",
        "channels": {"payload": _CHANNELS[first - 1], "depth": "w"} | _extras(layout, 0),
        "depth_encoding": f"floatBitsToUint({depth})" if layout.bits else depth,
        "options": written_cache_options(options.cache),
    }
    if layout.second:
        payload = {"payload": _CHANNELS[rest - 1]} if rest else {}
        channels = payload | _extras(layout, 1)
        cache["second"] = {"format": formats[1], "clear": [0.0] * 4, "channels": channels}
    return cache


def _clear(layout: Layout, options: CacheOptions) -> tuple[float, ...]:
    """What an empty texel holds."""
    if options.depth == "ndc":
        return CLEAR_NDC_BITS if layout.bits else CLEAR_NDC
    if layout.bits:
        return CLEAR_BITS
    return CLEAR_MARKED if marks_depths(options) else CLEAR


def _extras(layout: Layout, texel: int) -> dict[str, Any]:
    """What a texel holds beside payload and depth, and in which channel."""
    held = {name: where for name, (at, where) in layout.extra_places.items() if at == texel}
    return {"extras": held} if held else {}


def _source(source: Source) -> dict[str, str]:
    return {"name": source.name, "sha256": sha256(source.text.encode()).hexdigest()}


def _node(source: Source, node: Candidate, place: tuple[str, str]) -> dict[str, Any]:
    first, second = place
    start, end = source.position(node.expr.span.start), source.position(node.expr.span.end)
    return {
        "id": node.id,
        "path": node.path,
        "text": node.text,
        "type": str(node.type),
        "span": {
            "line": start.line,
            "column": start.column,
            "end_line": end.line,
            "end_column": end.column,
        },
        "channels": {name: text for name, text in (("cache", first), ("second", second)) if text},
        "conditional": is_skipped(node),
    }


def _pass(item: Pass) -> dict[str, Any]:
    return {
        "name": item.name,
        "vertex": f"{item.file}.vert",
        "fragment": f"{item.file}.frag",
        "targets": list(item.targets),
        "depth": {"test": item.depth_test, "write": True},
        "reads": list(item.reads),
        "uniforms": list(item.uniforms),
        "attributes": list(item.attributes),
        "on_reset": item.on_reset,
    }
