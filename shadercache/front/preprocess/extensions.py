"""Extensions: which names compilers know, and what ``#extension`` may say of them.

Source: The OpenGL Shading Language 4.60, section 3.3.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from shadercache.front.preprocess.directive_errors import DirectiveError

_FILE = Path(__file__).with_name("extensions.txt")
_EXTENSION = re.compile(r"(\w+)\s*:\s*(\w+)", re.ASCII)
_BEHAVIOURS = ("require", "enable", "warn", "disable")

INCLUDES = frozenset(
    (
        "GL_ARB_shading_language_include",
        "GL_GOOGLE_cpp_style_line_directive",
        "GL_GOOGLE_include_directive",
    )
)
"""Extensions that are for the preprocessor alone: the text that it makes needs them no more."""


@cache
def _known() -> dict[str, tuple[str, str]]:
    """The extensions with the first desktop and ES version whose compilers define the macro."""
    lines = _FILE.read_text(encoding="utf-8").splitlines()
    rows = (line.split() for line in lines if not line.startswith("#"))
    return {name: (desktop, es) for name, desktop, es in rows}


@cache
def extension_macros(version: int, es: bool) -> frozenset[str]:
    """The names of extensions that are macros, with the value 1, in a version."""
    sinces = ((name, since[es]) for name, since in _known().items())
    return frozenset(name for name, since in sinces if since != "-" and int(since) <= version)


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
    if behaviour == "require" and name != "all" and name not in _known():
        message = f"the extension '{name}' is not known"
        raise DirectiveError("SC108", message, "with 'enable' it is used where the driver has it")
    return name, behaviour
