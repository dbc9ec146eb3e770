"""What is known while files are read from top to bottom; directives read and change it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from shadercache.ast.nodes import Directive
from shadercache.diagnostics import Diagnostic
from shadercache.front.preprocess.conditions import evaluate, replace_defined
from shadercache.front.preprocess.directive_errors import DirectiveError, RunawayError, StopReading
from shadercache.front.preprocess.include import MAX_TEXT
from shadercache.front.preprocess.macros import Expander, Macro, define
from shadercache.front.preprocess.scanner import CleanText, Lexemes, clean, spellings
from shadercache.front.preprocess.version import Version, joins_comments
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source, Span

MAX_ERRORS = 100
"""Mistakes that are told; after that many no one reads on."""


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
        self.enabled: frozenset[str] = frozenset()
        self.files: list[OpenFile] = []
        self.once: set[Source] = set()
        self.place = Span(0, 0)  # Of the directive or macro that is being read.
        self.lexemes = Lexemes()
        self.errors: list[Diagnostic] = []
        self.room = MAX_TEXT  # Characters that included files may still have.
        self._joined = joins_comments(source.text)

    @property
    def file(self) -> OpenFile:
        """The innermost open file."""
        return self.files[-1]

    def open(self, part: Source, folder: Path | None) -> None:
        """Begin a file, which may include others of its folder."""
        text = clean(part, self._joined, self.errors, self.source)
        self.files.append(OpenFile(part, text, folder))

    def tell(self, mistake: DirectiveError, span: Span) -> None:
        """Note a mistake, and go on if that makes sense."""
        error = Diagnostic(mistake.code, mistake.message, self.source, span, mistake.hint)
        self.errors.append(error)
        if isinstance(mistake, RunawayError) or len(self.errors) >= MAX_ERRORS:
            raise StopReading

    def _line_number(self) -> str:
        """What ``__LINE__`` stands for here."""
        return str(self.source.position(self.place.start).line + self.file.shift)

    def set_file_number(self, number: str) -> None:
        """Change what ``__FILE__`` stands for."""
        self.file.number = number
        self.macros["__FILE__"] = Macro("__FILE__", None, (number,))

    def define_first_macros(self) -> None:
        """Define what is a macro before the first line."""
        for name in self.version.macros:
            self.macros[name] = Macro(name, None, ("1",), "1")
        version = str(self.version.number)
        self.macros["__VERSION__"] = Macro("__VERSION__", None, (version,))
        if self.options.dialect == "vulkan":
            self.macros["VULKAN"] = Macro("VULKAN", None, ("100",), "100")
        # Only a name: the expander asks for its replacement at each use.
        self.macros["__LINE__"] = Macro("__LINE__", None, ())
        self.set_file_number("0")
        for name in self.options.undefined:
            self.macros.pop(name, None)
        for name, value in self.options.defines:
            try:
                macro = define(f"{name} {value}")
                self.macros[macro.name] = macro
            except DirectiveError as mistake:
                message = f"cannot define '{name}': {mistake.message}"
                self.errors.append(Diagnostic(mistake.code, message, hint=mistake.hint))

    def value(self, rest: str) -> int:
        """The value of an expression in a directive."""
        # `defined` asks for names, so it is answered before macros are expanded.
        words = self.expander.expand(replace_defined(spellings(rest), self.macros))
        return evaluate(words, self.version.es)
