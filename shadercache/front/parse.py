"""The door of the front end: :func:`parse`, and for broken files :func:`parse_before`."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from threading import Lock
from typing import Any

from shadercache.ast.large import without_collector
from shadercache.ast.nodes import Module
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.attributes import without_attributes
from shadercache.front.comment_text import find_comments
from shadercache.front.dialects import Host, check_version, host_of
from shadercache.front.preprocess import (
    NO_VERSION,
    Lexemes,
    Preprocessed,
    Version,
    enabled_extensions,
    preprocess,
    preprocess_broken,
)
from shadercache.front.read_options import DEFAULTS, ReadOptions
from shadercache.front.recovery import recoverable_beginnings
from shadercache.front.webgl import WEBGL, is_webgl
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
    return _build(source, *_prepared(source, options))


def preprocessed(source: Source, options: ReadOptions) -> Preprocessed:
    """What the parser reads: the lexemes of a shader with what its host puts around them.

    Raises :class:`InputError` with all errors of the preprocessor.
    """
    prepared, lexemes = _prepared(source, options)
    return replace(prepared, lexemes=lexemes)


def _prepared(source: Source, options: ReadOptions) -> tuple[Preprocessed, Lexemes]:
    """The user's own lexemes, by which comments are placed, and all that the parser reads."""
    host = host_of(source, options.dialect)
    prepared = preprocess(source, options, _default(source, options, host))
    lexemes = without_attributes(prepared.lexemes, prepared.directives)
    if host is not None:
        check_version(Version(prepared.version, prepared.profile), source)
        lexemes = host.surround(lexemes, len(source.text))
    return prepared, lexemes


def parse_before(source: Source, options: ReadOptions, offset: int) -> Module | None:
    """The tree of what stands in front of an offset at which there is a mistake.

    It ends behind the last complete statement, or else behind the last complete declaration;
    ``None`` where that gives no tree. Raises :class:`InputError` for a mistake that stands further
    in front.
    """
    host = host_of(source, options.dialect)
    prepared = preprocess_broken(source, options, _default(source, options, host))[0]
    whole = without_attributes(prepared.lexemes, prepared.directives)
    for lexemes, own in recoverable_beginnings(whole, offset):
        if host is not None:
            own -= len(lexemes.texts) + len(host.main)
            lexemes = host.surround(lexemes, len(source.text))
            own += len(lexemes.texts)
        with suppress(_CannotEndError):
            return _build(source, prepared, lexemes, own)
    return None


def _default(source: Source, options: ReadOptions, host: Host | None) -> Version:
    """What a file is that names no version."""
    if host is not None:
        return host.version
    return WEBGL if options.webgl or is_webgl(source, options) else NO_VERSION


class _CannotEndError(Exception):
    """The text cannot end where it was made to."""


def _build(source: Source, prepared: Preprocessed, lexemes: Lexemes, own: int = -1) -> Module:
    """The tree of the lexemes; those behind the first ``own`` are ours and no fault of the user."""
    _check_depth(source, lexemes)
    with _one_at_a_time, without_collector():
        decls = _decls(source, prepared, lexemes, own)
    span = Span(0, len(source.text))
    comments = find_comments(source, prepared.lexemes)
    return Module(span, prepared.version, prepared.profile, prepared.directives, decls, comments)


def _decls(source: Source, prepared: Preprocessed, lexemes: Lexemes, own: int) -> Any:
    # Threads that import lark for the first time at once would wait for each other for ever.
    from lark.exceptions import UnexpectedToken

    from shadercache.front.grammar import load_parser
    from shadercache.front.tokens import Edition, TokenStream

    extensions = enabled_extensions(prepared.directives)
    language = Edition(prepared.version, prepared.profile == "es", extensions)
    stream = TokenStream(source, language, lexemes)
    lark, builder = load_parser()
    builder.state.begin(stream)
    try:
        return lark.parse(stream)
    except UnexpectedToken as error:
        if 0 <= own <= stream.index or (own >= 0 and error.token.type == "$END"):
            raise _CannotEndError from None
        from shadercache.front.errors import explain

        raise InputError(explain(error, stream)) from None
    finally:
        builder.state.end()


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
