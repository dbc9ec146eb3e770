"""Built-in functions, variables and constants, read from ``builtins.txt`` beside this file.

The file is indexed by name when the first name is asked for; a line is parsed, and its generic
types expanded, when its name is asked for. The notation is explained at the head of the file.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from shadercache.lang.availability import (
    NO_EXTENSIONS,
    Availability,
    availability,
    data_lines,
)
from shadercache.lang.generics import expanded
from shadercache.lang.types import Type, array_of, builtin_type, struct_type
from shadercache.lang.words import NONUNIFORM, type_names

_FILE = Path(__file__).with_name("builtins.txt")

MOST_ELEMENTS = {"gl_ClipDistance": 8, "gl_CullDistance": 8}
"""Elements of built-in arrays without a size, on every driver."""


@dataclass(frozen=True, slots=True, eq=False)
class Parameter:
    """A parameter of a built-in function; into a ``constant`` only constant expressions go."""

    type: Type
    direction: str = "in"
    constant: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Signature:
    """One overload of a built-in function.

    ``derivative``: it is a derivative. ``implicit_lod``: it takes its level of detail from
    derivatives. ``texture``: it looks into a texture. ``memory``: it reads or writes an image, an
    atomic counter or a buffer. ``fragment_only``: vertex shaders do not have it. ``foldable``:
    with constant arguments it is a constant expression (section 4.3.3).
    """

    name: str
    result: Type
    params: tuple[Parameter, ...]
    derivative: bool = False
    implicit_lod: bool = False
    texture: bool = False
    memory: bool = False
    fragment_only: bool = False
    foldable: bool = True

    def __str__(self) -> str:
        """``vec4 texture(sampler2D, vec2)``."""
        params = [f"{p.direction} {p.type}".removeprefix("in ") for p in self.params]
        return f"{self.result} {self.name}({', '.join(params)})"


@dataclass(frozen=True, slots=True, eq=False)
class BuiltinVariable:
    """A built-in variable or constant.

    ``storage`` is ``in``, ``out``, ``uniform`` or ``const``; ``value`` is the least value that a
    constant may have: drivers may give it a greater one.
    """

    name: str
    type: Type
    storage: str
    value: int | None = None


@dataclass(frozen=True, slots=True)
class _Line:
    """A line of the data file; ``words`` are its own, then those of the ``@`` above it."""

    text: str
    words: tuple[str, ...]


@cache
def functions(
    name: str,
    version: int = 330,
    profile: str | None = None,
    stage: str = "fragment",
    extensions: frozenset[str] = NO_EXTENSIONS,
) -> tuple[Signature, ...]:
    """All overloads of the built-in function ``name``; none if there is no such function.

    ``profile`` is ``"es"`` for GLSL ES, 1.00 too; ``extensions`` are those that are turned on.
    """
    kinds = type_names(version, profile == "es", extensions)
    return _distinct(
        signature
        for signature, where in _all_signatures(name)
        if where.holds(version, profile, stage, extensions)
        and signature.result.name in kinds
        and all(param.type.name in kinds for param in signature.params)
    )


@cache
def overloads(name: str) -> tuple[Signature, ...]:
    """The overloads of a built-in function in all versions, stages and extensions."""
    return _distinct(signature for signature, _ in _all_signatures(name))


@cache
def nonuniform(kind: Type) -> Signature:
    """``nonuniformEXT`` of any type: it says of a value that fragments may differ in it."""
    return Signature(NONUNIFORM, kind, (Parameter(kind),), foldable=False)


def _distinct(signatures: Iterator[Signature]) -> tuple[Signature, ...]:
    # max(genType, float) and max(genType, genType) are the same for a scalar: keyed by parameters.
    kept: dict[tuple[Type, ...], Signature] = {}
    for signature in signatures:
        kept.setdefault(tuple(param.type for param in signature.params), signature)
    return tuple(kept.values())


@cache
def variable(
    name: str,
    stage: str = "fragment",
    version: int = 330,
    profile: str | None = None,
    extensions: frozenset[str] = NO_EXTENSIONS,
) -> BuiltinVariable | None:
    """The built-in variable or constant ``name`` of a stage, or ``None``."""
    for section in ("variables", "constants"):
        for line in _index()[section].get(name, ()):
            if availability(line.words).holds(version, profile, stage, extensions):
                first, second, third = line.text.split()[:3]
                if section == "constants":
                    return BuiltinVariable(name, _named_type(first), "const", int(third))
                return BuiltinVariable(name, _named_type(second), first)
    return None


def struct(name: str) -> Type | None:
    """The built-in struct of that name (``gl_DepthRangeParameters``), or ``None``."""
    return _named_type(name) if name in _index()["structs"] else None


def function_names() -> tuple[str, ...]:
    """Names of all built-in functions of any version (for hints and tests)."""
    return tuple(_index()["functions"])


def variable_names() -> tuple[str, ...]:
    """Names of all built-in variables and constants of any version and stage."""
    return (*_index()["variables"], *_index()["constants"])


def variables_of(stage: str) -> Iterator[BuiltinVariable]:
    """Every built-in variable that a stage has in any version (for tests of lists of them)."""
    for name, lines in _index()["variables"].items():
        for line in lines:
            if availability(line.words).stage in (None, stage):
                storage, kind = line.text.split()[:2]
                yield BuiltinVariable(name, _named_type(kind), storage)


def functions_of(stage: str) -> Iterator[Signature]:
    """Every overload of a built-in function that a stage has in any version."""
    for name in _index()["functions"]:
        for signature, where in _all_signatures(name):
            if where.stage in (None, stage):
                yield signature


# --- reading the file -----------------------------------------------------------------------------


@cache
def _index() -> Mapping[str, dict[str, list[_Line]]]:
    """Lines of the data file by section and name."""
    sections: dict[str, dict[str, list[_Line]]] = defaultdict(dict)
    for section, text, shared in data_lines(_FILE):
        # Variables have storage and type before the name, structs nothing, all others a type.
        at = {"structs": 0, "variables": 2}.get(section, 1)
        names = text.partition("(")[0].partition(":")[0].split()[at]
        line = _Line(text, (*_own_words(text, at), *shared))
        for name in names.split("|"):
            sections[section].setdefault(name, []).append(line)
    return sections


def _own_words(text: str, at: int) -> list[str]:
    _, bracket, tail = text.partition(")")
    return tail.split() if bracket else text.split()[at + 1 :]


@cache
def _all_signatures(name: str) -> tuple[tuple[Signature, Availability], ...]:
    lines = _index()["functions"].get(name, ())
    return tuple(signature for line in lines for signature in _signatures(name, line))


def _signatures(name: str, line: _Line) -> Iterator[tuple[Signature, Availability]]:
    """Expand one line for one of its names."""
    head, _, _ = line.text.partition(")")
    result, _, rest = head.partition(" ")
    params = rest.partition("(")[2]
    for types, has_bias in expanded(f"{result}, {params}" if params else result):
        # Only fragments have the implicit level of detail that a bias adds to (4.60 section 8.9).
        words = (*line.words, "fragment") if has_bias else line.words
        signature = Signature(
            name,
            _named_type(types[0]),
            tuple(_parameter(text) for text in types[1:]),
            derivative="derivative" in words,
            implicit_lod="lod" in words,
            texture="texture" in words,
            memory="image" in words,
            fragment_only="fragment" in words,
            foldable=not {"texture", "variable"}.intersection(words),
        )
        yield signature, availability(words)


def _parameter(text: str) -> Parameter:
    word, _, kind = text.rpartition(" ")
    constant = word == "const"
    return Parameter(_named_type(kind), "in" if constant else word or "in", constant)


@cache
def _named_type(text: str) -> Type:
    name, _, size = text.partition("[")
    kind = builtin_type(name) or _struct(name)
    if not size:
        return kind
    digits = size.rstrip("]")
    return array_of(kind, int(digits) if digits else None)


@cache
def _struct(name: str) -> Type:
    lines = _index()["structs"].get(name)
    if not lines:
        raise ValueError(f"{_FILE.name}: no type {name!r}")
    fields = (field.split() for field in lines[0].text.partition(":")[2].split(","))
    return struct_type(name, {name: _named_type(kind) for kind, name in fields})
