"""Proof mode: keep the driver from knowing beforehand what a cache would not let it know.

A compiler evaluates ``pow(0.5, 1.5)`` itself where it knows the arguments, and to other bits than
the machine does. So where it knows a value of the original, or one component of it, that a variant
takes from the cache, the two come apart::

    vec4 t = vec4(v_color, 0.5);
    o = pow(t, vec4(1.5));    =>    o = pow(t - float(gl_FragCoord.x < 0.0), vec4(1.5));

Nor may it know a zero: llvmpipe takes ``0.0 * x`` for 0 whatever x is, ``precise`` or not, but zero
times infinity is NaN::

    vec3 tint = vec3(1.0, 0.5, 0.0) * s;    =>    vec3(1.0, 0.5, float(gl_FragCoord.x < 0.0)) * s;

No fragment lies left of the picture, so nothing changes but what the compiler knows: a zero that is
taken off keeps the sign of a zero. Other operations have one right result, known or not.
"""

from __future__ import annotations

from collections.abc import Iterable, Set
from dataclasses import replace
from typing import cast

from shadercache.analysis.effects import local_names
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.types import HALF, builtin_type
from shadercache.source import NOWHERE
from shadercache.transform.proof.known_values import (
    Constants,
    Known,
    is_boolean,
    is_floating,
    is_matrix,
    known_values,
)
from shadercache.transform.trees import change_declarations, change_functions

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

_HALVES = frozenset(
    (
        "GL_AMD_gpu_shader_half_float",
        "GL_EXT_shader_explicit_arithmetic_types",
        "GL_EXT_shader_explicit_arithmetic_types_float16",
    )
)
"""Extensions that have half floats."""

_COMPARISONS = ("<", ">", "<=", ">=", "==", "!=")


def make_arguments_opaque(module: n.Module, memo: Memo) -> n.Module:
    """The module with first arguments of such functions, and zeros, that no compiler knows."""
    names = INEXACT.difference(d.name for d in module.decls if isinstance(d, n.FunctionDef))
    # The smallest type there is, for it becomes any other, and none becomes it.
    number = "float" if _HALVES.isdisjoint(enabled_extensions(module)) else HALF.name
    constants = _constants({}, module.decls)

    def variable(decl: n.Decl) -> n.Decl:
        # A global whose initialiser may be any expression (GLSL ES demands a constant one).
        if module.profile == "es" or not isinstance(decl, n.VarDecl):
            return decl
        if decl.qualifiers.has("const", "uniform", "in", "out", "buffer"):
            return decl
        return _OpaqueArguments(names, constants, decl, number).rewrite(decl)

    def hidden(function: n.FunctionDef) -> n.FunctionDef:
        local = (node.decl for node in walk(function) if isinstance(node, n.DeclStmt))
        # The look-up's functions have names of their own, which may be those of users' globals.
        own = local_names(function)
        outer = {name: known for name, known in constants.items() if name not in own}
        known = _constants(outer, local)
        return _OpaqueArguments(names, known, function, number).rewrite(function)

    module = change_functions(module, hidden, memo.table("hidden arguments"))
    return change_declarations(module, variable)


def _constants(constants: Constants, decls: Iterable[n.Node]) -> Constants:
    """What is known of the values of names, those included that ``decls`` declare ``const``."""
    constants = dict(constants)
    for decl in decls:
        if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has("const"):
            continue
        for variable in decl.declarators:
            dims = len(decl.type.dims) + len(variable.dims)
            if variable.init is None or dims > 1 or builtin_type(decl.type.name) is None:
                continue
            init = known_values(variable.init, constants).get(variable.init)
            zero = init is None or init.zero
            kind = is_floating(decl.type), zero, dims == 1, is_boolean(decl.type)
            constants[variable.name] = Known(*kind)
    return constants


class _OpaqueArguments(Rewriter):
    def __init__(self, names: Set[str], constants: Constants, decl: n.Decl, number: str) -> None:
        self._names, self._constants, self._number = names, constants, number
        self._known = known_values(decl, constants)
        self._kept: set[n.Node] = set()
        self._floats: set[n.Node] = set()
        """Whole numbers that become floating-point ones."""

    def enter(self, node: n.Node) -> n.Node | None:
        """What must be constant stays: values of ``const`` and ``case``, sizes of arrays."""
        match node:
            case n.TypeSpec() | n.Case():
                return node
            case n.VarDecl(qualifiers=words) if words.has("const"):
                return node
            case n.VarDecl(type=kind, declarators=items) if is_floating(kind):
                self._floats.update(
                    variable.init for variable in items if variable.init is not None
                )
            case n.Declarator(dims=dims):
                self._kept.update(size for size in dims if size is not None)
            case n.Construct(type=kind, args=args) if is_floating(kind):
                self._floats.update(args)
            case n.Unary(op="+" | "-", operand=operand) if node in self._floats:
                self._floats.add(operand)
            case n.Binary(op=op, left=left, right=right) if op in _COMPARISONS:
                self._kept.update(side for side in (left, right) if side in self._known)
        if node in self._kept:
            return node
        known = self._known.get(node)
        return None if known is None else self._hidden(node, known)

    def _hidden(self, node: n.Node, known: Known) -> n.Node | None:
        """A constant that may have a zero, with that unknown; None is for looking into it."""
        match node:
            case _ if not known.zero or known.array:
                return node
            case n.Construct(type=kind, args=args) if is_floating(kind) and not is_matrix(kind):
                # Nothing can be added to a boolean: that is done to what is made of it.
                if not any(self._is_boolean(arg) for arg in args):
                    return None
            case n.Unary():
                return None
            case n.Literal() if known.floating or node in self._floats:
                return self._zero(known)
        # Not "-": what is taken from a zero becomes a negation, which turns the sign of a NaN.
        hidden = known.floating or (node in self._floats and not known.boolean)
        return n.Binary(NOWHERE, "+", cast("n.Expr", node), self._zero(known)) if hidden else node

    def _is_boolean(self, node: n.Expr) -> bool:
        known = self._known.get(node)
        return known is not None and known.boolean and not isinstance(node, n.Literal)

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        match original, node:
            case n.Call(args=(first, *_)), n.Call(name=name, args=args) if name in self._names:
                known = self._known.get(first)
                if known is None or not (known.zero and known.floating):
                    # Taking 0.0 off changes no number; adding it would make 0.0 of -0.0. One
                    # unknown argument is enough: no compiler evaluates the call.
                    less = n.Binary(NOWHERE, "-", args[0], _zero(self._number))
                    return replace(node, args=(less, *args[1:]))
            # The array must stay constant; what is read of it need not.
            case n.Index(object=n.Name(name=text)), _ if text in self._constants:
                known = self._constants[text]
                if known.array and known.floating and known.zero:
                    return n.Binary(NOWHERE, "+", node, _zero(self._number))
        return node

    def _zero(self, beside: Known) -> n.Expr:
        """What whole numbers become is no half float."""
        return _zero(self._number if beside.floating else "float")


def _zero(number: str) -> n.Expr:
    """A zero of this type that no compiler knows."""
    x = n.Member(NOWHERE, n.Name(NOWHERE, "gl_FragCoord"), "x")
    outside = n.Binary(NOWHERE, "<", x, n.Literal(NOWHERE, "0.0"))
    return n.Construct(NOWHERE, n.TypeSpec(NOWHERE, number), (outside,))
