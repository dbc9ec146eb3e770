"""The parser's callbacks, which build the tree from the bottom up, without a second walk.

Lark calls the callback that a rule of ``grammars/glsl.lark`` is named after with the values of its
symbols: a :class:`Token` for a terminal, ``None`` for what is left out, else what an earlier
callback returned. Most rules say by a pattern which symbol becomes which field of a node; the
callbacks of the others are methods.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Expr, Node
from shadercache.front.declaration_callbacks import DeclarationRules, TypeRules
from shadercache.front.tokens import Token
from shadercache.front.tree_state import Callback, TreeState
from shadercache.lang.words import PRECEDENCE
from shadercache.source import Span

MAX_STATEMENTS = 256
"""Statements that may nest; each ``else if`` counts as one inside the last."""

# The node of a rule and the field of each symbol, `_` for a symbol that only bounds the span.
_NODES: dict[str, tuple[type[Node], str]] = {
    "name": (n.Name, "name"),
    "literal": (n.Literal, "text"),
    "postfix": (n.Postfix, "operand op"),
    "index": (n.Index, "object _ index _"),
    "member": (n.Member, "object _ name"),
    "call": (n.Call, "name _ args _"),
    "prefix": (n.Unary, "op operand"),
    "conditional": (n.Conditional, "condition _ then _ other"),
    "assign": (n.Assign, "target op value"),
    "comma": (n.Comma, "left _ right"),
    "function_def": (n.FunctionDef, "proto body"),
    "expr_stmt": (n.ExprStmt, "expr _"),
    "empty_stmt": (n.ExprStmt, "_"),
    "case_label": (n.Case, "_ value _"),
    "default_label": (n.Case, "_ _"),
    "jump_stmt": (n.Jump, "word _"),
    "return_stmt": (n.Return, "_ value _"),
}

# Those at whose end a scope is closed.
_SCOPES: dict[str, tuple[type[Node], str]] = {
    "compound": (n.Block, "_ body _"),
    "if_stmt": (n.If, "_ _ condition _ then"),
    "if_else": (n.If, "_ _ condition _ then _ other"),
    "switch_stmt": (n.Switch, "_ _ selector _ _ body _"),
    "while_stmt": (n.While, "_ _ condition _ body"),
    "do_stmt": (n.DoWhile, "_ body _ _ condition _ _"),
    "for_stmt": (n.For, "_ _ init condition _ step _ body"),
}


class TreeBuilder:
    """All callbacks of the grammar, and the state that they share."""

    def __init__(self) -> None:
        self.state = TreeState()
        makers = {rule: self.state.node_maker(*pattern) for rule, pattern in _NODES.items()}
        scopes = {rule: self._scope_maker(*pattern) for rule, pattern in _SCOPES.items()}
        self.callbacks = SimpleNamespace(
            empty=lambda parts: [],
            first=lambda parts: parts,
            append=_append,
            append_after_comma=_append,
            **makers,
            **scopes,
        )
        for kind in (_Expressions, TypeRules, DeclarationRules, _Statements):
            rules: Any = kind(self.state)
            for name in dir(rules):
                if not name.startswith("_"):
                    setattr(self.callbacks, name, getattr(rules, name))

    def _scope_maker(self, kind: type[Node], pattern: str) -> Callback:
        make = self.state.node_maker(kind, pattern)

        def close_and_make(parts: list[Any]) -> Any:
            self.state.scopes.close()
            return make(parts)

        return close_and_make


def _append(parts: list[Any]) -> list[Any]:
    """A list and one more element, with or without a comma between."""
    # In place: a copy for each element would take quadratic time.
    elements: list[Any] = parts[0]
    elements.append(parts[-1])
    return elements


class _Expressions:
    def __init__(self, state: TreeState) -> None:
        self._state = state
        self._start_of, self._end_of = state.start_of, state.end_of
        self._conditional = state.node_maker(*_NODES["conditional"])

    def parens(self, parts: list[Any]) -> Expr:
        opening, node, closing = parts
        self._state.outer[node] = Span(opening.start, closing.end)
        return cast(Expr, node)

    def length(self, parts: list[Any]) -> n.Length:
        node, _, method, _, closing = parts
        if method.text != "length":
            self._state.refuse("SC110", f"there is no method '{method.text}'", method.span)
        return n.Length(Span(self._start_of(node), closing.end), node)

    def call_void(self, parts: list[Token]) -> n.Call:
        """``name(void)``, an old way to write a call without arguments."""
        name, _, word, closing = parts
        if word.text != "void":
            span = Span(word.start, closing.end)
            self._state.refuse("SC103", f"expected '(' after the type '{word.text}'", span)
        return n.Call(Span(name.start, closing.end), name.text, ())

    def construct(self, parts: list[Any]) -> n.Construct:
        type_spec, _, args, closing = parts
        if type_spec.struct is not None:
            message = "a struct cannot be defined in an expression"
            self._state.refuse("SC110", message, type_spec.span)
        return n.Construct(Span(type_spec.span.start, closing.end), type_spec, tuple(args or ()))

    def chain(self, parts: list[Any]) -> list[Any]:
        """The first operator of a chain: a stack of operands with operators in between."""
        parts[1] = parts[1].text
        return parts

    def chain_more(self, parts: list[Any]) -> list[Any]:
        """One more operator; those on the stack that bind as tight or tighter are complete."""
        stack, operator, operand = parts
        precedence = PRECEDENCE[operator.text]
        # `>=`, because all binary operators associate to the left (section 5.1).
        while len(stack) > 1 and PRECEDENCE[stack[-2]] >= precedence:
            self._fold_top(stack)
        stack += (operator.text, operand)
        return cast(list[Any], stack)

    def fold(self, parts: list[list[Any]]) -> Expr:
        """The end of a chain: one node, the rest of its operators being complete too."""
        stack = parts[0]
        while len(stack) > 1:
            self._fold_top(stack)
        return cast(Expr, stack[0])

    def _fold_top(self, stack: list[Any]) -> None:
        right = stack.pop()
        op = stack.pop()
        left = stack[-1]
        stack[-1] = n.Binary(Span(self._start_of(left), self._end_of(right)), op, left, right)

    def chain_conditional(self, parts: list[Any]) -> n.Conditional:
        condition = self.fold(parts[:1])
        return cast(n.Conditional, self._conditional([condition, *parts[1:]]))


class _Statements:
    def __init__(self, state: TreeState) -> None:
        self._state = state
        self._block = state.node_maker(*_SCOPES["compound"])

    def start(self, parts: list[list[Any]]) -> tuple[n.Decl, ...]:
        return tuple(decl for decl in parts[0] if decl is not None)

    def no_decl(self, parts: list[Token]) -> None:
        """A ``;`` of its own between declarations says nothing."""

    def open_scope(self, parts: list[Token]) -> Span:
        """The word or brace that a statement begins with."""
        span = parts[0].span
        if self._state.scopes.open() > MAX_STATEMENTS:
            self._state.refuse("SC105", f"more than {MAX_STATEMENTS} statements nest here", span)
        return span

    def body(self, parts: list[Any]) -> n.Block:
        """The body of a function; the scope of the parameters ends with it."""
        self._state.scopes.close()
        self._state.scopes.close()
        return cast(n.Block, self._block(parts))

    def decl_stmt(self, parts: list[Any]) -> n.DeclStmt:
        decl = parts[0]
        if isinstance(decl, n.BlockDecl):
            message = "an interface block must not stand in a function"
            self._state.refuse("SC110", message, decl.span)
        return n.DeclStmt(decl.span, decl)
