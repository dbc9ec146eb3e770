"""``#version``: the versions of GLSL, their profiles, and what they predefine.

Source: The OpenGL Shading Language 4.60, section 3.3; GLSL ES 3.20, section 3.4.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from shadercache.front.preprocess.directive_errors import DirectiveError

DESKTOP = (110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460)
ES = (100, 300, 310, 320)

_VERSION = re.compile(r"(\d{1,9})(?:\s+(\w+))?", re.ASCII)
_LINE = re.compile(r"^[ \t\ufeff]*(#[ \t]*version\b[^\n]*)", re.MULTILINE)
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_HINT = "there are 110 to 150, 330, 400 to 460, 100, and with 'es' 300, 310 and 320"


@dataclass(frozen=True, slots=True)
class Version:
    """A version and its profile: ``"es"`` for GLSL ES, even for 1.00, which does not say so."""

    number: int
    profile: str | None = None

    @property
    def es(self) -> bool:
        """Is it GLSL ES?"""
        return self.profile == "es"

    @property
    def counts_next_line(self) -> bool:
        """Does ``#line n`` give the number to the line that follows?"""
        return self.es or self.number >= 330

    @property
    def macros(self) -> tuple[str, ...]:
        """Names that are predefined as 1."""
        if self.es:
            return ("GL_ES", "GL_FRAGMENT_PRECISION_HIGH")
        names = ["GL_FRAGMENT_PRECISION_HIGH"] if self.number >= 130 else []
        if self.number >= 150:
            names.append("GL_core_profile")
        if self.profile == "compatibility":
            names.append("GL_compatibility_profile")
        return tuple(names)


NO_VERSION = Version(110)
"""What a shader without ``#version`` is."""


def read_version(rest: str) -> Version:
    """The version that ``#version rest`` asks for."""
    match = _VERSION.fullmatch(rest)
    if match is None:
        raise DirectiveError("SC100", "#version is followed by a number and a profile", _HINT)
    number, profile = int(match[1]), match[2]
    if number not in DESKTOP and number not in ES:
        raise DirectiveError("SC100", f"there is no GLSL version {number}", _HINT)
    if profile not in (None, "core", "compatibility", "es"):
        raise DirectiveError("SC100", f"there is no profile '{profile}'", _HINT)
    if number < 150 and profile:
        message = f"version {number} has no profiles"
        raise DirectiveError("SC100", message, f"write #version {number}")
    if number in ES and number > 100 and profile != "es":
        message = f"version {number} is one of GLSL ES"
        raise DirectiveError("SC100", message, f"write #version {number} es")
    if profile == "es" and number not in ES:
        message = f"version {number} is not one of GLSL ES"
        raise DirectiveError("SC100", message, "those with 'es' are 300, 310 and 320")
    return Version(number, "es" if number == 100 else profile)


def check_place(version: Version, before: str) -> None:
    """Refuse text before a ``#version`` where it has to begin the file (GLSL ES 3.00, section 3.3).

    Desktop versions and GLSL ES 1.00 let comments and empty lines stand before it.
    """
    if version.es and version.number >= 300 and before.strip(" \t\ufeff"):
        hint = "move it up: there may be no empty line and no comment before it"
        raise DirectiveError("SC100", "#version with 'es' must stand on the first line", hint)


def version_line(text: str) -> tuple[int, int] | None:
    """Where the ``#version`` of a text begins and ends; one in a comment is none."""
    bare = _COMMENT.sub(lambda comment: " " * len(comment[0]), text)
    found = _LINE.search(bare)
    return None if found is None else found.span(1)
