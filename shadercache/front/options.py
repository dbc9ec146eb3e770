"""What can be chosen about the reading of a shader."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias

Dialect: TypeAlias = Literal["glsl", "shadertoy", "auto"]

MAX_TOKENS = 2_000_000


@dataclass(frozen=True, slots=True)
class ReadOptions:
    """Options of the front end.

    ``defines``: macros, as name and replacement, that hold from the first line on. ``undefined``:
    macros that the tool or ``defines`` would define, and that are not. ``include_folders``: where
    ``#include`` may look. ``max_tokens``: tokens a file may have, macros expanded. ``dialect``: see
    :mod:`shadercache.front.dialects`.
    """

    defines: tuple[tuple[str, str], ...] = ()
    undefined: tuple[str, ...] = ()
    include_folders: tuple[Path, ...] = ()
    max_tokens: int = MAX_TOKENS
    dialect: Dialect = "glsl"
