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

from collections.abc import Iterable, Iterator
from dataclasses import replace

from shadercache.analysis.costs.cost import FETCH, CostTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.precision import PrecisionTable
from shadercache.analysis.reaching_definitions import order_matters
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE
from shadercache.transform.names import FreshNames
from shadercache.transform.replace import replace_expressions


def lower_ternaries(module: n.Module, facts: Facts) -> n.Module:
    """The module without costly choices inside expressions (the same module if there are none).

    ``facts`` are those of ``module``, which has unique names and one declarator to a declaration.
    """
    lowerer = _Lowerer(module, facts)
    decls = tuple(
        replace(decl, body=lowerer.block(decl.body)) if isinstance(decl, n.FunctionDef) else decl
        for decl in module.decls
    )
    return replace(module, decls=decls) if lowerer.changed else module


class _Lowerer:
    """Rewrites the bodies of functions."""

    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._facts = facts
        self._table = EffectTable(module)
        self._costs = CostTable(facts)
        self._precisions = PrecisionTable(module, facts)
        self._names = FreshNames(
            {name for node in walk(module) if (name := getattr(node, "name", None))}
        )
        self.changed = False

    def block(self, block: n.Block) -> n.Block:
        return replace(block, body=tuple(self._list(block.body)))

    def _list(self, stmts: Iterable[n.Stmt]) -> Iterator[n.Stmt]:
        for stmt in stmts:
            yield from self._statement(stmt)

    def _alone(self, stmt: n.Stmt) -> n.Stmt:
        made = list(self._statement(stmt))
        return made[0] if len(made) == 1 else n.Block(stmt.span, tuple(made))

    def _statement(self, stmt: n.Stmt) -> Iterator[n.Stmt]:
        match stmt:
            case n.For() | n.While() | n.DoWhile():
                yield stmt
                return
            case n.Block():
                yield self.block(stmt)
                return
        found = None if order_matters(stmt, self._table) else self._first_choice(stmt)
        if found is not None:
            self.changed = True
            choice, name = found, self._names.make("choice")
            yield from self._chosen(choice, name)
            used = n.Name(choice.span, name)
            yield from self._statement(
                replace_expressions(stmt, lambda old, new: used if old is choice else new)
            )
            return
        match stmt:
            case n.If():
                other = None if stmt.other is None else self._alone(stmt.other)
                yield replace(stmt, then=self._alone(stmt.then), other=other)
            case n.Switch():
                yield replace(stmt, body=tuple(self._list(stmt.body)))
            case _:
                yield stmt

    def _chosen(self, choice: n.Expr, name: str) -> Iterator[n.Stmt]:
        """The declaration of a choice's value, and the statements that make it."""
        precision = self._precisions.of(choice)
        words = n.Qualifiers(NOWHERE, (precision,)) if precision else n.NO_QUALIFIERS
        kind = n.TypeSpec(NOWHERE, self._facts.types[choice].name)
        match choice:
            case n.Conditional():
                yield _declared(words, kind, name, None)
                then, other = (
                    n.Block(NOWHERE, tuple(self._statement(_assigned(name, part))))
                    for part in (choice.then, choice.other)
                )
                yield from self._statement(n.If(choice.span, choice.condition, then, other))
            case n.Binary(op=op):
                yield from self._statement(_declared(words, kind, name, choice.left))
                known: n.Expr = n.Name(NOWHERE, name)
                open_ = known if op == "&&" else n.Unary(NOWHERE, "!", known)
                then = n.Block(NOWHERE, tuple(self._statement(_assigned(name, choice.right))))
                yield n.If(NOWHERE, open_, then, None)

    def _first_choice(self, stmt: n.Stmt) -> n.Expr | None:
        """The first costly choice among what the statement itself evaluates, whatever happens."""
        stack = list(reversed(_evaluated(stmt)))
        while stack:
            node = stack.pop()
            if isinstance(node, n.Conditional):
                if self._is_costly(node, (node.then, node.other)):
                    return node
                stack.append(node.condition)
            elif isinstance(node, n.Binary) and node.op in ("&&", "||"):
                if self._is_costly(node, (node.right,)):
                    return node
                stack.append(node.left)
            else:
                stack.extend(reversed(children(node)))
        return None

    def _is_costly(self, choice: n.Expr, skipped: Iterable[n.Expr]) -> bool:
        kind = self._facts.types.get(choice)
        if kind is None or kind.base is None or kind.is_array or self._facts.is_constant(choice):
            return False
        return any(self._costs.of(part) >= FETCH for part in skipped)


def _evaluated(stmt: n.Stmt) -> list[n.Node]:
    """The expressions of a statement, without those of statements inside it."""
    match stmt:
        case n.If(condition=first) | n.Switch(selector=first):
            return [first]
        case n.ExprStmt() | n.DeclStmt() | n.Return():
            return [child for child in children(stmt) if _may_choose(child)]
    return []


def _may_choose(node: n.Node) -> bool:
    return isinstance(node, (*EXPRESSIONS, n.VarDecl))


def _declared(words: n.Qualifiers, kind: n.TypeSpec, name: str, init: n.Expr | None) -> n.DeclStmt:
    item = n.Declarator(NOWHERE, name, (), init)
    return n.DeclStmt(NOWHERE, n.VarDecl(NOWHERE, words, kind, (item,)))


def _assigned(name: str, value: n.Expr) -> n.ExprStmt:
    return n.ExprStmt(NOWHERE, n.Assign(NOWHERE, "=", n.Name(NOWHERE, name), value))
