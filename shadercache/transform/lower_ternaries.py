"""Turn expressions that may skip a costly part of themselves into statements.

Only statements can be left out, and a value that is cached is handled in a statement of its own::

    light *= lit ? shadow(p) : 1.0;         float choice;
                                            if (lit) {
                                     =>         choice = shadow(p);
                                            } else {
                                                choice = 1.0;
                                            }
                                            light *= choice;

``a && f(b)`` and ``a || f(b)`` likewise. What is cheap stays as it is, and so do loops, whose
values are not cached; and statements with side effects, out of which nothing may be moved.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TypeAlias

from shadercache.analysis.costs.cost import FETCH, CostTable
from shadercache.analysis.dataflow import LOOPS
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.precision import PrecisionTable
from shadercache.analysis.reaching_definitions import order_matters
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import replace_expressions
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE, Span
from shadercache.transform.names import FreshNames, all_names
from shadercache.transform.trees import assigned, change_functions, declared, unconditional

Choice: TypeAlias = n.Conditional | n.Binary


def lower_ternaries(module: n.Module, facts: Facts) -> n.Module:
    """The module without costly choices inside expressions (the same module if there are none).

    ``facts`` are those of ``module``, which has unique names and one declarator to a declaration.
    """
    lowerer = _Lowerer(module, facts)
    lowered = change_functions(module, lowerer.function)
    return lowered if lowerer.changed else module


class _Lowerer:
    """Rewrites the bodies of functions."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._facts = facts
        self._table = EffectTable(module)
        self._costs = CostTable(facts)
        self._precisions = PrecisionTable(module, facts)
        self._names = FreshNames(all_names(module))
        self.changed = False

    def function(self, function: n.FunctionDef) -> n.FunctionDef:
        return replace(function, body=self._block(function.body.span, *function.body.body))

    def _block(self, span: Span, *stmts: n.Stmt) -> n.Block:
        return n.Block(span, tuple(new for stmt in stmts for new in self._statement(stmt)))

    def _alone(self, stmt: n.Stmt) -> n.Stmt:
        block = self._block(stmt.span, stmt)
        return block.body[0] if len(block.body) == 1 else block

    def _statement(self, stmt: n.Stmt) -> Iterator[n.Stmt]:
        # The outermost first: what is inside it stays the nodes that the tables know.
        choice = self._first_choice(stmt)
        if choice is not None:
            self.changed = True
            name = self._names.make("choice")
            yield from self._chosen(choice, name)
            used = n.Name(choice.span, name)
            rest = replace_expressions(stmt, lambda old, new: used if old is choice else new)
            yield from self._statement(rest)
            return
        match stmt:
            case n.Block() | n.Switch():
                yield replace(stmt, body=self._block(stmt.span, *stmt.body).body)
            case n.If():
                other = None if stmt.other is None else self._alone(stmt.other)
                yield replace(stmt, then=self._alone(stmt.then), other=other)
            case _:
                yield stmt

    def _chosen(self, choice: Choice, name: str) -> Iterator[n.Stmt]:
        """The declaration of a choice's value, and the statements that make it."""
        # In GLSL ES a variable more precise than the expression would change what is made of it.
        precision = self._precisions.of(choice)
        words = n.Qualifiers(NOWHERE, (precision,)) if precision else n.NO_QUALIFIERS
        kind = n.TypeSpec(NOWHERE, self._facts.types[choice].name)
        if isinstance(choice, n.Conditional):
            yield declared(words, kind, n.Declarator(NOWHERE, name))
            then, other = (
                self._block(NOWHERE, assigned(name, part)) for part in (choice.then, choice.other)
            )
            # The condition may hold a choice, too.
            yield from self._statement(n.If(choice.span, choice.condition, then, other))
            return
        yield from self._statement(
            declared(words, kind, n.Declarator(NOWHERE, name, (), choice.left))
        )
        # The right side is evaluated only where the left one leaves the answer open.
        known: n.Expr = n.Name(NOWHERE, name)
        still_open = known if choice.op == "&&" else n.Unary(NOWHERE, "!", known)
        then = self._block(NOWHERE, assigned(name, choice.right))
        yield n.If(NOWHERE, still_open, then, None)

    def _first_choice(self, stmt: n.Stmt) -> Choice | None:
        """The first costly choice among what the statement itself evaluates, whatever happens."""
        # What a block holds is lowered inside: its variables do not exist ahead of it.
        if isinstance(stmt, (n.Block, *LOOPS)) or order_matters(stmt, self._table):
            return None
        for node in unconditional(stmt):
            match node:
                case n.Conditional(then=then, other=other) if self._is_costly(node, then, other):
                    return node
                case n.Binary(op="&&" | "||", right=right) if self._is_costly(node, right):
                    return node
        return None

    def _is_costly(self, choice: Choice, *skipped: n.Expr) -> bool:
        kind = self._facts.types.get(choice)
        # A value read from a variable is no constant expression (GLSL 3.30 section 4.3.3).
        if kind is None or kind.base is None or kind.is_array or self._facts.is_constant(choice):
            return False
        # What costs less than a look-up can gain nothing by a statement of its own.
        return any(self._costs.of(part) >= FETCH for part in skipped)
