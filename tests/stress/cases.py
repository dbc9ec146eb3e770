"""The input that is written down: odd, huge and wrong texts."""

from __future__ import annotations

import sys
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from shadercache.front.read_options import Dialect

Stage: TypeAlias = Literal["fragment", "vertex"]

START = "#version 330\n"
VARYING = START + "in float v;\nout vec4 o;\n"
VARYING_MAIN = "void main() { o = vec4(v); }\n"
MAIN = START + "out vec4 o;\nvoid main() {{ {} o = vec4(1.0); }}\n"


@dataclass(frozen=True, slots=True)
class Case:
    """A text, what has to become of it, and the files beside it that it may include.

    ``expected`` is "accepted", "rejected" (with one diagnostic), its code, "either", or "damaged":
    then there may be more than one.
    """

    name: str
    text: str
    expected: str = "either"
    files: dict[str, str] = field(default_factory=dict)
    stage: Stage = "fragment"
    dialect: Dialect = "glsl"


def written_cases() -> Iterator[Case]:
    """The cases that are the same in every run."""
    yield from _deep()
    yield from _long()
    yield from _many()
    yield from _doubling()
    yield from _macros()
    yield from _includes()
    yield from _characters()


def _deep() -> Iterator[Case]:
    many = 10_000
    texts = {
        "parentheses": f"float x = {'(' * many}1.0{')' * many};",
        "open parentheses": "float x = " + "(" * many,
        "blocks": "{" * many + "}" * many,
        "unary minus": f"float x = {'- ' * many}1.0;",
        "unary not": f"bool x = {'!' * many}true;",
        "else-ifs": "if (true) ; " + "else if (true) ; " * many + "else ;",
        "ifs": "if (true) " * many + ";",
        "loops": "for (;;) " * many + ";",
        "calls": f"float x = {'sin(' * many}1.0{')' * many};",
        "indices": f"int a[2]; a{'[a[0]' * many}{']' * many};",
        "conditionals": "float x = " + "true ? 1.0 : " * many + "1.0;",
        "assignments": "float x; " + "x = " * many + "1.0;",
        "structs": "struct S { " * many,
        "switches": "switch (1) { case 0: " * many,
    }
    for name, text in texts.items():
        yield Case(f"10,000 nested {name}", MAIN.format(text))
    for depth in (50, 250):
        text = "if (true) ; " + "else if (true) ; " * depth
        yield Case(f"{depth} else-ifs", MAIN.format(text), "accepted")
    # The brace of `main` is open, too.
    for depth, expected in ((999, "accepted"), (1000, "SC105")):
        text = MAIN.format(f"float x = {'(' * depth}1.0{')' * depth};")
        yield Case(f"{depth} parentheses", text, expected)
    calls = _numbered("float f{1}(float x) {{ return f{0}(x); }}\n", 10_000)
    yield Case(
        "10,000 functions that call the next",
        f"{START}float f0(float x) {{ return x; }}\n{calls}void main() {{ f10000(1.0); }}\n",
        "accepted",
    )


