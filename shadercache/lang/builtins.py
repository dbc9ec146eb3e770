"""Built-in functions, variables and constants, read from ``builtins.txt`` beside this file.

The file is indexed by name when the first name is asked for; a line is parsed, and its generic
types expanded, when its name is asked for. The notation is explained at the head of the file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from shadercache.lang.generics import expanded
from shadercache.lang.types import Type, array_of, builtin_type, struct_type
from shadercache.lang.words import type_names

_FILE = Path(__file__).with_name("builtins.txt")

_NEVER = 9999
NO_EXTENSIONS: frozenset[str] = frozenset()
_OF_ES = frozenset(("GL_EXT_frag_depth", "GL_EXT_shader_texture_lod", "GL_EXT_shadow_samplers"))
"""Extensions that desktop GLSL does not know."""
MOST_ELEMENTS = {"gl_ClipDistance": 8, "gl_CullDistance": 8}
"""Elements of built-in arrays without a size, on every driver."""


@dataclass(frozen=True, slots=True, eq=False)
class Parameter:
    """A parameter of a built-in function.

    ``direction`` is ``in``, ``out`` or ``inout``; ``constant``: only constant expressions go in.
    """

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
class _Availability:
    """Where something exists: ranges of versions, one stage, extensions."""

    since: int = 110
    until: int = _NEVER
    es: int = 100
    es_until: int = _NEVER
    stage: str | None = None
    extensions: frozenset[str] = NO_EXTENSIONS
    extended_since: int = 0

    def holds(
        self, version: int, profile: str | None, stage: str, extensions: frozenset[str]
    ) -> bool:
        """Does a shader of this version, profile and stage have it?"""
        if self.stage not in (None, stage):
            return False
        found = self.extensions & extensions
        if found and version >= self.extended_since and (profile == "es" or found - _OF_ES):
            return True
        if profile == "es":
            return self.es <= version <= self.es_until
        return self.since <= version and (version <= self.until or profile == "compatibility")


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

    ``profile`` is ``"es"`` for GLSL ES (1.00 too); ``extensions`` are the names of those that
    ``#extension`` turned on.
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


def _distinct(found: Iterator[Signature]) -> tuple[Signature, ...]:
    # max(genType, float) and max(genType, genType) are the same for a scalar: keyed by parameters.
    kept: dict[tuple[Type, ...], Signature] = {}
    for signature in found:
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
            if _availability(line.words).holds(version, profile, stage, extensions):
                storage, kind, value = _fields(section, line.text)
                return BuiltinVariable(name, _named_type(kind), storage, value)
    return None


def _fields(section: str, text: str) -> tuple[str, str, int | None]:
    """Storage, type and value of a variable or constant."""
    first, second, third = text.split()[:3]
    return (first, second, None) if section == "variables" else ("const", first, int(third))


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
            if _availability(line.words).stage in (None, stage):
                storage, kind, _ = _fields("variables", line.text)
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
    sections: dict[str, dict[str, list[_Line]]] = {}
    section: dict[str, list[_Line]] = {}
    at = 1
    shared: tuple[str, ...] = ()
    for text in _FILE.read_text(encoding="utf-8").splitlines():
        if text.startswith("["):
            title, shared = text.strip("[]"), ()
            section = sections.setdefault(title, {})
            at = {"structs": 0, "variables": 2}.get(title, 1)
        elif text.startswith("@"):
            shared = tuple(text[1:].split())
        elif text and not text.startswith("#"):
            names = text.partition("(")[0].partition(":")[0].split()[at]
            line = _Line(text, (*_own_words(text, at), *shared))
            for name in names.split("|"):
                section.setdefault(name, []).append(line)
    return sections


def _own_words(text: str, at: int) -> list[str]:
    _, bracket, tail = text.partition(")")
    return tail.split() if bracket else text.split()[at + 1 :]


@cache
def _availability(words: tuple[str, ...]) -> _Availability:
    given: dict[str, str] = {}
    for key, _, value in (word.partition("=") for word in words):
        given.setdefault(key, value)
    first, _, last = given.get("es", "100").replace("-", " -").partition(" ")
    return _Availability(
        _number(given.get("since", "110")),
        int(given.get("until", _NEVER)),
        _number(first or "-"),
        int(last[1:]) if first and last else _NEVER,
        next((stage for stage in ("fragment", "vertex") if stage in given), None),
        frozenset("GL_" + ext for ext in given.get("ext", "").split("|") if ext),
        int(given.get("from", 0)),
    )


def _number(text: str) -> int:
    return _NEVER if text == "-" else int(text)


@cache
def _all_signatures(name: str) -> tuple[tuple[Signature, _Availability], ...]:
    lines = _index()["functions"].get(name, ())
    return tuple(found for line in lines for found in _signatures(name, line))


def _signatures(name: str, line: _Line) -> Iterator[tuple[Signature, _Availability]]:
    """Expand one line for one of its names."""
    head, _, _ = line.text.partition(")")
    result, _, rest = head.partition(" ")
    params = rest.partition("(")[2]
    for variant in expanded(f"{result}, {params}" if params else result):
        words = (*line.words, "fragment") if variant.fragment else line.words
        yield _signature(name, variant.types, words), _availability(words)


def _signature(name: str, types: tuple[str, ...], words: tuple[str, ...]) -> Signature:
    result, *params = types
    return Signature(
        name,
        _named_type(result),
        tuple(_parameter(text) for text in params),
        derivative="derivative" in words,
        implicit_lod="lod" in words,
        texture="texture" in words,
        memory="image" in words,
        fragment_only="fragment" in words,
        foldable=not {"texture", "variable"}.intersection(words),
    )


def _parameter(text: str) -> Parameter:
    word, _, kind = text.rpartition(" ")
    if word == "const":
        return Parameter(_named_type(kind), constant=True)
    return Parameter(_named_type(kind), word or "in")


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
