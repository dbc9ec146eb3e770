"""Read a shader and check it, and tell all its mistakes at once.

The parser stops at a mistake; so what stands in front of the mistake is checked by itself, that an
undeclared name in line 3 is told although a ``;`` is missing in line 90. What stands behind is
left alone: without the broken part its mistakes would often be none.
"""

from __future__ import annotations

from shadercache.ast.nodes import Module
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.foreign_shaders import recognised
from shadercache.front.parse import parse, parse_before
from shadercache.front.read_options import DEFAULTS, ReadOptions
from shadercache.sema.facts import Facts, Stage
from shadercache.source import Source
from shadercache.valid.validate import validate

# Limits: a shader that breaks one is not looked at any more closely.
_LIMITS = frozenset(("SC105", "SC109", "SC120"))
# What may be said only when all of the file, or all of its last function, is known.
_OF_WHOLE_FILES = frozenset(("SC215", "SC217"))
_OF_WHOLE_FUNCTIONS = frozenset(("SC211", "SC220"))


def read(
    source: Source,
    stage: Stage = "fragment",
    options: ReadOptions = DEFAULTS,
    *,
    needs_main: bool = False,
) -> tuple[Module, Facts]:
    """The tree of a shader and what the check found out.

    Raises :class:`InputError` with the mistakes that the check finds, or with those that keep the
    file from being parsed and the ones in front of them; of what is no GLSL, that alone.
    """
    try:
        module = _parsed(source, stage, options)
        return module, validate(module, source, stage, needs_main=needs_main)
    except InputError as error:
        foreign = recognised(source, options, error.diagnostics)
        if foreign is None:
            raise
        raise InputError(foreign) from None


def _parsed(source: Source, stage: Stage, options: ReadOptions) -> Module:
    try:
        return parse(source, options)
    except InputError as error:
        raise InputError(_with_earlier(error, source, stage, options)) from None


def _with_earlier(
    error: InputError, source: Source, stage: Stage, options: ReadOptions
) -> tuple[Diagnostic, ...]:
    """The diagnostics of an error of the preprocessor or parser, and those in front of it."""
    mistakes = error.diagnostics
    for _ in range(2):  # In front of an error of the preprocessor there may be one of syntax.
        span = mistakes[0].span
        if span is None or mistakes[0].code in _LIMITS:
            break
        try:
            module = parse_before(source, options, span.start)
        except InputError as earlier:
            mistakes = (*_in_front(earlier, span.start), *mistakes)
            continue
        if module is not None:
            return (*_mistakes(module, source, stage, span.start), *mistakes)
        break
    return mistakes


def _mistakes(module: Module, source: Source, stage: Stage, offset: int) -> tuple[Diagnostic, ...]:
    """What the check says of the beginning of a shader, without what its rest might put right."""
    try:
        validate(module, source, stage)
    except InputError as error:
        return tuple(
            diagnostic for diagnostic in _in_front(error, offset) if _stays(diagnostic, module)
        )
    return ()


def _stays(diagnostic: Diagnostic, module: Module) -> bool:
    """Is it a mistake whatever follows?"""
    last = module.decls[-1].span.start if module.decls else 0
    in_last = diagnostic.span is not None and diagnostic.span.start >= last
    return diagnostic.code not in _OF_WHOLE_FILES and not (
        in_last and diagnostic.code in _OF_WHOLE_FUNCTIONS
    )


def _in_front(error: InputError, offset: int) -> tuple[Diagnostic, ...]:
    return tuple(
        diagnostic
        for diagnostic in error.diagnostics
        if diagnostic.severity is Severity.ERROR
        and diagnostic.span
        and diagnostic.span.start < offset
    )
