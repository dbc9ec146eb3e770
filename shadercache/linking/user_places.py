"""What the driver says of the printed original, told at its place in the user's own file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from shadercache.analysed import Analysis
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.parse import parse
from shadercache.source import Source, Span

_PRINTED = ("original.frag", "original.vert")


@contextmanager
def at_home(analysis: Analysis) -> Iterator[None]:
    """Inside of it, errors about the printed original name the file that the user wrote."""
    try:
        yield
    except InputError as error:
        raise InputError(
            [_told(diagnostic, analysis) for diagnostic in error.diagnostics]
        ) from None


def _told(diagnostic: Diagnostic, analysis: Analysis) -> Diagnostic:
    """The diagnostic at the user's place, or at the file alone where that is not found."""
    own = (analysis.fragment, analysis.vertex or analysis.fragment)
    if diagnostic.source is None:
        # A user who wrote no vertex shader would not know what the name means.
        generated = "original.vert + " if analysis.vertex is None else ""
        message = diagnostic.message.replace(generated, "")
        for name, source in zip(_PRINTED, own, strict=True):
            message = message.replace(name, source.name)
        return replace(diagnostic, message=message)
    if diagnostic.source.name not in _PRINTED:
        return diagnostic
    stage = _PRINTED.index(diagnostic.source.name)
    written = analysis.raised[stage].module if stage < len(analysis.raised) else None
    span = written and diagnostic.span and _place(diagnostic.source, diagnostic.span, written)
    return replace(diagnostic, source=own[stage], span=span or None)


def _place(printed: Source, span: Span, written: n.Module) -> Span | None:
    """Where the smallest part of the printed text around a place stands in the user's tree.

    Both are the same tree; where they are not (proof mode prints another), there is no such place.
    """
    ones, others = list(walk(parse(printed))), list(walk(written))
    if [type(node) for node in ones] != [type(node) for node in others]:
        return None
    around = [
        (one.span.end - one.span.start, other.span)
        for one, other in zip(ones, others, strict=True)
        # What a pass has made stands nowhere in the user's text.
        if one.span.start <= span.start < one.span.end and other.span.start >= 0
    ]
    return min(around, key=lambda pair: pair[0])[1] if around else None
