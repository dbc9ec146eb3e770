"""The door of the front end: :func:`parse`, and for broken files :func:`parse_before`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from threading import Lock
from typing import Any

from shadercache.ast.large import without_collector
from shadercache.ast.nodes import Directive, Module
from shadercache.diagnostics import Diagnostic, InputError
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

_WITH_ATTRIBUTES = (
    "GL_EXT_control_flow_attributes",  # The beginning of ..._attributes2, too.
    "GL_EXT_subgroup_uniform_control_flow",
)
_OPENING = frozenset("([{")
_CLOSING = frozenset(")]}")
# The one parser of the process has a builder with the state of the file that is being parsed.
_one_at_a_time = Lock()


def parse(source: Source, options: ReadOptions = DEFAULTS) -> Module:
    """The syntax tree of a shader, with spans into ``source``.

    Raises :class:`InputError` with all errors of the preprocessor, or the first one of syntax.
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
    lexemes = _without_attributes(prepared.lexemes, prepared.directives)
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
    whole = _without_attributes(prepared.lexemes, prepared.directives)
    for lexemes, own in recoverable_beginnings(whole, offset):
        if host is not None:
            # Declarations come to stand before the lexemes and `main` behind them, so this adds the
            # number of the declarations: what is ours begins that much later.
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
    webgl = is_webgl([(source, options)]) if options.webgl is None else options.webgl
    return WEBGL if webgl else NO_VERSION


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

    extensions = enabled_extensions(prepared)
    language = Edition(prepared.version, prepared.profile == "es", extensions)
    stream = TokenStream(source, language, lexemes)
    lark, builder = load_parser()
    builder.state.begin(stream)
    try:
        return lark.parse(stream)
    except UnexpectedToken as error:
        # The mistake lies in the brackets that were added, or in that nothing follows them.
        if 0 <= own <= stream.index or (own >= 0 and error.token.type == "$END"):
            raise _CannotEndError from None
        from shadercache.front.errors import explain

        raise InputError(explain(error, stream)) from None
    finally:
        # The parser outlives the file and would keep its source and nodes alive.
        builder.state.end()


def _check_depth(source: Source, lexemes: Lexemes) -> None:
    # Passes recurse into blocks and lists, so their depth is bounded before there is a tree.
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


def _without_attributes(lexemes: Lexemes, directives: Iterable[Directive]) -> Lexemes:
    """The lexemes without ``[[unroll]]`` and the like, where an extension that has them is on."""
    # They tell a compiler how to run loops and branches, never what these mean; translators of
    # shaders write them.
    if not any(name in line.text for line in directives for name in _WITH_ATTRIBUTES):
        return lexemes
    kept = Lexemes()
    at = begin = 0
    texts = lexemes.texts
    while at < len(texts):
        behind = _behind_attribute(texts, at)
        if behind > at:
            kept.add(lexemes, begin, at)
            begin = behind
        at = max(behind, at + 1)
    kept.add(lexemes, begin, len(texts))
    return kept


def _behind_attribute(texts: Sequence[str], at: int) -> int:
    """The index behind the attribute that begins at an index, or that index if none does."""
    # No expression of GLSL begins with `[`, so two of them are never an index in an index.
    if texts[at] != "[" or texts[at + 1 : at + 2] != ["["]:
        return at
    depth = 0
    for index in range(at, len(texts)):
        depth += (texts[index] in "([") - (texts[index] in ")]")
        # No attribute holds these: the brackets are a mistake, which the parser tells.
        if texts[index] in ";{}":
            break
        if depth == 0:
            return index + 1
    return at
