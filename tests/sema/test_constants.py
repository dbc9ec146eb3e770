"""Constant expressions and their values (GLSL 3.30 section 4.3.3), against glslang."""

from __future__ import annotations

from pathlib import Path

import pytest
from sema.tools import checked, initialisers

from shadercache.sema.facts import Scalar
from shadercache.sema.fold import convert, literal
from tests.glslang import bad_lines, needs_glslang

DECLARATIONS = """
const int N = 3;
const float HALF = 0.5;
const vec3 V = vec3(1.0, 2.0, 3.0);
const ivec2 I = ivec2(4, 5);
const float A[3] = float[](1.0, 2.0, 3.0);
const bool YES = true;
struct S { float a; };
const S R = S(2.0);
uniform float u_f;
"""

VALUES: dict[str, Scalar] = {
    "1 + 2 * 3": 7,
    "7 / 2": 3,
    "-7 / 2": -3,
    "7 % 3": 1,
    "1.0 / 4.0": 0.25,
    "1 / 4.0": 0.25,
    "1 << 5": 32,
    "-16 >> 2": -4,
    "0x80000000u >> 31": 1,
    "6 & 3": 2,
    "6 | 3": 7,
    "6 ^ 3": 5,
    "~0": -1,
    "-N": -3,
    "+N": 3,
    "2147483647 + 1": -2147483648,
    "0u - 1u": 4294967295,
    "0xFFFFFFFF": -1,
    "012": 10,
    "1e3": 1000.0,
    ".5f": 0.5,
    "N > 2": True,
    "N >= 4": False,
    "N == 3 && !false": True,
    "false || YES": True,
    "true ^^ YES": False,
    "N > 2 ? 10 : 20": 10,
    "N > 5 ? 1 : 2.0": 2.0,
    "V.y": 2.0,
    "V[2]": 3.0,
    "V.zx[0]": 3.0,
    "(V * 2.0).z": 6.0,
    "(V + V).x": 2.0,
    "vec4(V, N).w": 3.0,
    "vec3(HALF).z": 0.5,
    "I.x * I.y": 20,
    "-I.y": -5,
    "(I / 2)[1]": 2,
    "int(2.9)": 2,
    "int(-2.9)": -2,
    "float(N) / 2": 1.5,
    "uint(N)": 3,
    "bool(N)": True,
    "int(YES)": 1,
    "int(V)": 1,
    "float(true)": 1.0,
    "A.length()": 3,
    "V == vec3(1.0, 2.0, 3.0)": True,
    "I != ivec2(4, 5)": False,
    "sqrt(16.0)": 4.0,
    "max(1, 2.5)": 2.5,
    "min(N, 2)": 2,
    "clamp(5.0, 0.0, 1.0)": 1.0,
    "abs(-N)": 3,
    "floor(2.7)": 2.0,
    "ceil(2.2)": 3.0,
    "fract(2.75)": 0.75,
    "mod(7.0, 4.0)": 3.0,
    "mod(-1.0, 4.0)": 3.0,
    "pow(2.0, 10.0)": 1024.0,
    "exp2(3.0)": 8.0,
    "sign(-2.0)": -1.0,
    "sign(-2)": -1,
    "step(1.0, 0.5)": 0.0,
    "mix(1.0, 3.0, 0.5)": 2.0,
    "mix(1.0, 3.0, true)": 3.0,
    "max(V, 2.0).x": 2.0,
    "all(lessThan(V, vec3(4.0)))": True,
    "any(equal(V, vec3(9.0)))": False,
    "not(bvec2(YES, false)).y": True,
    "radians(180.0) > 3.14": True,
    "R.a": 2.0,
    "A[1]": 2.0,
    "float[](4.0, 5.0)[1]": 5.0,
    "mat2(1.0)[0].x": 1.0,
    "mat2(1.0)[1].x": 0.0,
    "mat2(1.0, 2.0, 3.0, 4.0)[1][0]": 3.0,
    "mat3(mat2(2.0))[2].z": 1.0,
    "mat2(mat3(2.0))[1].y": 2.0,
    "(mat2(1.0, 2.0, 3.0, 4.0) * vec2(1.0, 10.0)).y": 42.0,
    "(vec2(1.0, 10.0) * mat2(1.0, 2.0, 3.0, 4.0)).y": 43.0,
    "(mat2(1.0, 2.0, 3.0, 4.0) * mat2(0.0, 1.0, 1.0, 0.0))[0].x": 3.0,
    "(mat2(1.0) * 3.0)[1].y": 3.0,
    "transpose(mat2x3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0))[1].y": 5.0,
    "determinant(mat2(1.0, 2.0, 3.0, 4.0))": -2.0,
    "inverse(mat2(2.0))[0].x": 0.5,
    "outerProduct(vec2(1.0, 2.0), vec2(3.0, 4.0))[1].x": 4.0,
    "matrixCompMult(mat2(2.0), mat2(3.0))[1].y": 6.0,
    "length(vec2(3.0, 4.0))": 5.0,
    "distance(vec2(1.0), vec2(1.0, 3.0))": 2.0,
    "dot(V, V)": 14.0,
    "cross(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)).z": 1.0,
    "normalize(vec2(0.0, 2.0)).y": 1.0,
    "reflect(vec2(1.0, -1.0), vec2(0.0, 1.0)).y": 1.0,
    "refract(vec2(0.0, -1.0), vec2(0.0, 1.0), 0.5).y": -1.0,
    "faceforward(vec2(1.0), vec2(1.0), vec2(1.0)).x": -1.0,
    "smoothstep(0.0, 2.0, 1.0)": 0.5,
    "inversesqrt(4.0)": 0.5,
    "floatBitsToInt(1.0)": 0x3F800000,
    "R == S(2.0)": True,
    "A == float[](1.0, 2.0, 4.0)": False,
    "gl_MaxDrawBuffers > 0": True,
}
DRIVER = "gl_MaxDrawBuffers > 0"
# Constant expressions all the same, which glslang does not compute.
UNFOLDED = (
    "transpose",
    "determinant",
    "inverse",
    "outerProduct",
    "cross",
    "reflect",
    "refract",
    "faceforward",
    "smoothstep",
    "matrixCompMult",
    "floatBitsToInt",
)

