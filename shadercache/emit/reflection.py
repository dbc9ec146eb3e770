"""What an engine gives a shader, with its kind, type and place: the user's part of the interface.

It is read from the checked trees of both stages; the twins of the last frame follow from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

from shadercache.ast import nodes as n
from shadercache.emit.packing import Packing, is_default
from shadercache.lang.types import StructType, Type
from shadercache.sema.facts import Facts, Stage

InputKind = Literal[
    "attribute",
    "uniform",
    "sampler",
    "image",
    "atomic counter",
    "uniform block",
    "storage block",
]

_STORAGES = ("uniform", "buffer")

MOST_MEMBERS = 1_000
"""A struct of more, all told, is given by its type alone."""


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a block or of a struct; ``layout`` as it is written on it."""

    name: str
    type: str
    layout: str = ""
    members: tuple[Member, ...] = ()


@dataclass(frozen=True, slots=True)
class Input:
    """Something that an engine gives.

    ``name`` is that of a block, not of its instance; ``dims`` are the sizes of an array of blocks,
    whose elements have a buffer each. ``location`` and ``binding`` are those that are declared.
    ``previous_of``: it wants what the one of this name had in the last frame.
    """

    kind: InputKind
    name: str
    type: str | None = None
    stages: tuple[Stage, ...] = ()
    location: int | None = None
    binding: int | None = None
    members: tuple[Member, ...] = ()
    instance: str | None = None
    dims: tuple[int, ...] = ()
    layout: Packing | None = None
    previous_of: str | None = None


def inputs_of(stages: Iterable[tuple[n.Module, Facts, Stage]]) -> tuple[Input, ...]:
    """What the stages of a program are given; what two of them declare is listed once."""
    found: dict[str, Input] = {}
    for module, facts, stage in stages:
        for item in _inputs(module, facts, stage):
            known = found.get(item.name)
            if known is None:
                found[item.name] = item
            elif known.kind != "attribute":
                found[item.name] = _joined(known, item)
    return tuple(found.values())


def _joined(one: Input, other: Input) -> Input:
    """One input that both stages declare; a place may stand in one of them only."""
    return replace(
        one,
        stages=(*one.stages, *other.stages),
        location=other.location if one.location is None else one.location,
        binding=other.binding if one.binding is None else one.binding,
    )


def with_twins(inputs: Iterable[Input], previous: Mapping[str, str]) -> tuple[Input, ...]:
    """The inputs, and the twins of those that have one (``previous``: name to twin's name).

    A twin has no location and no binding of its own, and stands in the vertex shader alone.
    """
    found = tuple(inputs)
    twins = tuple(_twin(item, previous) for item in found if item.name in previous)
    return found + twins


def _twin(item: Input, previous: Mapping[str, str]) -> Input:
    members = item.members
    if item.kind == "uniform block" and item.instance is None:
        members = tuple(replace(member, name=previous[member.name]) for member in members)
    return replace(
        item,
        name=previous[item.name],
        stages=("vertex",),
        location=None,
        binding=None,
        members=members,
        instance=previous[item.instance] if item.instance else None,
        previous_of=item.name,
    )


def _inputs(module: n.Module, facts: Facts, stage: Stage) -> Iterator[Input]:
    defaults = {storage: Packing() for storage in _STORAGES}
    for decl in module.decls:
        if isinstance(decl, n.QualifierDecl):
            for storage in _STORAGES:
                if is_default(decl, storage):
                    defaults[storage] = defaults[storage].under(decl.qualifiers)
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has(*_STORAGES):
            yield _block(decl, facts, stage, defaults)
        elif isinstance(decl, n.VarDecl) and _is_given(decl, stage):
            yield from _variables(decl, facts, stage)


def _is_given(decl: n.VarDecl, stage: Stage) -> bool:
    return decl.qualifiers.has("uniform") or (stage == "vertex" and decl.qualifiers.has("in"))


def _variables(decl: n.VarDecl, facts: Facts, stage: Stage) -> Iterator[Input]:
    for item in decl.declarators:
        kind = facts.declared[item].type
        yield Input(
            kind=_kind(kind) if decl.qualifiers.has("uniform") else "attribute",
            name=item.name,
            type=str(kind),
            stages=(stage,),
            location=_number(decl.qualifiers, "location", facts),
            binding=_number(decl.qualifiers, "binding", facts),
            members=_fields(kind),
        )


def _kind(kind: Type) -> InputKind:
    if kind.name == "atomic_uint":
        return "atomic counter"
    if kind.struct is not None or not kind.holds_opaque:
        return "uniform"
    return "image" if "image" in kind.name else "sampler"


def _fields(kind: Type) -> tuple[Member, ...]:
    if kind.struct is None or _count(kind.struct) > MOST_MEMBERS:
        return ()
    return tuple(
        Member(name, str(inner), members=_fields(inner))
        for name, inner in kind.struct.fields.items()
    )


@lru_cache
def _count(struct: StructType) -> int:
    """The members of a struct, and of those in it: forty structs of two have 2^40."""
    inner = (kind.struct for kind in struct.fields.values())
    return len(struct.fields) + sum(_count(item) for item in inner if item is not None)


def _block(decl: n.BlockDecl, facts: Facts, stage: Stage, defaults: Mapping[str, Packing]) -> Input:
    storage = next(word for word in _STORAGES if decl.qualifiers.has(word))
    dims = facts.declared[decl].type.dims if decl.instance is not None else ()
    return Input(
        kind="uniform block" if storage == "uniform" else "storage block",
        name=decl.name,
        stages=(stage,),
        binding=_number(decl.qualifiers, "binding", facts),
        members=tuple(_members(decl, facts)),
        instance=decl.instance,
        dims=tuple(size or 1 for size in dims),
        layout=defaults[storage].under(decl.qualifiers),
    )


def _members(decl: n.BlockDecl, facts: Facts) -> Iterator[Member]:
    for field in decl.fields:
        for item in field.declarators:
            if decl.instance is not None:
                struct = facts.declared[decl].type.struct
                assert struct is not None
                kind = struct.fields[item.name]
            else:
                kind = facts.declared[item].type
            yield Member(item.name, str(kind), _layout(field.qualifiers, facts), _fields(kind))


def _layout(qualifiers: n.Qualifiers, facts: Facts) -> str:
    """The inside of a member's ``layout(...)``."""
    parts = []
    for item in qualifiers.layout or ():
        number = None if item.value is None else facts.constants.get(item.value)
        parts.append(item.name if number is None else f"{item.name} = {number}")
    return ", ".join(parts)


def _number(qualifiers: n.Qualifiers, word: str, facts: Facts) -> int | None:
    found = None
    for item in qualifiers.layout or ():
        if item.name.lower() == word and item.value is not None:
            value = facts.constants.get(item.value)
            found = value if isinstance(value, int) else None
    return found
