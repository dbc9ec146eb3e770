"""The parser's callbacks for statements, and the builder that has all callbacks."""

from __future__ import annotations

from typing import Any

from shadercache.ast.nodes import (
    Block,
    BlockDecl,
    Case,
    Decl,
    DeclStmt,
    DoWhile,
    Expr,
    ExprStmt,
    For,
    If,
    Jump,
    Return,
    Switch,
    VarDecl,
    While,
)
from shadercache.front.build_declarations import DeclarationBuilder
from shadercache.front.tokens import Token
from shadercache.source import Span

MAX_STATEMENTS = 256
"""Statements that may nest; each ``else if`` counts as one inside the last."""


class Builder(DeclarationBuilder):
    """All callbacks of the grammar. Each statement that holds others opens a scope."""

    def start(self, parts: list[list[Any]]) -> tuple[Decl, ...]:
        """The declarations of a file."""
        return tuple(decl for decl in parts[0] if decl is not None)

    # --- scopes

    def open_scope(self, parts: list[Token]) -> int:
        """The word or brace that a statement begins with; its offset."""
        return self._open(parts[0])

    def open_condition(self, parts: list[Any]) -> tuple[int, Expr]:
        """``if (expr)`` or ``switch (expr) {``."""
        return self._open(parts[0]), parts[2]

    def while_open(self, parts: list[Any]) -> tuple[int, Expr | VarDecl]:
        """``while (condition)``."""
        return parts[0], parts[2]

    def _open(self, token: Token) -> int:
        if self._scopes.open() > MAX_STATEMENTS:
            span = Span(token.start, token.end)
            self._refuse("SC105", f"more than {MAX_STATEMENTS} statements nest here", span)
        return token.start

    # --- statements

    def compound(self, parts: list[Any]) -> Block:
        """``{ ... }``."""
        self._scopes.close()
        body = tuple(parts[1]) if len(parts) == 3 else ()
        return Block(Span(parts[0], parts[-1].end), body)

    def body(self, parts: list[Any]) -> Block:
        """The body of a function; the scope of the parameters ends with it."""
        self._scopes.close()
        return self.compound(parts)

    def decl_stmt(self, parts: list[Any]) -> DeclStmt:
        """A declaration."""
        decl = parts[0]
        if isinstance(decl, BlockDecl):
            message = "an interface block must not stand in a function"
            self._refuse("SC110", message, decl.span)
        return DeclStmt(decl.span, decl)

    def expr_stmt(self, parts: list[Any]) -> ExprStmt:
        """An expression, or nothing, and ``;``."""
        closing = parts[-1]
        if len(parts) == 1:
            return ExprStmt(Span(closing.start, closing.end), None)
        return ExprStmt(Span(self._start(parts[0]), closing.end), parts[0])

    def if_stmt(self, parts: list[Any]) -> If:
        """``if``, with or without ``else``."""
        self._scopes.close()
        start, condition = parts[0]
        other = parts[3] if len(parts) == 4 else None
        return If(Span(start, parts[-1].span.end), condition, parts[1], other)

    def switch_stmt(self, parts: list[Any]) -> Switch:
        """``switch``."""
        self._scopes.close()
        start, selector = parts[0]
        body = tuple(parts[1]) if len(parts) == 3 else ()
        return Switch(Span(start, parts[-1].end), selector, body)

    def case_label(self, parts: list[Any]) -> Case:
        """``case value:`` or ``default:``."""
        return Case(Span(parts[0].start, parts[-1].end), parts[1] if len(parts) == 3 else None)

    def while_stmt(self, parts: list[Any]) -> While:
        """``while``."""
        self._scopes.close()
        (start, condition), body = parts
        return While(Span(start, body.span.end), condition, body)

    def do_stmt(self, parts: list[Any]) -> DoWhile:
        """``do``."""
        self._scopes.close()
        return DoWhile(Span(parts[0], parts[-1].end), parts[1], parts[4])

    def for_rest(self, parts: list[Any]) -> tuple[Expr | VarDecl | None, Expr | None]:
        """The condition and the step of a ``for``, either of which may be left out."""
        condition = None if isinstance(parts[0], Token) else parts[0]
        step = None if isinstance(parts[-2], Token) else parts[-2]
        return condition, step

    def for_stmt(self, parts: list[Any]) -> For:
        """``for``."""
        self._scopes.close()
        start, init, (condition, step), body = parts
        return For(Span(start, body.span.end), init, condition, step, body)

    def jump_stmt(self, parts: list[Token]) -> Jump:
        """``break;``, ``continue;``, ``discard;`` or ``demote;``."""
        word, closing = parts
        return Jump(Span(word.start, closing.end), word.text)

    def return_stmt(self, parts: list[Any]) -> Return:
        """``return;`` or ``return value;``."""
        value = parts[1] if len(parts) == 3 else None
        return Return(Span(parts[0].start, parts[-1].end), value)
