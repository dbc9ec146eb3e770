"""Every operator on every pair of types, against glslang (GLSL 3.30 sections 5.4 to 5.9)."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest
from sema.tools import checked

from shadercache.lang.types import BOOL, Type, builtin_type
from shadercache.sema.conversions import Conversions
from shadercache.sema.operators import binary_type, construct_problem, unary_type
from tests.glslang import PROBED, PROBES, bad_lines, needs_glslang, probe

pytestmark = needs_glslang

ASSIGNED = ("+", "-", "*", "/", "%", "<<", ">>", "&", "|", "^")
BINARY = (*ASSIGNED, "&&", "||", "^^", "<", ">", "<=", ">=", "==", "!=")
UNARY = ("+", "-", "!", "~", "++", "--")
VERSIONS = (330, 400)


def kind(name: str) -> Type:
    found = builtin_type(name)
    assert found is not None
    return found


KINDS = [kind(name) for name in PROBED]


def agrees(tmp_path: Path, version: int, expressions: list[tuple[str, Type | None]]) -> None:
    """glslang accepts exactly the expressions that have a type, and they have that type."""
    variables = "".join(f"{name} v_{name}; {name} w_{name};\n" for name in PROBED)
    prelude = f"#version {version}\n{PROBES}{variables}void main() {{\n"
    file = tmp_path / "all.frag"
    lines = [f"{expr};\n" for expr, _ in expressions]
    file.write_text(prelude + "".join(lines) + "}\n")
    first = prelude.count("\n") + 1
    refused = {line - first for line in bad_lines(file)}
    expected = {i for i, (_, result) in enumerate(expressions) if result is None}
    wrong = [(expressions[i], "refused" if i in refused else "ok") for i in refused ^ expected]
    assert not wrong[:10]
    probes = [
        f"{probe(expr, str(result))};\n" for expr, result in expressions if result is not None
    ]
    file.write_text(prelude + "".join(probes) + "}\n")
    assert not list(bad_lines(file).values())[:10]


@pytest.mark.parametrize("version", VERSIONS)
def test_5_9_binary_operators(tmp_path: Path, version: int) -> None:
    conversions = Conversions(version)
    agrees(
        tmp_path,
        version,
        [
            (f"v_{left} {op} w_{right}", binary_type(op, left, right, conversions))
            for op, left, right in product(BINARY, KINDS, KINDS)
        ],
    )


@pytest.mark.parametrize("version", VERSIONS)
def test_5_8_compound_assignments(tmp_path: Path, version: int) -> None:
    conversions = Conversions(version)
    expressions: list[tuple[str, Type | None]] = []
    for op, left, right in product(ASSIGNED, KINDS, KINDS):
        result = binary_type(op, left, right, conversions)
        fits = result is not None and conversions.converts(result, left)
        expressions.append((f"v_{left} {op}= w_{right}", left if fits else None))
    agrees(tmp_path, version, expressions)


def test_5_9_unary_operators(tmp_path: Path) -> None:
    expressions = [
        (f"{op}v_{one}", unary_type(op, one))
        for op, one in product(UNARY, KINDS)
        # glslang takes '+' before bool; the specification does not.
        if not (op == "+" and one.base == "bool")
    ]
    assert unary_type("+", BOOL) is None
    agrees(tmp_path, 330, expressions)


@pytest.mark.parametrize("version", VERSIONS)
def test_5_9_ternary_operator(tmp_path: Path, version: int) -> None:
    conversions = Conversions(version)
    agrees(
        tmp_path,
        version,
        [
            (f"v_bool ? v_{left} : w_{right}", conversions.common(left, right))
            for left, right in product(KINDS, KINDS)
        ],
    )


@pytest.mark.parametrize("version", VERSIONS)
def test_4_1_10_implicit_conversions(tmp_path: Path, version: int) -> None:
    conversions = Conversions(version)
    agrees(
        tmp_path,
        version,
        [
            (f"v_{target} = w_{source}", target if fits else None)
            for target, source in product(KINDS, KINDS)
            for fits in [conversions.converts(source, target)]
        ],
    )


def test_5_4_constructors_of_one_and_two_arguments(tmp_path: Path) -> None:
    conversions = Conversions(330)
    pairs = [[one] for one in KINDS] + [[one, two] for one, two in product(KINDS, KINDS)]
    agrees(
        tmp_path,
        330,
        [
            (f"{made}({', '.join(f'v_{arg}' for arg in args)})", made if fits else None)
            for made, args in product(KINDS, pairs)
            for fits in [construct_problem(made, args, conversions) is None]
        ],
    )


CONSTRUCTORS = {
    "S(1, vec2(1))": True,
    "S(1.0, vec2(1.0))": True,
    "S(1.0)": False,
    "S(1.0, vec2(1.0), 1.0)": False,
    "S(vec2(1.0), 1.0)": False,
    "S(true, vec2(1.0))": False,
    "float[2](1.0, 2.0)": True,
    "float[](1.0, 2.0)": True,
    "float[](1, 2u)": True,
    "float[2](1.0)": False,
    "float[2](1.0, 2.0, 3.0)": False,
    "float[](1.0, vec2(1.0))": False,
    "int[](1, 2.0)": False,
    "float[]()": False,
    "vec3()": False,
    "S[2](S(1.0, vec2(1.0)), S(2.0, vec2(2.0)))": True,
    "vec3(1.0, 2.0, 3.0)": True,
    "vec3(1.0, 2.0, 3.0, 4.0)": False,
    "mat2(1.0, 2.0, 3.0, 4.0)": True,
    "mat2(1.0, 2.0, 3.0)": False,
    "mat2(1.0, 2.0, 3.0, 4.0, 5.0)": False,
    "mat2(vec2(1.0), vec3(1.0))": True,
    "mat3(mat2(1.0))": True,
    "mat3(mat2(1.0), 1.0)": False,
    "float(S(1.0, vec2(1.0)))": False,
    "float(u_s)": False,
    "vec4(1, 2u, true, 4.0)": True,
    "ivec2(vec3(1.0))": True,
    "sampler2D(1)": False,
}


@pytest.mark.parametrize("expression", CONSTRUCTORS)
def test_5_4_constructors(tmp_path: Path, expression: str) -> None:
    text = (
        "#version 330\nstruct S { float a; vec2 b; };\nuniform sampler2D u_s;\n"
        f"void main() {{ {expression}; }}\n"
    )
    file = tmp_path / "one.frag"
    file.write_text(text)
    assert (not bad_lines(file)) == CONSTRUCTORS[expression]
    if CONSTRUCTORS[expression]:
        checked(text)
    else:
        with pytest.raises(Exception, match=r"SC219|SC101"):
            checked(text)
