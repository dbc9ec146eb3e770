"""What each directive does: one function a directive, found by its name in two tables.

Those of :data:`CONDITIONALS` are obeyed even where the text is skipped, those of :data:`HANDLERS`
only where it is read. What is wrong is raised as a :class:`DirectiveError`.

Source: The OpenGL Shading Language 4.60, section 3.3.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from shadercache.ast.nodes import Directive
from shadercache.front.preprocess import include
from shadercache.front.preprocess.conditions import evaluate
from shadercache.front.preprocess.directive_errors import DirectiveError, RunawayError
from shadercache.front.preprocess.macros import define
from shadercache.front.preprocess.reading_state import ReadingState
from shadercache.front.preprocess.scanner import is_word, spellings
from shadercache.front.preprocess.version import extension_macros, read_extension, switched
from shadercache.lang.availability import VULKAN
from shadercache.source import Span

_FILE_NAME = re.compile(r'"[^"\n]*"$')
_FIXED = frozenset(("__LINE__", "__FILE__", "__VERSION__", "defined"))
_FOR_INCLUDES = (
    "GL_ARB_shading_language_include",
    "GL_GOOGLE_cpp_style_line_directive",
    "GL_GOOGLE_include_directive",
)


@dataclass(frozen=True, slots=True)
class Line:
    """One directive: its name, what follows the name, and where it stands."""

    name: str
    rest: str
    span: Span


# --- conditions -----------------------------------------------------------------------------------


def _if(state: ReadingState, line: Line) -> None:
    groups, holds = state.file.groups, None
    # A wrong condition opens its group all the same, or the #endif would close another.
    try:
        if groups.live:
            holds = state.value(line.rest) != 0
    finally:
        groups.begin(line.span, holds)


def _ifdef(state: ReadingState, line: Line) -> None:
    groups = state.file.groups
    valid = is_word(line.rest)
    holds = (line.rest in state.macros) == (line.name == "ifdef")
    groups.begin(line.span, holds if valid else None)
    # In text that is skipped anyway nothing is a mistake.
    if not valid and groups[-1].outer:
        raise DirectiveError("SC121", f"#{line.name} is followed by the name of a macro")


def _elif(state: ReadingState, line: Line) -> None:
    groups, holds = state.file.groups, None
    try:
        # Behind a branch that was taken the condition is not evaluated and may be anything.
        holds = groups.asks and state.value(line.rest) != 0
    finally:
        groups.go_on("elif", holds)


def _else(state: ReadingState, line: Line) -> None:
    state.file.groups.go_on("else", True)
    if state.file.groups[-1].outer:
        _expect_nothing(line)


def _endif(state: ReadingState, line: Line) -> None:
    state.file.groups.end()
    if state.file.groups.live:
        _expect_nothing(line)


def _expect_nothing(line: Line) -> None:
    if line.rest:
        hint = "a remark there needs // before it"
        raise DirectiveError("SC121", f"nothing may follow #{line.name}", hint)


CONDITIONALS: dict[str, Callable[[ReadingState, Line], None]] = {
    "if": _if,
    "ifdef": _ifdef,
    "ifndef": _ifdef,
    "elif": _elif,
    "else": _else,
    "endif": _endif,
}


# --- other directives -----------------------------------------------------------------------------


def _misplaced_version(state: ReadingState, line: Line) -> None:
    raise DirectiveError("SC100", "#version must come first, and only once")


def _extension(state: ReadingState, line: Line) -> None:
    name, behaviour = read_extension(line.rest)
    every = extension_macros(state.version.number, state.version.es)
    state.enabled = switched(state.enabled, (name, behaviour), every)
    # Some are for the preprocessor alone: the text that it makes needs them no more.
    if name not in _FOR_INCLUDES and name != VULKAN:
        state.directives.append(Directive(line.span, f"#extension {name} : {behaviour}"))


def _pragma(state: ReadingState, line: Line) -> None:
    if line.rest == "once":
        state.once.add(state.file.part)
    else:
        state.directives.append(Directive(line.span, " ".join(f"#pragma {line.rest}".split())))


def _define(state: ReadingState, line: Line) -> None:
    macro = define(line.rest)
    _check_name(state, macro.name)
    if state.macros.setdefault(macro.name, macro) != macro:
        message = f"macro '{macro.name}' is defined again in another way"
        raise DirectiveError("SC108", message, f"#undef {macro.name} first")


def _undef(state: ReadingState, line: Line) -> None:
    if not is_word(line.rest):
        raise DirectiveError("SC108", "#undef is followed by the name of a macro")
    _check_name(state, line.rest)
    state.macros.pop(line.rest, None)


def _check_name(state: ReadingState, name: str) -> None:
    if name in _FIXED or name.startswith("GL_"):
        raise DirectiveError("SC108", f"the macro name '{name}' belongs to the language")
    if "__" in name and state.version.number == 100:
        message = f"the macro name '{name}' has two underscores, which GLSL ES 1.00 reserves"
        raise DirectiveError("SC108", message)


def _error(state: ReadingState, line: Line) -> None:
    raise DirectiveError("SC108", f"#error {line.rest}".rstrip())


def _line(state: ReadingState, line: Line) -> None:
    """``#line line`` or ``#line line file``; both are expressions."""
    rest = _FILE_NAME.sub("", line.rest)
    if rest != line.rest and "GL_GOOGLE_cpp_style_line_directive" not in state.enabled:
        hint = "#extension GL_GOOGLE_cpp_style_line_directive : require"
        raise DirectiveError("SC108", "the file of a #line is a number", hint)
    words = state.expander.expand(spellings(rest))
    # `#line 1 + 2` is one expression; in `#line (1) 2` the last number is the file's.
    if len(words) > 1 and words[-1].isdecimal() and _ends_value(words[-2]):
        state.set_file_number(words.pop())
    number = evaluate(words, state.version.es)
    # Before GLSL 3.30, `#line n` gave n to itself and not to the line that follows.
    counts_next = state.version.es or state.version.number >= 330
    following = number if counts_next else number + 1
    state.file.shift = following - state.source.position(line.span.end).line - 1


def _ends_value(word: str) -> bool:
    return word == ")" or word[0] == "_" or word[0].isalnum()


def _include(state: ReadingState, line: Line) -> Path:
    """The file that is to be read next."""
    # As it was written, if it has to be: "a//b" is no comment.
    number, column = state.source.position(line.span.start)
    name, quoted = include.name_of(line.rest, state.file.part.line(number)[column - 1 :])
    if len(state.files) > include.MAX_DEPTH:
        message = f"more than {include.MAX_DEPTH} files include one another here"
        raise RunawayError("SC123", message, "does a file include itself?")
    beside = state.file.folder if quoted else None
    return include.find(name, beside, state.options.include_folders)


HANDLERS: dict[str, Callable[[ReadingState, Line], Path | None]] = {
    "version": _misplaced_version,
    "extension": _extension,
    "pragma": _pragma,
    "define": _define,
    "undef": _undef,
    "error": _error,
    "line": _line,
    "include": _include,
}
