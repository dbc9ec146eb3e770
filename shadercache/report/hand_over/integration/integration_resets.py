"""What INTEGRATION.md says of resets: when, and how."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import UNSET

from shadercache.manifest.model import Manifest
from shadercache.manifest.pass_model import TriangleEntry
from shadercache.manifest.sentences import age
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.integration_targets import texel
from shadercache.report.hand_over.integration.markdown import alike, code

_ACTIONS = {
    "attribute": "attributes",
    "uniform": "uniforms",
    "sampler": "textures",
    "image": "images",
    "atomic counter": "atomic counters",
    "uniform block": "uniform blocks",
    "storage block": "storage blocks",
    "built-in": "built-in inputs",
}


def reset_lines(cached: Sequence[HandedShader]) -> Iterator[str]:
    """The section."""
    first = manifest_of(cached[0])
    flat = isinstance(first.draw, TriangleEntry)
    more = "" if flat else ", a new projection"
    yield f"* When: the first frame, a cut, a resize{more}, a reloaded shader, a lost context."
    anew = "After a resize or a lost context make them anew first"
    yield f"* How: clear both caches to {_cleared(first)}. {anew}."
    for words, of in alike((_drawn(shader), shader.title) for shader in cached):
        yield f"* Then draw {words}{of}: nothing is reused, all is computed and stored."
    numbers = {
        f"`{one.name}` = {one.on_reset:g}"
        for shader in cached
        for one in shader.added
        if one.on_reset is not UNSET and shader.on_reset(one.name)
    }
    if numbers:
        yield f"* In these draws set {', '.join(sorted(numbers))}. Twins may have any value."
    if not flat:
        yield (
            "* An object that the last frame did not show, or that jumps: draw it so by itself, "
            "and leave the caches as they are."
        )
    for shader in cached:
        yield from _of_changes(shader, flat)


def _drawn(shader: HandedShader) -> str:
    """The passes of a reset."""
    drawn = [one.name for one in shader.passes if one.on_reset]
    return "all passes" if len(drawn) == len(shader.passes) else f"{code(drawn)} alone"


def _cleared(manifest: Manifest) -> str:
    second = manifest.cache.second
    more = "" if second is UNSET else f", `cache-2` to {texel(second.clear)}"
    return f"{texel(manifest.cache.clear)}{more}"


def _of_changes(shader: HandedShader, flat: bool) -> Iterator[str]:
    """What the value depends on, whose change may have to be shown at once."""
    manifest = manifest_of(shader)
    names: dict[str, list[str]] = {}
    for one in manifest.depends_on:
        members = [f"{one.name}.{member}" for member in one.members] or [one.name]
        names.setdefault(_ACTIONS[one.kind], []).extend(members)
    if not names:
        return
    told = "; ".join(f"{kind} {code(them)}" for kind, them in names.items())
    whom = "reset" if flat else "reset the objects that it concerns"
    old = age(shader.configuration.refresh, manifest.mapping.kind)
    yield (
        f"* The cached value of {manifest.source.fragment.name} depends on {told}. What is reused "
        f"is {old}. If one of these changes at once, and its old value must not be seen, {whom}."
    )
