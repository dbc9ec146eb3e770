"""The options about reading shaders, the same for every command that reads one."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Literal, TypeAlias

import typer

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.settings import cache_choices
from shadercache.diagnostics import usage_error
from shadercache.front.read_options import MAX_TOKENS, Dialect, ReadOptions
from shadercache.transform.hoist_fetches import FetchForm

_NAME = re.compile(r"[A-Za-z_]\w*(\([^()]*\))?", re.ASCII)
_FIXED = frozenset(("defined", "__LINE__", "__FILE__", "__VERSION__"))

StageName: TypeAlias = Literal["fragment", "vertex"]

DefineOption: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "-D", "--define", metavar="NAME[=VALUE]", help="Define a macro, as 1 without a value."
    ),
]
UndefineOption: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("-U", "--undefine", metavar="NAME", help="Leave a macro undefined."),
]
IncludeOption: TypeAlias = Annotated[
    list[Path] | None,
    typer.Option("-I", "--include", metavar="DIR", help="#include may read files from here."),
]
DialectOption: TypeAlias = Annotated[
    Dialect,
    typer.Option(help="auto takes a file with mainImage and without main for Shadertoy's."),
]
MappingOption: TypeAlias = Annotated[
    MappingKind | None,
    typer.Option(
        help="Where reused values lie: on the surface (where there is one), at the same pixel of "
        "the screen, or where the shader's scPreviousClip() says."
    ),
]
FetchesOption: TypeAlias = Annotated[
    FetchForm,
    typer.Option(
        help="What one pass does ahead of its branch of the payload's texture fetches: all of it; "
        "its level (needs isotropic filtering, GLSL 4.00)."
    ),
]
CacheOption: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--cache",
        metavar="KEY=VALUE,...",
        help="How the cache works: "
        + "; ".join(f"{key}: {', '.join(words)}" for key, words in cache_choices().items())
        + ". The first of each is the default.",
    ),
]
TokensOption: TypeAlias = Annotated[
    int, typer.Option(min=1, metavar="N", help="Tokens a shader may have, macros expanded.")
]
UnrollOption: TypeAlias = Annotated[
    bool,
    typer.Option("--unroll", help="Take loops of few trips apart; their sums are nodes."),
]


def read_options(
    define: Sequence[str] | None = None,
    undefine: Sequence[str] | None = None,
    include: Sequence[Path] | None = None,
    dialect: Dialect = "glsl",
    max_tokens: int = MAX_TOKENS,
    unroll: bool = False,
) -> ReadOptions:
    """What the options ask for. Of two definitions of a macro the later one holds.

    Raises:
        UsageError: SC008, the name of a macro is not one, or a folder does not exist.
    """
    defines = dict(_definition(text) for text in define or ())
    for name in undefine or ():
        _check_name(name, "-U")
    for folder in include or ():
        if not folder.is_dir():
            what = "is not a folder" if folder.exists() else "there is no such folder"
            raise usage_error("SC008", f"-I {folder}: {what}")
    return ReadOptions(
        defines=tuple(defines.items()),
        undefined=tuple(undefine or ()),
        include_folders=tuple(include or ()),
        max_tokens=max_tokens,
        dialect=dialect,
        unroll=unroll,
    )


def _definition(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    _check_name(name, "-D")
    if "\n" in value or "\r" in value:
        raise usage_error("SC008", f"-D: the value of '{name}' has more than one line")
    return name, value if equals else "1"


def _check_name(name: str, option: str) -> None:
    if name in _FIXED:
        raise usage_error("SC008", f"{option}: the macro '{name}' belongs to the language")
    if _NAME.fullmatch(name) is None:
        hint = "a value follows '=': -D NAME=VALUE" if option == "-D" and " " in name else None
        raise usage_error("SC008", f"{option}: '{name}' cannot be the name of a macro", hint)
