"""Random expressions of a given type. Values stay finite: what could grow is bounded on the way."""

from __future__ import annotations

from collections.abc import Callable

from .state import ELEMENT, FIELDS, FLOATS, LENGTH, WIDTH, Function, State

LITERALS = ("0.5", "1.0", "0.25", "2.0", "0.3", "1.7", "(-0.75)", "3.0", "0.0")
VARYINGS = {"v_position": "vec3", "v_normal": "vec3", "v_uv": "vec2"}
FUNCTIONS = (
    *("sin({})", "cos({})", "abs({})", "fract({})", "floor({})", "sqrt(abs({}))"),
    *("exp2(-abs({}))", "inversesqrt(1.0 + abs({}))", "sign({})", "tan(sin({}))"),
)
FUNCTIONS_2 = (
    *("min({a}, {b})", "max({a}, {b})", "mix({a}, {b}, fract({s}))", "mod({a}, 1.5)"),
    *("clamp({a}, -2.0, 2.0)", "step({a}, {b})", "smoothstep(-1.0, 1.0, {a})"),
    "pow(fract({a}) + 0.5, {b} * 0.0 + 1.5)",
)
Maker = Callable[[str, int], str]
LETTERS = ("xyzw", "rgba")
MOST_INDICES = 8
"""How deep indices stand in indices."""


