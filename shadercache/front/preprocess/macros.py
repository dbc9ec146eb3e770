"""Macros: what ``#define`` makes of its line, and the expansion of their uses.

Before::

    #define SQUARE(x) ((x) * (x))
    #define TWICE 2.0 * SQUARE
    TWICE(a + b)

After: ``2.0 * ((a + b) * (a + b))``. Arguments are expanded before they are put in, except beside
``##``; what comes out is read again together with the text that follows, and a name that comes out
of its own macro is never expanded again ("blue paint"). All of that is as in C (the specification
refers to it); there is no ``#`` that makes strings.

Source: The OpenGL Shading Language 4.60, section 3.3.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from shadercache.diagnostics import shortened
from shadercache.front.preprocess.directive_errors import LIMIT_HINT, DirectiveError, RunawayError
from shadercache.front.preprocess.scanner import MAX_WORD, is_word, spellings

MAX_NESTING = 100
"""Calls of macros that may stand in one another's arguments."""

USUAL_GROWTH = 20
"""Tokens that macros may expand to, for each character of the text."""

# As in C, only a `(` that follows the name at once begins parameters.
_DEFINITION = re.compile(r"([A-Za-z_]\w*)(\([^)]*\)?)?(.*)", re.DOTALL | re.ASCII)
_PASTE = "##"


class _Painted(str):
    """A name that came out of its own macro, and is none any more."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Macro:
    """A macro; without parameters where ``parameters`` is ``None``.

    ``spelling`` is the replacement as it was written, with single blanks: a macro may be defined
    again in the same way, and blanks count, but not how many. ``expanded`` has the parameters
    whose arguments are expanded before they are put in, because they stand away from ``##``.
    """

    name: str
    parameters: tuple[str, ...] | None
    body: tuple[str, ...]
    spelling: str = ""
    expanded: frozenset[str] = frozenset()

    @property
    def pastes(self) -> bool:
        """Is there a ``##`` in it?"""
        return _PASTE in self.body


def define(text: str) -> Macro:
    """The macro that ``#define text`` defines."""
    match = _DEFINITION.fullmatch(text)
    if match is None:
        raise DirectiveError("SC108", "#define needs the name of a macro")
    name, parameters, rest = match.groups()
    body = spellings(rest)
    if body[:1] == (_PASTE,) or body[-1:] == (_PASTE,):
        raise DirectiveError("SC108", "'##' needs a word on both sides")
    names = None if parameters is None else _parameters(parameters)
    alone = (word for at, word in enumerate(body) if not _beside_paste(body, at))
    expanded = frozenset(names or ()).intersection(alone)
    return Macro(name, names, body, " ".join(rest.split()), expanded)


def _beside_paste(body: tuple[str, ...], at: int) -> bool:
    # Slices, for they are empty at both ends; the index -1 would be the last word.
    return body[at - 1 : at] == (_PASTE,) or body[at + 1 : at + 2] == (_PASTE,)


def _parameters(text: str) -> tuple[str, ...]:
    words = spellings(text)
    # `( name , name )`: names at odd places, commas at even ones.
    names = words[1:-1:2]
    if words[-1] != ")":
        raise DirectiveError("SC108", "the list of macro parameters has no ')'")
    if words[2:-1:2] != (",",) * max(0, len(names) - 1) or not all(map(is_word, names)):
        raise DirectiveError("SC108", "the parameters of a macro are names with ',' between them")
    if len(set(names)) < len(names):
        raise DirectiveError("SC108", "a macro has two parameters of the same name")
    return names


@dataclass(slots=True)
class _Frame:
    """Lexemes and how far they are read; where a macro expands to them it has a name."""

    texts: Sequence[str]
    at: int
    name: str = ""


class _Feed:
    """Lexemes to be read, with the expansions that are read before them, innermost last.

    A macro is hidden as long as its expansion is being read.
    """

    __slots__ = ("frames", "hidden")

    def __init__(self, texts: Sequence[str], at: int, hidden: set[str]) -> None:
        self.frames = [_Frame(texts, at)]
        self.hidden = hidden

    def push(self, name: str, texts: Sequence[str]) -> None:
        self.frames.append(_Frame(texts, 0, name))
        self.hidden.add(name)

    def in_expansion(self) -> bool:
        """Is what comes next of a macro? Expansions that are read to their end are forgotten."""
        frames = self.frames
        while len(frames) > 1 and frames[-1].at == len(frames[-1].texts):
            # A hidden macro is never pushed again, so its name is that of one frame only.
            self.hidden.discard(frames.pop().name)
        return len(frames) > 1

    def peek(self) -> str | None:
        """The next lexeme, which stays."""
        self.in_expansion()
        frame = self.frames[-1]
        return frame.texts[frame.at] if frame.at < len(frame.texts) else None

    def next(self) -> str | None:
        """The next lexeme; painted where it names a macro that is hidden."""
        text = self.peek()
        if text is None:
            return None
        self.frames[-1].at += 1
        return _Painted(text) if text in self.hidden else text


