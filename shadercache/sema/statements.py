"""Statements: scopes, conditions, jumps (GLSL 3.30 section 6).

Statements are walked with an explicit stack that holds statements still to be checked and actions
that leave a scope or a loop; so neither a long ``else if`` chain nor deep nesting recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
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
    Jump,
    PrecisionDecl,
    QualifierDecl,
    Return,
    Stmt,
    Switch,
    VarDecl,
    While,
)
from shadercache.lang.types import BOOL, INT, UINT, VOID, Type
from shadercache.sema.check_context import ERROR, Context
from shadercache.sema.functions import FunctionChecker
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker

_Work: TypeAlias = "Stmt | Callable[[], object]"


@dataclass(slots=True)
class _SwitchState:
    """The switch that is being checked."""

    selector: Type
    depth: int
    seen: set[int | None] = field(default_factory=set)


class StatementChecker:
    """Checks the bodies of functions."""

    def __init__(
        self,
        context: Context,
        types: TypeResolver,
        variables: VariableChecker,
        functions: FunctionChecker,
    ) -> None:
        self._context = context
        self._scopes = context.scopes
        self._check = types.expressions.check
        self._values = types.expressions.constants.values
        self._constant = types.expressions.constants.expressions
        self._variables = variables
        self._functions = functions
        self._stack: list[_Work] = []
        self._loops = 0
        self._switches: list[_SwitchState] = []
        self._result: Type = VOID
        self._returns = False
        self._rules: Mapping[type, Callable[[Any], None]] = {
            Block: self._block,
            ExprStmt: self._expression,
            DeclStmt: self._declaration,
            If: self._if,
            Switch: self._switch,
            Case: self._case,
            For: self._for,
            While: self._while,
            DoWhile: self._do,
            Return: self._return,
            Jump: self._jump,
        }

    def check_function(self, function: FunctionDef) -> None:
        """Declare a function and check its body, in one scope with its parameters."""
        context = self._context
        overload = self._functions.declare(function.proto, function)
        self._scopes.push()
        self._functions.declare_params(function, overload)
        context.function = function
        context.called[function] = []
        self._result, self._returns = overload.result, False
        if context.version == 100:
            # Only there the parameters have a scope of their own (ES 1.00 section 4.2.2).
            self._scopes.push()
            self._stack.append(self._scopes.pop)
        self._run(function.body.body)
        context.function = None
        self._scopes.pop()
        if not self._returns and overload.result not in (VOID, ERROR):
            message = f"'{function.name}' returns {overload.result}, but has no return statement"
            context.error("SC211", message, function.proto)

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

    # --- simple statements ------------------------------------------------------------------------

    def _block(self, node: Block) -> None:
        self._scopes.push()
        self._stack.append(self._scopes.pop)
        self._stack.extend(reversed(node.body))

    def _expression(self, node: ExprStmt) -> None:
        if node.expr is not None:
            self._check(node.expr)

    def _declaration(self, node: DeclStmt) -> None:
        decl = node.decl
        if isinstance(decl, VarDecl):
            self._variables.declare(decl)
        elif isinstance(decl, FunctionProto):
            self._functions.declare(decl)
        elif isinstance(decl, QualifierDecl):
            self._variables.qualify(decl)
        elif isinstance(decl, PrecisionDecl):
            self._variables.check_precision(decl)

    def _return(self, node: Return) -> None:
        self._returns = True
        wanted, context = self._result, self._context
        if node.value is None:
            if wanted not in (VOID, ERROR):
                context.error("SC211", f"the function returns {wanted}: a value is missing", node)
            return
        given = self._check(node.value)
        if ERROR in (given, wanted):
            return
        if wanted is VOID:
            context.error("SC211", "a void function returns no value", node.value)
        elif not context.conversions.converts(given, wanted):
            message = f"the function returns {wanted}, not {given}"
            context.error("SC211", message, node.value)

    def _jump(self, node: Jump) -> None:
        context = self._context
        if node.word == "discard":
            if context.stage != "fragment":
                context.error("SC218", "'discard' is for fragment shaders only", node)
        elif node.word == "continue" and not self._loops:
            context.error("SC218", "'continue' outside of a loop", node)
        elif node.word == "break" and not self._loops and not self._switches:
            context.error("SC218", "'break' outside of a loop or switch", node)

    # --- choices ----------------------------------------------------------------------------------

    def _condition(self, expr: Expr) -> None:
        kind = self._check(expr)
        if kind is not BOOL and kind is not ERROR:
            self._context.error("SC212", f"the condition is {kind}, not bool", expr)

    def _if(self, node: If) -> None:
        self._condition(node.condition)
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
        context = self._context
        kind = self._check(node.selector)
        if kind not in (INT, UINT, ERROR):
            message = f"the selector of a switch is an int or uint, not {kind}"
            context.error("SC220", message, node.selector)
        if node.body and not isinstance(node.body[0], Case):
            context.error("SC220", "a statement before the first case", node.body[0])
        if node.body and isinstance(node.body[-1], Case) and not context.at_least(430, 310):
            context.error("SC220", "no statement after the last case", node.body[-1])
        self._scopes.push()
        self._switches.append(_SwitchState(kind, self._scopes.depth))
        self._stack.extend((self._scopes.pop, self._switches.pop))
        self._stack.extend(reversed(node.body))

    def _case(self, node: Case) -> None:
        context = self._context
        if not self._switches or self._switches[-1].depth != self._scopes.depth:
            context.error("SC220", "a case label outside of a switch", node)
            return
        state = self._switches[-1]
        value = None if node.value is None else self._label(node.value)
        if node.value is not None and value is None:
            return
        if value in state.seen:
            label = "default" if value is None else f"case {value}"
            context.error("SC220", f"'{label}' stands twice in the same switch", node)
        state.seen.add(value)

    def _label(self, label: Expr) -> int | None:
        """The value of a case label; ``None`` where it is not known or wrong."""
        context, kind = self._context, self._check(label)
        if kind is ERROR:
            return None
        if kind not in (INT, UINT) or label not in self._constant:
            context.error("SC220", "a case label is a constant integer", label)
            return None
        value = self._values.get(label)
        return value if isinstance(value, int) else None

    # --- loops ------------------------------------------------------------------------------------

    def _enter_loop(self) -> None:
        self._loops += 1

    def _leave_loop(self) -> None:
        self._loops -= 1

    def _for(self, node: For) -> None:
        self._scopes.push()
        if isinstance(node.init, DeclStmt):
            self._declaration(node.init)
        else:
            self._expression(node.init)
        self._loop_condition(node.condition)
        if node.step is not None:
            self._check(node.step)
        self._loop_body(node.body)

    def _while(self, node: While) -> None:
        self._scopes.push()
        self._loop_condition(node.condition)
        self._loop_body(node.body)

    def _loop_condition(self, condition: Expr | VarDecl | None) -> None:
        if isinstance(condition, VarDecl):
            self._variables.declare_condition(condition)
        elif condition is not None:
            self._condition(condition)

    def _loop_body(self, body: Stmt) -> None:
        """The body shares the scope of the loop's head (section 6.3): its braces open none."""
        self._enter_loop()
        self._stack.extend((self._scopes.pop, self._leave_loop))
        if isinstance(body, Block):
            self._stack.extend(reversed(body.body))
        else:
            self._stack.append(body)

    def _do(self, node: DoWhile) -> None:
        self._enter_loop()
        self._stack.append(lambda: self._condition(node.condition))
        self._stack.append(self._leave_loop)
        self._push_scoped(node.body)
