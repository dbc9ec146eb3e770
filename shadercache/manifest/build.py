"""Manifests put together from what was emitted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from hashlib import sha256
from typing import Any

from msgspec import UNSET, convert

from shadercache import __version__
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.payload_sets import is_skipped
from shadercache.analysis.outputs import targets_of
from shadercache.analysis.refusals import FIRST_TEXEL
from shadercache.caching.algorithms import PARKED
from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.layout import XYZW, Layout, empty_depth, layout_of
from shadercache.caching.outcomes import outcomes
from shadercache.caching.settings import written_settings
from shadercache.emit.program_set import Pass, ProgramSet, color_targets
from shadercache.manifest import cache_model, model, pass_model
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.kinds import TargetName
from shadercache.manifest.pass_model import DepthFunctionName, DepthFunctions, PassEntry
from shadercache.manifest.reflection import declared_inputs
from shadercache.manifest.sentences import Setting, frame_sentences, relies_on, reset_sentences
from shadercache.manifest.state import state_of
from shadercache.manifest.uniforms import added_uniforms
from shadercache.manifest.vulkan_uniforms import added_block, in_block
from shadercache.source import Source, as_text

# 16/w is as precise in half floats from w = 2.4e-4 to 2.6e5. Plain 1/w falls below 2^-14, and loses
# bits, at w = 16,384 (docs/why/reuse.md).
_DEPTHS = {"inverse-w": "16/w", "ndc": "z/w", "linear": "w"}

_ALWAYS = ("previous-cache", "current-cache", "previous-cache-2", "current-cache-2", "epsilon")
"""Roles that are told whether or not a program of the variants at hand has them."""

# Three vertices without attributes: the vertex shaders make their positions.
_FULL_SCREEN = pass_model.TriangleEntry(mode="triangles", vertices=3)

# Its draws would close the depth that the passes find open.
_DEBUG = {"format": "r32f", "clear": 0, "depth_buffer": "own"}

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
    nodes: Sequence[Candidate], configuration: Configuration, programs: ProgramSet, setting: Setting
) -> model.Manifest:
    """The manifest of a program set."""
    layout = layout_of(tuple(node.type for node in nodes), configuration)
    uniforms = {name for emitted in programs.passes for name in emitted.uniforms}
    cache = _cache(layout, configuration)
    assert programs.debug is not None
    return model.Manifest(
        generator=f"shadercache {__version__}",
        nodes=tuple(
            _node(setting.fragment, node, place)
            for node, place in zip(nodes, layout.places, strict=True)
        ),
        outputs=_outputs(programs),
        cache=cache,
        targets=_targets(cache, configuration.divisor, programs),
        uniforms=in_block(
            (
                uniform
                for uniform in added_uniforms(
                    programs.prefix,
                    layout,
                    configuration,
                    f"{programs.prefix}first_object" in uniforms,
                )
                if uniform.name in uniforms or uniform.role in _ALWAYS
            ),
            programs,
        ),
        uniform_block=added_block(programs),
        previous=dict(programs.last_frame.twins),
        debug=_debug(programs.debug, configuration, setting),
        frame=tuple(frame_sentences(layout.second, configuration, setting, programs)),
        reset=tuple(reset_sentences(configuration, setting, programs)),
        relies_on=tuple(relies_on(configuration, programs, setting)),
        **_head(programs, configuration.mode, setting.inputs),
        **_of_passes(programs),
        **_of_setting(setting),
    )


def _of_passes(programs: ProgramSet) -> dict[str, Any]:
    assert programs.original is not None and programs.payload is not None
    return {
        "original": _pass(programs.original),
        "variants": tuple(
            pass_model.VariantEntry(algorithm=name, passes=tuple(map(_pass, passes)))
            for name, passes in programs.variants.items()
        ),
        "refused": tuple(
            pass_model.RefusedEntry(algorithm=name, reason=reason)
            for name, reason in programs.refused.items()
        ),
        "payload": _pass(programs.payload),
    }


def _of_setting(setting: Setting) -> dict[str, Any]:
    unchanged = UNSET if setting.unchanged is None else setting.unchanged
    return {
        "source": model.SourcesEntry(
            fragment=_source(setting.fragment), vertex=_source(setting.vertex)
        ),
        "renamed": dict(setting.renamed),
        "depends_on": setting.depends_on,
        "mapping": model.MappingEntry(kind=setting.mapping, exact_while_unchanged=unchanged),
        "draw": _FULL_SCREEN if setting.full_screen else pass_model.ObjectsEntry(),
        "state": state_of(setting.full_screen),
        "depth_functions": UNSET if setting.full_screen else DEPTH_FUNCTIONS,
    }


def original_manifest(
    programs: ProgramSet, mode: Mode, inputs: Iterable[InputEntry]
) -> model.OriginalManifest:
    """How to draw the unchanged shader."""
    assert programs.original is not None
    original = _pass(programs.original)
    head = _head(programs, mode, inputs)
    return model.OriginalManifest(**head, outputs=_outputs(programs), original=original)


def needed_manifest(
    programs: ProgramSet, mode: Mode, inputs: Iterable[InputEntry]
) -> model.NeededManifest:
    """How to draw which pixels have payloads."""
    assert programs.debug is not None
    needed = pass_model.NeededEntry(**_about(programs.debug), by_some=programs.whole)
    return model.NeededManifest(**_head(programs, mode, inputs), needed=needed)


def _head(programs: ProgramSet, mode: Mode, inputs: Iterable[InputEntry]) -> dict[str, Any]:
    """What all manifests begin with."""
    uniforms = {name for one in programs.passes for name in one.uniforms}
    attributes = {name for one in programs.passes for name in one.attributes}
    return {
        "schema_version": model.SCHEMA_VERSION,
        "mode": mode,
        "inputs": declared_inputs(
            inputs, programs.last_frame, uniforms, attributes, programs.vulkan
        ),
    }


def _outputs(programs: ProgramSet) -> tuple[model.OutputEntry, ...]:
    names: Any = color_targets(targets_of(programs.outputs))
    return tuple(
        model.OutputEntry(
            output=output.name,
            type=str(output.type),
            location=output.location,
            targets=tuple(names[place] for place in output.places),
        )
        for output in programs.outputs
    )


def _targets(
    cache: cache_model.CacheEntry, divisor: int, programs: ProgramSet
) -> dict[TargetName, cache_model.TargetEntry]:
    colors: Any = color_targets(targets_of(programs.outputs))
    formats: dict[TargetName, Any] = {**dict.fromkeys(colors), "cache": cache.format}
    if cache.second is not UNSET:
        formats["cache-2"] = cache.second.format
    formats["mask"] = "r32f"
    for emitted in programs.passes:
        names: list[Any] = [name for name in emitted.targets if name.startswith(PARKED)]
        formats |= dict(zip(names, emitted.parked, strict=True))
    return {
        name: cache_model.TargetEntry(format=form, divisor=1 if name in colors else divisor)  # type: ignore[arg-type]
        for name, form in formats.items()
    }


def _cache(layout: Layout, configuration: Configuration) -> cache_model.CacheEntry:
    formats = layout.formats(configuration.storage.format)
    depth = _DEPTHS[configuration.storage.depth]
    cache: dict[str, Any] = {
        "format": formats[0],
        "buffers": 2,
        "clear": (0.0, 0.0, 0.0, empty_depth(layout, configuration)),
        # Look-ups fetch single texels and blend them themselves. Besides, a texture of integers
        # with a linear filter is incomplete (OpenGL 4.6 section 8.17).
        "filter": "nearest",
        "wrap": "clamp-to-edge",
        "channels": {"payload": XYZW[: min(layout.used, FIRST_TEXEL)], "depth": "w"}
        | _extras(layout, 0),
        "depth_encoding": f"floatBitsToUint({depth})" if layout.bits else depth,
        "options": written_settings(configuration),
    }
    if layout.second:
        rest = XYZW[: max(layout.used - FIRST_TEXEL, 0)]
        payload = {"payload": rest} if rest else {}
        channels = payload | _extras(layout, 1)
        cache["second"] = {"format": formats[1], "clear": (0.0,) * 4, "channels": channels}
    return convert(cache, cache_model.CacheEntry)


def _extras(layout: Layout, texel: int) -> dict[str, Any]:
    """What a texel holds beside payload and depth, and in which channel."""
    held = {name: where for name, (at, where) in layout.extra_places.items() if at == texel}
    return {"extras": held} if held else {}


def _source(source: Source) -> model.SourceEntry:
    return model.SourceEntry(
        name=as_text(source.name), sha256=sha256(source.text.encode()).hexdigest()
    )


def _debug(emitted: Pass, configuration: Configuration, setting: Setting) -> pass_model.DebugEntry:
    when = _WHEN if setting.full_screen else f"{_WHEN}; {_HIDDEN}"
    about = {"when": when, "values": outcomes(configuration)}
    return convert(_about(emitted) | _DEBUG | about, pass_model.DebugEntry)


def _node(source: Source, node: Candidate, place: tuple[str, str]) -> cache_model.NodeEntry:
    places = zip(("cache", "second"), place, strict=True)
    start, end = source.position(node.expr.span.start), source.position(node.expr.span.end)
    return cache_model.NodeEntry(
        id=node.id,
        path=node.path,
        text=node.text,
        type=str(node.type),
        span=cache_model.SpanEntry(
            line=start.line, column=start.column, end_line=end.line, end_column=end.column
        ),
        channels=convert({k: v for k, v in places if v}, cache_model.PlacesEntry),
        conditional=is_skipped(node),
        approximate=node.approximate,
    )


def _pass(emitted: Pass) -> PassEntry:
    return PassEntry(**_about(emitted))


def _about(emitted: Pass) -> dict[str, Any]:
    record = emitted.record
    return {
        "name": record.name,
        "vertex": f"{emitted.file}.vert",
        "fragment": f"{emitted.file}.frag",
        "targets": emitted.targets,
        "depth": pass_model.DepthEntry(
            test=record.depth_test, write=record.depth_write, buffer=record.depth_buffer
        ),
        "reads": emitted.reads,
        "uniforms": emitted.uniforms,
        "attributes": emitted.attributes,
        "on_reset": record.on_reset,
        "draws": record.draws,
    }