def _long() -> Iterator[Case]:
    sums = {
        "100,000 terms": "+ 1.0",
        "100,000 factors": "* 1.5",
        "100,000 mixed terms": "+ 2.0 * 1.5",
    }
    for name, term in sums.items():
        yield Case(name, MAIN.format(f"float x = 1.0 {term * 100_000};"), "accepted")
    yield Case("100,000 commas", MAIN.format(f"float x = (0.0{', 1.0' * 100_000});"), "accepted")
    yield Case("100,000 ands", MAIN.format(f"bool x = true{' && true' * 100_000};"), "accepted")
    yield Case("20,000 swizzles", MAIN.format(f"vec2 x = vec2(1.0){'.xy' * 20_000};"), "accepted")
    yield Case(
        "100,000 declarators", MAIN.format(f"float x{_numbered(', x{}', 100_000)};"), "accepted"
    )
    yield Case("100,000 lines", MAIN.format("o += 1.0;\n" * 100_000), "accepted")
    yield Case("100,000 empty lines", START + "\n" * 100_000 + "void main() {}\n", "accepted")
    functions = _numbered("float f{0}(float x) {{ return x + 1.0; }}\n", 20_000)
    yield Case("20,000 functions", START + functions + "void main() {}\n", "accepted")
    overloads = _numbered("void f(float x[{1}]) {{}}\n", 2_000)
    yield Case("2,000 overloads", START + overloads + "void main() {}\n", "accepted")
    yield Case(
        "20,000 uniforms",
        START + _numbered("uniform float u{};\n", 20_000) + "void main() {}",
        "accepted",
    )
    fields = _numbered(" float a{};", 20_000)
    yield Case("20,000 fields", START + f"struct S {{{fields} }};\nvoid main() {{}}", "accepted")
    cases = _numbered("case {}: break; ", 20_000)
    yield Case("20,000 cases", MAIN.format(f"switch (1) {{ {cases} }}"), "accepted")
    yield Case("a word of 1,000,000", START + "float " + "a" * 1_000_000 + ";\nvoid main() {}")
    yield Case("a number of 100,000 digits", MAIN.format(f"float x = 1{'0' * 100_000}.0;"))
    yield Case(
        "an integer of 100,000 digits", MAIN.format(f"int x = 1{'0' * 100_000};"), "rejected"
    )
    yield Case("an exponent of 10 digits", MAIN.format("float x = 1.0e1234567890;"))
    yield Case("2,100,000 tokens", START + ";" * 2_100_000, "SC120")
    yield Case("an array of 2^31 - 1", MAIN.format("float x[2147483647];"))
    yield Case("arrays of arrays of arrays", MAIN.format(f"float x{'[2]' * 900};"))


def _many() -> Iterator[Case]:
    """Many of the same kind, for what might look at each pair of them."""
    many = 1_000
    texts = {
        "inout calls": "void f(inout float x) { x *= 2.0; }\nvoid main() { float a = v; "
        + "f(a); " * many
        + "o = vec4(a); }",
        "assignments": "void main() { o = vec4(v); " + "o += sin(o * v); " * many + "}",
        "locals": "void main() { float a0 = v; "
        + _numbered("float a{1} = sin(a{0}); ", many)
        + f"o = vec4(a{many}); }}",
        "blocks": "void main() { " + "{ float a = v; o += a; } " * many + "}",
        "constants": "const float a0 = 1.0;\n"
        + _numbered("const float a{1} = a{0} * 0.5;\n", many)
        + f"void main() {{ o = vec4(a{many} * v); }}",
        "globals": "float a0 = 1.0;\n"
        + _numbered("float a{1} = a{0} * 0.5;\n", many)
        + f"void main() {{ o = vec4(a{many} * v); }}",
        "fetches": "uniform sampler2D t;\nvoid main() { o = vec4(0.0); "
        + "o += texture(t, o.xy + v); " * many
        + "}",
        "elements": f"const float a[] = float[](1.0{', 2.0' * many});\n{VARYING_MAIN}",
        "empty statements": "void main() { " + ";" * many + " }",
    }
    for name, text in texts.items():
        yield Case(f"1,000 {name}", VARYING + text, "accepted")
    wrong = _numbered("a{} = 1.0; ", 100_000)
    yield Case("100,000 mistakes in a line", MAIN.format(wrong), "damaged")


