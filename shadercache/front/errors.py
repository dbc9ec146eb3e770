"""Syntax errors in a programmer's words."""

from __future__ import annotations

from lark.exceptions import UnexpectedToken

from shadercache.diagnostics import Diagnostic
from shadercache.front.tokens import TokenStream
from shadercache.source import Span


def explain(error: UnexpectedToken, stream: TokenStream) -> Diagnostic:
    token = error.token
    end = len(stream.source.text)
    span = Span(end, end) if token.type == "$END" else Span(token.start, token.end)
    return Diagnostic("SC103", f"unexpected {token.type}", stream.source, span)
