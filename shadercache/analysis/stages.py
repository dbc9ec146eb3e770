"""How the outputs of a vertex shader meet the inputs of a fragment shader.

Two variables match by their locations where both have one, whatever their names (GLSL 4.60 section
4.4.1, from 4.10 and ES 3.10 on), else by their names; blocks by their block names, or member by
member where these have locations.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.sema.storage import PER_VERTEX, of_one_vertex
from shadercache.source import Source

Links = Mapping[str, frozenset[str]]
"""A name of the fragment shader (of a varying, a block, its instance, its member) -> the variables
of the vertex shader that it gets its value from."""

_PLACES = ("location", "component")
_SEPARATE = ("GL_ARB_separate_shader_objects", "GL_ARB_enhanced_layouts")

Place: TypeAlias = tuple[int, int]
"""Location and component."""

Key: TypeAlias = tuple[str | None, str]
"""The name of a block, or of its instance, if there is one; and that of a variable or member."""


@dataclass(frozen=True, slots=True)
class StageSide:
    """One stage of a program, with unique names."""

    module: n.Module
    facts: Facts
    source: Source


@dataclass(frozen=True, slots=True, eq=False)
class Varying:
    """A varying, or a member of a block of them; ``name``: the variable that holds it."""

    label: str
    name: str
    type: Type
    place: Place | None
    decl: n.VarDecl | n.BlockDecl
    node: n.Node

    @property
    def block(self) -> str | None:
        """The name of its block."""
        return self.decl.name if isinstance(self.decl, n.BlockDecl) else None

    @property
    def key(self) -> Key:
        """By what it matches another without a place."""
        return self.block, self.label

    @property
    def used(self) -> Key:
        """By what its shader uses it: the instance of its block, if there is one, and its name."""
        return (self.decl.instance if isinstance(self.decl, n.BlockDecl) else None), self.label


Pairs = Sequence[tuple[Varying, Varying]]
"""Inputs of the fragment shader, each with the output of the vertex shader that it is."""


def match_stages(fragment: StageSide, vertex: StageSide) -> Pairs:
    """Which outputs of the vertex shader the inputs of the fragment shader are.

    Raises :class:`InputError` SC406 for a varying that is read and is missing, or of another type.
    """
    outputs = [*_varyings(vertex, "out")]
    placed = {varying.place: varying for varying in outputs if varying.place is not None}
    named = {varying.key: varying for varying in outputs}
    used = _used(fragment.module)
    pairs: list[tuple[Varying, Varying]] = []
    problems: list[Diagnostic] = []
    for varying in _varyings(fragment, "in"):
        output = None if varying.place is None else placed.get(varying.place)
        by_place, by_name = output is not None, named.get(varying.key)
        # Names count where one side has no place: two different places are two varyings.
        if output is None and by_name is not None and None in (varying.place, by_name.place):
            output = by_name
        if output is not None and _same(varying.type, output.type, by_place):
            pairs.append((varying, output))
        # What is declared and never read needs no counterpart (GLSL 4.60 section 4.3.4).
        elif varying.name in used:
            problem = _problem(varying, output, named, vertex.source.name)
            problems.append(Diagnostic("SC406", problem, fragment.source, varying.node.span))
    if problems:
        raise InputError(problems)
    return pairs


def links_of(pairs: Pairs) -> Links:
    """The variables that each name of the fragment shader gets its value from."""
    links: dict[str, set[str]] = {}
    for ours, theirs in pairs:
        for name in filter(None, (ours.name, ours.block)):
            links.setdefault(name, set()).add(theirs.name)
    return {name: frozenset(names) for name, names in links.items()}


def next_location(side: StageSide, word: str) -> int:
    """The first location behind those of a stage's inputs or outputs (``word``: in, out)."""
    placed = (one for one in _varyings(side, word) if one.place is not None)
    return max((one.place[0] + one.type.slots for one in placed if one.place), default=0)


def spare_locations(side: StageSide, word: str, names: Collection[str]) -> dict[str, int]:
    """A location behind those of a stage's inputs or outputs for another one of each of these."""
    at, found = next_location(side, word), dict[str, int]()
    for one in _varyings(side, word):
        if one.name in names:
            found[one.name] = at
            at += one.type.slots
    return found


def _problem(
    varying: Varying, output: Varying | None, named: Mapping[Key, Varying], other: str
) -> str:
    """Why no output, or not this one, goes with an input."""
    if output is not None:
        called = f" ('{output.label}')" if output.label != varying.label else ""
        return f"'{varying.label}' is {varying.type} here and {output.type} in {other}{called}"
    if varying.key not in named and varying.block in {
        block for block, _ in named if block is not None
    }:
        return f"the block '{varying.block}' has no '{varying.label}' in {other}"
    where = f" at location {varying.place[0]}" if varying.place and varying.key in named else ""
    return f"{other} does not write '{varying.label}'{where}"


