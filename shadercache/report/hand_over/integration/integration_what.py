"""What INTEGRATION.md says first: what is cached, how, and what that gains."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import shortened
from shadercache.manifest.cache_model import NodeEntry
from shadercache.report.hand_over.expected import Expected
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.markdown import code, listed

_FOUND = {
    "surface": "where its point of the surface was in the last frame (reprojection)",
    "screen": "at its own pixel",
    "user": "where your `scPreviousClip()` says",
}
_SCHEDULES = {
    "stratified": "each pixel once in {0} frames, in squares of {1} × {1} pixels",
    "random": "each pixel once in {0} frames, in squares of {1} × {1} pixels",
    "tiled": "one of {0} tiles of the picture in each frame",
    "surface": "each triangle once in {0} frames",
    "none": "nothing is recomputed on purpose",
}
_LONGEST = 120
"""Characters of an expression."""


def what_lines(shaders: Sequence[HandedShader], expected: Expected | None) -> Iterator[str]:
    """The section."""
    for shader in shaders:
        several = len(shaders) > 1
        if several:
            yield f"* **`{shader.folder}`** is for {_objects(shader)}."
        if shader.variant:
            yield from (f"{'  ' * several}{line}" for line in _of_shader(shader))
    yield from _gain(expected)
    yield (
        "* Files: those of the passes below, `original.*` (your shader, to compare with) and "
        "`hit-mask.*` (for section 6)."
    )


def refresh_words(chosen: Configuration) -> str:
    """How often a value is recomputed on purpose."""
    refresh = chosen.refresh
    words = _SCHEDULES[refresh.schedule].format(refresh.period, refresh.block)
    if refresh.adaptive:
        words += f"; more often where a refresh changes it by more than {refresh.adaptive:g}"
    return f"{words}; none gets older than {refresh.period} frames" if refresh.age else words


def _objects(shader: HandedShader) -> str:
    """The objects, and which of them are not cached."""
    plain = listed(item.part.name for item in shader.plain)
    if not shader.variant:
        return f"{plain}, not cached: the example alone draws with what is there"
    cached = listed(item.part.name for item in shader.cached)
    return f"{cached}; and not cached {plain}" if plain else cached


def _of_shader(shader: HandedShader) -> Iterator[str]:
    manifest = manifest_of(shader)
    name = manifest.source.fragment.name
    for node in manifest.nodes:
        place = f"line {node.span.line} of {name} ({node.path})"
        yield f"* Cached: {_expression(node)}, {node.type}, {place}."
        if node.approximate:
            yield "* Exact at rest alone: it depends on where or how large a surface is seen."
    chosen, variant = shader.configuration, manifest.variants[0]
    yield f"* Algorithm: {variant.algorithm}, passes {code(one.name for one in variant.passes)}."
    yield f"* Refresh: {refresh_words(chosen)}."
    for item in shader.cached:
        own = item.configuration
        if own is not None and refresh_words(own) != refresh_words(chosen):
            yield f"* Refresh of {item.part.name}: {refresh_words(own)}."
    yield f"* Found again: {_FOUND[manifest.mapping.kind]}."
    if chosen.divisor > 1:
        yield f"* Rate: a texel for {chosen.divisor} × {chosen.divisor} pixels, upsampled by depth."


def _expression(node: NodeEntry) -> str:
    text = shortened(" ".join(node.text.split()), _LONGEST)
    return f"`{text}`"


def _gain(expected: Expected | None) -> Iterator[str]:
    if expected is None:
        yield "* Gain and error were not measured."
        return
    bound = "" if expected.bound is None else f", where {expected.bound:g} was the bound"
    width, height = expected.size
    yield (
        f"* Gain: {expected.speedup:.2f} times as fast as the original (95 % interval "
        f"{expected.low:.2f} to {expected.high:.2f})."
    )
    yield (
        f"* Error in {expected.metric}: {expected.mean:.4g} on average, {expected.worst:.4g} in "
        f"the worst frame{bound}."
    )
    yield (
        f"* Both measured over {expected.frames} frames that were not used for choosing, at "
        f"{width} × {height}, on {expected.renderer}."
    )