def _doubling() -> Iterator[Case]:
    """A few lines that ask for billions of something."""
    structs = "struct S0 { float a; };\n"
    structs += _numbered("struct S{1} {{ S{0} a; S{0} b; }};\n", 40)
    sums = "".join(f"float a{n} = a{n - 1} + a{n - 2};\n" for n in range(2, 60))
    constants = "struct S0 { float a; };\nconst S0 c0 = S0(1.0), d0 = S0(1.0);\n"
    constants += _numbered(
        "struct S{1} {{ S{0} a; S{0} b; }};\nconst S{1} c{1} = S{1}(c{0}, c{0});\n"
        "const S{1} d{1} = S{1}(d{0}, d{0});\n",
        40,
    )
    texts = {
        "a comparison of constants of 2^40 fields": f"{constants}const bool same = c40 == d40;\n"
        + VARYING_MAIN,
        "20 functions that call the next twice": "float f0(float x) { return x; }\n"
        + _numbered("float f{1}(float x) {{ return f{0}(x) + f{0}(x * v); }}\n", 20)
        + "void main() { o = vec4(f20(v)); }\n",
        "40 structs of two of the one before": f"{structs}uniform S40 s;\n{VARYING_MAIN}",
        "a comparison of 2^40 fields": f"{structs}void main() {{ S40 a, b; o = vec4(a == b); }}",
        "60 globals that are sums of the two before": f"float a0 = 1.0, a1 = 2.0;\n{sums}"
        "void main() { o = vec4(a59 * v); }",
        "60 locals that are sums of the two before": "void main() { float a0 = v, a1 = 2.0;\n"
        f"{sums}o = vec4(a59); }}",
    }
    for name, text in texts.items():
        yield Case(name, VARYING + text, "accepted")
    items = "#version 420\nfloat a[2147483647] = {1.0};\nvoid main() {}\n"
    yield Case("a list for 2^31 - 1 elements", items, "rejected")
    places = "#version 450\nlayout(location = 0) in float a[2147483647];\nvoid main() {}\n"
    yield Case("2^31 - 1 locations", places)


def _numbered(form: str, count: int) -> str:
    return "".join(form.format(number, number + 1) for number in range(count))


def _macros() -> Iterator[Case]:
    body = "void main() {}\n"
    bomb = "#define A0 1.0\n" + _numbered("#define A{1} A{0} + A{0}\n", 40)
    bomb_of_arguments = "#define B0(x) x x\n" + _numbered("#define B{1}(x) B{0}(x x)\n", 40)
    macros = {
        "a macro that is itself": "#define A A\nfloat A;\n",
        "macros that are each other": "#define A B\n#define B A\nfloat A;\n",
        "a macro that calls itself": "#define F(x) F(F(x))\nfloat a = F(F(F(F(1.0))));\n",
        "a macro bomb": bomb + "float a = A40;\n",
        "a macro bomb with arguments": bomb_of_arguments + "float a = B40(1.0);\n",
        "a macro of 1,000,000 words": "#define A " + "x " * 1_000_000 + "\n",
        "100,000 macros": _numbered("#define A{} 1\n", 100_000),
        "a chain of 10,000 macros": "#define A0 1.0\n"
        + _numbered("#define A{1} A{0}\n", 10_000)
        + "float a = A10000;\n",
        "an argument of 10,000 parentheses": "#define F(x) x\nfloat a = F("
        + "(" * 10_000
        + "1.0"
        + ")" * 10_000
        + ");\n",
        "10,000 nested uses": "#define F(x) x\nfloat a = "
        + "F(" * 10_000
        + "1.0"
        + ")" * 10_000
        + ";\n",
        "a use that is never closed": "#define F(x) x\nfloat a = F(1.0",
        "10,000 parameters": f"#define F(a{_numbered(', a{}', 10_000)}) a0\n",
        "pasting without end": "#define P(a, b) a##b\nfloat "
        + "P(" * 500
        + "a"
        + ", b)" * 500
        + ";\n",
        "pasting nothing": "#define P(a, b) a##b\nfloat P(, );\n",
        "10,000 nested #if": "#if 1\n" * 10_000 + "#endif\n" * 10_000,
        "10,000 #if that are never closed": "#if 1\n" * 10_000,
        "10,000 #elif": "#if 0\n" + "#elif 0\n" * 10_000 + "#endif\n",
        "a condition of 100,000 terms": "#if 1" + " + 1" * 100_000 + "\n#endif\n",
        "a condition of 10,000 parentheses": "#if "
        + "(" * 10_000
        + "1"
        + ")" * 10_000
        + "\n#endif\n",
        "a condition of 10,000 minus signs": "#if " + "-" * 10_000 + "1\n#endif\n",
        "a division by zero": "#if 1 / 0\n#endif\n",
        "a shift by too much": "#if 1 << 100000000000\n#endif\n",
        "a condition of 100,000 digits": "#if " + "9" * 100_000 + "\n#endif\n",
        "a line number of 100,000 digits": "#line " + "9" * 100_000 + "\n",
        "100,000 joined lines": "#define A \\\n" + "x \\\n" * 100_000 + "\n",
        "an unterminated comment": "/* " + "x " * 500_000,
        "1,000,000 comment openings": "/*" * 1_000_000,
        "1,000,000 stars": "/" + "*" * 1_000_000,
        "1,000,000 slashes": "/" * 1_000_000,
        "100,000 comments": "/**/ // a\n" * 100_000,
        "an unterminated string": '#include "abc\n',
    }
    for name, text in macros.items():
        yield Case(name, START + text + body)
    yield Case("directives without a name", f"{START}# \n#\n#!\n#@\n{body}", "damaged")


