"""Proof mode: keep the driver from knowing parts of values beforehand.

A compiler evaluates ``pow(0.5, 1.5)`` itself, and to other bits than the machine does. What a cache
gives back it cannot know; so where it knows a part of the same value in the original, the two come
apart::

    vec4 t = texture(map, uv);    vec4 t = texture(map, uv);
    t.x = 0.5;                =>  t.x = 0.5 - float(gl_FragCoord.x < 0.0);
    c = pow(t, p);                c = pow(t, p);

No fragment lies left of the picture, so nothing changes but what the compiler knows. Constants are
hidden where they become values of variables, parameters, results, or parts of a larger value. As
operands they stay: what is made of them and of something unknown is unknown. Loops may need to know
where they begin, and what is ``const`` must be a constant.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewrite import Rewriter
from shadercache.ast.walk import walk
from shadercache.lang.types import builtin_type
from shadercache.source import NOWHERE

Declared: TypeAlias = tuple[str, str | None]

_SCALARS = ("int", "uint", "float")


def hide_constants(module: n.Module, memo: Memo) -> n.Module:
    """The module with constants that a compiler cannot take for known parts of values."""
    consts = _constants(module, memo)
    functions = {decl.name for decl in module.decls if isinstance(decl, n.FunctionDef)}
    kept: dict[n.FunctionDef, n.FunctionDef] = memo.table("hidden constants")
    decls: list[n.Decl] = []
    for decl in module.decls:
        if isinstance(decl, n.FunctionDef):
            if decl not in kept:
                kept[decl] = _Hider(consts, functions).rewrite(decl)
            decls.append(kept[decl])
        else:
            decls.append(decl)
    return replace(module, decls=tuple(decls))


def _constants(module: n.Module, memo: Memo) -> dict[str, str]:
    """The ``const`` names that nothing else has, and their types."""
    kept: dict[n.Decl, list[Declared]] = memo.table("declared constants")
    found: dict[str, str | None] = {}
    for decl in module.decls:
        if decl not in kept:
            kept[decl] = list(_declared(decl))
        for name, kind in kept[decl]:
            found[name] = kind if found.get(name, kind) == kind else None
    return {name: kind for name, kind in found.items() if kind is not None}


def _declared(decl: n.Decl) -> Iterator[Declared]:
    """The variables of a declaration or function, with the type of those that are constant."""
    for node in walk(decl):
        if isinstance(node, n.VarDecl):
            plain = node.qualifiers.has("const") and not node.type.dims
            for item in node.declarators:
                yield item.name, node.type.name if plain and not item.dims else None
        elif isinstance(node, n.Param) and node.name is not None:
            yield node.name, None


class _Hider(Rewriter):
    def __init__(self, consts: Mapping[str, str], functions: Iterable[str]) -> None:
        self._consts, self._functions = consts, frozenset(functions)
        self._kept: set[n.Node] = set()

    def enter(self, node: n.Node) -> n.Node | None:
        match node:
            case n.For(init=init):
                self._kept.add(init)
            case n.VarDecl() if node.qualifiers.has("const"):
                return node
        return node if node in self._kept else None

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        match node:
            case n.Conditional(then=then, other=other):
                return replace(node, then=self._hidden(then), other=self._hidden(other))
            case n.Assign(op="=", value=value):
                return replace(node, value=self._hidden(value))
            case n.Call(name=name, args=args) if name in self._functions:
                return replace(node, args=tuple(map(self._hidden, args)))
            case n.Construct(type=kind, args=args) if self._type(node) is None:
                whole = _is_float(kind.name) and not kind.dims
                return replace(node, args=tuple(self._hidden(item, whole) for item in args))
        return node

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        match node:
            case n.DeclStmt(decl=n.VarDecl() as decl) if not decl.qualifiers.has("const"):
                whole = _is_float(decl.type.name)
                items = tuple(
                    replace(item, init=self._hidden(item.init, whole)) if item.init else item
                    for item in decl.declarators
                )
                return replace(node, decl=replace(decl, declarators=items))
            case n.Return(value=value) if value is not None:
                return replace(node, value=self._hidden(value))
        return node

    def _hidden(self, value: n.Expr, integers: bool = False) -> n.Expr:
        """A constant of floats less a zero that only the machine knows; anything else as it is.

        ``integers``: they become floats where they stand, so they are hidden as well.
        """
        kind = self._type(value)
        if kind is None or not (_is_float(kind) or (integers and kind in _SCALARS)):
            return value
        x = n.Member(NOWHERE, n.Name(NOWHERE, "gl_FragCoord"), "x")
        outside = n.Binary(NOWHERE, "<", x, n.Literal(NOWHERE, "0.0"))
        zero = n.Construct(NOWHERE, n.TypeSpec(NOWHERE, kind), (outside,))
        return n.Binary(NOWHERE, "-", value, zero)

    def _type(self, value: n.Expr) -> str | None:
        """The type of a constant scalar, vector or matrix; None for what is none, or may be."""
        match value:
            case n.Literal(text=text):
                return _literal(text)
            case n.Name(name=name):
                return self._consts.get(name)
            case n.Unary(op="-" | "+", operand=operand):
                return self._type(operand)
            case n.Binary(op="+" | "-" | "*" | "/", left=left, right=right):
                one, other = self._type(left), self._type(right)
                return one if one == other and one in (*_SCALARS, "vec2", "vec3", "vec4") else None
            case n.Construct(type=kind, args=args) if not kind.dims and builtin_type(kind.name):
                return kind.name if all(map(self._type, args)) else None
        return None


def _literal(text: str) -> str | None:
    low = text.lower()
    if low.startswith("0x") or low in ("true", "false"):
        return None
    if low.endswith("lf"):
        return None
    if "." in low or "e" in low or low.endswith("f"):
        return "float"
    return "uint" if low.endswith("u") else "int"


def _is_float(name: str) -> bool:
    kind = builtin_type(name)
    return kind is not None and kind.base == "float"
