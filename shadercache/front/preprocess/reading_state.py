"""What is known while files are read from top to bottom; directives read and change it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from shadercache.ast.nodes import Directive
from shadercache.front.preprocess.conditions import evaluate, replace_defined
from shadercache.front.preprocess.directive_errors import DirectiveError
from shadercache.front.preprocess.macros import Expander, Macro
from shadercache.front.preprocess.scanner import CleanText, spellings
from shadercache.front.preprocess.version import Version
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source, Span


@dataclass(slots=True)
class _Group:
    """An ``#if`` that is open: where it stands, and what is known of its branches."""

    span: Span
    outer: bool
    live: bool
    taken: bool
    last: bool = False


class Groups(list[_Group]):
    """The conditional groups (section 3.3) that are open in one file, innermost last."""

    @property
    def live(self) -> bool:
        """Is what stands here read?"""
        return not self or self[-1].live

    @property
    def asks(self) -> bool:
        """Does the condition of an ``#elif`` here matter?"""
        return bool(self) and self[-1].outer and not self[-1].taken

    def begin(self, span: Span, holds: bool | None) -> None:
        """``#if``, ``#ifdef`` or ``#ifndef``; of one that is wrong (``None``) nothing is read."""
        self.append(_Group(span, self.live, self.live and bool(holds), holds is not False))

    def go_on(self, name: str, holds: bool | None) -> None:
        """``#elif`` or ``#else``; where a condition is wrong (``None``) no more is read."""
        if not self:
            raise DirectiveError("SC121", f"#{name} without an #if")
        group = self[-1]
        if group.last:
            raise DirectiveError("SC121", f"#{name} behind the #else of its #if")
        group.live = group.outer and bool(holds) and not group.taken
        group.taken |= holds is not False
        group.last = name == "else"

    def end(self) -> None:
        """``#endif``."""
        if not self:
            raise DirectiveError("SC121", "#endif without an #if")
        self.pop()


@dataclass(slots=True)
class OpenFile:
    """A file that is being read: the user's own, or one that is included."""

    part: Source
    text: CleanText
    folder: Path | None
    groups: Groups = field(default_factory=Groups)
    # What `#line` says: how much to add to the numbers of lines, and the number of the file.
    shift: int = 0
    number: str = "0"


class ReadingState:
    """Version, macros, kept directives, and the files that are open, innermost last."""

    def __init__(self, source: Source, options: ReadOptions, default: Version) -> None:
        self.source = source
        self.options = options
        self.version = default
        self.directives: list[Directive] = []
        self.expander = Expander(options.max_tokens, self._line_number)
        self.macros = self.expander.macros
        self.enabled: set[str] = set()
        self.files: list[OpenFile] = []
        self.once: set[Source] = set()
        self.place = Span(0, 0)  # Of the directive or macro that is being read.

    @property
    def file(self) -> OpenFile:
        """The innermost open file."""
        return self.files[-1]

    def _line_number(self) -> str:
        """What ``__LINE__`` stands for here."""
        return str(self.source.position(self.place.start).line + self.file.shift)

    def set_file_number(self, number: str) -> None:
        """Change what ``__FILE__`` stands for."""
        self.file.number = number
        self.macros["__FILE__"] = Macro("__FILE__", None, (number,))

    def define_first_macros(self) -> None:
        """Define what is a macro before the first line, the user's options aside."""
        for name in self.version.macros:
            self.macros[name] = Macro(name, None, ("1",), "1")
        version = str(self.version.number)
        self.macros["__VERSION__"] = Macro("__VERSION__", None, (version,))
        self.macros["__LINE__"] = Macro("__LINE__", None, ())
        self.set_file_number("0")
        for name in self.options.undefined:
            self.macros.pop(name, None)

    def value(self, rest: str) -> int:
        """The value of an expression in a directive."""
        words = self.expander.expand(replace_defined(spellings(rest), self.macros))
        return evaluate(words, self.version.es)
