"""Built-in functions, variables and constants, read from ``builtins.txt`` beside this file.

The file is indexed by name when the first name is asked for; a line is parsed, and its generic
types expanded, when its name is asked for. The notation is explained at the head of the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from shadercache.lang.types import FLOAT, Type, array_of, builtin_type, struct_type

_FILE = Path(__file__).with_name("builtins.txt")

_GENERIC = re.compile(r"gen[IUBD]?Type|d?matCR|[iubd]?vecN")
_GVEC = re.compile(r"\bg(?=vec4|sampler)")
_GEN_NAMES = {"genType": "", "genIType": "i", "genUType": "u", "genBType": "b", "genDType": "d"}
_SCALARS = {"": "float", "i": "int", "u": "uint", "b": "bool", "d": "double"}
_SIZES = ("2", "3", "4")

_FIRST_DOUBLE = 400
_FOREVER = 9999

# GLSL ES as the desktop version that has about the same built-ins.
_ES_AS_DESKTOP = {100: 120, 300: 330, 310: 330, 320: 330}


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
    derivatives. ``texture``: it looks into a texture. ``fragment_only``: vertex shaders do not
    have it. ``foldable``: with constant arguments it is a constant expression (section 4.3.3).
    """

    name: str
    result: Type
    params: tuple[Parameter, ...]
    derivative: bool = False
    implicit_lod: bool = False
    texture: bool = False
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
    """Where something exists: a range of desktop versions, the first ES version, one stage."""

    since: int = 0
    until: int = _FOREVER
    es: int | None = None
    stage: str | None = None

    def holds(self, version: int, profile: str | None, stage: str) -> bool:
        """Does a shader of this version, profile and stage have it?"""
        if self.stage not in (None, stage):
            return False
        if profile == "es":
            if self.es is not None:
                return version >= self.es
            old = self.until < _FOREVER
            return self.since <= _ES_AS_DESKTOP.get(version, 330) and not (old and version >= 300)
        return self.since <= version and (version <= self.until or profile == "compatibility")


@cache
def functions(
    name: str, version: int = 330, profile: str | None = None, stage: str = "fragment"
) -> tuple[Signature, ...]:
    """All overloads of the built-in function ``name``; none if there is no such function."""
    # max(genType, float) and max(genType, genType) are the same for a scalar: keyed by parameters.
    found: dict[tuple[Type, ...], Signature] = {}
    for line in _index()["functions"].get(name, ()):
        for signature, where in _signatures(name, line):
            if where.holds(version, profile, stage):
                found.setdefault(tuple(param.type for param in signature.params), signature)
    return tuple(found.values())


@cache
def variable(
    name: str, stage: str = "fragment", version: int = 330, profile: str | None = None
) -> BuiltinVariable | None:
    """The built-in variable or constant ``name`` of a stage, or ``None``."""
    for line in _index()["variables"].get(name, ()):
        storage, kind, _, *words = line.split()
        if _availability(words).holds(version, profile, stage):
            return BuiltinVariable(name, _named_type(kind), storage)
    for line in _index()["constants"].get(name, ()):
        kind, _, value, *words = line.split()
        if _availability(words).holds(version, profile, stage):
            return BuiltinVariable(name, _named_type(kind), "const", int(value))
    return None


def function_names() -> tuple[str, ...]:
    """Names of all built-in functions of any version (for hints and tests)."""
    return tuple(_index()["functions"])


def variable_names() -> tuple[str, ...]:
    """Names of all built-in variables and constants of any version and stage."""
    return (*_index()["variables"], *_index()["constants"])


@cache
def _index() -> Mapping[str, dict[str, list[str]]]:
    """Lines of the data file by section and name."""
    sections: dict[str, dict[str, list[str]]] = {}
    section: dict[str, list[str]] = {}
    for line in _FILE.read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            section = sections.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#"):
            names = line.split("(", 1)[0].split()
            # A function line is "result names(...)", others have the name second or third.
            at = 2 if names[0] in ("in", "out", "uniform") else 1
            for name in names[at].split("|"):
                section.setdefault(name, []).append(line)
    return sections


