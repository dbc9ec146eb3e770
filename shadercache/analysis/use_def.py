"""Which expression gave a variable the value that it has at a point of the program.

Only where there is exactly one: the last write before is a declaration or a plain assignment of the
whole variable under no condition, or the variable is a parameter that nothing has written yet::

    float a = wave(p);      // a is wave(p)
    float b = a;            // b is a, is wave(p)
    b += 1.0;               // b is nothing simpler from here on
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass

from shadercache.analysis.call_paths import Instance, by_call
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.reaching_definitions import Step, order_matters
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import map_expressions_keyed
from shadercache.ast.walk import expressions
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts

MAX_EXPRESSIONS = 200
"""Expressions in a closed expression: one that is longer would better be a function."""

MAX_DEPTH = 100
"""Definitions that are followed in a row."""


@dataclass(frozen=True, slots=True)
class Definition:
    """An expression, where it is evaluated, and the type that its value is converted to."""

    instance: Instance
    step: Step
    expr: n.Expr
    type: Type


class Definitions:
    """Looks up definitions in the instances of one module."""

    def __init__(self, facts: Facts, table: EffectTable, instances: tuple[Instance, ...]) -> None:
        self.facts = facts
        self._table = table
        self._children = by_call(instances)

    def callee(self, instance: Instance, call: n.Call) -> Instance | None:
        """The instance that a call of a user's function leads to."""
        return self._children.get((instance, call))

    def version(self, instance: Instance, step: Step, name: str) -> int | None:
        """How many steps may have written a variable before; ``None`` if it changes within this."""
        # A plain statement without side effects inside reads all its operands before it writes.
        moves = step.is_control or order_matters(step.stmt, self._table)
        if name in step.effects.writes and moves:
            return None
        # (index, False) sorts before what the step itself writes, so only earlier steps count.
        return bisect_left(instance.places.reaching.writes(name), (step.index, False))

    def of(self, instance: Instance, step: Step, name: str) -> Definition | None:
        """What gave ``name`` its value, as read at ``step``; ``None`` if that is not one thing."""
        version = self.version(instance, step, name)
        if version is None:
            return None
        if version == 0:
            return self._argument(instance, name)
        index, kills = instance.places.reaching.writes(name)[version - 1]
        return self._assigned(instance, instance.places.reaching.steps[index]) if kills else None

    def result(self, instance: Instance) -> Definition | None:
        """The expression that a call returns, where it always is the same one."""
        steps = instance.places.reaching.steps
        # Behind an earlier return the last one is not what every call returns.
        if not steps or steps[-1].after_exit:
            return None
        match steps[-1].stmt:
            case n.Return(value=value) if value is not None and instance.call is not None:
                kind = self.facts.types[instance.call]
                return Definition(instance, steps[-1], value, kind)
        return None

    def closed(
        self, instance: Instance, step: Step, expr: n.Expr, depth: int = MAX_DEPTH
    ) -> n.Expr | None:
        """The expression with every local replaced by what gave it its value.

        A call becomes what it returns where that is one expression. ``None`` where a local has no
        single expression, for a very long one, and for one of more than ``depth`` steps in a row.
        """
        if depth == 0 or self._table.of(expr).writes:
            return None
        local_names = instance.places.reaching.local_names
        replaced: dict[n.Expr, n.Expr] = {}
        for part in expressions(expr):
            is_local = isinstance(part, n.Name) and part.name in local_names
            if is_local or isinstance(part, n.Call):
                value = self._replacement(instance, step, part, depth - 1)
                if value is not None:
                    replaced[part] = value
                elif is_local:
                    return None
        # What is used twice is copied twice, so lengths may double with each definition.
        whole = map_expressions_keyed(expr, replaced) if replaced else expr
        return whole if sum(1 for _ in expressions(whole)) <= MAX_EXPRESSIONS else None

    def _replacement(
        self, instance: Instance, step: Step, part: n.Expr, depth: int
    ) -> n.Expr | None:
        inner = None
        if isinstance(part, n.Name):
            inner = self.of(instance, step, part.name)
        elif isinstance(part, n.Call) and (child := self.callee(instance, part)):
            inner = self.result(child)
        if inner is None:
            return None
        value = self.closed(inner.instance, inner.step, inner.expr, depth)
        if value is None or str(self.facts.types[inner.expr]) == str(inner.type):
            return value
        # Where it ends up nothing converts it: n / 2 would go on as a division of integers.
        return n.Construct(value.span, n.TypeSpec(value.span, str(inner.type)), (value,))

    def _argument(self, instance: Instance, name: str) -> Definition | None:
        if instance.parent is None or instance.place is None or name not in instance.arguments:
            return None
        params = instance.places.function.proto.params
        param = next(param for param in params if param.name == name)
        # At entry an out parameter is undefined (GLSL 4.60 section 6.1.1).
        if param.qualifiers.has("out"):
            return None
        kind = self.facts.declared[param].type
        return Definition(instance.parent, instance.place.step, instance.arguments[name], kind)

    def _assigned(self, instance: Instance, step: Step) -> Definition | None:
        match step.stmt:
            case n.DeclStmt(decl=n.VarDecl(declarators=(variable,))) if variable.init is not None:
                value, kind = variable.init, self.facts.declared[variable].type
            case n.ExprStmt(expr=n.Assign(op="=", target=n.Name() as target, value=value)):
                kind = self.facts.types[target]
            case _:
                return None
        # A list is an expression only where it initialises something.
        if isinstance(value, n.InitList):
            return None
        return Definition(instance, step, value, kind)