class Expressions(State):
    """Writes expressions. ``depth`` is how many more levels an expression may have."""

    def expr(self, kind: str, depth: int) -> str:
        """An expression of the type."""
        if depth <= 0:
            return self.leaf(kind)
        makers: dict[str, tuple[Maker, ...]] = {
            "int": (self.leaf, self.int_binary, self.int_from_float, self.int_other, self.any),
            "uint": (self.leaf, self.uint_binary, self.any),
            "ivec2": (self.leaf, self.ivec_binary, self.any),
            "bool": (self.compare, self.logic, self.relational, self.any),
            "mat2": (self.leaf, self.columns, self.mat_binary, self.any),
            "mat3": (self.leaf, self.columns, self.mat_binary, self.any),
        }
        if kind in FLOATS:
            return self.choose(self.float_makers(kind))(kind, depth - 1)
        return self.choose(makers.get(kind, (self.leaf, self.construct, self.any)))(kind, depth - 1)

    def float_makers(self, kind: str) -> list[Maker]:
        found: list[Maker] = [self.leaf, self.binary, self.binary, self.function, self.function_2]
        found += [self.scaled, self.swizzle, self.call, self.call, self.any]
        found += [self.convert, self.textured, self.textured, self.geometry]
        if kind != "float":
            found += [self.construct, self.construct]
        if kind in ("vec2", "vec3"):
            found.append(self.transform)
        return found

    # --- leaves ---

    def leaf(self, kind: str, depth: int = 0) -> str:
        found = self.readable(kind)
        if found and self.pick(5):
            return self.choose(found)
        if kind == "bool" and self.pick(4):
            return self.parting_test()
        return self.literal(kind)

    def parting_test(self) -> str:
        """A condition that about half of the fragments meet."""
        place = f"{self.choose(('v_position', 'v_normal'))}.{self.choose('xyz')}"
        return f"({place} {self.choose('<>')} {self.choose(('0.1', '0.0', '(-0.2)'))})"

    def uniform_test(self) -> str:
        """A condition that all fragments agree on; mostly one that they meet."""
        return self.choose(("u_a > 0.5", "u_n == 3", "u_a < 2.0", "u_n > 5"))

    def readable(self, kind: str) -> list[str]:
        """Variables of the type, and parts of other variables; varyings are the likeliest."""
        found: list[str] = []
        visible = self.visible()
        for name, item in (*visible.items(), *list(visible.items())[: len(VARYINGS)]):
            if item.kind == kind:
                found.append(name)
            elif item.kind in WIDTH and WIDTH[item.kind] > WIDTH.get(kind, 9):
                start = self.pick(WIDTH[item.kind] - WIDTH[kind] + 1)
                found.append(f"{name}.{self.choose(LETTERS)[start : start + WIDTH[kind]]}")
            elif ELEMENT.get(item.kind) == kind:
                found.append(f"{name}[{self.index(item.kind)}]")
            else:
                found += [f"{name}.{f}" for f, held in FIELDS.get(item.kind, ()) if held == kind]
        return found

    def index(self, kind: str) -> str:
        """An index into an array: a constant, or what varies."""
        # Where many arrays are visible an index holds several more on average, without end.
        if self.dialect.arrays and self.indices_open < MOST_INDICES and self.chance(3):
            self.tag("varying index")
            self.indices_open += 1
            index = f"int({LENGTH[kind] - 1}.99 * fract({self.leaf('float')}))"
            self.indices_open -= 1
            return index
        return str(self.pick(LENGTH[kind]))

    def literal(self, kind: str) -> str:
        if kind == "float":
            return self.choose(LITERALS)
        if kind in FLOATS:
            parts = [self.choose(LITERALS) for _ in range(WIDTH[kind])]
            return f"{kind}({', '.join(parts)})"
        plain = {
            "int": ("1", "2", "0", "5"),
            "uint": ("1u", "3u", "7u"),
            "ivec2": ("ivec2(1, 2)", "ivec2(3)"),
            "bool": ("true", "false"),
            "mat2": ("mat2(1.0)", "mat2(0.8, 0.6, -0.6, 0.8)"),
            "mat3": ("mat3(1.0)", "mat3(0.0, 1.0, 0.0, 0.5, 0.0, 0.5, 0.0, 0.0, 1.0)"),
            "Pair": ("Pair(0.5, vec3(0.25))",),
            "float[3]": ("float[3](0.5, 0.25, 1.5)",),
            "vec2[2]": ("vec2[2](vec2(0.5), vec2(0.1, 0.2))",),
        }
        return self.choose(plain[kind])

    # --- floats ---

    def binary(self, kind: str, depth: int) -> str:
        a, b = self.expr(kind, depth), self.expr(kind, depth)
        form = self.choose(("+", "-", "*", "lit", "/"))
        self.tag("arithmetic")
        if form == "*":
            return f"({a} * sin({b}))"
        if form == "lit":
            return f"({a} * {self.choose(LITERALS)})"
        if form == "/":
            return f"({a} / (1.5 + abs({b})))"
        return f"({a} {form} {b})"

    def scaled(self, kind: str, depth: int) -> str:
        if self.chance(3):
            return f"(-{self.expr(kind, depth)})"
        return f"({self.expr(kind, depth)} * fract({self.expr('float', depth)}))"

    def function(self, kind: str, depth: int) -> str:
        form = self.choose(FUNCTIONS)
        return form.format(self.expr(kind, depth))

    def function_2(self, kind: str, depth: int) -> str:
        form = self.choose(FUNCTIONS_2)
        a, b = self.expr(kind, depth), self.expr(kind, depth)
        return form.format(a=a, b=b, s=self.expr("float", 0))

    def construct(self, kind: str, depth: int) -> str:
        self.tag("constructor")
        if kind in FIELDS:
            self.tag("struct")
            return f"Pair({self.expr('float', depth)}, {self.expr('vec3', depth)})"
        if kind in ELEMENT:
            self.tag("array")
            parts = (self.expr(ELEMENT[kind], depth) for _ in range(LENGTH[kind]))
            return f"{ELEMENT[kind]}[{LENGTH[kind]}]({', '.join(parts)})"
        left, parts_ = WIDTH[kind], []
        while left:
            width = 1 + self.pick(min(left, WIDTH[kind] - 1))
            parts_.append(self.expr(FLOATS[width - 1], depth))
            left -= width
        return f"{kind}({', '.join(parts_)})"

    def swizzle(self, kind: str, depth: int) -> str:
        self.tag("swizzle")
        wider = [k for k in FLOATS if WIDTH[k] >= max(2, WIDTH[kind])]
        held = self.choose(wider)
        letters = "".join(self.choose("xyzw"[: WIDTH[held]]) for _ in range(WIDTH[kind]))
        return f"({self.expr(held, depth)}).{letters}"

    def geometry(self, kind: str, depth: int) -> str:
        if kind == "float":
            held = self.choose(("vec3", "vec2"))
            form = self.choose(("length({})", "dot(sin({}), {})", "distance({}, {})"))
            parts = [self.expr(held, depth) for _ in range(form.count("{}"))]
            return form.format(*parts)
        if kind == "vec2":
            return f"normalize(vec2({self.expr('float', depth)}, 1.5))"
        if kind == "vec3":
            form = self.choose(("normalize(vec3({}, 1.5))", "cross(sin({}), {})"))
            kinds = ("vec2",) if "norm" in form else ("vec3", "vec3")
            return form.format(*(self.expr(k, depth) for k in kinds))
        return f"faceforward({', '.join(self.expr(kind, depth) for _ in range(3))})"

    def transform(self, kind: str, depth: int) -> str:
        self.tag("matrix")
        matrix = self.expr(f"mat{WIDTH[kind]}", depth)
        vector = self.expr(kind, depth)
        return self.choose((f"({matrix} * {vector})", f"({vector} * {matrix})", f"{matrix}[1]"))

    def convert(self, kind: str, depth: int) -> str:
        self.tag("conversion")
        if kind == "vec2":
            return f"(0.125 * vec2({self.expr('ivec2', depth)}))"
        held = self.choose(("int", "bool", "uint") if self.dialect.modern else ("int", "bool"))
        value = f"float({self.expr(held, depth)})"
        bounded = value if held == "bool" else f"fract(0.37 * {value})"
        return bounded if kind == "float" else f"{kind}({bounded})"

    # --- textures and derivatives ---

    def textured(self, kind: str, depth: int) -> str:
        forms: list[tuple[str, str, str]] = []
        if self.flow.uniform:
            forms += [
                ("texture", self.dialect.sampled + "({s}, {uv})", "derives"),
                ("texture bias", self.dialect.sampled + "({s}, {uv}, 1.0)", "derives"),
                ("textureProj", self.dialect.projected + "({s}, vec3({uv}, 1.25))", "derives"),
            ]
        if self.flow.uniform and self.dialect.derivatives:
            forms += [(name, name, "derives") for name in ("dFdx", "dFdy", "fwidth")]
        if self.flow.uniform and self.dialect.modern:
            forms += [
                ("textureOffset", "textureOffset({s}, {uv}, ivec2(1, -1))", "derives"),
                ("cube map", "texture(u_cube, vec3({uv}, 0.7))", "derives"),
                ("cube level", "textureLod(u_cube, vec3({uv}, 0.7), 0.0)", "derives"),
            ]
        if self.dialect.modern:
            forms += [
                ("textureLod", "textureLod({s}, {uv}, abs({l}))", ""),
                ("texelFetch", "texelFetch({s}, ivec2(15.0 * fract({uv})), 1)", ""),
            ]
        if not forms:
            return self.leaf(kind)
        name, form, derives = self.choose(forms)
        self.tag(name)
        self.derives |= bool(derives)
        if form == name:
            return f"{name}({self.expr(kind, depth)})"
        sampler = self.choose(("u_mipmapped", "u_plain")) if name != "texelFetch" else "u_mipmapped"
        text = form.format(s=sampler, uv=self.expr("vec2", depth), l=self.leaf("float"))
        letters = "".join(self.choose("xyzw") for _ in range(WIDTH[kind]))
        return f"{text}.{letters}"

    # --- calls and what any type has ---

    def call(self, kind: str, depth: int) -> str:
        fitting = [item for item in self.functions if item.result == kind and self.callable(item)]
        if not fitting or self.calls_left <= 0:
            return self.leaf(kind)
        return self.call_of(self.choose(fitting), depth)

    def callable(self, item: Function) -> bool:
        """May it be called here, and is there a variable for each parameter that it writes?"""
        if item.derives and not self.flow.uniform:
            return False
        if item.discards and not self.flow.escapes:
            return False
        needed = [kind for way, kind in item.params if way != "in"]
        return all(len(self.places(kind)) >= needed.count(kind) for kind in needed)

    def call_of(self, item: Function, depth: int) -> str:
        self.calls_left -= 1
        taken: set[str] = set()
        arguments: list[str] = []
        for way, kind in item.params:
            if way == "in":
                arguments.append(self.expr(kind, depth))
                continue
            self.tag(f"{way} argument")
            free = [p for p in self.places(kind) if p.split(".")[0].split("[")[0] not in taken]
            if not free:
                return self.leaf(item.result) if item.result != "void" else ""
            place = self.choose(free)
            taken.add(place.split(".")[0].split("[")[0])
            arguments.append(place)
        self.tag("call" if len(self.scopes) > 1 else "call of a call")
        if sum(other.name == item.name for other in self.functions) > 1:
            self.tag("overload called")
        self.derives |= item.derives
        if item.discards:
            self.discards = True
            self.leave()
        return f"{item.name}({', '.join(arguments)})"

    def places(self, kind: str) -> list[str]:
        """What an assignment may write to: variables, and parts of them."""
        found: list[str] = []
        for name, item in self.visible().items():
            if not item.writable:
                continue
            if item.kind == kind:
                found.append(name)
            elif kind in WIDTH and WIDTH.get(item.kind, 0) > WIDTH[kind]:
                found.append(
                    f"{name}.{'zxyw'[-WIDTH[item.kind] :][: WIDTH[kind]]}"
                    if item.kind == "vec4"
                    else f"{name}.{'yxz'[: WIDTH[kind]]}"
                )
            elif ELEMENT.get(item.kind) == kind:
                found.append(f"{name}[1]")
            elif item.kind == f"mat{WIDTH.get(kind)}":
                found.append(f"{name}[0]")
            else:
                found += [f"{name}.{f}" for f, held in FIELDS.get(item.kind, ()) if held == kind]
        return found

    def any(self, kind: str, depth: int) -> str:
        """The forms that every type has: ``?:``, the comma, an assignment, a call."""
        forms = ["call", "?:"]
        if kind not in ELEMENT and kind not in FIELDS:
            forms += [",", "="]
        form = self.choose(forms)
        if kind in ELEMENT and not self.dialect.modern:
            form = "call"
        if form == "call":
            return self.call(kind, depth)
        if form == ",":
            self.tag("comma")
            first = self.expr(self.choose(FLOATS), depth)
            return f"({first}, {self.expr(kind, depth)})"
        if form == "=":
            found = self.places(kind)
            if not found:
                return self.leaf(kind)
            self.tag("assignment in an expression")
            return f"({self.choose(found)} = {self.expr(kind, depth)})"
        self.tag("?:")
        condition = self.expr("bool", depth)
        with self.scope(uniform=False, escapes=False):
            return f"({condition} ? {self.expr(kind, depth)} : {self.expr(kind, depth)})"

    # --- integers, booleans, matrices ---

    def int_binary(self, kind: str, depth: int) -> str:
        self.tag("integer")
        a, b = self.expr("int", depth), self.expr("int", depth)
        forms = ["({a} + {b})", "({a} - {b})", "({a} * 3)"]
        if self.dialect.modern:
            forms += ["({a} & {b})", "({a} ^ {b})", "({a} << 1)", "({a} >> 2)", "(abs({a}) % 5)"]
        return self.choose(forms).format(a=a, b=b)

    def int_from_float(self, kind: str, depth: int) -> str:
        return f"int(8.0 * fract({self.expr('float', depth)}))"

    def int_other(self, kind: str, depth: int) -> str:
        counters = [name for name in self.places("int") if name in self.visible()]
        if counters:
            self.tag("++")
            name = self.choose(counters)
            return self.choose((f"{name}++", f"--{name}"))
        return self.leaf(kind)

    def uint_binary(self, kind: str, depth: int) -> str:
        self.tag("unsigned")
        a, b = self.expr("uint", depth), self.expr("uint", depth)
        forms = ("({a} + {b})", "({a} * 2654435761u)", "({a} ^ ({b} >> 3u))", "({a} & 255u)")
        whole = f"uint({self.int_from_float('int', depth)})"
        return self.choose((*forms, whole)).format(a=a, b=b)

    def ivec_binary(self, kind: str, depth: int) -> str:
        self.tag("integer")
        if self.chance(2):
            return f"ivec2(8.0 * fract({self.expr('vec2', depth)}))"
        return f"(ivec2({self.expr('int', depth)}, 2) + {self.expr('ivec2', depth)})"

    def compare(self, kind: str, depth: int) -> str:
        self.tag("comparison")
        held = self.choose(("float", "int"))
        word = self.choose(("<", ">", "<=", ">="))
        return f"({self.expr(held, depth)} {word} {self.expr(held, depth)})"

    def logic(self, kind: str, depth: int) -> str:
        word = self.choose(("&&", "||", "^^", "!"))
        self.tag(word)
        if word == "!":
            return f"(!{self.expr('bool', depth)})"
        a = self.expr("bool", depth)
        with self.scope(uniform=False, escapes=False):
            return f"({a} {word} {self.expr('bool', depth)})"

    def relational(self, kind: str, depth: int) -> str:
        self.tag("boolean vector")
        held = self.choose(("vec2", "vec3"))
        pair = f"{self.expr(held, depth)}, {self.expr(held, depth)}"
        form = self.choose(("any(lessThan({}))", "all(greaterThan({}))", "lessThan({}).y"))
        return form.format(pair)

    def columns(self, kind: str, depth: int) -> str:
        self.tag("matrix")
        width = int(kind[-1])
        parts = (f"sin({self.expr(f'vec{width}', depth)})" for _ in range(width))
        return f"{kind}({', '.join(parts)})"

    def mat_binary(self, kind: str, depth: int) -> str:
        self.tag("matrix")
        a, b = self.expr(kind, depth), self.literal(kind)
        return self.choose((f"({a} * {b})", f"({a} + {b})", f"({a} * 0.5)"))
