"""What is known while files are read from top to bottom; directives read and change it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from shadercache.ast.nodes import Directive
from shadercache.front.preprocess.conditional_groups import Groups
from shadercache.front.preprocess.conditions import evaluate, replace_defined
from shadercache.front.preprocess.extensions import extension_macros
from shadercache.front.preprocess.macros import Expander, Macro
from shadercache.front.preprocess.scanner import CleanText, spellings
from shadercache.front.preprocess.version import Version
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source, Span


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
        version, es = self.version.number, self.version.es
        for name in (*self.version.macros, *extension_macros(version, es)):
            self.macros[name] = Macro(name, None, ("1",), "1")
        self.macros["__VERSION__"] = Macro("__VERSION__", None, (str(version),))
        self.set_file_number("0")
        self.macros["__LINE__"] = Macro("__LINE__", None, ())
        for name in self.options.undefined:
            self.macros.pop(name, None)

    def value(self, rest: str) -> int:
        """The value of an expression in a directive."""
        words = self.expander.expand_all(replace_defined(spellings(rest), self.macros))
        return evaluate(words, self.version.es)
