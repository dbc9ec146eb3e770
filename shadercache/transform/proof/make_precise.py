"""Proof mode: forbid the driver to rearrange floating-point arithmetic.

Drivers fold across expressions (``(x * 2.1) * 3.3`` becomes one product), so cutting an expression
changes the last bits. With ``precise`` on every floating-point value of original and variants both
compute exactly what is written, and must agree to the bit (DESIGN section 4, law 2)::

    float f(float x) { return x * 2.1 * 3.3; }

    float f(float x) { precise float sc_result = x * 2.1 * 3.3; return sc_result; }

``precise`` needs GLSL 4.00 or GLSL ES 3.20. It goes on locals, global variables, outputs and out
parameters; a returned value and an argument of a user's function become locals first, since
``precise`` does not reach into expressions that are not assigned to a precise variable. So do the
arguments of built-in functions of matrices, which Mesa takes apart into temporaries that are not
precise; :mod:`transform.proof.write_out_matrices` has left no other arithmetic on these.
In GLSL ES everything becomes ``highp``: how exact ``mediump`` is, and where it is rounded, is up to
the driver as well.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import cast

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Linked
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import children
from shadercache.lang.types import builtin_type
from shadercache.sema.facts import Stage
from shadercache.source import NOWHERE
from shadercache.transform.proof.write_out_matrices import Types, types_for_matrices
from shadercache.transform.replace import replace_expressions
from shadercache.transform.versions.state_precisions import all_highp

_DESKTOP, _ES = 400, 320
_OUTPUTS_ONLY = 420


def precise_version(module: n.Module) -> int:
    """The version that a shader has in proof mode: the first with ``precise``, or its own."""
    return max(module.version, _ES if module.profile == "es" else _DESKTOP)


def make_precise(
    module: n.Module, prefix: str, stage: Stage = "fragment", memo: Memo | None = None
) -> n.Module:
    """The module at :func:`precise_version` with precise values and invariant varyings."""
    memo = Memo() if memo is None else memo
    functions = _functions(module, prefix, stage, memo)
    decls = tuple(
        functions[decl.name] if isinstance(decl, n.FunctionDef) else _decl(decl)
        for decl in module.decls
    )
    version = precise_version(module)
    # GLSL ES has no invariant inputs (3.20 section 4.8.1), nor has GLSL from 4.20 on.
    if stage == "vertex" or (module.profile != "es" and version < _OUTPUTS_ONLY):
        decls = tuple(_varying(decl, "out" if stage == "vertex" else "in") for decl in decls)
    made = replace(module, version=version, decls=decls)
    return all_highp(made, memo) if module.profile == "es" else made


def _functions(module: n.Module, prefix: str, stage: Stage, memo: Memo) -> dict[str, n.FunctionDef]:
    """The functions of a module with precise values, by name."""
    table = EffectTable(module, memo)
    kept: dict[Linked, n.FunctionDef] = memo.table("precise functions")
    linked = {name: table.linked(name) for name in table.functions}
    new = {name for name, item in linked.items() if item not in kept}
    types = types_for_matrices(module, new, stage, memo) if new else {}
    for name in new:
        function = table.functions[name]
        body = _Function(function, prefix, table.functions, table, types).block(function.body)
        kept[linked[name]] = replace(function, proto=_proto(function.proto), body=body)
    return {name: kept[item] for name, item in linked.items()}


def _decl(decl: n.Decl) -> n.Decl:
    match decl:
        case n.FunctionProto():
            return _proto(decl)
        case n.VarDecl():
            return _variable(decl)
        case _:
            return decl


def _proto(proto: n.FunctionProto) -> n.FunctionProto:
    params = tuple(
        replace(item, qualifiers=_with(item.qualifiers, "precise"))
        if item.writes_back and _is_float(item.type)
        else item
        for item in proto.params
    )
    return replace(proto, params=params)


def _variable(decl: n.VarDecl) -> n.VarDecl:
    words = decl.qualifiers
    if not _is_float(decl.type) or not decl.declarators or words.has("const", "uniform", "in"):
        return decl
    return replace(decl, qualifiers=_with(words, "precise"))


def _varying(decl: n.Decl, word: str) -> n.Decl:
    """Each pass has a vertex shader of its own, and all must compute the same varyings.

    Before GLSL 4.20 both stages must say so. ``precise`` comes first where both are there.
    """
    if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has(word):
        return decl
    rest = tuple(item for item in decl.qualifiers.words if item not in ("precise", "invariant"))
    first = ("precise",) if decl.qualifiers.has("precise") else ()
    return replace(decl, qualifiers=replace(decl.qualifiers, words=(*first, "invariant", *rest)))


def _with(qualifiers: n.Qualifiers, word: str) -> n.Qualifiers:
    if qualifiers.has(word):
        return qualifiers
    return replace(qualifiers, words=(word, *qualifiers.words))


def _is_float(spec: n.TypeSpec) -> bool:
    """Structs count: ``precise`` applies to their members."""
    kind = builtin_type(spec.name)
    return kind is None or kind.base in ("float", "double")


@dataclass(slots=True)
class _Function:
    """Rewrites the body of one function of a module."""

    function: n.FunctionDef
    prefix: str
    functions: dict[str, n.FunctionDef]
    table: EffectTable
    types: Types
    """Of all expressions, or empty where there are no matrices."""
    count: int = 0
    ahead: list[n.Stmt] = field(default_factory=list)
    """Statements that must come before the one at hand."""

    def block(self, block: n.Block) -> n.Block:
        body: list[n.Stmt] = []
        for stmt in block.body:
            new = self.statement(stmt)
            body += [*self.ahead, new]
            self.ahead = []
        return replace(block, body=tuple(body))

    def alone(self, stmt: n.Stmt) -> n.Stmt:
        """A statement that is the whole body of a conditional or loop."""
        return self.block(stmt if isinstance(stmt, n.Block) else n.Block(stmt.span, (stmt,)))

    def statement(self, stmt: n.Stmt) -> n.Stmt:
        match stmt:
            case n.Block():
                return self.block(stmt)
            case n.If():
                other = self.alone(stmt.other) if stmt.other else None
                return replace(stmt, then=self.alone(stmt.then), other=other)
            case n.For(init=n.DeclStmt(decl=n.VarDecl() as decl) as init):
                head = replace(init, decl=_variable(decl))
                return replace(stmt, init=head, body=self.alone(stmt.body))
            case n.For() | n.While() | n.DoWhile():
                return replace(stmt, body=self.alone(stmt.body))
            case n.Return(value=value) if value is not None:
                return self.returned(replace(stmt, value=self.expression(value)))
            case n.ExprStmt(expr=expr) if expr is not None:
                return replace(stmt, expr=self.expression(expr))
            case n.DeclStmt(decl=n.VarDecl() as decl):
                return replace(stmt, decl=self.declaration(decl))
            case _:
                return stmt

    def declaration(self, decl: n.VarDecl) -> n.VarDecl:
        items = tuple(
            replace(item, init=self.expression(item.init)) if item.init is not None else item
            for item in decl.declarators
        )
        return _variable(replace(decl, declarators=items))

    def returned(self, stmt: n.Return) -> n.Return:
        kind = self.function.proto.type
        if stmt.value is None or isinstance(stmt.value, n.Name | n.Literal) or not _is_float(kind):
            return stmt
        return replace(stmt, value=self.local(kind, (), stmt.value))

    def expression(self, expr: n.Expr) -> n.Expr:
        """Turn the arguments of the user's functions into precise locals, where order allows."""
        if any(self._order_matters(child) for child in children(expr)):
            return expr
        always = set(_unconditional(expr))

        def named(original: n.Expr, rebuilt: n.Expr) -> n.Expr:
            if original not in always:
                return rebuilt
            if isinstance(rebuilt, n.Call) and rebuilt.name in self.functions:
                params = self.functions[rebuilt.name].proto.params
                pairs = zip(params, rebuilt.args, strict=True)
                return replace(rebuilt, args=tuple(self.argument(*pair) for pair in pairs))
            return self.algebra(original, rebuilt) if self.types else rebuilt

        return replace_expressions(expr, named)

    def algebra(self, original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        """Turn the arguments of a built-in function of matrices into precise locals."""
        if not any(self._is_matrix(part) for part in (original, *children(original))):
            return rebuilt
        if isinstance(original, n.Call) and isinstance(rebuilt, n.Call):
            pairs = zip(original.args, rebuilt.args, strict=True)
            return replace(rebuilt, args=tuple(self.operand(*pair) for pair in pairs))
        return rebuilt

    def operand(self, original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        kind = self.types[original]
        simple = isinstance(rebuilt, n.Name | n.Literal) or kind.is_array or not kind.is_float
        return rebuilt if simple else self.local(n.TypeSpec(NOWHERE, kind.name), (), rebuilt)

    def _is_matrix(self, node: n.Node) -> bool:
        kind = self.types.get(cast("n.Expr", node))
        return kind is not None and kind.is_matrix

    def _order_matters(self, part: n.Node) -> bool:
        """Storing the payload (a variable of our own, read nowhere near) is no side effect."""
        return any(not name.startswith(self.prefix) for name in self.table.of(part).writes)

    def argument(self, param: n.Param, arg: n.Expr) -> n.Expr:
        simple = isinstance(arg, n.Name | n.Literal)
        if simple or param.writes_back or not _is_float(param.type):
            return arg
        return self.local(param.type, param.dims, arg)

    def local(self, kind: n.TypeSpec, dims: n.Dims, value: n.Expr) -> n.Name:
        """A new precise local that holds ``value``."""
        self.count += 1
        name = f"{self.prefix}exact_{self.count}"
        item = n.Declarator(value.span, name, dims, value)
        words = n.Qualifiers(NOWHERE, ("precise",))
        self.ahead.append(n.DeclStmt(value.span, n.VarDecl(NOWHERE, words, kind, (item,))))
        return n.Name(value.span, name)


def _unconditional(expr: n.Expr) -> list[n.Node]:
    """The parts of an expression that are always evaluated when it is."""
    found: list[n.Node] = []
    stack: list[n.Node] = [expr]
    while stack:
        item = stack.pop()
        found.append(item)
        if isinstance(item, n.Conditional):
            stack.append(item.condition)
        elif isinstance(item, n.Binary) and item.op in ("&&", "||"):
            stack.append(item.left)
        else:
            stack.extend(children(item))
    return found
