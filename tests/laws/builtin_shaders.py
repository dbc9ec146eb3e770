"""Shaders that give every built-in function, and operations on matrices, values to work on.

Each takes values that are payloads in one set, and gives one that is a payload in another::

    vec3 a_0 = sin(v_position.zxy * 1.9 + v_normal) * 0.3 + 0.35;
    vec3 b_0 = cos(v_normal.yzx * 2.7 + v_position) * 0.3 + 0.35;
    vec3 r_0 = reflect(a_0 * 1.3, b_0);
    total += r_0.x * 1.7 + r_0.y * 0.9 + r_0.z * 1.7;
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from shadercache.lang.builtins import Signature, function_names, functions
from shadercache.lang.types import Type, builtin_type
from shadercache.source import Source

HEAD = Path(__file__).with_name("builtins") / "head.glsl"
VERSION = 400
CHANNELS = 7
"""Of the payloads of one set."""

_OPERATIONS = {
    "product of matrices": ("mat2", "mat2", "mat2", "{0} * {1}"),
    "of wide ones": ("mat2x3", "mat2x3", "mat2", "{0} * {1}"),
    "matrix by vector": ("vec3", "mat3", "vec3", "{0} * {1}"),
    "vector by matrix": ("vec2", "vec3", "mat2x3", "{0} * {1}"),
    "sum of matrices": ("mat2", "mat2", "mat2", "{0} + {1}"),
    "difference": ("mat3x2", "mat3x2", "mat3x2", "{0} * 1.7 - {1}"),
    "quotient of matrices": ("mat2", "mat2", "mat2", "{0} / {1}"),
    "matrix by number": ("mat2", "mat2", "float", "{0} * {1} / 0.7"),
    "number by matrix": ("mat2", "float", "mat2", "{0} * {1} * 0.3"),
    "negated": ("mat2", "mat2", "mat2", "-({0} * 0.7) + {1}"),
    "column": ("vec3", "mat3", "float", "({0} * {1})[1] * 1.3"),
    "made of columns": ("mat2", "vec2", "vec2", "mat2({0} * 1.3, {1} * {0})"),
    "made of a matrix": ("mat2", "mat3", "float", "mat2({0} * {1})"),
    "diagonal": ("mat2", "float", "vec2", "mat2({0} * 1.3) * {1}[1]"),
    "choice": ("mat2", "mat2", "vec2", "{1}.x > 0.4 ? outerProduct({1}, {0}[0]) : inverse({0})"),
}
"""Result, arguments and text of operations on matrices."""

_ASSIGNED = {
    "times a matrix": ("mat2", "mat2", "*="),
    "times a number": ("mat2", "float", "*="),
    "plus a matrix": ("mat3x2", "mat3x2", "+="),
    "less a matrix": ("mat2", "mat2", "-="),
    "by a matrix": ("mat2", "mat2", "/="),
    "vector times a matrix": ("vec2", "mat2", "*="),
}

_WITHOUT = ("interpolateAt", "noise")
"""Functions of places in a pixel, and functions that drivers need not have."""

_OUTSIDE = {"acosh": "{} + 1.1", "ldexp": "{}", "findLSB": "{}"}


@dataclass(frozen=True, slots=True)
class Use:
    """One thing to do: the result's type, the arguments' types, and the text with ``{0}`` …"""

    name: str
    result: Type
    params: tuple[Type, ...]
    text: str
    assigned: str = ""
    """The operator, where the first argument is changed in place."""


@dataclass(frozen=True, slots=True)
class Shader:
    """Some uses in one shader, and the texts of the payloads of each set."""

    name: str
    source: Source
    sets: tuple[tuple[str, ...], ...]


def shaders() -> list[Shader]:
    """One shader for each few uses."""
    found: list[Shader] = []
    group: list[Use] = []
    for use in uses():
        if group and sum(map(_width, (*group, use))) > CHANNELS:
            found.append(_shader(group))
            group = []
        group.append(use)
    return [*found, _shader(group)]


def uses() -> Iterator[Use]:
    """Every built-in function of numbers, in some forms, and every operation."""
    for name in function_names():
        if name.startswith(_WITHOUT):
            continue
        signatures = [item for item in functions(name, VERSION) if _is_calculated(item)]
        yield from _of_function(name, signatures)
    for name, (result, *params, text) in _OPERATIONS.items():
        yield Use(name, _type(result), tuple(map(_type, params)), text)
    for name, (target, value, operator) in _ASSIGNED.items():
        kinds = (_type(target), _type(value))
        yield Use(name, kinds[0], kinds, f"{{0}} {operator} {{1}} * 0.7", operator)


def _of_function(name: str, signatures: Sequence[Signature]) -> Iterator[Use]:
    """The widest of vectors, two of matrices: one that fits a cache, one that does not."""
    if not signatures:
        return
    with_matrices = [s for s in signatures if any(t.is_matrix for t in _types(s))]
    if with_matrices:
        chosen = [min(with_matrices, key=_size), max(with_matrices, key=_size)]
        chosen += [s for s in with_matrices if _size(s) == 6][:1]
    else:
        fitting = [s for s in signatures if s.result.components_or_one <= 3]
        chosen = [max(fitting or signatures, key=_size)]
    for signature in dict.fromkeys(chosen):
        params = tuple(param.type for param in signature.params)
        arguments = ", ".join(
            f"{{{i}}}" if i else _OUTSIDE.get(name, "{} * 1.3").format("{0}")
            for i in range(len(params))
        )
        if params[0].is_matrix or not params[0].is_float:
            arguments = ", ".join(f"{{{i}}}" for i in range(len(params)))
        yield Use(name, signature.result, params, f"{name}({arguments})")


def _types(signature: Signature) -> tuple[Type, ...]:
    return (signature.result, *(param.type for param in signature.params))


def _size(signature: Signature) -> int:
    return sum(kind.components_or_one for kind in _types(signature)[:1])


def _is_calculated(signature: Signature) -> bool:
    """Does it calculate with floats, and nothing else?"""
    kinds = _types(signature)
    plain = all(kind.base in ("float", "int", "uint", "bool") for kind in kinds)
    floats = signature.result.is_float or any(kind.is_float for kind in kinds[1:])
    other = signature.texture or signature.memory or signature.derivative or signature.implicit_lod
    back = any(param.direction != "in" or param.constant for param in signature.params)
    return bool(
        plain
        and floats
        and signature.params
        and not other
        and not back
        and signature.result.base in ("float", "uint")
    )


def _type(name: str) -> Type:
    found = builtin_type(name)
    assert found is not None
    return found


def _width(use: Use) -> int:
    """Channels of its result or of its first argument as payloads, those that fit."""
    sizes = [kind.components_or_one for kind in (use.result, use.params[0])]
    return max((size for size in sizes if size <= CHANNELS), default=CHANNELS)


def _shader(group: Sequence[Use]) -> Shader:
    lines, results, arguments = list[str](), list[str](), list[str]()
    for at, use in enumerate(group):
        names = [f"{letter}_{at}" for letter in "abc"[: len(use.params)]]
        for place, (name, kind) in enumerate(zip(names, use.params, strict=True)):
            value = _value(kind, at, place)
            lines.append(f"{kind.name} {name} = {value};")
            if place == 0 and kind.is_float and kind.components_or_one <= CHANNELS:
                arguments.append(value)
        text = use.text.format(*names)
        if use.assigned:
            lines += [f"{text};", f"{use.result.name} r_{at} = {names[0]} * 1.3;"]
            text = f"{names[0]} * 1.3"
        else:
            lines.append(f"{use.result.name} r_{at} = {text};")
        if use.result.components_or_one <= CHANNELS:
            results.append(text)
        lines.append(f"total += {_sum(f'r_{at}', use.result)};")
    body = "\n    ".join(
        ["float total = 0.1;", *lines, "o_color = vec4(total, total * 0.3, v_uv);"]
    )
    name = ", ".join(dict.fromkeys(use.name for use in group))
    text = f"{HEAD.read_text(encoding='utf-8')}void main() {{\n    {body}\n}}\n"
    sets = tuple(tuple(item) for item in (results, arguments) if item)
    return Shader(name, Source("builtins.frag", text), sets)


def _value(kind: Type, at: int, place: int) -> str:
    """A value between 0.05 and 0.65, another for each place."""
    by = f"{1.7 + 0.3 * at + 0.9 * place:.1f}"
    size = kind.components_or_one
    if kind.is_matrix:
        column, at = _type(f"vec{size // kind.cols}"), at + 5
        return f"{kind.name}({', '.join(_value(column, at + i, place) for i in range(kind.cols))})"
    base = {
        1: f"v_position.x * {by} + v_normal.y",
        2: f"v_uv * {by} + v_position.xy",
        3: f"v_position.zxy * {by} + v_normal",
        4: f"vec4(v_normal, v_uv.x) * {by} + v_position.y",
    }[size]
    number = f"{'cos' if place else 'sin'}({base}) * 0.3 + 0.35"
    if kind.is_float:
        return number
    if kind.base == "bool":
        return f"greaterThan({number}, vec{size}(0.4))" if size > 1 else f"{number} > 0.4"
    return f"{kind.name}(({number}) * 9.0)"


def _sum(name: str, kind: Type) -> str:
    size = kind.components_or_one
    if kind.is_matrix:
        rows = size // kind.cols
        parts: Iterable[str] = (
            f"{name}[{i}].{'xyzw'[k]}" for i in range(kind.cols) for k in range(rows)
        )
    else:
        parts = (f"{name}.{'xyzw'[i]}" for i in range(size)) if size > 1 else (name,)
    if not kind.is_float:
        parts = (f"float({part} >> 8) * 1.0e-6" for part in parts)
    return " + ".join(f"{part} * {1.7 if at % 2 else 0.9}" for at, part in enumerate(parts))
