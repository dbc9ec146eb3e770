"""A plain vertex shader for any fragment shader: it gives every input a value of a fixed rule.

For ``in vec3 v_normal; flat in ivec2 v_cell;`` it declares both as outputs, and writes ::

    v_normal = vec3(<three different slopes over the image>);
    v_cell = ivec2(1, 2);

Structs, constants and extensions that the declarations may need are taken over.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count

from shadercache.ast import nodes as n
from shadercache.emit.printer import print_node
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts

POSITION = "sc_corner"
"""The vertex attribute: the corners of the image, from -1 to 1."""

_INPUT_WORDS = {"in": "out", "varying": "varying"}
_FIXED_FUNCTION = (*(f"gl_TexCoord[{unit}]" for unit in range(8)), "gl_FrontColor", "gl_BackColor")


def plain_vertex(module: n.Module, facts: Facts, uses_fixed_function: bool) -> str:
    """The text of the vertex shader, in the version of the fragment shader."""
    profile = f" {module.profile}" if module.profile and module.version != 100 else ""
    old = module.version < (300 if module.profile == "es" else 130)
    lines = [f"#version {module.version}{profile}"]
    lines += [
        item.text.replace("require", "enable")  # Some are of fragment shaders alone.
        for item in module.directives
        if item.text.startswith("#extension")
    ]
    if module.profile == "es":
        lines += ["precision highp float;", "precision highp int;"]
    lines.append(f"{'attribute' if old else 'in'} vec2 {POSITION};")
    statements = [f"gl_Position = vec4({POSITION}, 0.0, 1.0);"]
    number = count()
    for decl in module.decls:
        lines += [print_node(part) for part in _taken_over(decl)]
        for place, kind in _inputs(decl, facts):
            statements += _assignments(place, kind, number)
    if uses_fixed_function:
        for place in _FIXED_FUNCTION:
            statements.append(f"{place} = vec4({', '.join(_slope(next(number)) for _ in 'xyzw')});")
    body = "".join(f"    {statement}\n" for statement in statements)
    return "\n".join((*lines, f"void main()\n{{\n{body}}}\n"))


def _taken_over(decl: n.Decl) -> Iterator[n.Node]:
    """The parts of a declaration that the vertex shader has too, inputs turned into outputs."""
    match decl:
        case n.VarDecl(qualifiers=qualifiers):
            own = tuple(d for d in decl.declarators if not d.name.startswith("gl_"))
            if qualifiers.has("const"):
                yield decl
            elif qualifiers.has(*_INPUT_WORDS) and own:
                yield replace(decl, qualifiers=_turned(qualifiers), declarators=own)
            elif decl.type.struct is not None and decl.type.name:
                yield replace(decl, qualifiers=n.NO_QUALIFIERS, declarators=())
        case n.BlockDecl(qualifiers=qualifiers) if _is_input(decl):
            yield replace(decl, qualifiers=_turned(qualifiers))


def _is_input(decl: n.VarDecl | n.BlockDecl) -> bool:
    name = decl.name if isinstance(decl, n.BlockDecl) else ""
    return decl.qualifiers.has(*_INPUT_WORDS) and not name.startswith("gl_")


def _turned(qualifiers: n.Qualifiers) -> n.Qualifiers:
    words = tuple(_INPUT_WORDS.get(word, word) for word in qualifiers.words)
    return replace(qualifiers, words=words)


def _inputs(decl: n.Decl, facts: Facts) -> Iterator[tuple[str, Type]]:
    """The inputs that a declaration makes, as the expressions that stand for them."""
    if not isinstance(decl, n.VarDecl | n.BlockDecl) or not _is_input(decl):
        return
    declared: tuple[n.Declarator | n.BlockDecl, ...]
    if isinstance(decl, n.VarDecl):
        declared = decl.declarators
    elif decl.instance is not None:
        declared = (decl,)
    else:
        declared = tuple(item for field in decl.fields for item in field.declarators)
    for node in declared:
        symbol = facts.declared.get(node)
        if symbol is not None and not symbol.name.startswith("gl_"):
            yield symbol.name, symbol.type


def _assignments(place: str, kind: Type, number: Iterator[int]) -> Iterator[str]:
    if kind.is_array:
        for index in range(kind.dims[0] or 1):
            yield from _assignments(f"{place}[{index}]", kind.element, number)
    elif kind.struct is not None:
        for name, member in kind.struct.fields.items():
            yield from _assignments(f"{place}.{name}", member, number)
    elif kind.base is not None:
        values = [_value(kind.base, next(number)) for _ in range(kind.rows * kind.cols)]
        yield f"{place} = {kind.name}({', '.join(values)});"


def _value(base: str, number: int) -> str:
    return _slope(number) if base in ("float", "double") else str(1 + number % 3)


def _slope(number: int) -> str:
    """A number between 0 and 1 that changes over the image, each time in another direction."""
    across, up = 0.05 * (1 + number % 4), 0.05 * (1 + number // 4 % 4)
    sign = "-" if number % 2 else "+"
    return f"0.5 + {across:.2f} * {POSITION}.x {sign} {up:.2f} * {POSITION}.y"