def _availability(words: list[str]) -> _Availability:
    numbers = {key: int(value) for key, _, value in (w.partition("=") for w in words) if value}
    stage = next((word for word in words if word in ("fragment", "vertex")), None)
    return _Availability(
        numbers.get("since", 0), numbers.get("until", _FOREVER), numbers.get("es"), stage
    )


def _signatures(name: str, line: str) -> Iterator[tuple[Signature, _Availability]]:
    """Expand one line for one of its names."""
    head, _, tail = line.partition(")")
    result, _, rest = head.partition(" ")
    params = rest.partition("(")[2]
    words = tail.split()
    for double, text in _double_variants(f"{result}, {params}"):
        since = [f"since={_FIRST_DOUBLE}"] if double and "since=" not in tail else []
        for expanded in _variants(text):
            for fragment, types in _optional(expanded):
                own = [*words, *since, *(["fragment"] if fragment else [])]
                yield _signature(name, types, own), _availability(own)


def _signature(name: str, types: list[str], words: list[str]) -> Signature:
    result, *params = types
    return Signature(
        name,
        _named_type(result),
        tuple(_parameter(text) for text in params),
        derivative="derivative" in words,
        implicit_lod="lod" in words,
        texture="texture" in words,
        fragment_only="fragment" in words,
        foldable="texture" not in words and "variable" not in words,
    )


def _parameter(text: str) -> Parameter:
    word, _, kind = text.rpartition(" ")
    if word == "const":
        return Parameter(_named_type(kind), constant=True)
    return Parameter(_named_type(kind), word or "in")


def _double_variants(text: str) -> list[tuple[bool, str]]:
    """``genFDType`` stands for two lines: floats, and doubles from 4.00 on."""
    if "genFDType" not in text:
        return [(False, text)]
    single = text.replace("genFDType", "genType").replace("floatD", "float")
    double = text.replace("genFDType", "genDType").replace("floatD", "double")
    return [(False, single), (True, double.replace("genType", "genDType"))]


def _variants(text: str) -> Iterator[str]:
    """Replace the generic types by every size, and ``g`` by every prefix."""
    if "Type" in text:
        sizes: tuple[str, ...] = ("1", *_SIZES)
    elif "matCR" in text:
        sizes = tuple(f"{c}x{r}" for c in _SIZES for r in _SIZES)
    elif "vecN" in text:
        sizes = _SIZES
    else:
        for prefix in ("", "i", "u") if _GVEC.search(text) else ("",):
            yield _GVEC.sub(prefix, text)
        return
    generic = set(_GENERIC.findall(text))
    for size in sizes:
        expanded = text
        for word in generic:
            expanded = expanded.replace(word, _sized(word, size))
        yield expanded


def _sized(generic: str, size: str) -> str:
    """``genIType``, 1 -> ``int``; ``bvecN``, 3 -> ``bvec3``; ``matCR``, 2x3 -> ``mat2x3``."""
    prefix = _GEN_NAMES.get(generic)
    if prefix is None:
        return generic.removesuffix("N").removesuffix("CR") + size
    return _SCALARS[prefix] if size == "1" else f"{prefix}vec{size}"


def _optional(text: str) -> Iterator[tuple[bool, list[str]]]:
    """Expand a last ``bias?`` or ``comp?``; the flag says: for fragment shaders only."""
    types = [part for part in text.split(", ") if part]
    if not types[-1].endswith("?"):
        yield False, types
        return
    *types, last = types
    yield False, types
    yield last == "bias?", [*types, "float" if last == "bias?" else "const int"]


@cache
def _named_type(text: str) -> Type:
    name, _, size = text.partition("[")
    if name == "gl_DepthRangeParameters":
        return struct_type(name, dict.fromkeys(("near", "far", "diff"), FLOAT))
    kind = builtin_type(name)
    if kind is None:
        raise ValueError(f"{_FILE.name}: no type {text!r}")
    if not size:
        return kind
    digits = size.rstrip("]")
    return array_of(kind, int(digits) if digits else None)
