"""``#version`` and ``#extension``: what a shader is written in, and what that predefines.

Source: The OpenGL Shading Language 4.60, section 3.3; GLSL ES 3.20, section 3.4.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Protocol

from shadercache.ast.nodes import Directive
from shadercache.front.preprocess.directive_errors import DirectiveError
from shadercache.front.read_options import Dialect
from shadercache.lang.availability import VULKAN
from shadercache.lang.words import ES_VERSIONS, VERSIONS
from shadercache.source import Span

_EXTENSIONS = Path(__file__).with_name("extensions.txt")
_VERSION = re.compile(r"(\d{1,9})(?:\s+(\w+))?", re.ASCII)
# Possessive: a file that begins with many comments and has no #version is tried in one way only.
_VERSION_LINE = re.compile(
    r"(?:[\s\ufeff]+|//[^\n]*|/\*.*?\*/)*+(#[ \t\v\f]*version\b(?:/\*.*?\*/|[^\n])*)",
    re.DOTALL | re.ASCII,
)
_NUMBER = re.compile(r"#[ \t]*version[ \t]+(\d{3})\b[ \t]*(es\b)?", re.ASCII)
_HINT = "there are 110 to 150, 330, 400 to 460, 100, and with 'es' 300, 310 and 320"
_EXTENSION = re.compile(r"(\w+)\s*:\s*(\w+)", re.ASCII)
_EXTENSION_LINE = re.compile(r"\s*#\s*extension\s+(\w+)\s*:\s*(\w+)\s*", re.ASCII)
_BEHAVIOURS = ("require", "enable", "warn", "disable")


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
    def macros(self) -> tuple[str, ...]:
        """Names that are predefined as 1, those of extensions among them."""
        extensions = extension_macros(self.number, self.es)
        if self.es:
            return ("GL_ES", "GL_FRAGMENT_PRECISION_HIGH", *extensions)
        names = ["GL_FRAGMENT_PRECISION_HIGH"] if self.number >= 130 else []
        if self.number >= 150:
            names.append("GL_core_profile")
        if self.profile == "compatibility":
            names.append("GL_compatibility_profile")
        return (*names, *extensions)


NO_VERSION = Version(110)
"""What a shader without ``#version`` is."""

VULKAN_LINE = Directive(Span(0, 0), f"#extension {VULKAN} : enable")
"""What marks a tree of Vulkan GLSL. It is never printed: no compiler asks for it."""


def read_version(rest: str) -> Version:
    """The version that ``#version rest`` asks for."""
    match = _VERSION.fullmatch(rest)
    if match is None:
        raise DirectiveError("SC100", "#version is followed by a number and a profile", _HINT)
    number, profile = int(match[1]), match[2]
    message, hint = None, _HINT
    if number not in VERSIONS and number not in ES_VERSIONS:
        message = f"there is no GLSL version {number}"
    elif profile not in (None, "core", "compatibility", "es"):
        message = f"there is no profile '{profile}'"
    elif number < 150 and profile:
        message, hint = f"version {number} has no profiles", f"write #version {number}"
    elif number in ES_VERSIONS and number > 100 and profile != "es":
        message, hint = f"version {number} is one of GLSL ES", f"write #version {number} es"
    elif profile == "es" and number not in ES_VERSIONS:
        message = f"version {number} is not one of GLSL ES"
        hint = "those with 'es' are 300, 310 and 320"
    if message is not None:
        raise DirectiveError("SC100", message, hint)
    return Version(number, "es" if number == 100 else profile)


def check_dialect(version: Version, dialect: Dialect) -> None:
    """Refuse versions that there are not in a dialect (GL_KHR_vulkan_glsl; glslang)."""
    if dialect != "vulkan":
        return
    if version.number < (310 if version.es else 140):
        hint = "write #version 450"
        raise DirectiveError("SC125", "Vulkan GLSL begins with GLSL 1.40 and GLSL ES 3.10", hint)
    if version.profile == "compatibility":
        raise DirectiveError("SC125", "Vulkan GLSL has no compatibility profile", "leave it out")


