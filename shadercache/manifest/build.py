"""Manifests put together from what was emitted."""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from typing import Any

from msgspec import UNSET, convert

from shadercache import __version__
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.payload_sets import is_skipped
from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.layout import Layout, extras_of
from shadercache.caching.outcomes import outcomes
from shadercache.caching.settings import written_settings
from shadercache.emit.dependencies import Dependency
from shadercache.emit.program_set import Pass, ProgramSet
from shadercache.emit.reflection import Input
from shadercache.emit.uniforms import added_uniforms
from shadercache.manifest.cache_model import (
    CacheEntry,
    NodeEntry,
    PlacesEntry,
    SpanEntry,
    TargetEntry,
)
from shadercache.manifest.kinds import TargetName
from shadercache.manifest.model import (
    SCHEMA_VERSION,
    ColorEntry,
    DependencyEntry,
    Manifest,
    MappingEntry,
    NeededManifest,
    OriginalManifest,
    SourceEntry,
    SourcesEntry,
)
from shadercache.manifest.pass_model import (
    AddedUniform,
    DebugEntry,
    DepthEntry,
    DepthFunctionName,
    DepthFunctions,
    NeededEntry,
    ObjectsEntry,
    PassEntry,
    RefusedEntry,
    TriangleEntry,
    VariantEntry,
)
from shadercache.manifest.relies import relies_on
from shadercache.manifest.sentences import frame_sentences, reset_sentences
from shadercache.manifest.setting import Setting
from shadercache.manifest.shader_inputs import described_inputs
from shadercache.manifest.state import state_of
from shadercache.source import Source

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

OBJECTS = ObjectsEntry()
FULL_SCREEN = TriangleEntry(mode="triangles", vertices=3)
"""Three vertices without attributes: the vertex shaders make their positions."""

DEBUG = {"format": "r32f", "clear": 0, "depth_buffer": "own"}
"""Of the debug program. Its draws would close the depth that the passes find open."""

_WHEN = (
    "behind the swap of the caches and in front of the passes of the frame; in a frame of a reset "
    "all is a miss"
)
_HIDDEN = "objects that are not cached hide what is behind them and write 0"

_FORWARD = DepthFunctions(less="less", lequal="lequal", clear=1)
_REVERSED = DepthFunctions(less="greater", lequal="gequal", clear=0)

DEPTH_FUNCTIONS: dict[DepthFunctionName, DepthFunctions] = {
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
    configuration: Configuration,
    programs: ProgramSet,
    setting: Setting,
) -> Manifest:
    """The manifest of a program set."""
    assert programs.original is not None and programs.debug is not None
    assert programs.payload is not None
    layout = Layout(tuple(node.type for node in nodes), extras=extras_of(configuration))
    declared = _declared(programs)
    cache = _cache(layout, configuration)
    return Manifest(
        schema_version=SCHEMA_VERSION,
        generator=f"shadercache {__version__}",
        source=SourcesEntry(fragment=_source(fragment), vertex=_source(vertex)),
        nodes=tuple(
            _node(fragment, node, place) for node, place in zip(nodes, layout.places, strict=True)
        ),
        mode=configuration.mode,
        color=ColorEntry(output=programs.color, location=0),
        cache=cache,
        targets=_targets(cache),
        uniforms=tuple(
            AddedUniform(**entry)
            for entry in added_uniforms(programs.prefix, layout, configuration)
            if entry["name"] in declared or entry["role"] in _ALWAYS
        ),
        renamed=dict(setting.renamed),
        previous=programs.previous,
        inputs=described_inputs(setting.inputs, programs),
        depends_on=tuple(map(_dependency, setting.depends_on)),
        mapping=_mapping(setting),
        draw=FULL_SCREEN if setting.full_screen else OBJECTS,
        original=PassEntry(**_pass(programs.original)),
        variants=tuple(
            VariantEntry(
                algorithm=name,
                passes=tuple(PassEntry(**_pass(item)) for item in passes),
            )
            for name, passes in programs.variants.items()
        ),
        refused=tuple(
            RefusedEntry(algorithm=name, reason=reason) for name, reason in programs.refused.items()
        ),
        payload=PassEntry(**_pass(programs.payload)),
        debug=_debug(programs.debug, configuration, setting),
        frame=tuple(frame_sentences(bool(layout.second), setting, programs)),
        reset=tuple(reset_sentences(configuration, setting, programs)),
        relies_on=tuple(relies_on(configuration, programs, setting)),
        state=state_of(setting.full_screen),
        depth_functions=UNSET if setting.full_screen else DEPTH_FUNCTIONS,
    )


def original_manifest(
    programs: ProgramSet, mode: Mode, inputs: Sequence[Input]
) -> OriginalManifest:
    """How to draw the unchanged shader."""
    assert programs.original is not None
    return OriginalManifest(
        schema_version=SCHEMA_VERSION,
        mode=mode,
        inputs=described_inputs(inputs, programs),
        original=PassEntry(**_pass(programs.original)),
    )


