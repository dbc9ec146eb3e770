"""The door to a typed tree: :func:`read` parses and checks, and tells of all mistakes together."""

from __future__ import annotations

from shadercache.ast.nodes import FunctionDef, Module
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.options import DEFAULTS, ReadOptions
from shadercache.front.parse import parse
from shadercache.front.prefix import parse_before
from shadercache.sema.check import check
from shadercache.sema.facts import Facts, Stage
from shadercache.source import Source

# What may be said of a function only when all of it is known.
_OF_WHOLE_FUNCTIONS = ("SC211", "SC220")


def read(
    source: Source,
    stage: Stage = "fragment",
    options: ReadOptions = DEFAULTS,
    *,
    needs_main: bool = False,
) -> tuple[Module, Facts]:
    """The tree of a shader and the facts about it.

    Raises :class:`InputError` with every mistake found. Where the syntax is wrong these are the
    mistakes of the preprocessor or the first one of syntax, and before them those in what stands
    before.
    """
    try:
        module = parse(source, options)
    except InputError as error:
        raise InputError([*_before(source, error, stage, options), *error.diagnostics]) from None
    return module, check(module, source, stage, needs_main=needs_main)


def _before(
    source: Source, error: InputError, stage: Stage, options: ReadOptions
) -> list[Diagnostic]:
    """Mistakes before the first one of syntax, or of the preprocessor."""
    starts = [item.span.start for item in error.diagnostics if item.span is not None]
    place = min(starts, default=0)
    if place <= 0 or place > len(source.text):
        return []
    try:
        module = parse_before(source, place, options)
    except InputError as earlier:
        return [*_before(source, earlier, stage, options), *earlier.diagnostics]
    if module is None:
        return []
    try:
        check(module, source, stage)
    except InputError as found:
        return [item for item in found.diagnostics if _holds(item, module)]
    return []


def _holds(item: Diagnostic, module: Module) -> bool:
    """Is it a mistake whatever follows?"""
    if item.severity is not Severity.ERROR or item.span is None or not module.decls:
        return False
    last = module.decls[-1]
    cut = isinstance(last, FunctionDef) and item.span.start >= last.span.start
    return not (cut and item.code in _OF_WHOLE_FUNCTIONS)
