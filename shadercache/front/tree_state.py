"""What the parser's callbacks share while one file is parsed, and how they make nodes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any, NoReturn, cast

from shadercache.ast.nodes import Node
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.tokens import TokenStream, TypeScopes
from shadercache.source import Span

Callback = Callable[[list[Any]], Any]


class TreeState:
    """The stream that is parsed, the scopes of names, and where nodes begin and end.

    A node's span leaves out parentheses around the node itself, but a node that holds it begins
    or ends with them. ``outer`` has the spans with parentheses, of the nodes that have any.
    """

    def __init__(self) -> None:
        self.outer: dict[Node, Span] = {}
        self.scopes = TypeScopes()
        self.stream: TokenStream

    def begin(self, stream: TokenStream) -> None:
        """Make ready for another file."""
        self.stream, self.scopes = stream, stream.scopes
        self.outer.clear()

    def end(self) -> None:
        """Let go of the file."""
        del self.stream
        self.scopes = TypeScopes()
        self.outer.clear()

    def start_of(self, node: Node) -> int:
        """Where a node begins, parentheses included."""
        return self.outer.get(node, node.span).start

    def end_of(self, node: Node) -> int:
        """Where a node ends, parentheses included."""
        return self.outer.get(node, node.span).end

    def refuse(self, code: str, message: str, span: Span, hint: str | None = None) -> NoReturn:
        """Raise an :class:`InputError`."""
        raise InputError(Diagnostic(code, message, self.stream.source, span, hint))

    def node_maker(self, kind: type[Node], pattern: str) -> Callback:
        """The callback that makes a node from the symbols of a rule."""
        # Its code is put together once, as that of a dataclass is: this runs for every node.
        symbols = pattern.split()
        types = {field.name: str(field.type) for field in fields(kind)}
        # A symbol without a field is a terminal, or a span in its place: both know their ends.
        is_token = [types.get(symbol, "str") == "str" for symbol in symbols]
        start = "parts[0].start" if is_token[0] else "start_of(parts[0])"
        end = "parts[-1].end" if is_token[-1] else "end_of(parts[-1])"
        values = [f"Span({start}, {end})"]
        for name in list(types)[1:]:
            value = f"parts[{symbols.index(name)}]" if name in symbols else "None"
            if types[name] == "str":
                value += ".text"
            elif "tuple" in types[name]:
                value = f"tuple({value} or ())"
            values.append(value)
        names = {"start_of": self.start_of, "end_of": self.end_of, "kind": kind, "Span": Span}
        return cast(Callback, eval(f"lambda parts: kind({', '.join(values)})", names))
