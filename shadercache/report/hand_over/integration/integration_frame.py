"""What INTEGRATION.md says of a frame: uniforms, twins, and each pass in order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import UNSET

from shadercache.caching.algorithms import algorithm
from shadercache.manifest.interface import (
    AttributeInput,
    InputEntry,
    SamplerInput,
    StorageBlockInput,
    UniformBlockInput,
)
from shadercache.manifest.model import Manifest
from shadercache.manifest.pass_model import PassEntry, TriangleEntry
from shadercache.report.hand_over.frame_order import PassStep, steps_of
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.integration_targets import texel
from shadercache.report.hand_over.integration.markdown import alike, code, listed, table
from shadercache.report.hand_over.integration.role_words import value_words

_BLOCKS = (UniformBlockInput, StorageBlockInput)


def frame_lines(shaders: Sequence[HandedShader]) -> list[str]:
    """The section, in steps."""
    cached = [shader for shader in shaders if shader.variant]
    steps: list[list[str]] = [
        ["Swap the two caches: what the last frame wrote is now the one to read."],
        [f"Clear your depth and colours as ever, and {_cleared(manifest_of(cached[0]))}."],
        ["Set the uniforms that were added; each pass names its own.", "", *_added(cached), ""],
    ]
    twins = list(_twins(cached))
    if twins:
        steps.append(["Set the twins to what these had in the last frame.", "", *twins, ""])
    steps.append([_order(shaders), "", *_passes(shaders), ""])
    if twins:
        steps.append(["Keep this frame's values of what has twins."])
    return [
        f"{number}. {line}" if at == 0 else line
        for number, step in enumerate(steps, 1)
        for at, line in enumerate(step)
    ]


def _cleared(manifest: Manifest) -> str:
    cache = manifest.cache
    texts = [f"this frame's `cache` to {texel(cache.clear)}"]
    if cache.second is not UNSET:
        texts.append(f"its `cache-2` to {texel(cache.second.clear)}")
    if manifest.targets["cache"].divisor > 1:
        texts.append("the cache's own depth to 1")
    return " and ".join(texts)


def _added(shaders: Sequence[HandedShader]) -> list[str]:
    """A table of the added uniforms; of several shaders those together that are alike."""
    told = [
        ((f"`{one.name}`", one.type, value_words(one, shader.on_reset(one.name))), shader.title)
        for shader in shaders
        for one in shader.added
    ]
    rows = [(name, kind, words + of) for (name, kind, words), of in alike(told)]
    return table(("uniform", "type", "value"), rows)


def _twins(shaders: Sequence[HandedShader]) -> Iterator[str]:
    """A line for each twin: what it is, and of what."""
    told: set[str] = set()
    for entry in (entry for shader in shaders for entry in shader.inputs):
        of = getattr(entry, "previous_of", UNSET)
        if of is not UNSET and entry.name not in told:
            told.add(entry.name)
            yield f"   * `{entry.name}` ({_kind(entry)}) from `{of}`{_how(entry)}"


def _kind(entry: InputEntry) -> str:
    if isinstance(entry, UniformBlockInput):
        return "uniform block"
    if isinstance(entry, StorageBlockInput):
        return "storage block"
    return f"{'attribute ' if isinstance(entry, AttributeInput) else ''}{entry.type}"


def _how(entry: InputEntry) -> str:
    """What else is to be done for a twin."""
    if isinstance(entry, _BLOCKS):
        point = "a binding point of its own" if entry.binding is None else f"point {entry.binding}"
        if entry.takes_the_last_buffer is True:
            return f": bind that one's buffer of the last frame at {point}; keep two, swap them"
        return f": write a buffer of its own, and bind it at {point}"
    if isinstance(entry, AttributeInput):
        return ": keep two buffers, swap them; an index means the same vertex or instance in both"
    return ": keep two textures, swap them" if isinstance(entry, SamplerInput) else ""


def _order(shaders: Sequence[HandedShader]) -> str:
    """What holds for all passes."""
    text = "Draw these passes in this order, without blending. As a target `cache` is this frame's."
    cached = next(shader for shader in shaders if shader.variant)
    if isinstance(manifest_of(cached).draw, TriangleEntry):
        return f"{text} Each is one triangle: three vertices, no attributes, no index."
    if sum(len(shader.objects) for shader in shaders) > 1:
        return f"{text} All objects finish a pass before the next begins."
    return text


def _passes(shaders: Sequence[HandedShader]) -> Iterator[str]:
    many = len(shaders) > 1
    for number, step in enumerate(steps_of(shaders), 1):
        if step.cached:
            yield from _pass(number, step, many)
            yield from _spared(step, shaders)
        else:
            yield _uncached(number, step, many)


def _spared(step: PassStep, shaders: Sequence[HandedShader]) -> Iterator[str]:
    """The programs of other shaders that need not be drawn, since this step does it for them."""
    files = [
        f"{shader.folder}{file}"
        for shader in shaders
        for one in shader.passes
        if shader is not step.shader and not step.entry.targets and one.name == step.entry.name
        for file in (one.vertex, one.fragment)
    ]
    if files:
        yield f"     * It is that of all shaders: leave out {code(files)}."


def _uncached(number: int, step: PassStep, many: bool) -> str:
    what = f"`{step.shader.title}`" if many else listed([one.part.name for one in step.objects])
    return (
        f"   * **{number}. Not cached: {what}.** Your own shader as ever, with no cache attached. "
        "It comes first, so that nothing it hides is stored."
    )


def _pass(number: int, step: PassStep, many: bool) -> Iterator[str]:
    """What is drawn, where, and with what bound."""
    entry, manifest = step.entry, manifest_of(step.shader)
    of = f" of {step.shader.title}" if many else ""
    words = algorithm(manifest.variants[0].algorithm).words_of(entry.name)
    reset = "" if entry.on_reset else " Not in a frame of a reset."
    folder = step.shader.folder
    yield f"   * **{number}. `{entry.name}`{of}**: {words}.{reset}"
    program = code((f"{folder}{entry.vertex}", f"{folder}{entry.fragment}"))
    yield f"     * Program: {program}. Draw {_drawn(step)}."
    yield f"     * Targets: {_targets(entry)}. Depth: {_depth(entry, manifest)}."
    samplers = [one for one in step.shader.added if one.role in entry.reads]
    bound = [f"`{one.name}`: {value_words(one)}" for one in samplers if one.name in entry.uniforms]
    if bound:
        yield f"     * Sample {'; '.join(bound)}."
    names = {one.name for one in step.shader.added}
    sampled = {one.name for one in samplers}
    added = [name for name in entry.uniforms if name in names - sampled]
    twins = [name for name in entry.uniforms if name in manifest.previous.values()]
    own = [name for name in entry.uniforms if name not in names and name not in twins]
    lists = [f"added {code(added)}"] if added else []
    lists += [f"twins {code(twins)}"] if twins else []
    lists += [f"yours {code(own)}"] if own else []
    lists += [f"attributes {code(entry.attributes)}"] if entry.attributes else []
    if lists:
        yield f"     * Set: {'; '.join(lists)}."


def _drawn(step: PassStep) -> str:
    if step.entry.draws == "screen":
        return "one triangle over the screen (three vertices, no attributes), once for all objects"
    if step.entry.draws == "groups":
        return "the same triangle once for each group of draws"
    if isinstance(manifest_of(step.shader).draw, TriangleEntry):
        return "the triangle"
    return "the object" if len(step.objects) == 1 else "its objects"


def _targets(entry: PassEntry) -> str:
    if not entry.targets:
        return "none"
    return ", ".join(f"{at} `{name}`" for at, name in enumerate(entry.targets))


def _depth(entry: PassEntry, manifest: Manifest) -> str:
    write = "written" if entry.depth.write else "not written"
    buffer = ""
    if entry.depth.buffer == "marks":
        buffer = ", in the buffer of marks"
    elif any(manifest.targets[name].divisor > 1 for name in entry.targets):
        buffer = ", in the cache's own buffer"
    return f"`{entry.depth.test}`, {write}{buffer}"
