"""What INTEGRATION.md says last: what the variant relies on, and how to see that it works."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import UNSET

from shadercache.caching.configuration import Refresh
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.integration_targets import has_marks
from shadercache.report.hand_over.integration.markdown import alike, code
from shadercache.scene.description import Scene

_MUST = {
    "on": "On",
    "fill": "Filled",
    "off": "Off",
    "equal": "The same in every pass of a frame, and where you draw without the cache",
}


def relied_lines(cached: Sequence[HandedShader], scene: Scene) -> Iterator[str]:
    """What to check in one's engine."""
    told = ((words, one.title) for one in cached for words in manifest_of(one).relies_on)
    for words, of in alike(told):
        yield f"* {words[:1].upper()}{words[1:]}{of}."
    states: dict[str, list[str]] = {}
    for one in manifest_of(cached[0]).state:
        states.setdefault(one.must, []).append(one.state)
    for must, names in states.items():
        yield f"* {_MUST[must]}: {'; '.join(names)}."
    functions = manifest_of(cached[0]).depth_functions
    if functions is not UNSET:
        yield f"* {_depths(scene)}"


def _depths(scene: Scene) -> str:
    """What another depth function changes."""
    reverse = "`less` becomes `greater`, `lequal` becomes `gequal`, and depth is cleared to 0"
    own = scene.view.engine.depth
    if scene.view.engine.reversed:
        return f"Your depth function is `{own}`: in all passes above {reverse}."
    if own == "equal":
        return "You draw depth first: clear it behind that, since the passes find it themselves."
    return f"With reversed depth {reverse}."


def check_lines(cached: Sequence[HandedShader]) -> Iterator[str]:
    """How to see that it works."""
    first = manifest_of(cached[0])
    debug = first.debug
    programs = code(
        f"{shader.folder}{file}"
        for shader in cached
        for file in (manifest_of(shader).debug.vertex, manifest_of(shader).debug.fragment)
    )
    values = ", ".join(f"{value} {name}" for name, value in debug.values.items())
    yield (
        f"* Draw the hit mask ({programs}) instead of the passes: behind the swap, in front of "
        "them, with the same uniforms, into `mask`, with a depth buffer of its own. It holds 0 "
        f"where nothing was drawn, {values}."
    )
    for words, of in alike((_hits(one.configuration.refresh), one.title) for one in cached):
        yield f"* {words}{of}."
    yield "* Few hits at rest: the caches do not swap, or depth differs between passes."
    if first.previous:
        yield "* Hits at rest, few in motion: the twins do not have the last frame's values."
    if any(shader.configuration.refresh.schedule != "none" for shader in cached):
        yield "* Old values that stay for ever: the clock stands still."
    if any(map(has_marks, cached)):
        yield "* Holes where the mask shows misses: two passes have different depths of marks."


def _hits(refresh: Refresh) -> str:
    """How many hits to expect."""
    if refresh.renews:
        return "With a period of 1 all is refreshed in every frame, and nothing hits"
    if refresh.schedule == "none":
        return "At rest all hits, from the second frame on"
    share = 100.0 * (1.0 - 1.0 / refresh.period)
    most = "at most " if refresh.adaptive else ""
    return (
        f"At rest, from the second frame on, expect {most}{share:.1f} % hits "
        f"(1 - 1/{refresh.period}); the rest are refreshes"
    )