class Expander:
    """The macros that are defined, and their expansion.

    ``behind`` is the index behind the last use, in the list where it was met, even of a wrong one.
    ``line`` gives the replacement of ``__LINE__``. The tokens that come out of macros are counted,
    for a few nested macros can ask for billions: :meth:`allow` more of them for a longer text, up
    to ``limit`` in all.
    """

    def __init__(self, limit: int, line: Callable[[], str]) -> None:
        self.macros: dict[str, Macro] = {}
        self.behind = 0
        self._limit = limit
        self._allowed = self._left = limit // 10
        self._line = line
        self._depth = 0

    def allow(self, characters: int) -> None:
        """A text of this length is going to be read."""
        more = min(characters * USUAL_GROWTH, self._limit - self._allowed)
        self._allowed += more
        self._left += more

    def expand(self, texts: Sequence[str], use: int | None = None) -> list[str]:
        """The expansion of a text, or of the one macro that is named at ``texts[use]``.

        A use takes more than the name if arguments follow, even those of the macro's last word:
        ``behind`` says where it ends.
        """
        feed = _Feed(texts, use or 0, set())
        self._depth = 0
        try:
            return [str(text) for text in self._run(feed, whole=use is None)]
        finally:
            # Also after a mistake: the reader goes on behind what was consumed.
            self.behind = feed.frames[0].at

    def _run(self, feed: _Feed, whole: bool) -> list[str]:
        """Expand to the end of the feed, or only its next lexeme."""
        expanded: list[str] = []
        while (text := feed.next()) is not None:
            # A painted name equals its text: only the class tells it apart.
            if text in self.macros and type(text) is not _Painted:
                self._read_macro(feed, text, expanded)
            else:
                expanded.append(text)
            if not (whole or feed.in_expansion()):
                break
        return expanded

    def _read_macro(self, feed: _Feed, name: str, expanded: list[str]) -> None:
        """Have the expansion of a macro read next; or make it, if it has no macros in it."""
        macro = self.macros[name]
        texts: Sequence[str] = macro.body
        if macro.parameters is not None:
            if feed.peek() != "(":
                expanded.append(name)  # A mere name.
                return
            raw = self._arguments(feed, macro)
            texts = _put_in(macro, raw, self._expanded(macro, raw, feed.hidden))
        elif name == "__LINE__":
            texts = (self._line(),)
        elif macro.pastes:
            texts = _put_in(macro, [], [])
        self._count(len(texts))
        if self.macros.keys().isdisjoint(texts):
            expanded += texts
        else:
            feed.push(name, texts)

    def _count(self, words: int) -> None:
        self._left -= words
        if self._left < 0:
            message = f"macros expand to more than {self._allowed} tokens"
            raise RunawayError("SC109", message, LIMIT_HINT)

    def _arguments(self, feed: _Feed, macro: Macro) -> list[list[str]]:
        """Read the arguments of a call, brackets included."""
        assert macro.parameters is not None
        arguments: list[list[str]] = [[]]
        feed.next()
        depth = 1
        while True:
            text = feed.next()
            if text is None:
                message = f"the '(' of macro '{macro.name}' is never closed"
                raise DirectiveError("SC124", message, "no directive may stand among the arguments")
            depth += (text == "(") - (text == ")")
            if depth == 0:
                break
            if text == "," and depth == 1:
                arguments.append([])
            else:
                arguments[-1].append(text)
        # `F()` is a call with one empty argument, unless the macro takes none.
        if not macro.parameters and arguments == [[]]:
            return []
        if len(arguments) != len(macro.parameters):
            raise _wrong_number(macro, len(arguments))
        return arguments

    def _expanded(self, macro: Macro, raw: list[list[str]], hidden: set[str]) -> list[list[str]]:
        """The arguments as they are put in away from ``##``: expanded by themselves."""
        # Macro calls inside of arguments are the one place where expansion recurses.
        self._depth += 1
        if self._depth > MAX_NESTING:
            raise RunawayError("SC109", f"more than {MAX_NESTING} calls of macros nest here")
        plain = []
        for name, argument in zip(macro.parameters or (), raw, strict=True):
            self._count(len(argument))
            if name in macro.expanded and not self.macros.keys().isdisjoint(argument):
                argument = self._run(_Feed(argument, 0, hidden), whole=True)
            plain.append(argument)
        self._depth -= 1
        return plain


def _wrong_number(macro: Macro, given: int) -> DirectiveError:
    wanted = len(macro.parameters or ())
    plural = "" if wanted == 1 else "s"
    message = f"macro '{macro.name}' has {wanted} parameter{plural}, but {given} are given"
    return DirectiveError("SC124", message)


def _put_in(macro: Macro, raw: list[list[str]], plain: list[list[str]]) -> list[str]:
    """The body with the arguments in it: ``plain``, but ``raw`` beside ``##``."""
    places = {name: index for index, name in enumerate(macro.parameters or ())}
    whole: list[str] = []
    for at, text in enumerate(macro.body):
        if text == _PASTE:
            continue
        place = places.get(text)
        if place is None:
            piece = [text]
        elif _beside_paste(macro.body, at):
            # An empty word stands for an empty argument, so that `##` has something to take.
            piece = raw[place] or [""]
        else:
            piece = plain[place]
        if macro.body[at - 1 : at] == (_PASTE,):
            piece = [_pasted(whole.pop(), piece[0]), *piece[1:]]
        whole += piece
    # Without the empty words that stood for empty arguments.
    return [text for text in whole if text] if macro.pastes else whole


def _pasted(left: str, right: str) -> str:
    text = left + right
    if len(text) > MAX_WORD:
        raise DirectiveError("SC124", f"'##' makes a word of more than {MAX_WORD} characters")
    if len(spellings(text)) > 1:
        raise DirectiveError("SC124", f"'##' makes '{shortened(text)}', which is not one word")
    return text