def needed_manifest(programs: ProgramSet, mode: Mode, inputs: Sequence[Input]) -> NeededManifest:
    """How to draw which pixels have payloads."""
    assert programs.debug is not None
    return NeededManifest(
        schema_version=SCHEMA_VERSION,
        mode=mode,
        inputs=described_inputs(inputs, programs),
        needed=NeededEntry(**_pass(programs.debug), by_some=programs.whole),
    )


def _mapping(setting: Setting) -> MappingEntry:
    """Where payloads are found."""
    unchanged = UNSET if setting.unchanged is None else tuple(setting.unchanged)
    return MappingEntry(kind=setting.mapping, exact_while_unchanged=unchanged)


def _targets(cache: CacheEntry) -> dict[TargetName, TargetEntry]:
    found: dict[TargetName, TargetEntry] = {
        "color": TargetEntry(format=None),
        "cache": TargetEntry(format=cache.format),
    }
    if cache.second is not UNSET:
        found["cache-2"] = TargetEntry(format=cache.second.format)
    return found | {"mask": TargetEntry(format="r32f")}


def _declared(programs: ProgramSet) -> set[str]:
    """The uniforms that any program declares."""
    passes = [item for variant in programs.variants.values() for item in variant]
    passes += [item for item in (programs.debug, programs.payload) if item is not None]
    return {name for item in passes for name in item.uniforms}


def _cache(layout: Layout, configuration: Configuration) -> CacheEntry:
    formats = layout.formats(configuration.storage.format)
    first, rest = layout.payload_channels
    depth = _DEPTHS[configuration.storage.depth]
    cache: dict[str, Any] = {
        "format": formats[0],
        "buffers": 2,
        "clear": _clear(layout, configuration),
        "filter": "nearest",
        "wrap": "clamp-to-edge",
        "channels": {"payload": _CHANNELS[first - 1], "depth": "w"} | _extras(layout, 0),
        "depth_encoding": f"floatBitsToUint({depth})" if layout.bits else depth,
        "options": written_settings(configuration),
    }
    if layout.second:
        payload = {"payload": _CHANNELS[rest - 1]} if rest else {}
        channels = payload | _extras(layout, 1)
        cache["second"] = {"format": formats[1], "clear": (0.0,) * 4, "channels": channels}
    return convert(cache, CacheEntry)


def _clear(layout: Layout, configuration: Configuration) -> tuple[float, ...]:
    """What an empty texel holds."""
    if configuration.storage.depth == "ndc":
        return CLEAR_NDC_BITS if layout.bits else CLEAR_NDC
    if layout.bits:
        return CLEAR_BITS
    return CLEAR_MARKED if configuration.filter.marks_depths else CLEAR


def _extras(layout: Layout, texel: int) -> dict[str, Any]:
    """What a texel holds beside payload and depth, and in which channel."""
    held = {name: where for name, (at, where) in layout.extra_places.items() if at == texel}
    return {"extras": held} if held else {}


def _source(source: Source) -> SourceEntry:
    return SourceEntry(name=source.name, sha256=sha256(source.text.encode()).hexdigest())


def _debug(item: Pass, configuration: Configuration, setting: Setting) -> DebugEntry:
    when = _WHEN if setting.full_screen else f"{_WHEN}; {_HIDDEN}"
    return convert(
        _pass(item) | DEBUG | {"when": when, "values": outcomes(configuration)}, DebugEntry
    )


def _dependency(item: Dependency) -> DependencyEntry:
    found = {"kind": item.kind, "name": item.name, "stages": item.stages}
    return convert(found | ({"members": item.members} if item.members else {}), DependencyEntry)


def _node(source: Source, node: Candidate, place: tuple[str, str]) -> NodeEntry:
    places = zip(("cache", "second"), place, strict=True)
    start, end = source.position(node.expr.span.start), source.position(node.expr.span.end)
    return NodeEntry(
        id=node.id,
        path=node.path,
        text=node.text,
        type=str(node.type),
        span=SpanEntry(
            line=start.line, column=start.column, end_line=end.line, end_column=end.column
        ),
        channels=convert({k: v for k, v in places if v}, PlacesEntry),
        conditional=is_skipped(node),
    )


def _pass(item: Pass) -> dict[str, Any]:
    return {
        "name": item.record.name,
        "vertex": f"{item.file}.vert",
        "fragment": f"{item.file}.frag",
        "targets": item.targets,
        "depth": DepthEntry(test=item.record.depth_test, write=item.record.depth_write),
        "reads": item.reads,
        "uniforms": item.uniforms,
        "attributes": item.attributes,
        "on_reset": item.record.on_reset,
        "draws": item.record.draws,
    }
