"""The members of blocks and structs, with their places in a buffer where those are fixed."""

from __future__ import annotations

from functools import lru_cache

from msgspec import UNSET, structs

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.emit.packing import Packing
from shadercache.lang.block_layout import LAID_OUT, alignment, strides, up
from shadercache.lang.types import StructType, Type
from shadercache.manifest.interface import MemberEntry
from shadercache.sema.facts import Facts

MOST_MEMBERS = 1_000
"""A struct of more, all told, is given by its type alone."""


def block_fields(decl: n.BlockDecl, facts: Facts) -> dict[str, Type]:
    """The members of a block and their types, in order."""
    if decl.instance is not None:
        kind = facts.declared[decl].type
        assert kind.struct is not None
        return dict(kind.struct.fields)
    nodes = [node for field in decl.fields for node in field.declarators]
    return {node.name: facts.declared[node].type for node in nodes}


def block_members(
    module: n.Module, decl: n.BlockDecl, facts: Facts, packing: Packing
) -> tuple[tuple[MemberEntry, ...], int]:
    """The members of a block of a module, and where the last of them ends."""
    kinds, read = block_fields(decl, facts), _read(module, decl, facts)
    # GLSL 4.60 section 4.4.5: the alignment of a block is that of members that have none.
    every = number_of(decl.qualifiers, "align", facts)
    members: list[MemberEntry] = []
    end = last = 0
    for field in decl.fields:
        rules = packing.under(field.qualifiers)
        align = number_of(field.qualifiers, "align", facts) or every or 1
        offset = number_of(field.qualifiers, "offset", facts)
        layout = _layout(field.qualifiers, facts) or UNSET
        for node in field.declarators:
            start = end if offset is None else offset
            member, end = _member(node.name, kinds[node.name], rules, start, align)
            members.append(structs.replace(member, layout=layout, read=node.name in read))
            last = max(last, end)
    return tuple(members), last


def struct_members(kind: Type, rules: Packing | None = None) -> tuple[MemberEntry, ...]:
    """The members of a struct; with places in a buffer where ``rules`` lay it out."""
    if kind.struct is None or _count(kind.struct) > MOST_MEMBERS:
        return ()
    members: list[MemberEntry] = []
    end = 0
    for name, field in kind.struct.fields.items():
        member, end = _member(name, field, rules, end)
        members.append(member)
    return tuple(members)


def number_of(qualifiers: n.Qualifiers, word: str, facts: Facts) -> int | None:
    """What a word of a ``layout(...)`` is said to be."""
    # Of a word that stands there twice the last one holds, and case does not matter (GLSL 4.60
    # section 4.4).
    number = None
    for entry in qualifiers.layout or ():
        if entry.name.lower() == word and entry.value is not None:
            value = facts.constants.get(entry.value)
            number = value if isinstance(value, int) else None
    return number


def _member(
    name: str, kind: Type, rules: Packing | None, start: int, align: int = 1
) -> tuple[MemberEntry, int]:
    """A member that begins at ``start`` or behind it, and where it ends; both in bytes."""
    dims = tuple(size or 0 for size in kind.dims)
    # Of shared and packed blocks each implementation chooses the places (GLSL 4.60 section 4.4.5).
    if rules is None or rules.packing not in LAID_OUT:
        plain = MemberEntry(name=name, type=str(kind), members=struct_members(kind), dims=dims)
        return plain, 0
    by_rows = rules.matrices == "row_major"
    unit, size = alignment(kind, rules.packing, by_rows)
    stride, matrix_stride = strides(kind, rules.packing, by_rows)
    # `align` moves a written `offset` up as well, and never goes below what the packing asks for
    # (GLSL 4.60 section 4.4.5).
    offset = up(start, max(unit, align))
    member = MemberEntry(
        name=name,
        type=str(kind),
        members=struct_members(kind, rules),
        dims=dims,
        offset=offset,
        stride=UNSET if stride is None else stride,
        matrix_stride=UNSET if matrix_stride is None else matrix_stride,
    )
    # The buffer that is bound decides how long such an array is: it adds nothing to what is needed.
    return member, offset if kind.is_unsized else offset + size


# Forty structs that hold the next one twice have 2^40 members; each struct is counted once.
@lru_cache
def _count(struct: StructType) -> int:
    """The members of a struct, and of those in it."""
    inner = (kind.struct for kind in struct.fields.values())
    return len(struct.fields) + sum(_count(below) for below in inner if below is not None)


def _read(module: n.Module, decl: n.BlockDecl, facts: Facts) -> set[str]:
    """The members that something reads."""
    if decl.instance is None:  # Its members are names of their own.
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
    owner = member.object
    while isinstance(owner, n.Index):
        owner = owner.object
    return owner


def _layout(qualifiers: n.Qualifiers, facts: Facts) -> str:
    """The inside of a member's ``layout(...)``."""
    parts = []
    for entry in qualifiers.layout or ():
        number = None if entry.value is None else facts.constants.get(entry.value)
        parts.append(entry.name if number is None else f"{entry.name} = {number}")
    return ", ".join(parts)
