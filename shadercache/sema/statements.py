"""Statements: their scopes, and the types of what stands in them (GLSL 3.30 section 6).

Statements are walked with an explicit stack that holds statements still to be gone through and
actions that leave a scope; so neither a long ``else if`` chain nor deep nesting recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

from shadercache.ast.nodes import (
    Block,
    Case,
    DeclStmt,
    DoWhile,
    Expr,
    ExprStmt,
    For,
    FunctionDef,
    FunctionProto,
    If,
    PrecisionDecl,
    QualifierDecl,
    Return,
    Stmt,
    Switch,
    VarDecl,
    While,
)
from shadercache.sema.functions import FunctionChecker
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker

_Work: TypeAlias = "Stmt | Callable[[], object]"


class StatementChecker:
    """Goes through the bodies of functions."""

    def __init__(
        self,
        context: InferenceContext,
        types: TypeResolver,
        variables: VariableChecker,
        functions: FunctionChecker,
    ) -> None:
        self._context = context
        self._scopes = context.scopes
        self._check = types.expressions.check
        self._variables = variables
        self._functions = functions
        self._stack: list[_Work] = []
        self._rules: Mapping[type, Callable[[Any], None]] = {
            Block: self._block,
            ExprStmt: lambda node: self._optional(node.expr),
            DeclStmt: self._declaration,
            If: self._if,
            Switch: self._switch,
            Case: lambda node: self._optional(node.value),
            For: self._for,
            While: self._while,
            DoWhile: self._do,
            Return: lambda node: self._optional(node.value),
        }

    def check_function(self, function: FunctionDef) -> None:
        """Declare a function and go through its body, in one scope with its parameters."""
        context = self._context
        overload = self._functions.declare(function.proto, function)
        self._scopes.push()
        self._functions.declare_params(function, overload)
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
        stack = self._stack
        stack.extend(reversed(body))
        rules = self._rules
        while stack:
            item = stack.pop()
            rule = rules.get(type(item))
            if rule is not None:
                rule(item)
            elif callable(item):
                item()

    def _optional(self, expr: Expr | None) -> None:
        if expr is not None:
            self._check(expr)

    def _scoped(self, body: tuple[Stmt, ...]) -> None:
        self._scopes.push()
        self._stack.append(self._scopes.pop)
        self._stack.extend(reversed(body))

    def _block(self, node: Block) -> None:
        self._scoped(node.body)

    def _declaration(self, node: DeclStmt) -> None:
        decl = node.decl
        if isinstance(decl, VarDecl):
            self._variables.declare(decl)
        elif isinstance(decl, FunctionProto):
            self._functions.declare(decl)
        elif isinstance(decl, QualifierDecl):
            self._variables.qualify(decl)
        elif isinstance(decl, PrecisionDecl):
            self._variables.declare_precision(decl)

    def _if(self, node: If) -> None:
        self._check(node.condition)
        if node.other is not None:
            self._push_scoped(node.other)
        self._push_scoped(node.then)

    def _push_scoped(self, body: Stmt) -> None:
        """A statement that is a scope of its own, braces or not."""
        if isinstance(body, DeclStmt):
            self._stack.extend((self._scopes.pop, body, self._scopes.push))
        else:
            self._stack.append(body)

    def _switch(self, node: Switch) -> None:
        self._check(node.selector)
        self._scoped(node.body)

    def _for(self, node: For) -> None:
        self._scopes.push()
        if isinstance(node.init, DeclStmt):
            self._declaration(node.init)
        else:
            self._optional(node.init.expr)
        self._loop_condition(node.condition)
        self._optional(node.step)
        self._loop_body(node.body)

    def _while(self, node: While) -> None:
        self._scopes.push()
        self._loop_condition(node.condition)
        self._loop_body(node.body)

    def _loop_condition(self, condition: Expr | VarDecl | None) -> None:
        if isinstance(condition, VarDecl):
            self._variables.declare(condition)
        else:
            self._optional(condition)

    def _loop_body(self, body: Stmt) -> None:
        """The body shares the scope of the loop's head (section 6.3): its braces open none."""
        self._stack.append(self._scopes.pop)
        if isinstance(body, Block):
            self._stack.extend(reversed(body.body))
        else:
            self._stack.append(body)

    def _do(self, node: DoWhile) -> None:
        self._stack.append(lambda: self._check(node.condition))
        self._push_scoped(node.body)
