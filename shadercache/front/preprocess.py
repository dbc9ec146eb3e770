"""The preprocessor: ``#version``, kept directives and object-like macros.

Before::

    #version 330
    #define TAU (2.0 * PI)
    float turn = TAU;

After: version 330 and the lexemes ``float turn = ( 2.0 * PI ) ;`` where the five of the macro all
have the place of its use. A directive is handled by the entry of :data:`_HANDLERS` with its name;
one without an entry is refused.

Source: The OpenGL Shading Language 3.30, section 3.3.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from shadercache.ast.nodes import Directive
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.lexis import Lexemes, clean, is_word, spellings
from shadercache.source import Source, Span

VERSIONS = (330, 400, 410, 420, 430, 440, 450, 460)
PROFILES = ("core", "compatibility")

MAX_EXPANSION = 1_000_000
"""Words that may be read in the macros of one file; a few nested macros can ask for billions."""

_DIRECTIVE = re.compile(r"^[ \t\v\f]*#[^\n]*", re.MULTILINE)
_PARTS = re.compile(r"\s*#\s*(\w*)\s*(.*)", re.DOTALL | re.ASCII)
_DEFINE = re.compile(r"([A-Za-z_]\w*)(\()?\s*(.*)", re.DOTALL | re.ASCII)
_VERSION = re.compile(r"(\d+)(?:\s+(\w+))?", re.ASCII)


@dataclass(frozen=True, slots=True)
class Preprocessed:
    """What the preprocessor makes of a file."""

    version: int
    profile: str | None
    directives: tuple[Directive, ...]
    lexemes: Lexemes


@dataclass(slots=True)
class _State:
    """What is known while the file is read from top to bottom."""

    source: Source
    errors: list[Diagnostic] = field(default_factory=list)
    version: int | None = None
    profile: str | None = None
    directives: list[Directive] = field(default_factory=list)
    macros: dict[str, tuple[str, ...]] = field(default_factory=dict)
    lexemes: Lexemes = field(default_factory=Lexemes)
    expanded: int = 0

    def refuse(self, code: str, message: str, span: Span, hint: str | None = None) -> None:
        self.errors.append(Diagnostic(code, message, self.source, span, hint))


def preprocess(source: Source, default_version: int | None = None) -> Preprocessed:
    """Read the directives of a file and expand its macros.

    ``default_version`` is that of a file without ``#version``.

    Raises :class:`InputError` with every error it finds.
    """
    state = _State(source)
    text = clean(source, state.errors)
    at = 0
    for match in _DIRECTIVE.finditer(text):
        _read_code(state, text, at, match.start())
        _read_directive(state, match)
        at = match.end()
    _read_code(state, text, at, len(text))
    if state.version is None:
        state.version = default_version
    if state.version is None and not any(error.code == "SC100" for error in state.errors):
        _refuse_missing_version(state, text)
    if state.errors or state.version is None:
        raise InputError(sorted(state.errors, key=lambda error: error.span or Span(0, 0)))
    return Preprocessed(state.version, state.profile, tuple(state.directives), state.lexemes)


def _refuse_missing_version(state: _State, text: str) -> None:
    start = len(text) - len(text.lstrip())
    end = text.find("\n", start)
    message = "without #version the file is GLSL 1.10; version 330 or 400 to 460 is needed"
    span = Span(start, end if end >= 0 else len(text))
    state.refuse("SC100", message, span, hint="begin the file with #version 330")


# --- directives -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Line:
    """One directive: its name, what follows the name, and where it stands."""

    name: str
    rest: str
    span: Span


def _read_directive(state: _State, match: re.Match[str]) -> None:
    raw = match[0]
    start = match.start() + raw.index("#")
    span = Span(start, start + len(raw.strip()))
    parts = _PARTS.match(raw)
    assert parts is not None
    name, rest = parts[1], parts[2].strip()
    if not raw.isascii():
        state.refuse("SC101", "a directive holds a character that is not ASCII", span)
    elif handler := _HANDLERS.get(name):
        handler(state, _Line(name, rest, span))
    elif name or rest:
        _refuse_directive(state, _Line(name, rest, span))


def _refuse_directive(state: _State, line: _Line) -> None:
    if line.name in _INNER and any(error.code == "SC107" for error in state.errors):
        return  # It belongs to an #if that has been refused.
    if line.name in _LATER or line.name in _INNER:
        message = f"#{line.name} is not supported yet"
        state.refuse("SC107", message, line.span, hint="preprocess the shader first")
    else:
        state.refuse("SC108", f"there is no directive #{line.name or line.rest}", line.span)


def _read_version(state: _State, line: _Line) -> None:
    if state.version is not None or state.lexemes.texts or state.directives or state.macros:
        state.refuse("SC100", "#version must come first, and only once", line.span)
        return
    match = _VERSION.fullmatch(line.rest)
    number, profile = (int(match[1]), match[2]) if match else (0, None)
    if number not in VERSIONS or profile not in (None, *PROFILES):
        message = f"GLSL version '{line.rest}' is not supported"
        hint = "the versions 330 and 400 to 460 are, with 'core', 'compatibility' or no profile"
        state.refuse("SC100", message, line.span, hint)
        return
    state.version, state.profile = number, profile


def _keep(state: _State, line: _Line) -> None:
    text = " ".join(f"#{line.name} {line.rest}".split())
    state.directives.append(Directive(line.span, text))


def _read_define(state: _State, line: _Line) -> None:
    match = _DEFINE.fullmatch(line.rest)
    if match is None:
        state.refuse("SC108", "#define needs the name of a macro", line.span)
        return
    name, body = match[1], spellings(match[3])
    if match[2]:
        message = f"macro '{name}' has parameters, which is not supported yet"
        state.refuse("SC107", message, line.span, hint="preprocess the shader first")
    elif _is_fixed(name):
        state.refuse("SC108", f"the macro name '{name}' belongs to the language", line.span)
    elif state.macros.get(name, body) != body:
        message = f"macro '{name}' is defined again in another way"
        state.refuse("SC108", message, line.span, hint=f"#undef {name} first")
    else:
        state.macros[name] = body


def _read_undef(state: _State, line: _Line) -> None:
    if not is_word(line.rest) or _is_fixed(line.rest):
        state.refuse("SC108", "#undef needs the name of a macro", line.span)
    state.macros.pop(line.rest, None)


def _read_error(state: _State, line: _Line) -> None:
    state.refuse("SC108", f"#error {line.rest}".rstrip(), line.span)


_HANDLERS: dict[str, Callable[[_State, _Line], None]] = {
    "version": _read_version,
    "extension": _keep,
    "pragma": _keep,
    "define": _read_define,
    "undef": _read_undef,
    "error": _read_error,
}
_LATER = frozenset(("if", "ifdef", "ifndef", "line", "include"))
_INNER = frozenset(("elif", "else", "endif"))


# --- macros ---------------------------------------------------------------------------------------

_FIXED = frozenset(("__LINE__", "__FILE__", "__VERSION__", "GL_core_profile", "defined"))


def _is_fixed(name: str) -> bool:
    return name in _FIXED or name.startswith("GL_")


def _read_code(state: _State, text: str, start: int, end: int) -> None:
    lexemes = Lexemes()
    lexemes.scan(text, start, end)
    used = set(lexemes.texts)
    if used.isdisjoint(_FIXED) and state.macros.keys().isdisjoint(used):
        state.lexemes.texts += lexemes.texts
        state.lexemes.starts += lexemes.starts
        state.lexemes.ends += lexemes.ends
    else:
        _expand_all(state, lexemes)


def _expand_all(state: _State, lexemes: Lexemes) -> None:
    out = state.lexemes
    for text, start, end in zip(lexemes.texts, lexemes.starts, lexemes.ends, strict=True):
        body = _body(state, text, start)
        made = (text,) if body is None else _expand(state, text, body, Span(start, end))
        for word in made:
            out.texts.append(word)
            out.starts.append(start)
            out.ends.append(end)


def _body(state: _State, name: str, at: int) -> tuple[str, ...] | None:
    """What a macro stands for; ``None`` where the name is not one."""
    match name:
        case "__LINE__":
            return (str(state.source.position(at).line),)
        case "__FILE__":
            return ("0",)
        case "__VERSION__":
            return (str(state.version),)
        case "GL_core_profile":
            return None if state.profile == "compatibility" else ("1",)
        case _:
            return state.macros.get(name)


def _expand(state: _State, name: str, body: tuple[str, ...], use: Span) -> Iterator[str]:
    """The lexemes of a macro, with the macros in it expanded, but never one inside itself."""
    open_names = [name]
    open_bodies = [iter(body)]
    hidden = {name}
    while open_bodies:
        for text in open_bodies[-1]:
            state.expanded += 1
            if state.expanded > MAX_EXPANSION:
                message = f"macros expand to more than {MAX_EXPANSION} words"
                raise InputError(Diagnostic("SC109", message, state.source, use))
            inner = None if text in hidden else _body(state, text, use.start)
            if inner is None:
                yield text
            else:
                open_names.append(text)
                open_bodies.append(iter(inner))
                hidden.add(text)
                break
        else:
            open_bodies.pop()
            hidden.discard(open_names.pop())
