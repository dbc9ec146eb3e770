"""Statements: their scopes, and the types of what stands in them (GLSL 3.30 section 6).

Statements are walked with an explicit stack that holds statements still to be gone through and
actions that leave a scope; so neither a long ``else if`` chain nor deep nesting recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Expr, Stmt
from shadercache.sema.declarations import declare, declare_function, declare_params
from shadercache.sema.inference_context import InferenceContext

_Work: TypeAlias = "Stmt | Callable[[], object]"


class StatementChecker:
    """Goes through the bodies of functions."""

    def __init__(self, context: InferenceContext) -> None:
        self._context = context
        self._scopes = context.scopes
        self._stack: list[_Work] = []
        self._rules: Mapping[type, Callable[[Any], None]] = {
            n.Block: lambda node: self._scoped(node.body),
            n.ExprStmt: lambda node: self._optional(node.expr),
            n.DeclStmt: lambda node: declare(context, node.decl),
            n.If: self._if,
            n.Switch: self._switch,
            n.Case: lambda node: self._optional(node.value),
            n.For: self._for,
            n.While: self._while,
            n.DoWhile: self._do,
            n.Return: lambda node: self._optional(node.value),
        }

    def check_function(self, function: n.FunctionDef) -> None:
        """Declare a function and go through its body, in one scope with its parameters."""
        context = self._context
        overload = declare_function(context, function.proto, function)
        self._scopes.push()
        declare_params(context, function, overload)
        context.function = function
        context.tables.called[function] = []
        if context.language.version == 100:
            # Only there the parameters have a scope of their own (ES 1.00 section 4.2.2).
            self._scopes.push()
            self._stack.append(self._scopes.pop)
        self._run(function.body.body)
        context.function = None
        self._scopes.pop()

    def _run(self, body: tuple[Stmt, ...]) -> None:
        self._stack.extend(reversed(body))
        while self._stack:
            work = self._stack.pop()
            rule = self._rules.get(type(work))
            if rule is not None:
                rule(work)
            elif callable(work):
                work()

    def _optional(self, expr: Expr | None) -> None:
        if expr is not None:
            self._context.check(expr)

    def _scoped(self, body: tuple[Stmt, ...]) -> None:
        self._scopes.push()
        self._stack.append(self._scopes.pop)
        self._stack.extend(reversed(body))

    def _if(self, node: n.If) -> None:
        self._context.check(node.condition)
        if node.other is not None:
            self._push_scoped(node.other)
        self._push_scoped(node.then)

    def _push_scoped(self, body: Stmt) -> None:
        """A statement that is a scope of its own, braces or not."""
        # A block opens its own scope, and no other statement declares anything around itself.
        if isinstance(body, n.DeclStmt):
            self._stack.extend((self._scopes.pop, body, self._scopes.push))
        else:
            self._stack.append(body)

    def _switch(self, node: n.Switch) -> None:
        self._context.check(node.selector)
        self._scoped(node.body)

    def _for(self, node: n.For) -> None:
        self._scopes.push()
        self._rules[type(node.init)](node.init)
        self._loop_condition(node.condition)
        self._optional(node.step)
        self._loop_body(node.body)

    def _while(self, node: n.While) -> None:
        self._scopes.push()
        self._loop_condition(node.condition)
        self._loop_body(node.body)

    def _loop_condition(self, condition: Expr | n.VarDecl | None) -> None:
        if isinstance(condition, n.VarDecl):
            declare(self._context, condition)
        else:
            self._optional(condition)

    def _loop_body(self, body: Stmt) -> None:
        """The body shares the scope of the loop's head (section 6.3): its braces open none."""
        self._stack.append(self._scopes.pop)
        if isinstance(body, n.Block):
            self._stack.extend(reversed(body.body))
        else:
            self._stack.append(body)

    def _do(self, node: n.DoWhile) -> None:
        # Behind the body, and outside of its scope: the condition does not see what it declares.
        self._stack.append(lambda: self._context.check(node.condition))
        self._push_scoped(node.body)
