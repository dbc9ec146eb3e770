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
        """Does a condition hold in a trip? ``None`` where that is not known before."""
        # A driver may calculate floats with more bits.
        if any(self._facts.types[part].is_float for part in expressions(condition)):
            return None
        value = self.value(condition, known)
        return None if value is None else bool(value)

    def trips(self, loop: n.For, around: Counters, limit: int) -> list[Counters]:
        """The values of the loop's own counters in each trip.

        ``around`` are the counters of the loops that it stands in. Raises
        :class:`UncountableError`, for more than ``limit`` trips too.
        """
        if not isinstance(loop.condition, n.Expr):
            raise UncountableError("it has no condition that ends it")
        own = self._first(loop, around)
        trips: list[Counters] = []
        while True:
            goes_on = self.value(loop.condition, {**around, **own})
            if goes_on is None:
                raise UncountableError("its condition needs more than its counters and constants")
            if not goes_on:
                return trips
            trips.append(own)
            # The limit also ends the count of a loop that never ends.
            if len(trips) > limit:
                raise UncountableError(f"it makes more than {limit} trips")
            if loop.step is not None:
                own = self._stepped(loop.step, around, own)

    def _first(self, loop: n.For, around: Counters) -> Counters:
        match loop.init:
            case n.DeclStmt(decl=n.VarDecl(declarators=items)) if items:
                pass
            case _:
                raise UncountableError("it does not declare its counter")
        own: dict[str, Scalar] = {}
        for counter in items:
            kind = self._facts.declared[counter].type
            value = None if counter.init is None else self.value(counter.init, {**around, **own})
            if value is None or not kind.is_scalar or kind.base not in COUNTABLE:
                raise UncountableError("a counter does not begin with a constant number")
            own[counter.name] = _fitting(value, kind.base)
        return own

    def _stepped(self, step: n.Expr, around: Counters, own: Counters) -> Counters:
        value: Scalar | None = None
        match step:
            case n.Comma(left=left, right=right):
                return self._stepped(right, around, self._stepped(left, around, own))
            case (
                n.Unary(op="++" | "--" as op, operand=n.Name(name=name))
                | n.Postfix(op=op, operand=n.Name(name=name))
            ) if name in own:
                value = own[name] + (1 if op == "++" else -1)
            case n.Assign(op="=", target=n.Name(name=name), value=new) if name in own:
                value = self.value(new, {**around, **own})
            case n.Assign(op=op, target=n.Name(name=name) as old, value=new) if name in own:
                value = self._binary(step, op[:-1], (old, new), {**around, **own})
        if value is None:
            raise UncountableError("its step does more than count by constants")
        return {**own, name: _fitting(value, self._facts.types[step].base)}

    def value(self, expr: n.Expr, known: Counters) -> Scalar | None:
        """The value of an expression, ``None`` where it is not known."""
        if expr in self._facts.constants:
            return self._facts.constants[expr]
        kind = self._facts.types[expr]
        match expr:
            case n.Name(name=name):
                return known.get(name)
            case n.Unary(op="+" | "-" | "~" | "!" as op, operand=operand):
                value = self.value(operand, known)
                return None if value is None else _scalar(fold.fold_unary(op, value, kind))
            case n.Binary(op=op, left=left, right=right):
                return self._binary(expr, op, (left, right), known)
            case n.Construct(args=(part,)) if kind.is_scalar:
                value = self.value(part, known)
                return None if value is None else fold.convert(value, kind.base)
        return None

    def _binary(
        self, whole: n.Expr, op: str, operands: tuple[n.Expr, n.Expr], known: Counters
    ) -> Scalar | None:
        left, right = (self.value(operand, known) for operand in operands)
        one, two = (self._facts.types[operand] for operand in operands)
        if left is None or right is None or not (one.is_scalar and two.is_scalar):
            return None
        # Of ``i < 3u`` both sides are unsigned, which decides what a negative counter is.
        base = self._conversions.common_base(one.base or "", two.base or "")
        kind = self._facts.types[whole]
        return _scalar(fold.fold_binary(op, (left, right), (one, two), base, kind))


def _scalar(value: fold.Value | None) -> Scalar | None:
    return None if isinstance(value, tuple) else value


def _fitting(value: Scalar, base: str | None) -> Scalar:
    # Integers wrap (GLSL 3.30 section 4.1.3), floats have 32 bits: not so in Python.
    fitting = fold.convert(value, base)
    if fitting is None or not isfinite(fitting):
        raise UncountableError("a counter leaves the numbers of its type")
    return fitting
