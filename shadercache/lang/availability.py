"""Where something of the language exists, as ``builtins.txt`` and ``words.txt`` say it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

NEVER = 9999
"""A version that there will not be."""

VULKAN = "GL_KHR_vulkan_glsl"
"""What is on in Vulkan GLSL, and nowhere else: an extension that no ``#extension`` turns on."""

NO_EXTENSIONS: frozenset[str] = frozenset()
_OF_ES = frozenset(("GL_EXT_frag_depth", "GL_EXT_shader_texture_lod", "GL_EXT_shadow_samplers"))
"""Extensions that desktop GLSL does not know."""


@dataclass(frozen=True, slots=True)
class Availability:
    """Where something exists: ranges of versions, one stage, extensions."""

    since: int = 110
    until: int = NEVER
    es: int = 100
    es_until: int = NEVER
    stage: str | None = None
    extensions: frozenset[str] = NO_EXTENSIONS
    extended_since: int = 0

    def holds(
        self, version: int, profile: str | None, stage: str | None, extensions: frozenset[str]
    ) -> bool:
        """Does a shader of this version, profile and stage have it?"""
        if self.stage not in (None, stage):
            return False
        on = self.extensions & extensions
        if on and version >= self.extended_since and (profile == "es" or on - _OF_ES):
            return True
        if profile == "es":
            return self.es <= version <= self.es_until
        # What the core profile dropped, the compatibility profile keeps.
        return self.since <= version and (version <= self.until or profile == "compatibility")


@cache
def availability(words: tuple[str, ...]) -> Availability:
    """What the words of a line mean, its own first."""
    given = settings(words)
    first, _, last = given.get("es", "100").replace("-", " -").partition(" ")
    return Availability(
        number(given.get("since", "110")),
        int(given.get("until", NEVER)),
        number(first or "-"),
        int(last[1:]) if first and last else NEVER,
        next((stage for stage in ("fragment", "vertex") if stage in given), None),
        frozenset("GL_" + extension for extension in given.get("ext", "").split("|") if extension),
        int(given.get("from", 0)),
    )


def settings(words: Sequence[str]) -> dict[str, str]:
    """The value of each ``key=value``; the first of a key counts."""
    return dict(word.partition("=")[::2] for word in reversed(words))


def number(text: str) -> int:
    """A version, or ``-`` for none."""
    return NEVER if text == "-" else int(text)


def data_lines(path: Path) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Section, text and shared words of each line: ``@`` has words for all lines up to the next."""
    section = ""
    shared: tuple[str, ...] = ()
    for text in path.read_text(encoding="utf-8").splitlines():
        if text.startswith("["):
            section, shared = text.strip("[]"), ()
        elif text.startswith("@"):
            shared = tuple(text[1:].split())
        elif text and not text.startswith("#"):
            yield section, text, shared
