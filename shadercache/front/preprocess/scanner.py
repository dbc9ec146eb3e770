"""From characters to lexemes: comments, line continuations, words, numbers and signs.

What is taken out is replaced by blanks of the same length, so that an offset into the cleaned text
is an offset into the user's file. Only a line continuation in the middle of a word or operator is
cut out; :class:`CleanText` knows where.

Source: The OpenGL Shading Language 4.60, sections 3.1 to 3.6 and 4.1 (literals).
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field

from shadercache.diagnostics import Diagnostic
from shadercache.source import Source, Span

# Unrolled, so that each character is tried once. Of a comment that is never closed the rest of the
# text is taken, or each `/*` in it would search to the end again.
_COMMENT = re.compile(r"//[^\n]*|/\*[^*]*\*+(?:[^/*][^*]*\*+)*/|(?P<unclosed>/\*.*)", re.DOTALL)
_CONTINUATION = re.compile(r"(?:\\\r?\n)+")
_LONE_RETURN = re.compile(r"\r(?!\n)")
_NEXT_LINE = re.compile(r"\n[ \t]*([^\n]?[^\n]?)")

# A word or number runs on to the last word character, so that `2x` is one malformed number.
_LEXEME = re.compile(
    r"(\s*)("
    r"[A-Za-z_]\w*"
    r"|0[xX]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\w*"
    r"|<<=|>>=|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||\^\^|[-+*/%&^|]=|\#\#"
    r"|\S)",
    re.ASCII,
)
_BLANKS = " \t\n\r\f\v"
_NUMBER = re.compile(
    r"(?:0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)[uU]?[lLsS]?"
    r"|(?:(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?:[fF]|lf|LF|hf|HF)?",
    re.ASCII,
)

MAX_WORD = 1024
"""Characters of a name (section 3.7), and of a number, for which compilers have the same limit."""

_CHUNK = 1 << 18  # Characters; the number of lexemes is looked at after each.


@dataclass(frozen=True, slots=True)
class CleanText:
    """A file without comments and line continuations.

    ``base`` is the offset of the file in its source. ``cuts`` has, in order, the offsets into
    ``text`` before which characters are missing, and ``missing`` how many by then.
    """

    text: str
    base: int = 0
    cuts: tuple[int, ...] = ()
    missing: tuple[int, ...] = ()

    def place(self, offset: int) -> int:
        """The place in the source of an offset into the text."""
        cut = bisect_right(self.cuts, offset) if self.cuts else 0
        return self.base + offset + (self.missing[cut - 1] if cut else 0)

    def span(self, start: int, end: int) -> Span:
        """The span in the source of a range of the text."""
        # The end is that of the last character: something may be missing between it and the next.
        return Span(self.place(start), self.place(end - 1) + 1 if end > start else self.place(end))


@dataclass(slots=True)
class Lexemes:
    """The lexemes of a text, as parallel lists: spelling, start and end in the source.

    All lexemes that a macro expands to have the place where the macro is used.
    """

    texts: list[str] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    ends: list[int] = field(default_factory=list)

    def scan(self, clean: CleanText, start: int, end: int, limit: int) -> None:
        """Append the lexemes of ``clean.text[start:end]``; soon behind the ``limit`` it stops."""
        first = len(self.texts)
        while start < end and len(self.texts) <= limit:
            stop = _blank_behind(clean.text, start + _CHUNK, end)
            self._scan_chunk(clean.text, start, stop, clean.base)
            start = stop
        # Continuations inside of words are rare, so their places are put right afterwards.
        if clean.cuts:
            for index in range(first, len(self.texts)):
                at, stop = self.starts[index] - clean.base, self.ends[index] - clean.base
                self.starts[index], self.ends[index] = clean.span(at, stop)

    def cut(self, first: int) -> Lexemes:
        """Take away the lexemes from an index on."""
        tail = Lexemes(self.texts[first:], self.starts[first:], self.ends[first:])
        del self.texts[first:], self.starts[first:], self.ends[first:]
        return tail

    def add(self, other: Lexemes, first: int, behind: int) -> None:
        """Append some lexemes of another list."""
        self.texts += other.texts[first:behind]
        self.starts += other.starts[first:behind]
        self.ends += other.ends[first:behind]

    def repeat(self, texts: Sequence[str], start: int, end: int) -> None:
        """Append lexemes that all have one place."""
        self.texts += texts
        self.starts += [start] * len(texts)
        self.ends += [end] * len(texts)

    def _scan_chunk(self, text: str, start: int, end: int, base: int) -> None:
        add_text, add_start, add_end = self.texts.append, self.starts.append, self.ends.append
        # Blanks at the end are no part of a lexeme, and the pattern would try each of them.
        end = start + len(text[start:end].rstrip(_BLANKS))
        at = start + base
        # Blanks are captured too, so that places are sums of lengths and no match objects are made.
        for blank, lexeme in _LEXEME.findall(text, start, end):
            at += len(blank)
            add_text(lexeme)
            add_start(at)
            at += len(lexeme)
            add_end(at)


def _blank_behind(text: str, at: int, end: int) -> int:
    """Where a text can be cut: the next line end or blank, if one is near ``at``, else its end."""
    for blank in "\n ":
        place = text.find(blank, at, min(at + _CHUNK, end))
        if place >= 0:
            return place
    return end


def spellings(text: str) -> tuple[str, ...]:
    """The lexemes of a text without their places."""
    return tuple(lexeme for _, lexeme in _LEXEME.findall(text.rstrip(_BLANKS)))


def is_word(lexeme: str) -> bool:
    """Is it a name or keyword?"""
    return lexeme.isidentifier() and lexeme.isascii()


def is_number(lexeme: str) -> bool:
    """Is it a well-formed literal? (Suffixes: ``u``, ``l``, ``s``, ``f``, ``lf``, ``hf``.)"""
    return _NUMBER.fullmatch(lexeme) is not None


def clean(file: Source, joined: bool, errors: list[Diagnostic], root: Source) -> CleanText:
    """The text with comments and line continuations blanked and every line ended by ``\\n``.

    A file may hold any characters in comments, but no NUL: many drivers take it for the end of
    the text. What is wrong is appended to ``errors``, with its place in ``root``, of which the file
    is a part; ``joined`` is what :func:`.version.joins_comments` says of the root.
    """
    text = file.text
    nul = text.find("\0")
    if nul >= 0:
        span = Span(file.base + nul, file.base + nul + 1)
        errors.append(Diagnostic("SC101", "the file holds a NUL character", root, span))
    if text.startswith("\ufeff"):
        text = " " + text[1:]  # The byte order mark that some editors begin a file with.
    if "\r" in text:
        # A carriage return ends a line by itself; before a line feed it is a blank (section 3.1).
        text = _LONE_RETURN.sub("\n", text)
    if not joined:
        text = _blank_comments(CleanText(text, file.base), errors, root)
    cleaned = _join_lines(text, file.base)
    if joined:
        text = _blank_comments(cleaned, errors, root)
        cleaned = CleanText(text, file.base, cleaned.cuts, cleaned.missing)
    return cleaned


def _blank_comments(clean: CleanText, errors: list[Diagnostic], root: Source) -> str:
    """The text with blanks for comments. A comment that spans lines joins them (section 3.4)."""

    def blank(match: re.Match[str]) -> str:
        comment = match[0]
        if comment.startswith("//") and comment.rstrip("\r").endswith("\\"):
            _check_comment_end(clean, match, errors, root)
        elif match["unclosed"]:
            message = "this comment is never closed"
            span = clean.span(match.start(), match.start() + 2)
            errors.append(Diagnostic("SC104", message, root, span, hint="close it with */"))
        return " " * len(comment)

    return _COMMENT.sub(blank, clean.text)


def _check_comment_end(
    clean: CleanText, match: re.Match[str], errors: list[Diagnostic], root: Source
) -> None:
    """Refuse a ``//`` comment that ends in a backslash where that could swallow code."""
    # Before 4.20 some compilers continue such a comment on the next line and some do not.
    following = _NEXT_LINE.match(clean.text, match.end())
    if following and following[1] not in ("", "//"):
        message = "a comment ends in '\\', so compilers disagree on whether the next line is code"
        end = match.start() + len(match[0].rstrip())
        errors.append(Diagnostic("SC104", message, root, clean.span(end - 1, end)))


def _join_lines(text: str, base: int) -> CleanText:
    """Join each line that ends in a backslash with the next."""
    if "\\" not in text:
        return CleanText(text, base)
    pieces: list[str] = []
    cuts: list[int] = []
    missing: list[int] = []
    at = lost = 0
    for match in _CONTINUATION.finditer(text):
        pieces.append(text[at : match.start()])
        at = match.end()
        # Beside a blank it becomes blanks, which keep the offsets; in a word it is cut out.
        around = text[match.start() - 1 : match.start()] + text[at : at + 1]
        if len(around) == 2 and not any(char.isspace() for char in around):
            lost += at - match.start()
            cuts.append(at - lost)
            missing.append(lost)
        else:
            pieces.append(" " * (at - match.start()))
    return CleanText("".join([*pieces, text[at:]]), base, tuple(cuts), tuple(missing))
