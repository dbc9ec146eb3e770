"""Proof mode: keep the driver from calculating roots, powers and sines beforehand.

A compiler evaluates ``pow(0.5, 1.5)`` itself where it knows the arguments, and to other bits than
the machine does. What a cache gives back it cannot know; so where it knows a value of the original,
or one component of it, the two come apart::

    vec4 t = vec4(v_color, 0.5);
    o = pow(t, vec4(1.5));    =>    o = pow(t - float(gl_FragCoord.x < 0.0), vec4(1.5));

No fragment lies left of the picture, so nothing changes but what the compiler knows: a zero that is
taken off keeps the sign of a zero. Other operations have one right result, known or not.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewrite import Rewriter
from shadercache.source import NOWHERE

INEXACT = frozenset(
    (
        *("pow", "exp", "log", "exp2", "log2", "sqrt", "inversesqrt"),
        *("sin", "cos", "tan", "asin", "acos", "atan"),
        *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
        *("length", "distance", "normalize", "refract"),
        *("packHalf2x16", "packUnorm2x16", "packSnorm2x16", "packUnorm4x8", "packSnorm4x8"),
    )
)
"""Built-in functions with more than one right result (GLSL 4.60, sections 4.7.1 and 8.4)."""


def hide_arguments(module: n.Module, memo: Memo) -> n.Module:
    """The module with first arguments of such functions that no compiler knows."""
    own = {decl.name for decl in module.decls if isinstance(decl, n.FunctionDef)}
    kept: dict[n.FunctionDef, n.FunctionDef] = memo.table("hidden arguments")
    decls: list[n.Decl] = []
    for decl in module.decls:
        if isinstance(decl, n.FunctionDef):
            if decl not in kept:
                kept[decl] = _Hider(INEXACT - own).rewrite(decl)
            decls.append(kept[decl])
        else:
            decls.append(decl)
    return replace(module, decls=tuple(decls))


class _Hider(Rewriter):
    def __init__(self, names: Iterable[str]) -> None:
        self._names = frozenset(names)
        self._sizes: set[n.Node] = set()

    def enter(self, node: n.Node) -> n.Node | None:
        """What must be a constant stays: values of ``const`` and ``case``, sizes of arrays."""
        match node:
            case n.VarDecl(qualifiers=words) if words.has("const"):
                return node
            case n.TypeSpec() | n.Case():
                return node
            case n.Declarator(dims=dims):
                self._sizes.update(size for size in dims if size is not None)
        return node if node in self._sizes else None

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if isinstance(node, n.Call) and node.name in self._names and node.args:
            return replace(node, args=(_less_zero(node.args[0]), *node.args[1:]))
        return node


def _less_zero(value: n.Expr) -> n.Expr:
    x = n.Member(NOWHERE, n.Name(NOWHERE, "gl_FragCoord"), "x")
    outside = n.Binary(NOWHERE, "<", x, n.Literal(NOWHERE, "0.0"))
    zero = n.Construct(NOWHERE, n.TypeSpec(NOWHERE, "float"), (outside,))
    return n.Binary(NOWHERE, "-", value, zero)
