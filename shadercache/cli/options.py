"""Options that several subcommands share, each declared once.

A group of options is a frozen dataclass. A command takes a group as one parameter; ``expanded``
gives typer the group's fields in its place.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass, replace
from functools import wraps
from inspect import Parameter, Signature, signature
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias, TypeVar, get_type_hints

import typer

from shadercache.analysis.mapping import MappingKind
from shadercache.caching import configuration as cached
from shadercache.caching.algorithms import ALGORITHMS, USUAL
from shadercache.caching.settings import cache_choices
from shadercache.cli.io import folder
from shadercache.cli.scenes import OpenedTarget, open_target
from shadercache.diagnostics import usage_error
from shadercache.front.read_options import MAX_TOKENS, Dialect, ReadOptions
from shadercache.transform.hoist_fetches import FetchForm

if TYPE_CHECKING:
    from shadercache.compiler import Analysis
    from shadercache.scene.description import Scene

R = TypeVar("R")

PASSES = (*(algorithm.word for algorithm in ALGORITHMS), "all")
"""What ``--passes`` takes."""

NODE_HELP = "Node: an id, a name from the scene, a text 'f(x)' or a place :LINE[:COLUMN]"
"""How a node may be named."""

# ASCII: GLSL's identifiers have no other letters, while \w alone takes those of every script.
_MACRO = re.compile(r"[A-Za-z_]\w*(\([^()]*\))?", re.ASCII)
# Nobody may redefine these (GLSL 4.60 section 3.3).
_FIXED_MACROS = frozenset(("defined", "__LINE__", "__FILE__", "__VERSION__"))

TARGET_HELP = "Scene, or a shader without one: full-screen, or shown by a made object."

VertexOption: TypeAlias = Annotated[
    Path | None,
    typer.Option(
        "--vert",
        metavar="FILE",
        help="Vertex shader of FRAG; if left out, FRAG with .vert, or one that is made.",
    ),
]
FragmentArgument: TypeAlias = Annotated[
    str, typer.Argument(metavar="FRAG", help="Fragment shader; - is stdin.")
]
UnprofitableOption: TypeAlias = Annotated[
    bool, typer.Option("--unprofitable", help="Also nodes that cost less than a fetch.")
]
FormatOption: TypeAlias = Annotated[
    cached.CacheFormat, typer.Option("--format", help="Texel format of the cache.")
]
RateOption: TypeAlias = Annotated[
    cached.PayloadRate,
    typer.Option(
        help="Compute values for each pixel, or in a picture of half or a quarter of the size, from"
        " which pixels of the same surface take them (--passes 3 alone can do that)."
    ),
]
SettingsOption: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--cache",
        metavar="KEY=VALUE,...",
        help="How the cache works: "
        + "; ".join(f"{key}: {', '.join(words)}" for key, words in cache_choices().items())
        + ". The first of each is the default.",
    ),
]


ClusterOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--cluster", metavar="ADDRESS|local:N", help="Draw on the workers of a Dask cluster."
    ),
]


@dataclass(frozen=True, kw_only=True)
class SourceOptions:
    """How the text of a shader is read."""

    define: Annotated[
        list[str] | None,
        typer.Option(
            "-D", "--define", metavar="NAME[=VALUE]", help="Define a macro, as 1 without a value."
        ),
    ] = None
    undefine: Annotated[
        list[str] | None,
        typer.Option("-U", "--undefine", metavar="NAME", help="Leave a macro undefined."),
    ] = None
    include: Annotated[
        list[Path] | None,
        typer.Option("-I", "--include", metavar="DIR", help="#include may read files from here."),
    ] = None
    dialect: Annotated[
        Dialect,
        typer.Option(
            help="auto takes a file with mainImage and without main for Shadertoy's; vulkan reads "
            "GLSL as Vulkan has it."
        ),
    ] = "glsl"
    max_tokens: Annotated[
        int, typer.Option(min=1, metavar="N", help="Tokens a shader may have, macros expanded.")
    ] = MAX_TOKENS

    def read_options(self) -> ReadOptions:
        """What the options ask for. Of two definitions of a macro the later one holds.

        Raises :class:`UsageError` SC008: a macro's name is not one, or a folder does not exist.
        """
        defines = dict(map(_definition, self.define or ()))
        for name in self.undefine or ():
            _check_macro(name, "-U")
        for path in self.include or ():
            if not path.is_dir():
                what = "is not a folder" if path.exists() else "there is no such folder"
                raise usage_error("SC008", f"-I {path}: {what}")
        return ReadOptions(
            defines=tuple(defines.items()),
            undefined=tuple(self.undefine or ()),
            include_folders=tuple(self.include or ()),
            max_tokens=self.max_tokens,
            dialect=self.dialect,
        )


@dataclass(frozen=True, kw_only=True)
class ShaderOptions(SourceOptions):
    """How a shader is read and analysed."""

    mapping: Annotated[
        MappingKind | None,
        typer.Option(
            help="Where reused values lie: on the surface (where there is one), at the same pixel "
            "of the screen, or where the shader's scPreviousClip() says."
        ),
    ] = None
    unroll: Annotated[
        bool,
        typer.Option("--unroll", help="Take loops of few trips apart; their sums are nodes."),
    ] = False
    approximate: Annotated[
        bool,
        typer.Option(
            "--approximate",
            help="Also values of the screen (derivatives, gl_FragCoord, ...): exact at rest only.",
        ),
    ] = False
    moving: Annotated[
        list[str] | None,
        typer.Option(
            "--moving",
            metavar="NAME",
            help="An attribute, texture or buffer that moves vertices and changes from frame to "
            "frame, beside those that are guessed; none: nothing is guessed.",
        ),
    ] = None

    def read_options(self) -> ReadOptions:
        options = super().read_options()
        return replace(
            options,
            unroll=self.unroll,
            approximate=self.approximate,
            moving=tuple(self.moving or ()),
        )


@dataclass(frozen=True, kw_only=True)
class SceneOptions(ShaderOptions):
    """Which scene, and how its shaders are read and analysed."""

    target: Annotated[str, typer.Argument(metavar="SCENE|FRAG", help=TARGET_HELP)]
    vert: VertexOption = None

    def opened(self, context: typer.Context, frames: Path | None = None) -> OpenedTarget:
        """What is drawn, and how to open it again; ``frames`` is a recording. Raises as
        :func:`open_target` and ``read_recording``."""
        from shadercache.scene.recording import read_recording

        reading, recording = self.read_options(), frames and read_recording(frames)
        found = open_target(context, self.target, self.vert, reading, self.mapping)
        return found.played(reading, recording) if recording else found

    def open(self, context: typer.Context, frames: Path | None = None) -> tuple[Scene, Analysis]:
        """The scene with its analysed shaders. Raises as :meth:`opened`."""
        opened = self.opened(context, frames)
        return opened.scene, opened.analysis


@dataclass(frozen=True, kw_only=True)
class CacheOptions:
    """How payloads are stored and looked up."""

    cache_format: FormatOption = "rgba16f"
    fetches: Annotated[
        FetchForm,
        typer.Option(
            help="What one pass and parked misses fetch ahead of what branches: whole fetches, or "
            "levels (needs isotropic filtering, GLSL 4.00)."
        ),
    ] = "whole"
    cache: SettingsOption = None

    @property
    def base(self) -> cached.Configuration:
        """The configuration without what ``--cache`` sets."""
        storage = cached.Storage(self.cache_format)
        return cached.Configuration(storage=storage, fetches=self.fetches)


@dataclass(frozen=True, kw_only=True)
class PictureOptions:
    """How large a scene is drawn, and which mesh.

    Raises :class:`UsageError` SC007 for what is not a size, before anything is compiled.
    """

    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "1024"
    mesh: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw this mesh (.npz) instead.")
    ] = None

    def __post_init__(self) -> None:
        parse_size(self.size)


@dataclass(frozen=True, kw_only=True)
class DrawOptions(CacheOptions, PictureOptions):
    """How variants are drawn and weighed against the original."""

    epsilon: Annotated[float, typer.Option(min=0.0, help="Depth tolerance, relative to 1/w.")] = (
        cached.DEFAULT_EPSILON
    )
    weigh: Annotated[
        bool,
        typer.Option(
            "--weigh/--no-weigh",
            help="Of several objects, leave those to their originals where caching gains nothing.",
        ),
    ] = True

    def configured(self, scene: Scene) -> cached.Configuration:
        """The configuration in a scene. Raises :class:`UsageError` SC028."""
        from shadercache.linking.cache_settings import configured

        base = replace(self.base, hit_test=cached.HitTest(epsilon=self.epsilon))
        return configured(scene, base, self.cache)


def expanded(command: Callable[..., R]) -> Callable[..., R]:
    """A command as typer reads it: the fields of a group stand in the place of the group.

    The default of a field is that of the parameter's default, where it has one.
    """
    groups: dict[str, Any] = {}
    shown: list[Parameter] = []
    # By keyword, since a parameter that must be given may then stand behind one that need not.
    kind = Parameter.KEYWORD_ONLY
    for parameter in signature(command, eval_str=True).parameters.values():
        group = parameter.annotation
        if not is_dataclass(group):
            shown.append(parameter.replace(kind=kind))
            continue
        groups[parameter.name] = group
        hints = get_type_hints(group, include_extras=True)
        for field in fields(group):
            default = getattr(parameter.default, field.name, field.default)
            if default is MISSING:
                default = Parameter.empty
            shown.append(Parameter(field.name, kind, default=default, annotation=hints[field.name]))

    @wraps(command)
    def call(**values: Any) -> R:
        for name, group in groups.items():
            given = {field.name: values.pop(field.name) for field in fields(group)}
            values[name] = group(**given)
        return command(**values)

    call.__signature__ = Signature(shown)  # type: ignore[attr-defined]
    return call


def output(purpose: str) -> Any:
    """The option ``--output`` for a folder."""
    return typer.Option("-o", "--output", metavar="DIR", parser=folder, help=purpose)


def one_of(words: Sequence[str]) -> Callable[[str], str]:
    """A parser of an option that takes one of these words."""

    def word(text: str) -> str:
        if text not in words:
            raise typer.BadParameter(f"'{text}' is not one of {', '.join(words)}")
        return text

    return word


def parse_size(text: str) -> tuple[int, int]:
    """``1024`` or ``1280x720`` as (width, height). Raises :class:`UsageError` SC007."""
    parts = text.lower().split("x")
    if len(parts) in (1, 2) and all(part.isdecimal() and 0 < int(part) <= 16384 for part in parts):
        return int(parts[0]), int(parts[-1])
    raise usage_error("SC007", f"'{text}' is not a size", "give 1024 or 1280x720, in pixels")


def split_names(texts: Sequence[str]) -> list[str]:
    """The names of nodes in lists of them: commas part them, but for those in brackets."""
    names = []
    for text in texts:
        depth, start = 0, 0
        for at, char in enumerate(text):
            depth += (char in "([{") - (char in ")]}")
            if char == "," and depth <= 0:
                names.append(text[start:at])
                start = at + 1
        names.append(text[start:])
    return [name for name in names if name.strip()]


def parse_passes(text: str) -> tuple[str, ...]:
    """The names of algorithms, from their words, such as ``1,2``, and ``all`` for the usual ones.

    Raises :class:`UsageError` SC008.
    """
    known = {algorithm.word: algorithm.name for algorithm in ALGORITHMS}
    named = {"all": USUAL, **{word: (name,) for word, name in known.items()}}
    words = _parts(text)
    if words and all(word in named for word in words):
        return tuple(dict.fromkeys(name for word in words for name in named[word]))
    hint = f"give 'all', or some of {', '.join(known)}, separated by commas"
    raise usage_error("SC008", f"'{text}' is no value for --passes", hint)


def parse_rates(text: str) -> list[cached.PayloadRate]:
    """Payload rates, from ``full,half``. Raises :class:`UsageError` SC008."""
    parts = _parts(text)
    rates = [rate for part in parts for rate in cached.DIVISORS if rate == part]
    if parts and len(rates) == len(parts):
        return rates
    hint = f"give some of {', '.join(cached.DIVISORS)}, separated by commas"
    raise usage_error("SC008", f"'{text}' is no value for --rate", hint)


def parse_periods(text: str) -> list[int]:
    """Refresh periods in frames (the look-up's arithmetic ends at 65,535)."""
    return _numbers(text, "--period", 1, 65_535)


def parse_blocks(text: str) -> list[int]:
    """Block edges in pixels: even, so that blocks hold whole 2x2 quads."""
    blocks = _numbers(text, "--block", 2, 4096)
    if any(block % 2 for block in blocks):
        raise usage_error("SC008", f"'{text}' is no value for --block", "blocks are even")
    return blocks


def _numbers(text: str, name: str, least: int, most: int) -> list[int]:
    """``1,4,32`` as numbers. Raises :class:`UsageError` SC008 for one out of its range."""
    parts = _parts(text)
    if parts and all(part.isdecimal() and least <= int(part) <= most for part in parts):
        return [int(part) for part in parts]
    hint = f"give whole numbers from {least} to {most}, separated by commas"
    raise usage_error("SC008", f"'{text}' is no value for {name}", hint)


def _parts(text: str) -> list[str]:
    return [part for part in text.split(",") if part]


def _definition(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    _check_macro(name, "-D")
    if "\n" in value or "\r" in value:
        raise usage_error("SC008", f"-D: the value of '{name}' has more than one line")
    return name, value if equals else "1"


def _check_macro(name: str, option: str) -> None:
    if name in _FIXED_MACROS:
        raise usage_error("SC008", f"{option}: the macro '{name}' belongs to the language")
    if _MACRO.fullmatch(name) is None:
        hint = "a value follows '=': -D NAME=VALUE" if option == "-D" and " " in name else None
        raise usage_error("SC008", f"{option}: '{name}' cannot be the name of a macro", hint)
