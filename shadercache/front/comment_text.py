"""The comments of a file, each with the place in the tree that it belongs to.

Before::

    // Once per pixel.
    float f = 1.0;  // The start.

After: two comments, the first anchored where ``float`` begins, the second behind the ``;``. What
they are anchored to is found among the lexemes, so no rule of the grammar knows of comments.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from dataclasses import dataclass

from shadercache.ast.nodes import Comment
from shadercache.front.preprocess import Lexemes
from shadercache.source import Source, Span

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
_GROUP = re.compile(r"[ \t]*#[ \t]*(?:if|ifdef|ifndef|elif|else)\b")
_NOT_NEWLINE = re.compile(r"[^\n]")

_OPENERS = frozenset(("{", "else"))
"""Words that a statement follows: a comment before them belongs to that statement."""

_ENDS = frozenset((";", "}", ":"))
"""What a declaration, statement or label ends with."""


@dataclass(frozen=True, slots=True)
class _File:
    """The user's file: with comments blanked, its lexemes, and its directives."""

    text: str
    words: list[str]
    starts: list[int]
    ends: list[int]
    directives: list[tuple[int, int]]


def find_comments(source: Source, lexemes: Lexemes) -> tuple[Comment, ...]:
    """The comments of the user's own file, but for those in directives and in text that an ``#if``
    leaves out."""
    text = source.text
    if "//" not in text and "/*" not in text:
        return ()
    if "\r" in text:
        # Of the same length, so that offsets stay.
        text = text.replace("\r\n", " \n").replace("\r", "\n")
    file = _read(text, lexemes)
    matches = [match for match in _COMMENT.finditer(text) if _counts(file, match.start())]
    header = _header(file, matches)
    comments = []
    for match in matches:
        span = Span(match.start(), match.start() + len(match[0].rstrip()))
        anchor = _anchor(file, match, match.end() <= header)
        comments.append(Comment(span, _tidy(match[0]), *anchor))
    return tuple(comments)


def _read(text: str, lexemes: Lexemes) -> _File:
    # Blanked first: a '#' in a comment begins no directive.
    blank = _COMMENT.sub(lambda match: _NOT_NEWLINE.sub(" ", match[0]), text)
    directives = [match.span() for match in _DIRECTIVE.finditer(blank)] if "#" in blank else []
    words, starts, ends = lexemes.texts, lexemes.starts, lexemes.ends
    if starts and max(starts) >= len(text):  # The places of included files lie behind this one.
        own = [index for index, start in enumerate(starts) if start < len(text)]
        words, starts = [words[index] for index in own], [starts[index] for index in own]
        ends = [ends[index] for index in own]
    return _File(blank, words, starts, ends, directives)


def _counts(file: _File, start: int) -> bool:
    """Is a comment neither in a directive nor in text that is left out?

    Text between two directives counts as left out where it holds code and none of it is a lexeme,
    or where it is all of a group of an ``#if`` and holds no code.
    """
    # The pair sorts behind any directive that begins there or before.
    index = bisect_right(file.directives, (start, len(file.text)))
    opening, before = file.directives[index - 1] if index else (0, 0)
    if before > start:
        return False
    after = file.directives[index][0] if index < len(file.directives) else len(file.text)
    lexeme = bisect_left(file.starts, before)
    if lexeme < len(file.starts) and file.starts[lexeme] < after:
        return True
    return file.text[before:after].isspace() and not _GROUP.match(file.text, opening)


def _header(file: _File, matches: list[re.Match[str]]) -> int:
    """Where the comments end that stand before the first lexeme, apart from it."""
    edge = file.starts[0] if file.starts else len(file.text)
    for match in reversed(matches):
        if match.end() <= edge:
            gap = file.text[match.end() : edge]
            # An empty line parts the head of a file from the comment of its first declaration.
            if gap.strip() or gap.count("\n") > 1:
                return match.end()
            edge = match.start()
    return 0


def _anchor(file: _File, match: re.Match[str], in_header: bool) -> tuple[int, bool]:
    """The offset that a comment belongs to, and whether it stands behind that."""
    if in_header:
        return 0, False
    index = bisect_left(file.starts, match.start())
    words, count = file.words, len(file.words)
    # The statement does not end at such a `}`, so no comment stands behind it.
    then_block = index and words[index - 1 : index + 1] == ["}", "else"]
    if index and words[index - 1] in _ENDS and not then_block:
        end = file.ends[index - 1]
        if "\n" not in file.text[end : match.start()]:
            return end, True
    while index < count and words[index] in _OPENERS:
        index += 1
    return (file.starts[index] if index < count else len(file.text)), False


def _tidy(comment: str) -> str:
    """The text of a comment as it is printed."""
    if comment.startswith("//"):
        # For some compilers a backslash at the end continues the comment on the next line.
        return comment.rstrip("\\ \t\r\v\f")
    return "\n".join(line.rstrip() for line in comment.split("\n"))
