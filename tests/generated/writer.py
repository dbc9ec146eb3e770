"""Random fragment shaders: statements, functions, and the shader as a whole."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cache

from hypothesis import strategies as st

from .carriers import indented
from .dialects import DIALECTS, Dialect
from .expressions import VARYINGS
from .shapes import Shapes
from .state import ELEMENT, FLOATS, LENGTH

UNIFORMS = {
    "u_a": ("float", (0.7,)),
    "u_b": ("vec3", (0.3, 0.6, 0.9)),
    "u_n": ("int", (3.0,)),
}
SAMPLERS = {"u_mipmapped": "sampler2D", "u_plain": "sampler2D", "u_cube": "samplerCube"}

NEVER = ("u_n > 5", "u_b.x > 2.0", "u_a < 0.0")
"""Conditions that no fragment meets, which only the driver can know."""

LEVELS = (1, 2, 2, 3)
"""Of an expression."""


@dataclass(frozen=True)
class Shader:
    """A generated fragment shader: its text and how often each construct was written."""

    dialect: Dialect
    text: str
    tags: Counter[str]


class Writer(Shapes):
    """Writes one shader."""

    def shader(self) -> Shader:
        self.default_precision = not (self.dialect.es and self.chance(4))
        self.may_discard = self.chance(3)
        head = self.head()
        lines: list[str] = []
        for number in range(self.pick(5)):
            shapes = (self.function_, self.taker, self.taker, self.giver, self.passer)
            lines += self.choose((*shapes, self.function_, self.taker))(number)
        lines += self.main()
        text = "\n".join([*head, *lines, ""])
        return Shader(self.dialect, text, self.tags)

    def head(self) -> list[str]:
        dialect = self.dialect
        lines = [f"#version {dialect.version}"]
        if dialect.es and self.default_precision:
            lines.append(f"precision {self.choose(('highp', 'mediump'))} float;")
        lines += [f"{dialect.reads} {self.varying(k)} {name};" for name, k in VARYINGS.items()]
        lines += [f"uniform {self.typed(k)} {name};" for name, (k, _) in UNIFORMS.items()]
        lines += [f"uniform {kind} {name};" for name, kind in SAMPLERS.items() if self.has(name)]
        if dialect.color == "o_color":
            lines.append(f"out {self.highp('vec4')} o_color;")
        lines.append(
            f"struct Pair {{ {self.typed('float')} first; {self.typed('vec3')} second; }};"
        )
        for name, kind in VARYINGS.items():
            self.declare(name, kind, writable=False)
        for name, (kind, _) in UNIFORMS.items():
            self.declare(name, kind, writable=False)
        lines += self.globals()
        return lines

    def varying(self, kind: str) -> str:
        """Both stages must agree in the precision where a version says so."""
        return self.highp(kind)

    def highp(self, kind: str) -> str:
        return f"highp {kind}" if self.dialect.es else kind

    def has(self, sampler: str) -> bool:
        return sampler != "u_cube" or self.dialect.modern

    def globals(self) -> list[str]:
        lines: list[str] = []
        for number in range(self.pick(4)):
            kinds = ("float", "vec3", "float", "int", "vec2", "Pair", "bool", "mat2", "float[3]")
            kind = self.choose(self.held(kinds))
            name, constant = f"g{number}", self.chance(4)
            if self.chance(4):
                name = self.new_name() or name
            self.tag("const global" if constant else "global")
            word = "const " if constant else ""
            lines.append(f"{word}{self.variable(kind, name)} = {self.literal(kind)};")
            self.declare(name, kind, writable=not constant)
        if self.dialect.arrays and self.chance(4):
            self.tag("const global array")
            lines.append(f"const {self.variable('float[3]', 'table')} = float[3](0.25, 0.5, 1.5);")
            self.declare("table", "float[3]", writable=False)
        return lines

    # --- functions ---

    def function_(self, number: int) -> list[str]:
        kinds = ("float", "vec3", "vec2", "vec4", "void", "int", "bool", "mat2", "Pair")
        result = self.choose(kinds)
        params = tuple(self.parameter() for _ in range(self.pick(4)))
        name = self.function_name(number, params)
        self.begin_function(result, calls=2)
        for _, kind in params:
            given = self.new_name()
            assert given is not None
            self.declare(given, kind)
        outs = [
            name for (way, _), name in zip(params, self.scopes[-1], strict=True) if way == "out"
        ]
        body = [f"{name} = {self.literal(self.scopes[-1][name].kind)};" for name in outs]
        body += self.declaration(0)
        body += self.statements(1 + self.pick(3), 1)
        if result != "void":
            body.append(f"return {self.expr(result, self.choose(LEVELS))};")
        return self.finished(name, result, params, body)

    def parameter(self) -> tuple[str, str]:
        kinds = ["float", "vec3", "vec2", "vec4", "int", "mat2", "Pair", "bool"]
        if self.dialect.arrays:
            kinds.append("float[3]")
        way = self.choose(("in", "in", "in", "inout", "out"))
        kind = self.choose(kinds if way == "in" else kinds[:5])
        self.tag(f"{way} parameter")
        if kind in ("Pair", "float[3]"):
            self.tag("struct or array parameter")
        return way, kind

    def function_name(self, number: int, params: tuple[tuple[str, str], ...]) -> str:
        kinds = [kind for _, kind in params]
        for other in self.functions:
            same = [item for item in self.functions if item.name == other.name]
            taken = [[kind for _, kind in item.params] for item in same]
            if kinds not in taken and self.chance(3):
                self.tag("overload")
                return other.name
        return f"f{number}"

    def main(self) -> list[str]:
        self.begin_function("main", calls=5)
        color = self.dialect.color
        body = [f"{color} = vec4(0.0);"]
        body += self.first_values()
        body += self.statements(self.pick(3), 2)
        for _ in range(self.pick(3)):
            body += self.story(1)
        body += self.statements(self.pick(3), 2)
        body.append(f"{color} += {self.expr('vec4', 3)};")
        for name, item in self.visible().items():
            text = self.as_float(name, item.kind)
            if text and item.writable:
                body.append(f"{color}.{self.choose('xyzw')} += 0.2 * {text};")
        return ["void main() {", *indented(body), "}"]

    def first_values(self) -> list[str]:
        """Values of the surface, before anything is under a condition: there are always nodes."""
        body = [f"{self.variable('vec3', 's')} = {self.expr('vec3', 2)} + sin(3.0 * v_position);"]
        self.declare("s", "vec3")
        body.append(f"{self.variable('vec4', 't')} = {self.textured('vec4', 1)} * 0.5;")
        self.declare("t", "vec4")
        for item in self.functions[-2:]:
            name = self.new_name()
            if name is None or not self.callable(item):
                continue
            text = self.call_of(item, 1)
            if item.result != "void" and self.flow.uniform:
                text = f"{self.variable(item.result, name)} = {text}"
                self.declare(name, item.result)
            body += [f"{text};"] if text else []
        return [*body, *self.declaration(0)]

    def as_float(self, name: str, kind: str) -> str:
        if kind in FLOATS:
            return f"fract({name}{'.y' if kind != 'float' else ''})"
        if kind in ("int", "uint", "bool"):
            return f"fract(0.37 * float({name}))"
        if kind.startswith("mat"):
            return f"fract({name}[0].x)"
        return {"Pair": f"fract({name}.second.x)", "float[3]": f"fract({name}[2])"}.get(kind, "")

    # --- statements ---

    def statements(self, count: int, depth: int) -> list[str]:
        """``depth`` is how deep statements may be nested."""
        lines: list[str] = []
        for _ in range(count):
            forms = [self.declaration, self.declaration, self.assignment, self.assignment]
            forms += [self.call_statement, self.compound]
            if depth:
                forms += [self.if_, self.for_, self.block, self.if_, self.story, self.story]
                forms += [self.while_] if self.dialect.loops else []
                forms += [self.switch] if self.dialect.modern else []
            if self.flow.escapes and self.chance(2):
                forms += [self.leave_early]
            lines += self.choose(forms)(depth)
        return lines

    def kinds(self) -> list[str]:
        found = ["float", "vec3", "vec2", "vec4", "float", "vec3", "int", "bool", "mat2", "mat3"]
        found += ["Pair"]
        if self.dialect.arrays:
            found += ["float[3]", "vec2[2]"]
        if self.dialect.modern:
            found += ["uint", "ivec2"]
        return found

    def declaration(self, depth: int) -> list[str]:
        kind, name = self.choose(self.kinds()), self.new_name()
        if name is None:
            return self.assignment(depth)
        if kind in ("Pair", *LENGTH):
            self.tag("struct" if kind == "Pair" else "array")
        if kind in FLOATS and self.chance(8):
            self.tag("const local")
            self.declare(name, kind, writable=False)
            return [f"const {self.variable(kind, name)} = {self.literal(kind)};"]
        first = f"{self.variable(kind, name)} = {self.expr(kind, self.choose(LEVELS))}"
        self.declare(name, kind)
        other = self.new_name()
        if kind not in LENGTH and other and self.chance(5):
            self.tag("several declarators")
            first += f", {other} = {self.expr(kind, 1)}"
            self.declare(other, kind)
        return [f"{first};"]

    def assignment(self, depth: int) -> list[str]:
        kind = self.choose([k for k in self.kinds() if k not in ELEMENT])
        found = self.places(kind)
        if not found:
            return [f"{self.expr('float', 2)};"] if self.chance(3) else []
        place = self.choose(found)
        if "." in place and kind in FLOATS:
            self.tag("swizzled l-value")
        if self.result != "main" and self.is_global(place):
            self.tag("global written by a function")
        return [f"{place} = {self.expr(kind, self.choose(LEVELS))};"]

    def compound(self, depth: int) -> list[str]:
        kind = self.choose(("float", "vec3", "vec2", "vec4", "int"))
        found = self.places(kind)
        if not found:
            return []
        self.tag("compound assignment")
        place, value = self.choose(found), self.expr(kind, 2)
        if kind == "int":
            return [f"{place} {self.choose(('+=', '-='))} {value};"]
        form = self.choose(("+= {}", "-= {}", "*= cos({})", "/= 1.25 + abs({})"))
        return [f"{place} {form.format(value)};"]

    def call_statement(self, depth: int) -> list[str]:
        fitting = [item for item in self.functions if self.callable(item)]
        if not fitting or self.calls_left <= 0:
            return self.assignment(depth)
        text = self.call_of(self.choose(fitting), 2)
        self.tag("call as a statement")
        return [f"{text};"] if text else []

    def block(self, depth: int) -> list[str]:
        with self.scope():
            body = self.statements(1 + self.pick(2), depth - 1)
            left = self.flow.uniform
        self.flow.uniform = left
        return ["{", *indented(body), "}"]

    def nested(self, depth: int, uniform: bool, **changes: bool) -> list[str]:
        """A body of its own. What jumps out of it to the end of the function divides the flow."""
        with self.scope(uniform=uniform, **changes):
            jumps = self.tags["return"], self.tags["discard"], self.tags["jump"]
            body = self.statements(1 + self.pick(2), depth - 1)
            if self.flow.loop and self.chance(2):
                body += self.leave_early(depth)
        if jumps != (self.tags["return"], self.tags["discard"], self.tags["jump"]):
            self.leave()
        return indented(body)

    def if_(self, depth: int) -> list[str]:
        uniform = self.chance(4)
        self.tag("uniform if" if uniform else "if")
        test = self.uniform_test() if uniform else self.expr("bool", 2)
        before = self.flow.uniform
        lines = [f"if ({test}) {{", *self.nested(depth, uniform and before)]
        if self.chance(2):
            self.tag("else")
            lines += ["} else {", *self.nested(depth, uniform and before)]
        return [*lines, "}"]

    def for_(self, depth: int) -> list[str]:
        self.tag("for")
        jumps = self.chance(2)
        name = self.choose(("i", "j"))
        with self.scope():
            self.declare(name, "int", writable=False)
            uniform = self.flow.uniform and not jumps
            leaves = jumps and self.flow.escapes
            body = self.nested(depth, uniform, escapes=leaves, loop=leaves)
        if jumps:
            self.flow.uniform = False
        end = 1 + self.pick(3)
        return [f"for (int {name} = 0; {name} < {end}; {name}++) {{", *body, "}"]

    def while_(self, depth: int) -> list[str]:
        name = self.choose(("n", "m"))
        form = self.choose(("while", "do"))
        self.tag(form)
        with self.scope():
            self.declare(name, "int", writable=False)
            body = self.nested(depth, False, loop=True)
            test = f"{name} < {1 + self.pick(3)} && {self.expr('bool', 1)}"
        self.flow.uniform = False
        count = f"    {name}++;"
        if form == "while":
            lines = [f"while ({test}) {{", count, *body, "}"]
        else:
            lines = ["do {", count, *body, f"}} while ({test});"]
        return ["{", *indented([f"int {name} = 0;", *lines]), "}"]

    def switch(self, depth: int) -> list[str]:
        uniform = self.chance(3)
        self.tag("uniform switch" if uniform else "switch")
        lines = [f"switch ({'u_n' if uniform else self.expr('int', 2)}) {{"]
        uniform = uniform and self.flow.uniform
        for label in ("case 3:", "case 2:", "default:"):
            lines += [f"    {label}", "    {"]
            lines += indented(self.nested(depth, uniform, switch=True))
            falls = label != "default:" and self.chance(3)
            if falls:
                self.tag("fall through")
            lines += ["    }"] if falls else ["    }", "    break;"]
        return [*lines, "}"]

    def leave_early(self, depth: int) -> list[str]:
        """A return, a break or continue, or a discard, mostly under a condition."""
        ways = ["return"] if self.flow.escapes else []
        if self.flow.loop:
            ways += ["break", "continue", "break", "continue"]
        if self.may_discard and self.flow.escapes:
            ways += ["discard", "discard"]
        word = self.choose(ways)
        together = word in ("return", "discard") and self.chance(3)
        test = self.choose(NEVER) if together else self.expr("bool", 2)
        if together:
            self.tag(f"uniform {word}")
        elif word in ("return", "discard"):
            self.leave()
        if word == "return":
            self.tag("return")
            if self.result not in ("void", "main"):
                word = f"return {self.expr(self.result, 2)}"
        elif word == "discard":
            self.tag("discard")
            self.discards = True
        else:
            self.tag("jump")
            self.tag(word)
        return [f"if ({test}) {word};"]


@cache
def _below(count: int) -> st.SearchStrategy[int]:
    return st.integers(0, count - 1)


@st.composite
def shaders(draw: st.DrawFn, dialect: str) -> Shader:
    """Random fragment shaders of a dialect."""
    writer = Writer(lambda count: draw(_below(count)), DIALECTS[dialect])
    return writer.shader()
