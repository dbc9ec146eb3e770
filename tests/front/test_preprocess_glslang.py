"""The reference compiler's preprocessor makes the same of small texts, and rejects the same."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from preprocessing import run

from shadercache.diagnostics import InputError
from shadercache.front.preprocess import spellings
from tests.glslang import needs_glslang

pytestmark = needs_glslang

MACROS = [
    "#define A B\n#define B 1 + A\nA B",
    "#define F(x) [x]\n#define G(x, y) F(x) F(y)\nF(1) G(2, F(3)) G((4, 5), 7) F F (\n6\n) G",
    "#define N() n\nN() N( ) N",
    "#define f(x) x f\nf(1)(2)",
    "#define f(a) a*g\n#define g(a) f(a)\nf(2)(9)",
    "#define F(x) x\n#define LP (\nF LP 1)",
    "#define P(a, b) a##b\n#define x 1\nP(x, y) P(a, 1) P(<, <=) P(=, =) P(a.b, c)",
    "#define P(a) pre_##a##_post\n#define M z\n#define W(a) P(a)\nP(M) W(M)",
    "#define A x##y\n#define xy 3\nA",
    "#define A 1 +  2\n#define A   1 + 2\nA\n#undef A\nA\n#undef A\n#define A 3\nA",
    "#define float vec4\nfloat a;\n#undef float\nfloat b;",
    "#define A /* x\n y */ 1\nA /* \u00e4 */ // \u2264\nA",
    "#define H __LINE__\n__LINE__ H __VERSION__\n#line 20 3\nH __FILE__\n#line 5 + 2\nH",
    "fl\\\noat a;\n#\\\n",
    "#de\\\nfine A 1 \\\n + 2\nA a\\\n\\\n+\\\n+b",
]
CONDITIONS = [
    "1 || 0 && 0",
    "(1 | 6) == 7 && !(2 & 5) && (6 ^ 3) == 5",
    "1 - 1 - 1 == -1 && 7 / 2 * 2 == 6 && -7 % 3 == -1",
    "0x1F == 31 && 017 == 15 && ~0 == -1 && - - 1",
    "1 << 3 >> 1 == 4 && 3 > 2 && 2 >= 2 && 1 < 2 && 2 <= 2 && 1 != 2",
    "defined A && defined(A) && !defined B && !defined(B)",
    "A == 4 && F(3) == 6 && X == 0",
    "__VERSION__ >= 450 && GL_core_profile",
    "2147483647 + 1 < 0 && 4294967295 == -1",
    "4 / 3 == 2",
    "F(0)",
]
WRONG = [
    *("#define A 1\n#define A 2", "#define A 1+1\n#define A 1 + 1"),
    *("#define A(x) x\n#define A(y) y", "#define A ## b\nA"),
    *("#define P(a, a) a", "#define P(a, 1) a", "#define P(a b) a", "#define P(a,) a"),
    *("#define P(...", "#define", "#define defined", "#define GL_X 1"),
    *("#undef GL_core_profile", "#undef A B"),
    *("#define F(x, y) x\nF(1)", "#define F(x, y) x\nF(1, 2, 3)", "#define F(x) x\nF(1"),
    *("#define N() 1\nN(1)", "#define F(x) x\nF(\n#if 1\n#endif\n)"),
    *("#if\n#endif", "#if 1 +\n#endif", "#if 1 / 0\n#endif", "#if (1\n#endif", "#if 1)\n#endif"),
    *("#if 1 2\n#endif", "#if 1.0\n#endif", "#if 08\n#endif", "#if 1u\n#endif", "#if @\n#endif"),
    *("#if 1 ? 1 : 0\n#endif", "#if defined(A\n#endif", "#if defined\n#endif", "#if 1 = 1\n#endif"),
    *("#if 99999999999\n#endif", "#define D defined(X)\n#if D\n#endif", "#if 1 ^^ 0\n#endif"),
    *("#ifdef\n#endif", "#ifdef 1\n#endif", "#ifdef A B\n#endif", "#ifndef A B\n#endif"),
    *("#if 1", "#if 0", "#endif", "#else", "#elif 1", "#if 1\n#else\n#else\n#endif"),
    *("#if 1\n#else\n#elif 1\n#endif", "#if 1\n#else x\n#endif"),
    *("#if 1\n#endif x", "#if 0\n#endif x"),
    *("#foo", "# 1", "#error no", "#version 450", "/* open", "#if 0\n/* open\n#endif"),
    *("#line", "#line 1.0", "#line 1 2 3"),
    *("#extension GL_X enable", "#extension", "#extension GL_X :"),
]


def reference(text: str, folder: Path) -> list[str] | None:
    """What the reference compiler makes of a text; ``None`` where it rejects it."""
    file = folder / "test.frag"
    file.write_text(text)
    command = ["glslangValidator", "-E", str(file)]
    done = subprocess.run(command, capture_output=True, check=False)
    lines = done.stdout.decode("utf-8", "replace").splitlines()
    kept = (line for line in lines if not re.match(r"\s*#\s*(version|line)", line))
    return None if done.returncode else list(spellings("\n".join(kept)))


def ours(text: str) -> list[str] | None:
    try:
        return run(text).lexemes.texts
    except InputError:
        return None


@pytest.mark.parametrize("text", MACROS)
@pytest.mark.parametrize("version", ["150", "310 es", "450"])
def test_macros(text: str, version: str, tmp_path: Path) -> None:
    text = f"#version {version}\n{text}\n"
    expected = reference(text, tmp_path)
    assert expected is not None
    assert ours(text) == expected


@pytest.mark.parametrize("expression", CONDITIONS)
def test_conditions(expression: str, tmp_path: Path) -> None:
    head = "#version 450\n#define A 1 + 3\n#define F(x) x * 2\n"
    text = f"{head}#if {expression}\nyes\n#elif 1\nno\n#else\nnever\n#endif\n"
    expected = reference(text, tmp_path)
    assert expected is not None
    assert ours(text) == expected


@pytest.mark.parametrize("body", WRONG)
@pytest.mark.slow
def test_mistakes(body: str, tmp_path: Path) -> None:
    text = f"#version 450\n{body}\n"
    assert (ours(text), reference(text, tmp_path)) == (None, None)
