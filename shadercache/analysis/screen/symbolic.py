"""Goes through ``main`` with a term for what each variable holds (:mod:`analysis.screen.terms`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

from shadercache.analysis.effect_table import EffectTable, out_arguments
from shadercache.analysis.effects import global_names
from shadercache.analysis.screen.terms import Term, Terms, Where
from shadercache.analysis.vertex_inputs import POSITION
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts

MAX_STEPS = 50_000
"""Expressions that are gone through, each as often as it is reached."""

_SWIZZLES = ("xyzw", "rgba", "stpq")


class TooLongError(Exception):
    """The shader takes more steps than :data:`MAX_STEPS`."""


class Evaluator:
    """``run`` leaves in ``env`` what the variables hold behind ``main``."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self.facts, self.terms = facts, Terms()
        self.env: dict[str, Term] = {}
        self._table = EffectTable(module)
        self._module, self._steps = module, 0
        self._moving = {
            name
            for decl in module.decls
            if isinstance(decl, n.VarDecl | n.BlockDecl)
            and decl.qualifiers.has("uniform", "buffer")
            for name in global_names(decl)
        }
        self._returned: list[list[tuple[dict[str, Term], Term | None]]] = []

    def run(self) -> None:
        """Raises :class:`TooLongError`."""
        for decl in self._module.decls:
            if isinstance(decl, n.VarDecl) and not decl.qualifiers.has("uniform", "in", "buffer"):
                self._declare(decl)
        self._call_body(self._table.functions["main"], None)

    def _statement(self, stmt: n.Stmt) -> bool:
        """Is what comes behind the statement reached?"""
        match stmt:
            case n.ExprStmt(expr=expr) if expr is not None:
                self.value(expr)
            case n.DeclStmt(decl=n.VarDecl() as decl):
                self._declare(decl)
            case n.Block(body=body):
                # all() ends at the first one, so what stands behind a return is left out.
                return all(self._statement(part) for part in body)
            case n.If():
                return self._branch(stmt)
            case n.For() | n.While() | n.DoWhile() | n.Switch():
                self._repeated(stmt)
            case n.Return(value=value):
                result = None if value is None else self.value(value)
                self._returned[-1].append((dict(self.env), result))
                return False
        return True

    def _declare(self, decl: n.VarDecl) -> None:
        for variable in decl.declarators:
            if variable.init is not None:
                self.env[variable.name] = self.value(variable.init)
            else:
                # What an earlier call of the function left in it is not what this one finds.
                self.env.pop(variable.name, None)

    def _branch(self, stmt: n.If) -> bool:
        condition = self.value(stmt.condition)
        before = dict(self.env)
        then_goes_on = self._statement(stmt.then)
        then, self.env = self.env, dict(before)
        other_goes_on = stmt.other is None or self._statement(stmt.other)
        if then_goes_on and other_goes_on:
            self.env = self._joined([then, self.env], (condition,))
        elif then_goes_on:
            self.env = then
        return then_goes_on or other_goes_on

    def _repeated(self, stmt: n.For | n.While | n.DoWhile | n.Switch) -> None:
        """What is written there is made of what is read and of what was there."""
        effects = self._table.of(stmt)
        parts = [
            self.env.get(name) or self._leaf(name, None)
            for name in sorted(effects.reads | effects.writes)
            if name in self.env or name in self._moving
        ]
        # The position first: what is written beside it may be made of it.
        for name in sorted(effects.writes, key=lambda name: (name != POSITION, name)):
            old = self.env.get(name)
            self.env[name] = self.terms.unknown(parts, old.type if old is not None else None)
            if name == POSITION and name in effects.reads:
                parts.append(self.env[name])

    def _joined(
        self, ways: Sequence[dict[str, Term]], decides: tuple[Term, ...] = ()
    ) -> dict[str, Term]:
        names = dict.fromkeys(name for way in ways for name in way)
        return {
            name: self.terms.join([way[name] for way in ways if name in way], decides)
            for name in names
        }

    def value(self, expr: n.Expr) -> Term:
        """What an expression is; assigns on the way."""
        self._steps += 1
        if self._steps > MAX_STEPS:
            raise TooLongError
        constant = self.facts.constants.get(expr)
        kind = self.facts.types.get(expr)
        if constant is not None:
            return self.terms.make("literal", float(constant), (), kind)
        match expr:
            case n.Name(name=name):
                return self.env.get(name) or self._leaf(name, kind)
            case n.Assign(op=op, target=target):
                term = self.value(expr.value)
                if op != "=":
                    term = self._binary(op[:-1], self.value(target), term, kind)
                self._assign(target, term)
                return term
            case n.Unary(op="++" | "--", operand=place) | n.Postfix(operand=place):
                term = self.terms.unknown([self.value(place)], kind)
                self._assign(place, term)
                return term
            case n.Member() | n.Index():
                owner = self.value(expr.object)
                where = self._where(expr, owner)
                if isinstance(where, Term):
                    return self.terms.make("index", None, (owner, where), kind)
                return self.terms.part(owner, where, kind)
            case n.Binary():
                return self._chain(expr)
            case n.Call():
                return self._call(expr, kind)
            case n.Construct():
                return self._construct(expr, kind)
            case n.Conditional(condition=condition, then=then, other=other):
                decides = (self.value(condition),)
                return self.terms.join([self.value(then), self.value(other)], decides)
            case n.Comma(left=left, right=right):
                self.value(left)
                return self.value(right)
        inner = [part for part in children(expr) if isinstance(part, EXPRESSIONS)]
        parts = [self.value(cast("n.Expr", part)) for part in inner]
        return self.terms.make(type(expr).__name__, getattr(expr, "op", None), parts, kind)

    def _leaf(self, name: str, kind: Type | None) -> Term:
        return self.terms.leaf(name, kind, name in self._moving)

    def _chain(self, expr: n.Binary) -> Term:
        """``a + b + c``, however long, without recursion."""
        chain = [expr]
        while isinstance(left := chain[-1].left, n.Binary) and left not in self.facts.constants:
            chain.append(left)
        term = self.value(chain[-1].left)
        for node in reversed(chain):
            term = self._binary(node.op, term, self.value(node.right), self.facts.types.get(node))
        return term

    def _binary(self, op: str, one: Term, other: Term, kind: Type | None) -> Term:
        kinds = [term.type for term in (one, other) if term.type is not None]
        # Only products without a scalar are chains through which the projection can be found.
        matrices = any(k.is_matrix for k in kinds) and not any(k.is_scalar for k in kinds)
        if op == "*" and kind is not None and len(kinds) == 2 and matrices:
            return self.terms.multiply(one, other, kind)
        return self.terms.make(op, None, (one, other), kind)

    def _construct(self, expr: n.Construct, kind: Type | None) -> Term:
        args = [self.value(arg) for arg in expr.args]
        if len(args) == 1 and args[0].type is kind:
            return args[0]
        if kind is not None and kind.struct is not None and not kind.dims:
            return self.terms.make("struct", tuple(kind.struct.fields), args, kind)
        return self.terms.make("construct", None, args, kind)

    def _where(self, expr: n.Member | n.Index, owner: Term) -> Where | Term:
        """Which part of its owner a member or an element is; an index that is not known itself."""
        if isinstance(expr, n.Member):
            return swizzled(expr, self.facts) or expr.name
        index = self.value(expr.index)
        if index.op != "literal" or not isinstance(index.data, float):
            return index
        at = int(index.data)
        # v[0] is the component v.x, but m[0] a column and a[0] an element.
        return (at,) if owner.type is not None and owner.type.is_vector else at

    def _assign(self, target: n.Expr, value: Term) -> None:
        if isinstance(target, n.Name):
            self.env[target.name] = value
        elif isinstance(target, n.Member | n.Index):
            owner = self.value(target.object)
            where = self._where(target, owner)
            if isinstance(where, Term):
                # Any element may be the one that was written: nothing is known of the whole.
                changed = self.terms.unknown((owner, where, value), owner.type)
            else:
                changed = self.terms.insert(owner, where, value)
            self._assign(target.object, changed)

    def _call(self, call: n.Call, kind: Type | None) -> Term:
        function = self._table.functions.get(call.name)
        outs = out_arguments(call, self._table)
        args = [self.value(arg) for arg in call.args]
        if function is None:
            term = self.terms.make("call", call.name, args, kind)
            for arg, out in zip(call.args, outs, strict=True):
                if out:
                    self._assign(arg, self.terms.unknown(args, self.facts.types.get(arg)))
            return term
        names = [param.name or "" for param in function.proto.params]
        # One environment for all functions: names are unique, and none is on its way twice, for
        # GLSL has no recursion (4.60 section 6.1).
        self.env |= dict(zip(names, args, strict=True))
        term = self._call_body(function, kind)
        backs = [self.env.get(name) for name in names]
        for arg, out, back in zip(call.args, outs, backs, strict=True):
            if out and back is not None:
                self._assign(arg, back)
        return term

    def _call_body(self, function: n.FunctionDef, kind: Type | None) -> Term:
        self._returned.append([])
        goes_on = self._statement(function.body)
        ends = self._returned.pop()
        if goes_on:
            ends.append((dict(self.env), None))
        self.env = self._joined([env for env, _ in ends])
        results = [value for _, value in ends if value is not None]
        return self.terms.join(results) if results else self.terms.leaf("void", kind, False)


def swizzled(expr: n.Member, facts: Facts) -> tuple[int, ...] | None:
    """The components that a member of a vector names; ``None`` for a field."""
    kind = facts.types.get(expr.object)
    if kind is None or not (kind.is_vector or kind.is_scalar):
        return None
    letters = next((row for row in _SWIZZLES if set(expr.name) <= set(row)), None)
    return None if letters is None else tuple(map(letters.index, expr.name))
