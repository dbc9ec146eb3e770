"""The parser's callbacks for expressions and array sizes.

Lark calls the method that a rule of ``grammars/glsl.lark`` is named after with the values of its
symbols: a :class:`Token` for a terminal, else what an earlier callback returned. The tree comes to
be from the bottom up, without a second walk.
"""

from __future__ import annotations

from typing import Any, NamedTuple, NoReturn

from shadercache.ast.nodes import (
    Assign,
    Binary,
    Call,
    Comma,
    Conditional,
    Construct,
    Expr,
    Index,
    Length,
    Literal,
    Member,
    Name,
    Node,
    Postfix,
    Unary,
)
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.tokens import Token, TokenStream
from shadercache.lang.words import PRECEDENCE
from shadercache.source import Span


class Dim(NamedTuple):
    """``[size]`` or ``[]``, with the place where it ends."""

    size: Expr | None
    end: int


class ExpressionBuilder:
    """Callbacks for lists, array sizes and expressions.

    A node's span leaves out parentheses around the node itself, but a node that holds it begins
    or ends with them. ``_outer`` has the spans with parentheses, of the nodes that have any.
    """

    def __init__(self) -> None:
        self._outer: dict[Node, Span] = {}
        self._stream: TokenStream

    def begin(self, stream: TokenStream) -> None:
        """Make ready for another file."""
        self._stream = stream
        self._outer = {}

    def end(self) -> None:
        """Let go of the file."""
        del self._stream
        self._outer = {}

    def _start(self, node: Node) -> int:
        outer = self._outer.get(node)
        return node.span[0] if outer is None else outer[0]

    def _end(self, node: Node) -> int:
        outer = self._outer.get(node)
        return node.span[1] if outer is None else outer[1]

    def _refuse(self, code: str, message: str, span: Span, hint: str | None = None) -> NoReturn:
        raise InputError(Diagnostic(code, message, self._stream.source, span, hint))

    # --- lists

    def empty(self, parts: list[Any]) -> list[Any]:
        """A list without elements."""
        return []

    def first(self, parts: list[Any]) -> list[Any]:
        """A list of one element."""
        return parts

    def append(self, parts: list[Any]) -> list[Any]:
        """A list and one more element."""
        elements: list[Any] = parts[0]
        elements.append(parts[1])
        return elements

    def append_after_comma(self, parts: list[Any]) -> list[Any]:
        """A list, a comma and one more element."""
        elements: list[Any] = parts[0]
        elements.append(parts[2])
        return elements

    def dim(self, parts: list[Any]) -> Dim:
        """``[]`` or ``[size]``."""
        return Dim(parts[1] if len(parts) == 3 else None, parts[-1].end)

    # --- operands

    def name(self, parts: list[Token]) -> Name:
        """A variable."""
        token = parts[0]
        return Name(Span(token.start, token.end), token.text)

    def literal(self, parts: list[Token]) -> Literal:
        """A number, ``true`` or ``false``."""
        token = parts[0]
        return Literal(Span(token.start, token.end), token.text)

    def parens(self, parts: list[Any]) -> Expr:
        """``(expr)``: the expression itself."""
        opening, node, closing = parts
        self._outer[node] = Span(opening.start, closing.end)
        inside: Expr = node
        return inside

    def postfix(self, parts: list[Any]) -> Postfix:
        """``operand++``, ``operand--``."""
        operand, op = parts
        return Postfix(Span(self._start(operand), op.end), op.text, operand)

    def index(self, parts: list[Any]) -> Index:
        """``object[index]``."""
        node, _, index, closing = parts
        return Index(Span(self._start(node), closing.end), node, index)

    def member(self, parts: list[Any]) -> Member:
        """``object.name``."""
        node, _, name = parts
        return Member(Span(self._start(node), name.end), node, name.text)

    def length(self, parts: list[Any]) -> Length:
        """``object.length()``; there is no other method."""
        node, _, method, _, closing = parts
        if method.text != "length":
            span = Span(method.start, method.end)
            self._refuse("SC110", f"there is no method '{method.text}'", span)
        return Length(Span(self._start(node), closing.end), node)

    def call(self, parts: list[Any]) -> Call:
        """``name(args)``."""
        name = parts[0]
        args = tuple(parts[2]) if len(parts) == 4 else ()
        return Call(Span(name.start, parts[-1].end), name.text, args)

    def call_void(self, parts: list[Token]) -> Call:
        """``name(void)``, an old way to write a call without arguments."""
        name, _, word, closing = parts
        if word.text != "void":
            span = Span(word.start, closing.end)
            self._refuse("SC103", f"expected '(' after the type '{word.text}'", span)
        return Call(Span(name.start, closing.end), name.text, ())

    def construct(self, parts: list[Any]) -> Construct:
        """``type(args)``."""
        type_spec = parts[0]
        if type_spec.struct is not None:
            message = "a struct cannot be defined in an expression"
            self._refuse("SC110", message, type_spec.span)
        args = tuple(parts[2]) if len(parts) == 4 else ()
        return Construct(Span(type_spec.span[0], parts[-1].end), type_spec, args)

    # --- operators

    def prefix(self, parts: list[Any]) -> Unary:
        """A prefix operator and its operand."""
        op, operand = parts
        return Unary(Span(op.start, self._end(operand)), op.text, operand)

    def chain(self, parts: list[Any]) -> list[Any]:
        """The first operator of a chain: a stack of operands with operators in between."""
        parts[1] = parts[1].text
        return parts

    def chain_more(self, parts: list[Any]) -> list[Any]:
        """One more operator; those on the stack that bind as tight or tighter are complete."""
        stack: list[Any] = parts[0]
        op = parts[1].text
        precedence = PRECEDENCE[op]
        while len(stack) > 1 and PRECEDENCE[stack[-2]] >= precedence:
            self._fold_top(stack)
        stack.append(op)
        stack.append(parts[2])
        return stack

    def fold(self, parts: list[list[Any]]) -> Expr:
        """The end of a chain: one node, the rest of its operators being complete too."""
        stack = parts[0]
        while len(stack) > 1:
            self._fold_top(stack)
        node: Expr = stack[0]
        return node

    def _fold_top(self, stack: list[Any]) -> None:
        right = stack.pop()
        op = stack.pop()
        left = stack[-1]
        stack[-1] = Binary(Span(self._start(left), self._end(right)), op, left, right)

    def conditional(self, parts: list[Any]) -> Conditional:
        """``condition ? then : other``."""
        condition, _, then, _, other = parts
        if isinstance(condition, list):
            condition = self.fold([condition])
        span = Span(self._start(condition), self._end(other))
        return Conditional(span, condition, then, other)

    def assign(self, parts: list[Any]) -> Assign:
        """``target op value``."""
        target, op, value = parts
        return Assign(Span(self._start(target), self._end(value)), op.text, target, value)

    def comma(self, parts: list[Any]) -> Comma:
        """``left, right``."""
        left, _, right = parts
        return Comma(Span(self._start(left), self._end(right)), left, right)
