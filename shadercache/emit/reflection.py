"""What an engine gives a shader, with its kind, type and place: the user's part of the interface.

It is read from the checked trees of both stages; the twins of the last frame follow from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import isfinite
from typing import Literal, TypeAlias

from shadercache.ast import nodes as n
from shadercache.emit.block_members import (
    InputMember,
    block_members,
    joined_members,
    number_of,
    struct_members,
)
from shadercache.emit.packing import Packing, is_default
from shadercache.emit.printer import print_node
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.fold import Value, flattened, fold_construct

InputKind = Literal[
    "attribute",
    "uniform",
    "sampler",
    "image",
    "atomic counter",
    "uniform block",
    "storage block",
]

Default: TypeAlias = tuple[float, ...] | str
"""The numbers of an initialiser, or its text where only a driver knows them."""

_STORAGES = ("uniform", "buffer")


@dataclass(frozen=True, slots=True)
class Input:
    """Something that an engine gives.

    ``name`` is that of a block, not of its instance; ``dims`` are the sizes of an array; the
    elements of an array of blocks have a buffer each. ``location`` and ``binding`` are those that
    are declared. ``previous_of``: it wants what the one of this name had in the last frame.
    ``default``: what the shaders initialise it with.
    """

    kind: InputKind
    name: str
    type: str | None = None
    stages: tuple[Stage, ...] = ()
    location: int | None = None
    binding: int | None = None
    members: tuple[InputMember, ...] = ()
    instance: str | None = None
    dims: tuple[int, ...] = ()
    layout: Packing | None = None
    previous_of: str | None = None
    default: Default | None = None


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
        members=joined_members(one.members, other.members),
        default=other.default if one.default is None else one.default,
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
            yield _block(decl, module, facts, stage, defaults)
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
            location=number_of(decl.qualifiers, "location", facts),
            binding=number_of(decl.qualifiers, "binding", facts),
            members=struct_members(kind),
            dims=tuple(size or 0 for size in kind.dims),
            default=_default(item.init, facts),
        )


def _kind(kind: Type) -> InputKind:
    if kind.name == "atomic_uint":
        return "atomic counter"
    if kind.struct is not None or not kind.holds_opaque:
        return "uniform"
    return "image" if "image" in kind.name else "sampler"


def _block(
    decl: n.BlockDecl,
    module: n.Module,
    facts: Facts,
    stage: Stage,
    defaults: Mapping[str, Packing],
) -> Input:
    storage = next(word for word in _STORAGES if decl.qualifiers.has(word))
    dims = facts.declared[decl].type.dims if decl.instance is not None else ()
    layout = defaults[storage].under(decl.qualifiers)
    return Input(
        kind="uniform block" if storage == "uniform" else "storage block",
        name=decl.name,
        stages=(stage,),
        binding=number_of(decl.qualifiers, "binding", facts),
        members=block_members(module, decl, facts, layout),
        instance=decl.instance,
        dims=tuple(size or 1 for size in dims),
        layout=layout,
    )


def _default(init: n.Expr | None, facts: Facts) -> Default | None:
    """The numbers of an initialiser, or its text where only the driver knows them."""
    if init is None:
        return None
    value = _value(init, facts)
    numbers = () if value is None else tuple(map(float, flattened(value)))
    return numbers if numbers and all(map(isfinite, numbers)) else print_node(init)


def _value(expr: n.Expr, facts: Facts) -> Value | None:
    known: Value | None = facts.constants.get(expr)
    if known is not None or not isinstance(expr, n.Construct):
        return known
    parts = [_value(part, facts) for part in expr.args]
    values = [part for part in parts if part is not None]
    return fold_construct(facts.types[expr], values) if len(values) == len(parts) else None
