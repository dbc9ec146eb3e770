"""The token that a syntax error is about, with all that its diagnostic is made from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from lark.exceptions import UnexpectedToken

from shadercache.diagnostics import Diagnostic
from shadercache.front.tokens import Edition, TokenStream
from shadercache.lang.words import keywords
from shadercache.source import Span

PAIRS = {"(": ")", "[": "]", "{": "}"}
CLOSERS = {")": "RPAR", "]": "RSQB", "}": "RBRACE"}
"""Closing brackets with their terminals."""


@dataclass(frozen=True)
class Unexpected:
    """A token that no shader could have where it stands, and what is around it.

    ``text``, ``earlier``, ``before`` and ``after`` are the spellings of the token, of the two
    before it and of the next, empty outside the file. ``callee`` is the word before the brackets
    that end before the token. ``openings`` has the brackets that are open, innermost last, each
    with the spelling before it. ``right`` has the terminals that could have come, ``values`` what
    stands unfinished on the parser's stack.
    """

    stream: TokenStream
    text: str
    kind: str
    span: Span
    before: str
    before_span: Span
    earlier: str
    after: str
    callee: str
    openings: list[tuple[str, Span, str]]
    right: frozenset[str]
    values: list[Any]

    @property
    def language(self) -> Edition:
        """The GLSL of the file."""
        return self.stream.language

    @property
    def is_keyword(self) -> bool:
        """Is the token a keyword of that GLSL?"""
        return self.text in keywords(*self.language)

    @property
    def innermost(self) -> tuple[str, Span, str]:
        """The innermost bracket that is open; outside of all it is as in a block."""
        return self.openings[-1] if self.openings else ("{", Span(0, 0), "")

    def at(
        self, span: Span, message: str, hint: str | None = None, code: str = "SC103"
    ) -> Diagnostic:
        return Diagnostic(code, message, self.stream.source, span, hint)

    def here(self, message: str, hint: str | None = None, code: str = "SC103") -> Diagnostic:
        return self.at(self.span, message, hint, code)

    def behind(self, message: str, hint: str | None = None) -> Diagnostic:
        """At the end of the token before, where something is missing."""
        return self.at(Span(self.before_span.end, self.before_span.end), message, hint)

    @property
    def place(self) -> str:
        """The unexpected token as the end of a sentence."""
        return f"before '{self.text}'" if self.text else "at the end of the file"

    @property
    def operand_missing(self) -> bool:
        # A literal may stand wherever an operand may begin, and nowhere else.
        return "LITERAL" in self.right

    @property
    def same_line(self) -> bool:
        between = Span(self.before_span.end, self.span.start)
        return "\n" not in self.stream.source.excerpt(between)


def gather(error: UnexpectedToken, stream: TokenStream) -> Unexpected:
    """What is known about the token that the parser stopped at."""
    lexemes = stream.lexemes
    # At the end nothing more was read, so the stream still points to the last lexeme.
    index = len(lexemes.texts) if error.token.type == "$END" else stream.index
    parser: Any = error.interactive_parser
    openings: list[tuple[str, Span, str]] = []
    callee = ""
    for at, text in enumerate(lexemes.texts[:index]):
        if text in PAIRS:
            openings.append((text, _place(stream, at), _spelling(stream, at - 1)))
        elif text in CLOSERS:
            # The parser took all of this, so each closing bracket has an opening one.
            _, _, callee = openings.pop()
    return Unexpected(
        stream=stream,
        text=_spelling(stream, index),
        kind=error.token.type,
        span=_place(stream, index),
        before=_spelling(stream, index - 1),
        before_span=_place(stream, index - 1),
        earlier=_spelling(stream, index - 2),
        after=_spelling(stream, index + 1),
        callee=callee if _spelling(stream, index - 1) in CLOSERS else "",
        openings=openings,
        # Not the row of the LALR state: that also has terminals which fail after a reduction.
        right=frozenset(parser.accepts()),
        values=parser.parser_state.value_stack,
    )


def _spelling(stream: TokenStream, index: int) -> str:
    texts = stream.lexemes.texts
    return texts[index] if 0 <= index < len(texts) else ""


def _place(stream: TokenStream, index: int) -> Span:
    lexemes = stream.lexemes
    if 0 <= index < len(lexemes.texts):
        return Span(lexemes.starts[index], lexemes.ends[index])
    end = len(stream.source.text.rstrip()) if index >= 0 else 0
    return Span(end, end)
