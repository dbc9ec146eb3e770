"""The trips of a loop, found out before it runs: which values its counters have in each.

Only a ``for`` whose head declares its counters and begins, ends and steps by constants has them;
the counters of loops around it count as constants. Calculated as GLSL does: integers wrap, floats
are rounded to 32 bits after every step.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import expressions
from shadercache.sema import fold
from shadercache.sema.conversions import Conversions
from shadercache.sema.facts import Facts, Scalar

Counters: TypeAlias = Mapping[str, Scalar]

COUNTABLE = ("int", "uint", "float")


class UncountableError(Exception):
    """The trips are not known before the loop runs; says why."""


class TripCounter:
    """Counts the trips of loops of one checked module with unique names."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._facts = facts
        self._conversions = Conversions(module.version, module.profile == "es")

    def decision(self, condition: n.Expr, known: Counters) -> bool | None:
        """Does a condition hold in a trip? ``None`` where that is not known before.

        Not for floats, which a driver may calculate with more bits.
        """
        for part in expressions(condition):
            if self._facts.types[part].is_float:
                return None
        found = self.value(condition, known)
        return None if found is None else bool(found)

    def trips(self, loop: n.For, around: Counters, limit: int) -> list[Counters]:
        """The values of the loop's own counters in each trip.

        ``around`` are the counters of the loops that it stands in. Raises
        :class:`UncountableError`, for more than ``limit`` trips too.
        """
        if not isinstance(loop.condition, n.Expr):
            raise UncountableError("it has no condition that ends it")
        own = self._first(loop, around)
        found: list[Counters] = []
        while True:
            goes_on = self.value(loop.condition, {**around, **own})
            if goes_on is None:
                raise UncountableError(
                    "its condition does not hang on its counters and constants alone"
                )
            if not goes_on:
                return found
            found.append(own)
            if len(found) > limit:
                raise UncountableError(f"it makes more than {limit} trips")
            own = own if loop.step is None else self._stepped(loop.step, around, own)

    def _first(self, loop: n.For, around: Counters) -> Counters:
        match loop.init:
            case n.DeclStmt(decl=n.VarDecl(declarators=items)) if items:
                pass
            case _:
                raise UncountableError("it does not declare its counter")
        own: dict[str, Scalar] = {}
        for item in items:
            kind = self._facts.declared[item].type
            value = None if item.init is None else self.value(item.init, {**around, **own})
            if value is None or not kind.is_scalar or kind.base not in COUNTABLE:
                raise UncountableError("a counter does not begin with a constant number")
            own[item.name] = _fitting(value, kind.base)
        return own

    def _stepped(self, step: n.Expr, around: Counters, own: Counters) -> Counters:
        match step:
            case n.Comma(left=left, right=right):
                return self._stepped(right, around, self._stepped(left, around, own))
            case (
                n.Unary(op="++" | "--" as op, operand=n.Name(name=name) as target)
                | n.Postfix(op=op, operand=n.Name(name=name) as target)
            ) if name in own:
                value: Scalar | None = own[name] + (1 if op == "++" else -1)
            case n.Assign(op=op, target=n.Name(name=name) as target) if name in own:
                value = self._assigned(step, {**around, **own})
            case _:
                raise UncountableError("its step does more than count by constants")
        if value is None:
            raise UncountableError("its step does more than count by constants")
        return {**own, name: _fitting(value, self._facts.types[target].base)}

    def _assigned(self, step: n.Assign, known: Counters) -> Scalar | None:
        if step.op == "=":
            return self.value(step.value, known)
        return self._binary(step.op[:-1], step.target, step.value, None, known)

    def value(self, expr: n.Expr, known: Counters) -> Scalar | None:
        """The value of an expression, ``None`` where it is not known."""
        if expr in self._facts.constants:
            return self._facts.constants[expr]
        kind = self._facts.types[expr]
        found: fold.Value | None = None
        match expr:
            case n.Name(name=name):
                found = known.get(name)
            case n.Unary(op="+" | "-" | "~" | "!" as op, operand=operand):
                value = self.value(operand, known)
                found = None if value is None else fold.fold_unary(op, value, kind)
            case n.Binary(op=op, left=left, right=right):
                found = self._binary(op, left, right, expr, known)
            case n.Construct(args=(part,)) if kind.is_scalar:
                value = self.value(part, known)
                found = None if value is None else fold.convert(value, kind.base)
        return None if isinstance(found, tuple) else found

    def _binary(
        self, op: str, left: n.Expr, right: n.Expr, whole: n.Expr | None, known: Counters
    ) -> Scalar | None:
        """``left op right``; ``whole`` is that expression, or it is that of an assignment."""
        one, two = self.value(left, known), self.value(right, known)
        operands = self._facts.types[left], self._facts.types[right]
        if one is None or two is None or not all(kind.is_scalar for kind in operands):
            return None
        bases = operands[0].base or "", operands[1].base or ""
        base = self._conversions.common_base(*bases)
        kind = operands[bases.index(base) if base in bases else 0]
        if whole is not None:
            kind = self._facts.types[whole]
        found = fold.fold_binary(op, (one, two), operands, base, kind)
        return None if isinstance(found, tuple) else found


def _fitting(value: Scalar, base: str | None) -> Scalar:
    found = fold.convert(value, base)
    if found is None or not isfinite(found):
        raise UncountableError("a counter leaves the numbers of its type")
    return found