def _includes() -> Iterator[Case]:
    use = "#extension GL_GOOGLE_include_directive : require\n#include {}\nvoid main() {{}}\n"
    selves = {"a.glsl": '#include "a.glsl"\n#include "a.glsl"\n'}
    yield Case("a file that includes itself", START + use.format('"a.glsl"'), "rejected", selves)
    each = {"a.glsl": '#include "b.glsl"\n', "b.glsl": '#include "a.glsl"\n'}
    yield Case("files that include each other", START + use.format('"a.glsl"'), "rejected", each)
    twice = {f"f{n}.glsl": f'#include "f{n + 1}.glsl"\n' * 2 for n in range(40)} | {
        "f40.glsl": "\n"
    }
    yield Case("an include bomb", START + use.format('"f0.glsl"'), "either", twice)
    for name in (
        '"../../x"',
        '"/etc/passwd"',
        '"~/.profile"',
        '"a/../../x"',
        '"."',
        '""',
        "<../x>",
    ):
        yield Case(f"#include {name}", START + use.format(name), "rejected")
    yield Case(
        "#include of a name of 1,000,000", START + use.format(f'"{"a" * 1_000_000}"'), "rejected"
    )
    yield Case("#include of a NUL", START + use.format('"a\0b"'), "damaged")


def _characters() -> Iterator[Case]:
    for where, form in {
        "code": "{}",
        "a comment": "// {}\n",
        "a block comment": "/* {} */",
    }.items():
        text = START + form.format("\0") + "\nvoid main() {}\n"
        yield Case(f"a NUL in {where}", text, "rejected" if where == "code" else "either")
    yield Case("nothing", "")
    yield Case("blanks", " \t\r\n" * 100_000)
    yield Case("a byte order mark", "\ufeff" + START + "void main() {}\n", "accepted")
    yield Case("1,000,000 backslashes", START + "\\" * 1_000_000 + "\nvoid main() {}\n")
    yield Case("1,000,000 quotes", START + '"' * 1_000_000 + "\nvoid main() {}\n")
    for kind, characters in _unicode_classes().items():
        body = "void main() {}\n"
        line = START + f"// {characters}\n" + body
        yield Case(f"Unicode {kind} in a line comment", line, "accepted")
        block = START + f"/* {characters} */ " + body
        yield Case(f"Unicode {kind} in a block comment", block, "accepted")
        yield Case(f"Unicode {kind} in code", START + f"float {characters};\n" + body)


def _unicode_classes() -> dict[str, str]:
    """Forty characters of every general category but ASCII, and the bidirectional marks."""
    found: dict[str, list[str]] = {}
    for code in range(128, sys.maxunicode + 1):
        character = chr(code)
        kept = found.setdefault(unicodedata.category(character), [])
        if len(kept) < 40 and character.encode("utf-8", "replace") != b"?":
            kept.append(character)
    found["bidirectional"] = list("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
    return {kind: " ".join(characters) for kind, characters in found.items() if characters}
