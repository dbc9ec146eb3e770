"""What the engine gives, as the manifest lists it: blocks apart from uniforms, twins with them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeVar

from msgspec import UNSET, UnsetType

from shadercache.emit.block_members import InputMember
from shadercache.emit.program_set import Pass, ProgramSet
from shadercache.emit.reflection import Input, InputKind, with_twins
from shadercache.lang.block_layout import LAID_OUT, up
from shadercache.manifest.interface import (
    AttributeInput,
    CounterInput,
    ImageInput,
    InputEntry,
    MemberEntry,
    SamplerInput,
    StorageBlockInput,
    UniformBlockInput,
    UniformInput,
)

T = TypeVar("T")

_TEXTURE = re.compile(
    r"([iu]?)(?:sampler|image)(1D|2D|3D|Cube|Buffer|ExternalOES)(Rect)?(MS)?(Array)?(Shadow)?"
)
_DIMENSIONS = {"Cube": "cube", "Buffer": "buffer", "ExternalOES": "2D"}
_COMPONENTS = {"": "float", "i": "int", "u": "uint"}
_BUFFER_UNIT = 16  # drivers count a block up to a whole vec4


def described_inputs(inputs: Sequence[Input], programs: ProgramSet) -> tuple[InputEntry, ...]:
    """An entry for every input that a program of the set declares, the added ones apart."""
    declared = {name for item in _passes(programs) for name in (*item.uniforms, *item.attributes)}
    return tuple(
        _ENTRIES[item.kind](item)
        for item in with_twins(inputs, programs.previous)
        if item.name in declared
    )


def _passes(programs: ProgramSet) -> Iterable[Pass]:
    for variant in programs.variants.values():
        yield from variant
    for item in (programs.original, programs.debug, programs.payload):
        if item is not None:
            yield item


def _variable(item: Input) -> dict[str, Any]:
    return {"name": item.name, "stages": item.stages, "type": item.type, "dims": item.dims}


def _attribute(item: Input) -> InputEntry:
    return AttributeInput(**_variable(item), location=item.location)


def _uniform(item: Input) -> InputEntry:
    return UniformInput(
        **_variable(item),
        location=item.location,
        default=_or_unset(item.default),
        members=tuple(map(_member, item.members)),
        previous_of=_or_unset(item.previous_of),
    )


def _texture(item: Input) -> dict[str, Any]:
    """What the name of a type says of a texture."""
    found = _TEXTURE.match(item.type or "")
    assert found is not None, item.type
    return _variable(item) | {
        "binding": item.binding,
        "dimension": "rectangle" if found[3] else _DIMENSIONS.get(found[2], found[2]),
        "component": _COMPONENTS[found[1]],
        "layers": bool(found[5]),
        "multisampled": bool(found[4]),
    }


def _sampler(item: Input) -> InputEntry:
    kind = item.type or ""
    return SamplerInput(
        **_texture(item), compares="Shadow" in kind, external=kind.startswith("samplerExternalOES")
    )


def _image(item: Input) -> InputEntry:
    return ImageInput(**_texture(item))


def _counter(item: Input) -> InputEntry:
    return CounterInput(**_variable(item), binding=item.binding)


def _block(item: Input) -> dict[str, Any]:
    assert item.layout is not None
    end = max(((member.offset or 0) + member.size for member in item.members), default=0)
    return {
        "name": item.name,
        "stages": item.stages,
        "instance": item.instance,
        "dims": item.dims,
        "packing": item.layout.packing,
        "matrices": item.layout.matrices,
        "binding": item.binding,
        "size": up(end, _BUFFER_UNIT) if item.layout.packing in LAID_OUT else UNSET,
        "members": tuple(map(_member, item.members)),
        "previous_of": _or_unset(item.previous_of),
    }


def _uniform_block(item: Input) -> InputEntry:
    found = _block(item)
    twin: bool | UnsetType = UNSET
    if item.previous_of is not None:
        # Of a packed block a program may leave out what it does not read.
        twin = found["packing"] != "packed"
    return UniformBlockInput(**found, takes_the_last_buffer=twin)


def _storage_block(item: Input) -> InputEntry:
    return StorageBlockInput(**_block(item))


def _member(member: InputMember) -> MemberEntry:
    return MemberEntry(
        name=member.name,
        type=member.type,
        dims=member.dims,
        offset=_or_unset(member.offset),
        stride=_or_unset(member.stride),
        matrix_stride=_or_unset(member.matrix_stride),
        layout=member.layout or UNSET,
        read=member.read,
        members=tuple(map(_member, member.members)),
    )


def _or_unset(value: T | None) -> T | UnsetType:
    return UNSET if value is None else value


_ENTRIES: dict[InputKind, Callable[[Input], InputEntry]] = {
    "attribute": _attribute,
    "uniform": _uniform,
    "sampler": _sampler,
    "image": _image,
    "atomic counter": _counter,
    "uniform block": _uniform_block,
    "storage block": _storage_block,
}
