"""Precisions of GLSL ES: of what the compiler adds, and of all there is in proof mode.

Fragment shaders of GLSL ES have no default precision of floats and a middling one of integers and
samplers; a look-up in the cache needs every bit. The user's own declarations stay as they are; ours
are those that have no place in the source::

    uniform sampler2D sc_cache;        =>        uniform highp sampler2D sc_cache;
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.lang.types import builtin_type
from shadercache.lang.words import PRECISIONS
from shadercache.source import NOWHERE

N = TypeVar("N", bound=n.VarDecl | n.Param | n.FunctionProto)

_DEFAULTS = ("float", "int", "sampler2D", "samplerCube")


def with_precisions(module: n.Module, memo: Memo | None = None) -> n.Module:
    """The module with ``highp`` on the declarations that are not the user's, if it is GLSL ES."""
    if module.profile != "es":
        return module
    return _each(module, _Highp(), Memo() if memo is None else memo)


def all_highp(module: n.Module, memo: Memo | None = None) -> n.Module:
    """The module with ``highp`` in the place of every other precision, the default ones too."""
    defaults = (n.PrecisionDecl(NOWHERE, "highp", n.TypeSpec(NOWHERE, kind)) for kind in _DEFAULTS)
    made = _each(module, _AllHighp(), Memo() if memo is None else memo)
    return replace(made, decls=(*defaults, *made.decls))


def _each(module: n.Module, rewriter: Rewriter, memo: Memo) -> n.Module:
    """The module with every declaration rewritten, each by itself: other programs have it too."""
    kept: dict[n.Decl, tuple[n.Decl, ...]] = memo.table(type(rewriter).__name__)
    decls: list[n.Decl] = []
    for decl in module.decls:
        found = kept.get(decl)
        if found is None:
            found = rewriter.rewrite(replace(module, directives=(), decls=(decl,))).decls
            kept[decl] = found
        decls += found
    return replace(module, decls=tuple(decls))


class _AllHighp(Rewriter):
    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl | Sequence[n.Decl]:
        return replace(node, precision="highp") if isinstance(node, n.PrecisionDecl) else node

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if isinstance(node, n.DeclStmt) and isinstance(node.decl, n.PrecisionDecl):
            return replace(node, decl=replace(node.decl, precision="highp"))
        return node

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        if not isinstance(node, n.Qualifiers) or PRECISIONS.isdisjoint(node.words):
            return node
        words = ("highp" if word in PRECISIONS else word for word in node.words)
        return replace(node, words=tuple(words))


class _Highp(Rewriter):
    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl | Sequence[n.Decl]:
        return _precise(node) if isinstance(node, n.VarDecl) else node

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if isinstance(node, n.DeclStmt) and isinstance(node.decl, n.VarDecl):
            return replace(node, decl=_precise(node.decl))
        return node

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        return _precise(node) if isinstance(node, n.Param | n.FunctionProto) else node


def _precise(node: N) -> N:
    kind = builtin_type(node.type.name)
    plain = kind is None or kind.is_void or kind.base == "bool"
    if node.span.start >= 0 or plain or node.qualifiers.has(*PRECISIONS):
        return node
    words = (*node.qualifiers.words, "highp")
    return replace(node, qualifiers=replace(node.qualifiers, words=words))
