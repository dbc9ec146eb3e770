"""The one door of the front end: :func:`parse`."""

from __future__ import annotations

from threading import Lock
from typing import Any

from shadercache.ast.large import without_collector
from shadercache.ast.nodes import Module
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.comments import find_comments
from shadercache.front.dialects import host_of
from shadercache.front.lexis import Lexemes
from shadercache.front.options import DEFAULTS, ReadOptions
from shadercache.front.preprocess import Preprocessed, preprocess
from shadercache.front.version import NO_VERSION
from shadercache.source import Source, Span

MAX_BRACKETS = 1000
"""Brackets that may be open at one place."""

_OPENING = frozenset("([{")
_CLOSING = frozenset(")]}")
_one_at_a_time = Lock()


def parse(source: Source, options: ReadOptions = DEFAULTS) -> Module:
    """The syntax tree of a shader, with spans into ``source``.

    Raises :class:`InputError`: with all errors of the preprocessor, or with the first error of
    syntax.
    """
    host = host_of(source, options.dialect)
    prepared = preprocess(source, options, host.version if host else NO_VERSION)
    lexemes = prepared.lexemes
    if host is not None:
        lexemes = host.surround(lexemes, len(source.text))
    return build(source, prepared, lexemes)


def build(source: Source, prepared: Preprocessed, lexemes: Lexemes) -> Module:
    """The syntax tree of lexemes: those of ``prepared``, and what a host puts around them."""
    _check_depth(source, lexemes)
    from lark.exceptions import UnexpectedToken

    from shadercache.front.grammar import load_parser
    from shadercache.front.tokens import Language, TokenStream, enabled_extensions

    extensions = enabled_extensions(directive.text for directive in prepared.directives)
    language = Language(prepared.version, prepared.profile == "es", extensions)
    stream = TokenStream(source, language, lexemes)
    with _one_at_a_time, without_collector():
        lark, builder = load_parser()
        builder.begin(stream)
        try:
            decls: Any = lark.parse(stream)
        except UnexpectedToken as error:
            from shadercache.front.errors import explain

            raise InputError(explain(error, stream)) from None
        finally:
            builder.end()
    span = Span(0, len(source.text))
    comments = find_comments(source, prepared.lexemes)
    return Module(span, prepared.version, prepared.profile, prepared.directives, decls, comments)


def _check_depth(source: Source, lexemes: Lexemes) -> None:
    depth = 0
    for index, text in enumerate(lexemes.texts):
        if text in _OPENING:
            depth += 1
            if depth > MAX_BRACKETS:
                span = Span(lexemes.starts[index], lexemes.ends[index])
                message = f"more than {MAX_BRACKETS} brackets are open here"
                raise InputError(Diagnostic("SC105", message, source, span))
        elif text in _CLOSING:
            depth -= 1