def check_place(version: Version, before: str) -> None:
    """Refuse text before a ``#version`` where it has to begin the file."""
    # Other versions let comments and empty lines stand before it (GLSL ES 3.00, section 3.3).
    if version.es and version.number >= 300 and before.strip(" \t\ufeff"):
        hint = "move it up: there may be no empty line and no comment before it"
        raise DirectiveError("SC100", "#version with 'es' must stand on the first line", hint)


def version_line(text: str) -> tuple[int, int] | None:
    """Where the ``#version`` begins and ends that a text begins with, if there is one."""
    match = _VERSION_LINE.match(text)
    return None if match is None else match.span(1)


def joins_comments(text: str) -> bool:
    """Does the version of a shader continue ``//`` comments behind a backslash?"""
    # GLSL 4.20 and ES 3.00 join lines before they look for comments (section 3.1). The versions
    # before know no line continuation, though compilers take them outside of comments.
    line = version_line(text)
    match = _NUMBER.match(text, line[0]) if line else None
    return match is not None and int(match[1]) >= (300 if match[2] else 420)


@cache
def _known_extensions() -> dict[str, tuple[str, str]]:
    """The extensions with the first desktop and ES version whose compilers define the macro."""
    lines = _EXTENSIONS.read_text(encoding="utf-8").splitlines()
    rows = (line.split() for line in lines if not line.startswith("#"))
    return {name: (desktop, es) for name, desktop, es in rows}


@cache
def extension_macros(version: int, es: bool) -> frozenset[str]:
    """The names of extensions that are macros, with the value 1, in a version."""
    # A bool as index: False is the desktop's version, True that of ES.
    sinces = ((name, since[es]) for name, since in _known_extensions().items())
    return frozenset(name for name, since in sinces if since != "-" and int(since) <= version)


class Headed(Protocol):
    """A file or a tree: what its first lines say of it."""

    @property
    def version(self) -> int: ...
    @property
    def profile(self) -> str | None: ...
    @property
    def directives(self) -> Iterable[Directive]: ...


def written_lines(part: Headed) -> list[str]:
    """The kept directives of a file as a compiler may be given them."""
    return [line.text for line in part.directives if line.text != VULKAN_LINE.text]


def enabled_extensions(part: Headed) -> frozenset[str]:
    """Names of the extensions that the kept directives of a file leave on."""
    names: frozenset[str] = frozenset()
    every = extension_macros(part.version, part.profile == "es")
    for directive in part.directives:
        line = _EXTENSION_LINE.fullmatch(directive.text)
        if line is not None:
            names = switched(names, (line[1], line[2]), every)
    return names


def switched(on: frozenset[str], line: tuple[str, str], every: frozenset[str]) -> frozenset[str]:
    """The extensions that are on behind an ``#extension`` line of this name and behaviour.

    ``every``: those that there are. ``all`` overrides every line before it, and ``warn`` is as good
    as ``enable`` but for the warnings.
    """
    name, behaviour = line
    if name == "all":
        return every if behaviour == "warn" else frozenset()
    return on - {name} if behaviour == "disable" else on | {name}


def read_extension(rest: str) -> tuple[str, str]:
    """Name and behaviour that an ``#extension`` line gives."""
    match = _EXTENSION.fullmatch(rest)
    if match is None:
        raise DirectiveError("SC108", "#extension is followed by 'name : behaviour'")
    name, behaviour = match.groups()
    if behaviour not in _BEHAVIOURS:
        message = f"'{behaviour}' is no behaviour of an extension"
        raise DirectiveError("SC108", message, "it is require, enable, warn or disable")
    if name == "all" and behaviour in ("require", "enable"):
        raise DirectiveError("SC108", f"'all' cannot be followed by '{behaviour}'")
    if behaviour == "require" and name != "all" and name not in _known_extensions():
        message = f"the extension '{name}' is not known"
        raise DirectiveError("SC108", message, "with 'enable' it is used where the driver has it")
    return name, behaviour
