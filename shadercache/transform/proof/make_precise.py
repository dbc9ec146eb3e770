"""Proof mode: forbid the driver to rearrange floating-point arithmetic.

Drivers fold across expressions (``(x * 2.1) * 3.3`` becomes one product), so cutting an expression
changes the last bits. With ``precise`` on every floating-point value of original and variants both
compute exactly what is written, and must agree to the bit (law 2 of CONTRIBUTING.md)::

    float f(float x) { return x * 2.1 * 3.3; }

    float f(float x) { precise float sc_result = x * 2.1 * 3.3; return sc_result; }

``precise`` needs GLSL 4.00 or GLSL ES 3.20. It goes on locals, global variables, outputs and out
parameters of every type, since a rounding decides about booleans and integers too; a returned
value, an argument of a user's function and a condition become locals first, since ``precise`` does
not reach into expressions that are not assigned to a precise variable. So do the arguments of
built-in functions of matrices, which Mesa takes apart into temporaries that are not precise;
:mod:`transform.proof.write_out_matrices` has left no other arithmetic on these. What only some
fragments evaluate, behind ``?:``, ``&&`` and ``||``, stays where it is.
In GLSL ES everything becomes ``highp``: how exact ``mediump`` is, and where it is rounded, is up to
the driver as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import cast

from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter, replace_expressions
from shadercache.ast.walk import children, walk
from shadercache.lang.types import FLOATS, builtin_type
from shadercache.sema.facts import Stage
from shadercache.source import NOWHERE
from shadercache.transform.proof.write_out_matrices import Types, rewrite_linked
from shadercache.transform.trees import block_of, change_declarations, declared, unconditional
from shadercache.transform.versions.state_precisions import all_highp

_DESKTOP, _ES = 400, 320
_OUTPUTS_ONLY = 420
# Not `%` or `&`: they work on integers, which have one right result.
_ARITHMETIC = frozenset("+-*/")
_BOOL = n.TypeSpec(NOWHERE, "bool")
_PRECISE = n.Qualifiers(NOWHERE, ("precise",))


def precise_version(module: n.Module) -> int:
    """The version that a shader has in proof mode: the first with ``precise``, or its own."""
    return max(module.version, _ES if module.profile == "es" else _DESKTOP)


def make_precise(module: n.Module, prefix: str, stage: Stage, memo: Memo) -> n.Module:
    """The module at :func:`precise_version` with precise values and invariant varyings."""

    def precise(function: n.FunctionDef, table: EffectTable, types: Types) -> n.FunctionDef:
        body = _PreciseBody(function.proto.type, prefix, table, types).rewrite(function.body)
        return replace(function, proto=_proto(function.proto), body=body)

    version = precise_version(module)
    # GLSL ES has no invariant inputs (3.20 section 4.8.1), nor has GLSL from 4.20 on.
    exact_inputs = module.profile != "es" and version < _OUTPUTS_ONLY
    varyings = ("out",) if stage == "vertex" else ("in",) * exact_inputs

    def declaration(decl: n.Decl) -> n.Decl:
        match decl:
            case n.FunctionProto():
                return _proto(decl)
            case n.VarDecl():
                decl = _variable(decl)
                return _varying(decl) if decl.qualifiers.has(*varyings) else decl
        return decl

    module = rewrite_linked(module, stage, memo.table("precise functions"), precise, memo)
    module = replace(change_declarations(module, declaration), version=version)
    return all_highp(module, memo) if module.profile == "es" else module


def _proto(proto: n.FunctionProto) -> n.FunctionProto:
    params = tuple(
        replace(param, qualifiers=_with_precise(param.qualifiers))
        if param.writes_back and _has_value(param.type)
        else param
        for param in proto.params
    )
    return replace(proto, params=params)


def _variable(decl: n.VarDecl) -> n.VarDecl:
    words = decl.qualifiers
    if not _has_value(decl.type) or not decl.declarators or words.has("const", "uniform", "in"):
        return decl
    return replace(decl, qualifiers=_with_precise(words))


def _varying(decl: n.VarDecl) -> n.VarDecl:
    """Each pass has a vertex shader of its own, and all must compute the same varyings.

    Before GLSL 4.20 both stages must say so. ``precise`` comes first where both are there.
    """
    rest = tuple(word for word in decl.qualifiers.words if word not in ("precise", "invariant"))
    first = ("precise",) if decl.qualifiers.has("precise") else ()
    return replace(decl, qualifiers=replace(decl.qualifiers, words=(*first, "invariant", *rest)))


def _with_precise(qualifiers: n.Qualifiers) -> n.Qualifiers:
    if qualifiers.has("precise"):
        return qualifiers
    return replace(qualifiers, words=("precise", *qualifiers.words))


def _has_value(spec: n.TypeSpec) -> bool:
    """Structs count: ``precise`` applies to their members."""
    kind = builtin_type(spec.name)
    return kind is None or kind.base is not None


def _is_float(spec: n.TypeSpec) -> bool:
    kind = builtin_type(spec.name)
    return kind is None or kind.base in FLOATS


def _computes(expr: n.Expr) -> bool:
    """Is there anything in an expression that a driver may rearrange?"""
    return any(
        isinstance(node, n.Call) or (isinstance(node, n.Binary) and node.op in _ARITHMETIC)
        for node in walk(expr)
    )


class _PreciseBody(Rewriter):
    """Rewrites the statements of one function that returns a ``result``.

    ``types`` are those of all expressions, or empty where there are no matrices.
    """

    def __init__(self, result: n.TypeSpec, prefix: str, table: EffectTable, types: Types) -> None:
        self._result, self._prefix, self._table, self._types = result, prefix, table, types
        self._count = 0
        self._ahead: list[n.Stmt] = []
        """Statements that must come before the one at hand."""

    def enter(self, node: n.Node) -> n.Node | None:
        match node:
            case n.For(init=n.DeclStmt(decl=n.VarDecl() as decl) as init):
                return self._loop(replace(node, init=replace(init, decl=_variable(decl))))
            case n.For() | n.While() | n.DoWhile():
                return self._loop(node)
            case n.Block() | n.If() | n.Switch() | n.Return() | n.ExprStmt() | n.DeclStmt():
                return None
        return node

    def _loop(self, loop: n.For | n.While | n.DoWhile) -> n.Stmt:
        """A loop's condition is computed in every round, so it is assigned where it stands."""
        loop = replace(loop, body=self.rewrite(block_of(loop.body)))
        condition = loop.condition
        if isinstance(condition, n.VarDecl):
            return cast("n.Stmt", replace(cast("n.While", loop), condition=_variable(condition)))
        if condition is None or not _computes(condition):
            return loop
        name = self._fresh()
        known = n.Assign(condition.span, "=", n.Name(condition.span, name), condition)
        flag = declared(_PRECISE, _BOOL, n.Declarator(NOWHERE, name))
        return n.Block(loop.span, (flag, replace(loop, condition=known)))

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        match node:
            case n.If(condition=condition, then=then, other=other):
                known, other = self._condition(condition), other and block_of(other)
                node = replace(node, condition=known, then=block_of(then), other=other)
            case n.Switch(selector=selector):
                node = replace(node, selector=self._selector(selector))
            case n.DeclStmt(decl=n.VarDecl() as decl):
                node = replace(node, decl=_variable(self._initialised(decl)))
            case n.ExprStmt(expr=expr) if expr is not None:
                node = replace(node, expr=self._expression(expr))
            case n.Return(value=value) if value is not None:
                value = self._expression(value)
                if _is_float(self._result) or _computes(value):
                    value = self._local(self._result, (), value)
                node = replace(node, value=value)
        ahead, self._ahead = self._ahead, []
        return (*ahead, node) if ahead else node

    def _condition(self, condition: n.Expr) -> n.Expr:
        known = self._expression(condition)
        return self._local(_BOOL, (), known) if _computes(known) else known

    def _initialised(self, decl: n.VarDecl) -> n.VarDecl:
        variables = (
            replace(variable, init=self._expression(variable.init)) if variable.init else variable
            for variable in decl.declarators
        )
        return replace(decl, declarators=tuple(variables))

    def _expression(self, expr: n.Expr) -> n.Expr:
        """Turn arguments of the user's functions, and what decides a choice, into precise locals,
        where order allows."""
        # Storing the payload (a variable of our own, read nowhere near) is no side effect.
        written = {name for child in children(expr) for name in self._table.of(child).writes}
        # Of any other write the arguments that are moved ahead might see the old value.
        if not all(name.startswith(self._prefix) for name in written):
            return expr
        always = set(unconditional(expr))

        def named(original: n.Expr, rebuilt: n.Expr) -> n.Expr:
            if original not in always:
                return rebuilt
            if isinstance(rebuilt, n.Conditional) and _computes(rebuilt.condition):
                return replace(rebuilt, condition=self._local(_BOOL, (), rebuilt.condition))
            if not isinstance(rebuilt, n.Call):
                return rebuilt
            originals = cast("tuple[n.Expr, ...]", children(original))
            if rebuilt.name in self._table.functions:
                params = self._table.functions[rebuilt.name].proto.params
                named_args = map(self._argument, params, rebuilt.args)
            elif any(map(self._is_matrix, (original, *originals))):
                named_args = map(self._operand, originals, rebuilt.args)
            else:
                return rebuilt
            return replace(rebuilt, args=tuple(named_args))

        return replace_expressions(expr, named)

    def _selector(self, expr: n.Expr) -> n.Expr:
        """What a ``switch`` goes by. Floats become whole numbers by ``int`` or ``uint``."""

        def named(original: n.Expr, rebuilt: n.Expr) -> n.Expr:
            if isinstance(rebuilt, n.Construct) and rebuilt.type.name in ("int", "uint"):
                return self._local(rebuilt.type, (), rebuilt)
            return rebuilt

        return replace_expressions(self._expression(expr), named)

    def _is_matrix(self, expr: n.Expr) -> bool:
        return expr in self._types and self._types[expr].is_matrix

    def _argument(self, param: n.Param, arg: n.Expr) -> n.Expr:
        # What is written back needs its place, and there are no variables of textures. Whole
        # numbers are exact where nothing is computed.
        kind = builtin_type(param.type.name)
        opaque = kind is not None and kind.is_opaque
        if param.writes_back or opaque or not (_is_float(param.type) or _computes(arg)):
            return arg
        return self._local(param.type, param.dims, arg)

    def _operand(self, original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        kind = self._types[original]
        if kind.is_array or not kind.is_float:
            return rebuilt
        return self._local(n.TypeSpec(NOWHERE, kind.name), (), rebuilt)

    def _local(self, kind: n.TypeSpec, dims: n.Dims, value: n.Expr) -> n.Expr:
        """A new precise local that holds a value, unless that is exact as it stands."""
        if isinstance(value, n.Name | n.Literal):
            return value
        # ``precise`` is about what is assigned (GLSL 4.60 section 4.9): so an argument must be.
        name = self._fresh()
        variable = n.Declarator(value.span, name, dims, value)
        self._ahead.append(declared(_PRECISE, kind, variable, value.span))
        return n.Name(value.span, name)

    def _fresh(self) -> str:
        self._count += 1
        return f"{self._prefix}exact_{self._count}"
