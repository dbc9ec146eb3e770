"""The statements of a function that every call executes, in order, and who defines what they read.

These are its unconditional statements, nested plain blocks flattened. A conditional, a loop or a
``switch`` is one step, taken as a whole: it may write what any statement inside it writes. Values
that are cached are computed here, so this simple form of reaching definitions is exact where it
matters and safe elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does, Effects, local_names
from shadercache.ast import nodes as n
from shadercache.ast.walk import children
from shadercache.source import NOWHERE

Trip: TypeAlias = tuple[n.Declarator, ...]
"""The counters of a trip of an unrolled loop, as declared there, outermost loop first."""

CONTROL = (n.If, n.Switch, n.For, n.While, n.DoWhile)


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """One unconditional statement.

    ``after_exit``: an earlier statement may have left the function or discarded the fragment, so
    that this one is not always reached. ``trip``: the counters of the unrolled loops it stands in.
    """

    index: int
    stmt: n.Stmt
    effects: Effects
    after_exit: bool
    trip: Trip = ()

    @property
    def is_control(self) -> bool:
        """Is it a conditional, a loop or a switch as a whole?"""
        return isinstance(self.stmt, CONTROL)


class ReachingDefinitions:
    """The steps of one function, and the definitions that reach each of them."""

    def __init__(self, function: n.FunctionDef, table: EffectTable) -> None:
        self.function = function
        self.local_names = local_names(function)
        self.steps: list[Step] = []
        self._writes: dict[str, list[tuple[int, bool]]] = {}
        left = False
        for index, (stmt, trip) in enumerate(_flatten(function.body.body)):
            effects = table.of(stmt)
            self.steps.append(Step(index, stmt, effects, left, trip))
            kills = _overwrites(stmt)
            # A declaration without a value writes nothing, but nothing older is left behind it.
            for name in effects.writes | kills:
                # In order of the steps: whoever looks for a write does so by bisection.
                self._writes.setdefault(name, []).append((index, name in kills))
            # A break or continue stays inside its loop or switch, which is one step.
            left = left or bool(effects.does & (Does.RETURN | Does.DISCARD))

    def writes(self, name: str) -> Sequence[tuple[int, bool]]:
        """The steps that may write ``name``, in order, and whether nothing is left of its value."""
        return self._writes.get(name, ())


def _flatten(stmts: Iterable[n.Stmt], trip: Trip = ()) -> Iterator[tuple[n.Stmt, Trip]]:
    for stmt in stmts:
        if isinstance(stmt, n.Block):
            yield from _flatten(stmt.body, trip + counters_of(stmt))
        else:
            yield stmt, trip


def counters_of(block: n.Block) -> Trip:
    """The counters that a block begins with if it is a trip of an unrolled loop.

    The statement that declares them was added, but their names are the user's
    (:mod:`shadercache.transform.unroll`).
    """
    counters: list[n.Declarator] = []
    for stmt in block.body:
        match stmt:
            case n.DeclStmt(span=span, decl=n.VarDecl(declarators=(variable,))) if span == NOWHERE:
                if variable.span != NOWHERE:
                    counters.append(variable)
                    continue
        break
    return tuple(counters)


def _overwrites(stmt: n.Stmt) -> frozenset[str]:
    """Variables whose old value the statement makes irrelevant to every later reader."""
    match stmt:
        case n.DeclStmt(decl=n.VarDecl(declarators=items)):
            return frozenset(variable.name for variable in items)
        # Also s += x: whoever reads s afterwards reads it through this statement.
        case n.ExprStmt(expr=n.Assign(target=n.Name(name=name))):
            return frozenset((name,))
    return frozenset()


def order_matters(stmt: n.Stmt, table: EffectTable) -> bool:
    """Does a part of the statement have a side effect, other than its last act?

    Of a conditional only the condition counts: what stands under it are statements of their own.
    The last act is the assignment itself and, in ``x = f(...)`` or ``f(...)``, the call.
    """
    match stmt:
        case n.If(condition=last) | n.Switch(selector=last):
            return bool(table.of(last).writes)
        case n.ExprStmt(expr=n.Assign(target=target, value=last)):
            inside = [*children(target), *children(last)]
        case n.ExprStmt(expr=last) if last is not None:
            inside = [*children(last)]
        case n.DeclStmt(decl=n.VarDecl(declarators=items)):
            inits = [variable.init for variable in items if variable.init is not None]
            inside = [child for init in inits for child in children(init)] + list(inits[1:])
        case n.Return(value=last) if last is not None:
            inside = [*children(last)]
        case _:
            return False
    return any(table.of(part).writes for part in inside)


def written_anywhere(module: n.Module, table: EffectTable) -> frozenset[str]:
    """Names of the global variables that some function of the module writes."""
    return frozenset[str]().union(*(table.summary(name).writes for name in table.functions))
