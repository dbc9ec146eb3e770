"""What is computed ahead of the shader proper, which must find every global as it was."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from shadercache.analysis.call_paths import Use
from shadercache.analysis.derivative_uses import SharedUse
from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.lang.types import Type
from shadercache.sema.facts import Symbol
from shadercache.source import NOWHERE

LEVELS_SINCE = 400
"""The version of GLSL that has ``textureQueryLod``."""


def movable(use: SharedUse) -> bool:
    """Can a derivative, or a fetch that takes one, be made ahead of all else?"""
    plain = use.instance.use is Use.PLAIN and use.place.use is Use.PLAIN
    moves = use.instance.order_matters or use.place.order_matters
    return plain and not moves and not (use.instance.after_exit or use.place.step.after_exit)


def left_changed(
    builder: PassBuilder, shader: Shader, entries: Sequence[str]
) -> tuple[Symbol, ...]:
    """The user's globals that some functions of a shader change, if it has these."""
    table = EffectTable(shader.module, builder.program.memo)
    names = [name for name in map(builder.own, entries) if name in table.functions]
    written = frozenset[str]().union(*(table.summary(name).writes for name in names))
    declared = builder.program.facts.declared.values()
    return tuple(s for s in declared if s.kind == "global" and s.name in written)


def variable(kind: Type, name: str, precision: str | None) -> n.VarDecl:
    """A plain global variable."""
    words = n.Qualifiers(NOWHERE, (precision,)) if precision else n.NO_QUALIFIERS
    dims = tuple(n.Literal(NOWHERE, str(size)) for size in kind.dims)
    declarator = n.Declarator(NOWHERE, name, dims)
    return n.VarDecl(NOWHERE, words, n.TypeSpec(NOWHERE, kind.name), (declarator,))


def caller(
    builder: PassBuilder, name: str, callees: Iterable[str], kept: Sequence[Symbol]
) -> n.FunctionDef:
    """A function that calls others and then gives the ``kept`` variables their old values."""
    before: list[n.Stmt] = []
    after: list[n.Stmt] = []
    for number, symbol in enumerate(kept, start=1):
        local, own = builder.own(f"kept_{number}"), n.Name(NOWHERE, symbol.name)
        dims = tuple(n.Literal(NOWHERE, str(size)) for size in symbol.type.dims)
        kind = n.TypeSpec(NOWHERE, symbol.type.name)
        copy = n.Declarator(NOWHERE, local, dims, own)
        before.append(n.DeclStmt(NOWHERE, n.VarDecl(NOWHERE, n.NO_QUALIFIERS, kind, (copy,))))
        restored = n.Assign(NOWHERE, "=", own, n.Name(NOWHERE, local))
        after.append(n.ExprStmt(NOWHERE, restored))
    calls = (n.ExprStmt(NOWHERE, n.Call(NOWHERE, callee, ())) for callee in callees)
    body = n.Block(NOWHERE, (*before, *calls, *after))
    void = n.TypeSpec(NOWHERE, "void")
    proto = n.FunctionProto(NOWHERE, n.NO_QUALIFIERS, void, builder.own(name), ())
    return n.FunctionDef(NOWHERE, proto, body)
