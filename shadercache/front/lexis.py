"""From characters to lexemes: comments, line continuations, words, numbers and signs.

Everything that is taken out is replaced by blanks of the same length, so that an offset into the
cleaned text is an offset into the user's file.

Source: The OpenGL Shading Language 3.30, sections 3.1 to 3.5 and 4.1 (literals).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from shadercache.diagnostics import Diagnostic
from shadercache.source import Source, Span

_COMMENT = re.compile(r"//[^\n]*|/\*[^*]*\*+(?:[^/*][^*]*\*+)*/|(?P<unclosed>/\*.*)", re.DOTALL)
_NOT_NEWLINE = re.compile(r"[^\n]")
_CONTINUATION = re.compile(r"\\([ \t]*\n)")
_NEXT_LINE = re.compile(r"\n[ \t]*([^\n]?[^\n]?)")

# A word or number runs on to the last word character, so that `2x` is one malformed number.
_LEXEME = re.compile(
    r"(\s*)("
    r"[A-Za-z_]\w*"
    r"|0[xX]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\w*"
    r"|<<=|>>=|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||\^\^|[-+*/%&^|]="
    r"|\S)",
    re.ASCII,
)
_BLANKS = " \t\n\r\f\v"
_NUMBER = re.compile(
    r"(?:0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)[uU]?"
    r"|(?:(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?:[fF]|lf|LF)?",
    re.ASCII,
)


@dataclass(slots=True)
class Lexemes:
    """The lexemes of a text, as parallel lists: spelling, start and end in the user's file.

    All lexemes that a macro expands to have the place where the macro is used.
    """

    texts: list[str] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    ends: list[int] = field(default_factory=list)

    def scan(self, text: str, start: int, end: int) -> None:
        """Append the lexemes of ``text[start:end]``."""
        add_text, add_start, add_end = self.texts.append, self.starts.append, self.ends.append
        # Blanks at the end are no part of a lexeme, and the pattern would try each of them.
        end = start + len(text[start:end].rstrip(_BLANKS))
        at = start
        for blank, lexeme in _LEXEME.findall(text, start, end):
            at += len(blank)
            add_text(lexeme)
            add_start(at)
            at += len(lexeme)
            add_end(at)


def spellings(text: str) -> tuple[str, ...]:
    """The lexemes of a text without their places."""
    return tuple(lexeme for _, lexeme in _LEXEME.findall(text.rstrip(_BLANKS)))


def is_word(lexeme: str) -> bool:
    """Is it a name or keyword?"""
    return lexeme.isidentifier()


def is_number(lexeme: str) -> bool:
    """Is it a well-formed literal? (An integer suffix ``u``; ``f`` and, from 4.00 on, ``lf``.)"""
    return _NUMBER.fullmatch(lexeme) is not None


def clean(source: Source, errors: list[Diagnostic]) -> str:
    """The text with comments and line continuations blanked and every line ended by ``\\n``.

    A file may hold any characters in comments, but no NUL: many drivers take it for the end of
    the text. What is wrong is appended to ``errors``.
    """
    text = source.text
    nul = text.find("\0")
    if nul >= 0:
        message = "the file holds a NUL character"
        errors.append(Diagnostic("SC101", message, source, Span(nul, nul + 1)))
    if text.startswith("\ufeff"):
        text = " " + text[1:]  # The byte order mark that some editors begin a file with.
    if "\r" in text:
        text = text.replace("\r\n", " \n").replace("\r", "\n")
    text = _blank_comments(text, source, errors)
    return _join_lines(text, source, errors) if "\\" in text else text


def _blank_comments(text: str, source: Source, errors: list[Diagnostic]) -> str:
    def blank(match: re.Match[str]) -> str:
        comment = match[0]
        if comment.startswith("//"):
            if comment.rstrip().endswith("\\"):
                _check_comment_end(text, match, source, errors)
            return " " * len(comment)
        if match["unclosed"]:
            message = "this comment is never closed"
            span = Span(match.start(), match.start() + 2)
            errors.append(Diagnostic("SC104", message, source, span, hint="close it with */"))
        return _NOT_NEWLINE.sub(" ", comment)

    return _COMMENT.sub(blank, text)


def _check_comment_end(
    text: str, match: re.Match[str], source: Source, errors: list[Diagnostic]
) -> None:
    """Refuse a ``//`` comment that ends in a backslash where that could swallow code.

    Before version 4.20 some compilers continue such a comment on the next line and some do not.
    """
    following = _NEXT_LINE.match(text, match.end())
    if following and following[1] not in ("", "//"):
        message = "a comment ends in '\\', so compilers disagree on whether the next line is code"
        end = match.start() + len(match[0].rstrip())
        errors.append(Diagnostic("SC104", message, source, Span(end - 1, end)))


def _join_lines(text: str, source: Source, errors: list[Diagnostic]) -> str:
    """Blank each backslash at the end of a line, and the end of the line with it."""

    def join(match: re.Match[str]) -> str:
        around = text[match.start() - 1 : match.start()] + text[match.end() : match.end() + 1]
        if len(around) == 2 and _glues(around):
            message = "a line continuation in the middle of a word or operator is not supported"
            errors.append(Diagnostic("SC107", message, source, Span(match.start(), match.end())))
        return " " * len(match[0])

    return _CONTINUATION.sub(join, text)


def _glues(pair: str) -> bool:
    return not any(char.isspace() for char in pair) and len(spellings(pair)) == 1
