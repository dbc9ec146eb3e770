"""What INTEGRATION.md says of targets: which to allocate, and what lies in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import UNSET, UnsetType

from shadercache.caching.algorithms import PARKED
from shadercache.manifest.model import Manifest
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.markdown import alike, table

_HEAD = ("target", "how many", "format", "size", "filter, wrap", "cleared to")


def target_lines(cached: Sequence[HandedShader]) -> list[str]:
    """The section; ``cached``: the shaders that are, of which all share a cache."""
    first = manifest_of(cached[0])
    rows = [*_own_rows(cached), *_cache_rows(first), *_parked_rows(cached)]
    mask = first.debug
    rows.append(("`mask`", "1, for section 6", mask.format, _size(first), "-", f"{mask.clear}"))
    return [*table(_HEAD, rows), "", f"A texel of the cache holds {', '.join(_channels(first))}."]


def texel(values: Sequence[float]) -> str:
    """What an empty texel holds."""
    return f"({', '.join(f'{value:g}' for value in values)})"


def has_marks(shader: HandedShader) -> bool:
    """Has a pass the depth buffer of marks?"""
    return any(one.depth.buffer == "marks" for one in shader.passes)


def _own_rows(cached: Sequence[HandedShader]) -> Iterator[tuple[str, ...]]:
    outputs = {
        name: one
        for shader in cached
        for one in manifest_of(shader).outputs
        for name in one.targets
    }
    for name, one in outputs.items():
        yield f"`{name}`", "yours", f"yours: `{one.output}`, {one.type}", "picture", "-", "as ever"
    yield "depth", "yours", "yours", "picture", "-", "1, once a frame, not in each pass"


def _cache_rows(manifest: Manifest) -> Iterator[tuple[str, ...]]:
    cache, size = manifest.cache, _size(manifest)
    layers: list[tuple[str, str, Sequence[float]]] = [("cache", cache.format, cache.clear)]
    if cache.second is not UNSET:
        layers.append(("cache-2", cache.second.format, cache.second.clear))
    how = f"{cache.filter}, clamp to edge"
    for name, form, clear in layers:
        yield f"`{name}`", "2, which swap", form, size, how, texel(clear)
    if manifest.targets["cache"].divisor > 1:
        yield "the cache's depth", "1", "as yours", size, "-", "1, once a frame"


def _parked_rows(cached: Sequence[HandedShader]) -> Iterator[tuple[str, ...]]:
    """Those of several shaders are shared where their formats are the same."""
    told = [
        ((name, str(target.format)), shader.title)
        for shader in cached
        for name, target in manifest_of(shader).targets.items()
        if name.startswith(PARKED)
    ]
    for (name, form), of in alike(told):
        yield f"`{name}`", f"1{of}", form, "picture", "nearest, clamp to edge", "never"
    if any(map(has_marks, cached)):
        yield "depth of marks", "1", "depth, 24 bits or more", "picture", "-", "never"


def _size(manifest: Manifest) -> str:
    divisor = manifest.targets["cache"].divisor
    return "picture" if divisor == 1 else f"picture / {divisor}, rounded up"


def _channels(manifest: Manifest) -> Iterator[str]:
    """What lies in which channels."""
    cache = manifest.cache
    yield f"payload in {cache.channels.payload}"
    yield f"depth ({cache.depth_encoding}) in w"
    yield from _extras(cache.channels.extras, "")
    if cache.second is not UNSET:
        channels = cache.second.channels
        if channels.payload is not UNSET:
            yield f"more payload in {channels.payload} of `cache-2`"
        yield from _extras(channels.extras, " of `cache-2`")


def _extras(extras: Mapping[str, str] | UnsetType, where: str) -> Iterator[str]:
    for name, channel in ({} if extras is UNSET else extras).items():
        yield f"{name} in {channel}{where}"