CONSTANT_WITHOUT_VALUE = [
    "V",
    "R",
    "mat2(1.0)",
    "mat2(1.0) * vec2(1.0)",
    "cross(V, V)",
    "normalize(V)",
    "S(1.0)",
    "gl_MaxDrawBuffers",
    "1 / 0",
    "-7 % 3",
    "1 << 40",
    "float[](1.0, 2.0)",
    "dFdx(1.0)",
]

NOT_CONSTANT = ["u_f", "u_f + 1.0", "vec2(1.0, u_f)", "gl_FragCoord.x", "(1, 2)", "sin(u_f)"]


def shader(expression: str) -> str:
    lines = f"float f = u_f; int i = 1; {expression};"
    return f"#version 330\n{DECLARATIONS}void main() {{ {lines} }}\n"


def facts_of(expression: str) -> tuple[bool, Scalar | None]:
    """Is it a constant expression, and which value does it have?"""
    module, facts = checked(shader(f"bool probe = ({expression}) == ({expression})"))
    both = initialisers(module)["probe"]
    return facts.is_constant(both), facts.constants.get(both.left)  # type: ignore[union-attr]


@pytest.mark.parametrize("expression", VALUES)
def test_4_3_3_values(expression: str) -> None:
    constant, value = facts_of(expression)
    assert constant
    if expression == DRIVER:
        assert value is None
    else:
        assert value == VALUES[expression]
        assert type(value) is type(VALUES[expression])


@pytest.mark.parametrize("expression", CONSTANT_WITHOUT_VALUE)
def test_4_3_3_constant_expressions_without_a_value(expression: str) -> None:
    assert facts_of(expression) == (True, None)


@pytest.mark.parametrize("expression", NOT_CONSTANT)
def test_4_3_3_other_expressions(expression: str) -> None:
    assert facts_of(expression) == (False, None)


def holds(expression: str, value: Scalar) -> str:
    """A constant condition: the expression has the value."""
    if isinstance(value, bool):
        return f"({expression})" if value else f"!({expression})"
    text = f"{value}u" if "u" in expression and isinstance(value, int) else str(value)
    return f"({expression}) == ({text.replace('-2147483648', '-2147483647 - 1')})"


@needs_glslang
def test_4_3_3_glslang_folds_to_the_same_values(tmp_path: Path) -> None:
    """An array of size -1 is an error: so a condition that does not hold is one."""
    conditions = [
        holds(expression, value)
        for expression, value in VALUES.items()
        if not expression.startswith(UNFOLDED)
    ]
    head = f"#version 330\n{DECLARATIONS}"
    file = tmp_path / "all.frag"
    for negation, wrong in (("", 0), ("!", len(conditions))):
        lines = [f"float a{i}[{negation}({c}) ? 1 : -1];\n" for i, c in enumerate(conditions)]
        file.write_text(head + "".join(lines) + "void main() { }\n")
        assert len(bad_lines(file)) == wrong


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("1", "int", 1),
        ("1u", "uint", 1),
        ("0x1Fu", "uint", 31),
        ("0XFF", "int", 255),
        ("0xe", "int", 14),
        ("017", "int", 15),
        ("0", "int", 0),
        ("1.", "float", 1.0),
        ("1e-2", "float", convert(0.01, "float")),
        ("3.F", "float", 3.0),
        ("1.5lf", "double", 1.5),
        ("true", "bool", True),
        ("4294967296", "int", None),
    ],
)
def test_4_1_literals(text: str, kind: str, value: Scalar | None) -> None:
    found, number = literal(text)
    assert (str(found), number) == (kind, value)


@pytest.mark.parametrize(
    ("value", "base", "result"),
    [
        (0.1, "float", 0.10000000149011612),
        (1e300, "float", float("inf")),
        (-1, "uint", 4294967295),
        (3e9, "int", None),
        (-1.0, "uint", None),
        (3e9, "uint", 3000000000),
        (2, "bool", True),
        (True, "int", 1),
        (0.1, "double", 0.1),
        (float("nan"), "int", None),
    ],
)
def test_5_4_1_conversions(value: Scalar, base: str, result: Scalar | None) -> None:
    assert convert(value, base) == result