def _same(one: Type, other: Type, any_name: bool, known: set[object] | None = None) -> bool:
    """The same type? (A struct without a name is any that has the same members.)"""
    known = set() if known is None else known
    sizes = zip(one.dims, other.dims, strict=False)
    if len(one.dims) != len(other.dims) or any(None not in s and s[0] != s[1] for s in sizes):
        return False
    if one.struct is None or other.struct is None:
        return one.name == other.name
    if not any_name and one.name and other.name and one.name != other.name:
        return False
    # Once is enough: with two members of one struct at each level it would be 2^depth times.
    if (one.struct, other.struct) in known:
        return True
    known.add((one.struct, other.struct))
    ours, theirs = one.struct.fields, other.struct.fields
    return [*ours] == [*theirs] and all(
        _same(ours[name], theirs[name], any_name, known) for name in ours
    )


def _used(module: n.Module) -> set[str]:
    return {
        node.name
        for decl in module.decls
        if isinstance(decl, n.FunctionDef | n.VarDecl)
        for node in walk(decl)
        if isinstance(node, n.Name)
    }


# --- what a stage declares ------------------------------------------------------------------------


def _varyings(side: StageSide, word: str) -> Iterator[Varying]:
    for decl in side.module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has(word):
            for variable in decl.declarators:
                if not variable.name.startswith("gl_"):
                    kind = of_one_vertex(side.facts.declared[variable].type, decl.qualifiers)
                    place = _place(decl.qualifiers, side.facts)
                    yield Varying(variable.name, variable.name, kind, place, decl, variable)
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has(word) and not _is_builtin(decl):
            yield from _members(decl, side.facts)


def _is_builtin(block: n.BlockDecl) -> bool:
    return block.name.startswith("gl_")


def _members(block: n.BlockDecl, facts: Facts) -> Iterator[Varying]:
    """One behind the other, unless they say otherwise; an array of blocks goes by its name."""
    array = bool(block.dims) and not block.qualifiers.has(*PER_VERTEX)
    at = None if array else _place(block.qualifiers, facts)
    for decl in block.fields:
        at = (None if array else _place(decl.qualifiers, facts)) or at
        for field in decl.declarators:
            kind = of_one_vertex(_member_type(block, field, facts), decl.qualifiers)
            yield Varying(field.name, block.instance or field.name, kind, at, block, field)
            at = at and (at[0] + kind.slots, 0)


def _member_type(block: n.BlockDecl, field: n.Declarator, facts: Facts) -> Type:
    if block.instance is None:
        return facts.declared[field].type
    held = facts.declared[block].type.struct
    assert held is not None
    return held.fields[field.name]


def _place(qualifiers: n.Qualifiers, facts: Facts) -> Place | None:
    places = {
        entry.name.lower(): int(facts.constants[entry.value])
        for entry in qualifiers.layout or ()
        if entry.value is not None and entry.name.lower() in _PLACES
    }
    return (places["location"], places.get("component", 0)) if "location" in places else None


# --- where one stage alone has places -------------------------------------------------------------


def aligned(vertex: StageSide, fragment: StageSide) -> n.Module:
    """The vertex shader with places where the fragment shader has them: drivers may not find what
    only one of them places, though the names are the same."""
    theirs = {varying.key: varying for varying in _varyings(fragment, "in")}
    changed: dict[n.Decl, n.Decl] = {}
    for varying in _varyings(vertex, "out"):
        other = theirs.get(varying.key)
        if other is None or (varying.place is None) == (other.place is None):
            continue
        # Places can be taken away in any version, but given only from 4.10 and ES 3.10 on.
        if other.place is None or _takes_places(vertex.module):
            changed[varying.decl] = _placed_like(varying.decl, other.decl)
    if not changed:
        return vertex.module
    decls = tuple(changed.get(decl, decl) for decl in vertex.module.decls)
    return replace(vertex.module, decls=decls)


def _takes_places(module: n.Module) -> bool:
    since = 310 if module.profile == "es" else 410
    extensions = enabled_extensions(module)
    return module.version >= since or not extensions.isdisjoint(_SEPARATE)


def _placed_like(decl: n.VarDecl | n.BlockDecl, other: n.VarDecl | n.BlockDecl) -> n.Decl:
    qualifiers = _with_places(decl.qualifiers, other.qualifiers)
    if isinstance(decl, n.VarDecl) or isinstance(other, n.VarDecl):
        return replace(decl, qualifiers=qualifiers)
    fields = decl.fields
    if len(fields) == len(other.fields):
        fields = tuple(
            replace(ours, qualifiers=_with_places(ours.qualifiers, theirs.qualifiers))
            for ours, theirs in zip(fields, other.fields, strict=True)
        )
    return replace(decl, qualifiers=qualifiers, fields=fields)


def _with_places(ours: n.Qualifiers, theirs: n.Qualifiers) -> n.Qualifiers:
    placed = tuple(entry for entry in theirs.layout or () if entry.name.lower() in _PLACES)
    kept = tuple(entry for entry in ours.layout or () if entry.name.lower() not in _PLACES)
    return replace(ours, layout=(*placed, *kept) or None)
