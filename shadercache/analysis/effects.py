"""What is known of a piece of program: what it reads and writes, and what else it does."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Flag, auto

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk


class Does(Flag):
    """What evaluating a piece of program may do beside reading and writing variables."""

    NOTHING = 0
    DISCARD = auto()
    RETURN = auto()
    JUMP = auto()
    """``break`` or ``continue``."""
    DERIVATIVE = auto()
    """``dFdx``, ``dFdy``, ``fwidth`` and what else needs derivatives explicitly."""
    IMPLICIT_LOD = auto()
    """A texture fetch whose level of detail comes from derivatives."""


EXITS = Does.RETURN | Does.DISCARD | Does.JUMP
"""What may skip statements that follow."""


@dataclass(frozen=True, slots=True)
class Effects:
    """Variables read and written (by name), and what else is done."""

    # Frozen, since nodes share them with their operands, and heads of functions are keyed by them.
    reads: frozenset[str] = frozenset()
    writes: frozenset[str] = frozenset()
    does: Does = Does.NOTHING

    def __or__(self, other: Effects) -> Effects:
        return Effects(self.reads | other.reads, self.writes | other.writes, self.does | other.does)


NO_EFFECTS = Effects()


def union(effects: Iterable[Effects]) -> Effects:
    """All of them together."""
    items = tuple(effects)
    if len(items) < 2:
        return items[0] if items else NO_EFFECTS
    does = Does.NOTHING
    for effect in items:
        if effect.does is not Does.NOTHING:  # Or-ing flags takes its time.
            does |= effect.does
    reads = frozenset[str]().union(*(effect.reads for effect in items))
    return Effects(reads, frozenset[str]().union(*(effect.writes for effect in items)), does)


def root_variable(target: n.Expr) -> str | None:
    """The variable that an assignment to ``target`` changes: ``v`` for ``v.xy[1]``."""
    while not isinstance(target, n.Name):
        if not isinstance(target, n.Member | n.Index):
            return None
        target = target.object
    return target.name


@dataclass(frozen=True, slots=True, eq=False)
class FunctionSummary:
    """What a caller has to know of a function. Equal ones are one and the same object."""

    effects: Effects
    live_at_entry: frozenset[str]
    """Variables of its callers that it may read before it overwrites them."""
    overwritten: frozenset[str]
    """Variables of its callers that it overwrites wholly, wherever it returns."""
    params: tuple[tuple[bool, n.TypeSpec, n.Dims], ...]
    """For each parameter: does it write back? Its type."""


@dataclass(frozen=True, slots=True, eq=False)
class Linked:
    """A function with the heads of those that it calls.

    It is the same object in every module where these are the same, so that what follows from
    them can be kept in a :class:`Memo` with it as the key.
    """

    function: n.FunctionDef
    names: frozenset[str]
    """What it declares or writes: variables of other names are the same before and behind it."""
    head: FunctionSummary


def local_names(function: n.FunctionDef) -> frozenset[str]:
    """Names of the parameters and of all variables declared in a function."""
    names = {param.name for param in function.proto.params if param.name}
    names.update(node.name for node in walk(function.body) if isinstance(node, n.Declarator))
    return frozenset(names)


def global_names(decl: n.VarDecl | n.BlockDecl) -> list[str]:
    """The global names that a declaration declares: of a block its instance, or its members."""
    if isinstance(decl, n.BlockDecl) and decl.instance is not None:
        return [decl.instance]
    decls = decl.fields if isinstance(decl, n.BlockDecl) else (decl,)
    return [variable.name for part in decls for variable in part.declarators]
