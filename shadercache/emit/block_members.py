"""The members of blocks and structs, as an engine is told of them: with their places in a buffer
where the language fixes these."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.emit.packing import Packing
from shadercache.lang.block_layout import LAID_OUT, alignment, strides, up
from shadercache.lang.types import StructType, Type
from shadercache.sema.facts import Facts

MOST_MEMBERS = 1_000
"""A struct of more, all told, is given by its type alone."""


@dataclass(frozen=True, slots=True)
class InputMember:
    """A member of a block or of a struct; ``layout`` as it is written on it.

    ``offset``, ``size`` and strides are bytes, from the beginning of the block or struct; ``None``
    where only a driver knows them. ``read``: does a program read it?
    """

    name: str
    type: str
    layout: str = ""
    members: tuple[InputMember, ...] = ()
    dims: tuple[int, ...] = ()
    offset: int | None = None
    size: int = 0
    stride: int | None = None
    matrix_stride: int | None = None
    read: bool = True


def block_fields(decl: n.BlockDecl, facts: Facts) -> dict[str, Type]:
    """The members of a block and their types, in order."""
    if decl.instance is not None:
        kind = facts.declared[decl].type
        assert kind.struct is not None
        return dict(kind.struct.fields)
    nodes = [node for field in decl.fields for node in field.declarators]
    return {node.name: facts.declared[node].type for node in nodes}


def block_members(
    module: n.Module, decl: n.BlockDecl, facts: Facts, layout: Packing
) -> tuple[InputMember, ...]:
    """The members of a block of a module."""
    kinds, read = block_fields(decl, facts), _read(module, decl, facts)
    every = number_of(decl.qualifiers, "align", facts)
    found: list[InputMember] = []
    end = 0
    for field in decl.fields:
        rules = layout.under(field.qualifiers)
        align = number_of(field.qualifiers, "align", facts) or every or 1
        offset = number_of(field.qualifiers, "offset", facts)
        for item in field.declarators:
            start = end if offset is None else offset
            member = _member(item.name, kinds[item.name], rules, start, align)
            text = _layout(field.qualifiers, facts)
            found.append(replace(member, layout=text, read=item.name in read))
            end = (member.offset or 0) + member.size
    return tuple(found)


def struct_members(kind: Type, rules: Packing | None = None) -> tuple[InputMember, ...]:
    """The members of a struct; with places in a buffer where ``rules`` lay it out."""
    if kind.struct is None or _count(kind.struct) > MOST_MEMBERS:
        return ()
    return tuple(_fields(kind.struct.fields, rules))


def joined_members(
    one: tuple[InputMember, ...], other: tuple[InputMember, ...]
) -> tuple[InputMember, ...]:
    """Those of a block of two stages."""
    read = {member.name for member in other if member.read}
    return tuple(replace(member, read=member.read or member.name in read) for member in one)


def number_of(qualifiers: n.Qualifiers, word: str, facts: Facts) -> int | None:
    """What a word of a ``layout(...)`` is said to be."""
    found = None
    for item in qualifiers.layout or ():
        if item.name.lower() == word and item.value is not None:
            value = facts.constants.get(item.value)
            found = value if isinstance(value, int) else None
    return found


def _fields(fields: Mapping[str, Type], rules: Packing | None) -> Iterator[InputMember]:
    end = 0
    for name, kind in fields.items():
        member = _member(name, kind, rules, end)
        end = (member.offset or 0) + member.size
        yield member


def _member(
    name: str, kind: Type, rules: Packing | None, start: int, align: int = 1
) -> InputMember:
    """A member that begins at ``start`` or behind it."""
    dims = tuple(size or 0 for size in kind.dims)
    if rules is None or rules.packing not in LAID_OUT:
        return InputMember(name, str(kind), members=struct_members(kind), dims=dims)
    by_rows = rules.matrices == "row_major"
    unit, size = alignment(kind, rules.packing, by_rows)
    stride, matrix_stride = strides(kind, rules.packing, by_rows)
    return InputMember(
        name,
        str(kind),
        members=struct_members(kind, rules),
        dims=dims,
        offset=up(start, max(unit, align)),
        size=0 if kind.is_unsized else size,
        stride=stride,
        matrix_stride=matrix_stride,
    )


@lru_cache
def _count(struct: StructType) -> int:
    """The members of a struct, and of those in it: forty structs of two have 2^40."""
    inner = (kind.struct for kind in struct.fields.values())
    return len(struct.fields) + sum(_count(item) for item in inner if item is not None)


def _read(module: n.Module, decl: n.BlockDecl, facts: Facts) -> set[str]:
    """The members that something reads."""
    if decl.instance is None:
        return {s.name for s in facts.symbols.values() if s.block is decl and s.kind != "block"}
    own = facts.declared[decl]
    return {
        node.name
        for node in walk(module)
        if isinstance(node, n.Member)
        and isinstance(owner := _owner(node), n.Name)
        and facts.symbols.get(owner) is own
    }


def _owner(member: n.Member) -> n.Expr:
    """What a member is of, apart from its place in an array."""
    found = member.object
    while isinstance(found, n.Index):
        found = found.object
    return found


def _layout(qualifiers: n.Qualifiers, facts: Facts) -> str:
    """The inside of a member's ``layout(...)``."""
    parts = []
    for item in qualifiers.layout or ():
        number = None if item.value is None else facts.constants.get(item.value)
        parts.append(item.name if number is None else f"{item.name} = {number}")
    return ", ".join(parts)
