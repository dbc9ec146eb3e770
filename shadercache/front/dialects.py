"""Dialects: shaders that are written for a host which declares things around them.

Before (a file of Shadertoy, with no declarations)::

    void mainImage(out vec4 fragColor, in vec2 fragCoord) { fragColor = vec4(iTime); }

After: the same lexemes at the same places, between those of ``glsl/shadertoy.glsl``, which declares
``iTime`` and the like before them and calls ``mainImage`` behind them. What the host adds has no
width: it stands at the first or behind the last character of the user's file. A uniform that the
user declares as well, say as another kind of sampler, is left to the user.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.preprocess import (
    Lexemes,
    Version,
    clean,
    joins_comments,
    read_version,
    spellings,
    version_line,
)
from shadercache.front.read_options import Dialect
from shadercache.source import Source, Span

FOLDER = Path(__file__).with_name("glsl")

OLDEST = 130
"""The first version that has all that is in the texts of the hosts."""

_MAIN = re.compile(r"\bvoid\s+(main|mainImage)\s*\(", re.ASCII)
_USER = "// The user's file stands here.\n"


@dataclass(frozen=True, slots=True)
class Host:
    """What a host puts around a file; ``version`` holds where the file names none."""

    version: Version
    declarations: tuple[tuple[str, ...], ...]
    main: tuple[str, ...]

    def needed(self, user: list[str]) -> list[tuple[str, ...]]:
        """The declarations of what no ``uniform`` of the user's lexemes declares."""
        own: set[str] = set()
        declares = False
        for word in user:
            if word in ("uniform", ";"):
                declares = word == "uniform"
            elif declares:
                # Its type and precision too, which no host's variable is called like.
                own.add(word)
        return [decl for decl in self.declarations if decl[2] not in own]

    def surround(self, user: Lexemes, end: int) -> Lexemes:
        """The lexemes of the whole; ``end`` is the length of the user's text."""
        before = [text for decl in self.needed(user.texts) for text in decl]
        whole = Lexemes()
        whole.repeat(before, 0, 0)
        whole.add(user, 0, len(user.texts))
        whole.repeat(self.main, end, end)
        return whole


def host_of(source: Source, dialect: Dialect) -> Host | None:
    """The host that a file needs; ``None`` for plain GLSL.

    ``auto`` takes a file for Shadertoy's if it defines ``mainImage`` and no ``main``. Raises
    :class:`InputError` SC125 for a file that is said to be Shadertoy's and defines ``main``.
    """
    if dialect in ("glsl", "vulkan") or (dialect == "auto" and "mainImage" not in source.text):
        return None
    # A `main` in a comment is none. Mistakes are dropped here: the preprocessor finds them again.
    text = clean(source, joins_comments(source.text), [], source)
    mains = {match[1]: match for match in _MAIN.finditer(text.text)}
    if "main" not in mains:
        return _shadertoy() if dialect == "shadertoy" or mains else None
    if dialect == "shadertoy":
        message = "a file of Shadertoy has 'mainImage', and no 'main'"
        span = text.span(mains["main"].start(1), mains["main"].end(1))
        hint = "--dialect auto tells such files from plain GLSL"
        raise InputError(Diagnostic("SC125", message, source, span, hint))
    return None


def surrounded(source: Source, dialect: Dialect) -> str:
    """The user's text with what its host adds, for a driver; raises as :func:`host_of`."""
    host = host_of(source, dialect)
    if host is None:
        return source.text
    head = map(" ".join, host.needed(re.findall(r"\w+|[^\w\s]", source.text)))
    named = version_line(source.text)
    # The user's #version moves to the top: the host's lines must not stand before it either.
    version, user = f"#version {host.version.number}", source.text
    if named is not None:
        version, user = user[slice(*named)], user[: named[0]] + user[named[1] :]
    return "\n".join([version, *head, user, " ".join(host.main), ""])


def check_version(version: Version, source: Source) -> None:
    """Can what the host adds be read in this version? If not, :class:`InputError` SC125."""
    if version.es or version.number < OLDEST:
        message = f"what Shadertoy adds to a file needs GLSL {OLDEST // 100}.{OLDEST % 100}"
        hint = "leave the #version out"
        raise InputError(Diagnostic("SC125", message, source, Span(0, 0), hint))


@cache
def _shadertoy() -> Host:
    text = (FOLDER / "shadertoy.glsl").read_text(encoding="utf-8")
    head, main = text.split(_USER)
    first, *lines = head.splitlines()
    version = read_version(first.removeprefix("#version "))
    return Host(version, tuple(spellings(line) for line in lines if line), spellings(main))
