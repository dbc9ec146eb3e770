"""Rules between the fields of a manifest, which neither types nor the JSON Schema hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TypeAlias

from msgspec import UNSET

from shadercache.lang.block_layout import LAID_OUT
from shadercache.manifest.interface import (
    AttributeInput,
    InputEntry,
    StorageBlockInput,
    UniformBlockInput,
    UniformInput,
    name_space,
)
from shadercache.manifest.model import Manifest
from shadercache.manifest.pass_model import PassEntry

Problem: TypeAlias = tuple[str, str]
"""A path in the manifest, and what is wrong there."""

# JSON Schema can say which keys a map needs; the types cannot.
_OUTCOMES = ("hit", "refresh", "outside", "depth")


def problems(manifest: Manifest) -> Iterator[Problem]:
    """What is wrong between the fields of a manifest."""
    yield from _interface(manifest)
    attributes = {entry.name for entry in manifest.inputs if isinstance(entry, AttributeInput)}
    inputs = [entry for entry in manifest.inputs if not isinstance(entry, AttributeInput)]
    others = {entry.name for entry in (*manifest.uniforms, *inputs)}
    for path, entry in passes_of(manifest):
        yield from _pass(path, entry, manifest)
        yield from _unknown(f"{path}.attributes", entry.attributes, attributes)
        yield from _unknown(f"{path}.uniforms", entry.uniforms, others)
    for at, variant in enumerate(manifest.variants):
        if not any(entry.on_reset for entry in variant.passes):
            yield f"variants[{at}].passes", "a reset draws none of them"
    for at, node in enumerate(manifest.nodes):
        if node.channels.cache is UNSET and node.channels.second is UNSET:
            yield f"nodes[{at}].channels", "it lies in none"
    missing = [name for name in _OUTCOMES if name not in manifest.debug.values]
    if missing:
        yield "debug.values", f"lacks '{missing[0]}'"


def passes_of(manifest: Manifest) -> Iterator[tuple[str, PassEntry]]:
    """Every pass, with its path."""
    for at, variant in enumerate(manifest.variants):
        for number, entry in enumerate(variant.passes):
            yield f"variants[{at}].passes[{number}]", entry
    yield "original", manifest.original
    yield "debug", manifest.debug
    if manifest.payload is not UNSET:
        yield "payload", manifest.payload
    if manifest.geometry is not UNSET:
        yield "geometry", manifest.geometry


def _pass(path: str, entry: PassEntry, manifest: Manifest) -> Iterator[Problem]:
    for key in ("targets", "reads", "uniforms", "attributes"):
        yield from _twice(f"{path}.{key}", getattr(entry, key))
    yield from _unknown(f"{path}.targets", entry.targets, manifest.targets)
    if (
        len({target.divisor for name in entry.targets if (target := manifest.targets.get(name))})
        > 1
    ):
        yield f"{path}.targets", "they are of several sizes"
    if not entry.targets and entry.depth.buffer != "marks":
        yield f"{path}.targets", "it draws into nothing"
    if entry.draws != "objects" and entry.attributes:
        yield f"{path}.attributes", "a pass over the screen has none"
    sampled = {"previous-cache-2", "current-cache-2"}.intersection(entry.reads)
    if sampled and manifest.cache.second is UNSET:
        yield f"{path}.reads", f"{min(sampled)} is in no manifest without cache.second"


def _interface(manifest: Manifest) -> Iterator[Problem]:
    names: dict[type, list[str]] = {UniformInput: [entry.name for entry in manifest.uniforms]}
    for entry in manifest.inputs:
        names.setdefault(name_space(entry), []).append(entry.name)
    for space in names.values():
        yield from _twice("inputs", space)
    for at, entry in enumerate(manifest.inputs):
        path = f"inputs[{at}]"
        yield from _twice(f"{path}.stages", entry.stages)
        if isinstance(entry, UniformBlockInput | StorageBlockInput):
            placed = [member.offset is not UNSET for member in entry.members]
            if entry.packing in LAID_OUT and not (all(placed) and entry.size is not UNSET):
                yield path, f"a {entry.packing} block has a size, and offsets of its members"
        yield from _twin(path, entry, manifest)
    for at, needed in enumerate(manifest.depends_on):
        yield from _twice(f"depends_on[{at}].stages", needed.stages)


def _twin(path: str, entry: InputEntry, manifest: Manifest) -> Iterator[Problem]:
    of = getattr(entry, "previous_of", UNSET)  # some kinds have no twins
    if of is UNSET:
        return
    if manifest.previous.get(of) != entry.name:
        yield f"{path}.previous_of", f"'previous' does not lead from {of} to it"
    if of not in {other.name for other in manifest.inputs}:
        yield f"{path}.previous_of", f"there is no input {of}"


def _twice(path: str, names: Iterable[str]) -> Iterator[Problem]:
    for name, count in Counter(names).items():
        if count > 1:
            yield path, f"{name} stands there twice"


def _unknown(path: str, names: Iterable[str], known: Iterable[str]) -> Iterator[Problem]:
    missing = [name for name in names if name not in known]
    if missing:
        yield path, f"nothing else tells of {missing[0]}"
