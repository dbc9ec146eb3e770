"""How a value gets to where neighbouring fragments share it: by carriers, through calls.

A *story* is a row of statements: a value is computed, carried on (by a local, a global, a member or
an element, written here or by a function, under a condition or in a loop), and comes to a *sink*: a
derivative, a level of detail, a look-up in a cube map or a discard, here or in a function that is
called. Functions for that are *takers*, *givers* (they write a global) and *passers* (they write a
parameter).
"""

from __future__ import annotations

from .expressions import Expressions
from .state import FLOATS, LENGTH, WIDTH, Function

CARRIERS = ("float", "vec3", "vec2", "vec4", "Pair", "float[3]", "mat2", "int")
"""What a number can travel in."""

HELD = ("float", "vec3", "vec2", "Pair", "float[3]")
"""Types of globals that a function takes what it works on from."""

FACTORS = ("1.0", "0.5", "2.0", "(-0.75)")

WRAPS = ("branch", "branch", "plain", "switch", "block", "branch", "loop", "again")
"""What a story may stand in."""

Lines = list[str]


class Carriers(Expressions):
    """Writes stories, and the functions that they call."""

    # --- numbers in other types ---

    def packed(self, kind: str, value: str) -> str:
        """The number ``value`` as a value of the type."""
        if kind == "float":
            return value
        if kind in FLOATS:
            parts = (self.choose(FACTORS) for _ in range(WIDTH[kind]))
            return f"({value} * {kind}({', '.join(parts)}) + {self.leaf(kind)})"
        forms = {
            "int": f"int(8.0 * fract({value}))",
            "bool": f"({value} > 0.25)",
            "mat2": f"mat2({value})",
            "Pair": self.choose(
                (f"Pair({value}, {self.leaf('vec3')})", f"Pair(0.5, vec3({value}, 0.3, 1.7))")
            ),
            "float[3]": f"float[3](0.5, {value}, 1.5)",
        }
        return forms[kind]

    def unpacked(self, kind: str, place: str) -> str:
        """A number out of a place of the type."""
        if kind == "float":
            return place
        if kind in FLOATS:
            return f"{place}.{self.choose('xy')}"
        forms = {
            "int": f"(0.37 * float({place}))",
            "bool": f"float({place})",
            "mat2": f"{place}[0].x",
            "Pair": f"({place}.first + {place}.second.x)",
            "float[3]": f"{place}[1]",
        }
        return forms[kind]

    def held(self, kinds: tuple[str, ...]) -> list[str]:
        """Those of the types that the dialect can assign."""
        return [kind for kind in kinds if kind not in LENGTH or self.dialect.arrays]

    # --- carrying ---

    def carried(self, value: str) -> tuple[Lines, str]:
        """Statements that carry a number on, and where it is behind them."""
        forms = [self.by_local, self.by_place, self.by_place, self.by_branch, self.by_loop]
        forms += [self.by_function] * 3
        return self.choose(forms)(value)

    def by_local(self, value: str) -> tuple[Lines, str]:
        kind, name = self.choose(self.held(CARRIERS)), self.new_name()
        if name is None:
            return [], value
        self.tag("carried by a local")
        lines = [f"{self.variable(kind, name)} = {self.packed(kind, value)};"]
        self.declare(name, kind)
        return lines, self.unpacked(kind, name)

    def place(self, kinds: tuple[str, ...] = CARRIERS) -> tuple[str, str] | None:
        """Something that may be written, with its type; as likely a global as anything else."""
        found = [(place, kind) for kind in self.held(kinds) for place in self.places(kind)]
        outside = [(place, kind) for place, kind in found if self.is_global(place)]
        if outside and self.chance(2):
            found = outside
        return self.choose(found) if found else None

    def by_place(self, value: str) -> tuple[Lines, str]:
        found = self.place()
        if found is None:
            return self.by_local(value)
        place, kind = found
        self.tag_place(place)
        return [f"{place} = {self.packed(kind, value)};"], self.unpacked(kind, place)

    def tag_place(self, place: str) -> None:
        """Note what carries."""
        self.tag("carried by a part" if set(place) & set(".[") else "carried by a variable")
        if self.is_global(place):
            self.tag("carried by a global")

    def by_branch(self, value: str) -> tuple[Lines, str]:
        """Written under a condition, or in one of two branches."""
        found = self.place()
        if found is None:
            return self.by_local(value)
        place, kind = found
        self.tag_place(place)
        self.tag("carried under a condition")
        lines = [f"if ({self.condition()}) {{", f"    {place} = {self.packed(kind, value)};"]
        if self.chance(2):
            lines += ["} else {", f"    {place} = {self.packed(kind, self.leaf('float'))};"]
        return [*lines, "}"], self.unpacked(kind, place)

    def by_loop(self, value: str) -> tuple[Lines, str]:
        found = self.place(("float", "vec3", "vec2"))
        if found is None:
            return self.by_local(value)
        place, kind = found
        self.tag("carried by a loop")
        body = f"    {place} += 0.25 * {self.packed(kind, value)};"
        return ["for (int q = 0; q < 2; q++) {", body, "}"], self.unpacked(kind, place)

    def by_function(self, value: str) -> tuple[Lines, str]:
        """Through a function that writes a global or a parameter."""
        fitting = [f for f in self.functions if f.role in ("giver", "passer") and self.callable(f)]
        if not fitting:
            return self.by_place(value)
        item = self.choose(fitting)
        self.tag("carried by a function")
        if item.role == "giver":
            name, kind = item.carrier
            return [f"{self.call_with(item, value)};"], self.unpacked(kind, name)
        kind = item.params[1][1]
        place = self.choose(self.places(kind))
        return [f"{self.call_with(item, value, place)};"], self.unpacked(kind, place)

    def condition(self) -> str:
        """Of a branch: mostly one that fragments differ in."""
        form = self.choose((self.parting_test, self.uniform_test, lambda: self.expr("bool", 1)))
        return form()

    # --- sinks ---

    def sink(self, value: str) -> tuple[Lines, str]:
        """Statements that bring a number to where fragments share it, and what comes out."""
        takers = [f for f in self.functions if f.role == "taker" and self.callable(f)]
        forms = ["taker"] * (6 if takers else 0) + list(self.sinks())
        if not forms:
            return [], value
        form = self.choose(forms)
        if form == "taker":
            return self.taken(self.choose(takers), value)
        self.tag(f"sink: {form}")
        if form == "discard":
            self.discards = True
            self.leave()
            return [f"if ({value} > {self.choose(('0.6', '0.3', '0.9'))}) discard;"], value
        self.derives = True
        return [], self.sinks()[form].format(x=value, y=self.leaf("float"))

    def sinks(self) -> dict[str, str]:
        """The forms that may be written here."""
        found: dict[str, str] = {}
        sampled, projected = self.dialect.sampled, self.dialect.projected
        if self.flow.uniform:
            if self.dialect.derivatives:
                found |= {"derivative": "fwidth({x})", "dFdx": "(4.0 * dFdx({x}))"}
            found["level"] = f"{sampled}(u_mipmapped, 4.0 * vec2({{x}}, {{y}})).x"
            found["bias"] = f"{sampled}(u_mipmapped, 4.0 * vec2({{y}}, {{x}}), 0.5).y"
            found["projected"] = f"{projected}(u_mipmapped, vec3({{x}}, {{y}}, 0.25)).z"
            if self.dialect.modern:
                found["cube"] = "texture(u_cube, vec3({x}, {y}, 0.7)).x"
                # llvmpipe rounds it by the neighbours' coordinates, also of those that have left.
                found["cube level"] = "textureLod(u_cube, vec3(0.3, {x}, {y}), 0.0).x"
        if self.may_discard and self.flow.escapes:
            found["discard"] = ""
        return found

    def taken(self, item: Function, value: str) -> tuple[Lines, str]:
        """A call of a function that takes the number by a parameter or a global."""
        self.tag("sink: a function")
        lines: Lines = []
        name, kind = item.carrier
        if name:
            lines.append(f"{name} = {self.packed(kind, value)};")
            self.tag("sink: a function by a global")
            value = self.leaf("float")
        call = self.call_with(item, value)
        if item.discards:
            self.discards = True
            self.leave()
        self.derives |= item.derives
        if item.result == "void":
            name, kind = item.left
            return [*lines, f"{call};"], self.unpacked(kind, name) if name else value
        return lines, self.unpacked(item.result, call)

    def call_with(self, item: Function, value: str, place: str | None = None) -> str:
        """A call that gives the number to the first parameter, and ``place`` to the second."""
        arguments: list[str] = []
        for index, (way, kind) in enumerate(item.params):
            if way != "in":
                arguments.append(place or self.choose(self.places(kind)))
            elif index == 0:
                arguments.append(self.packed(kind, value))
            else:
                arguments.append(self.leaf(kind))
        return f"{item.name}({', '.join(arguments)})"

    # --- stories ---

    def story(self, depth: int) -> Lines:
        """A value, its carriers, a sink; as it stands, or in a branch, a block or a loop."""
        self.stories += 1
        out = f"r{self.stories}"
        self.tag("story")
        lines = [f"{self.variable('float', out)} = 0.0;"]
        self.declare(out, "float")
        inside = self.chance(2)
        first, value = ([], "") if inside else self.value()
        wrap = self.choose(
            ("branch", "branch", "plain", "switch", "block", "branch", "loop", "again")
        )
        if wrap == "switch" and not self.dialect.modern:
            wrap = "branch"
        self.tag(f"story: {wrap}")
        if wrap in ("plain", "again"):
            if inside:
                first, value = self.value()
            tell = self.told if wrap == "plain" else self.told_again
            return [*lines, *first, *tell(value, out)]
        return [*lines, *first, *self.wrapped(wrap, value, out)]

    def value(self) -> tuple[Lines, str]:
        """A number that is worth caching, in a variable of its own if there is room."""
        text, name = f"sin({self.expr('float', 2)} + 3.0 * v_position.{self.choose('xyz')})", None
        if self.pick(4):
            name = self.new_name()
        if name is None:
            return [], text
        lines = [f"{self.variable('float', name)} = {text};"]
        self.declare(name, "float")
        return lines, name

    def told(self, value: str, out: str) -> Lines:
        """Carried on, to the sink, and what comes out of that to ``out``."""
        lines: Lines = []
        for _ in range(self.pick(3)):
            more, value = self.carried(value)
            lines += more
        if self.flow.escapes and self.chance(5):
            lines += self.leave_early(0)
        more, text = self.sink(value)
        return [*lines, *more, f"{out} += {text};"]

    def told_again(self, value: str, out: str) -> Lines:
        """A loop in which the sink comes first, and is fed for the next time round."""
        found = self.place(("float", "vec3", "vec2", "Pair"))
        if found is None:
            return self.told(value, out)
        place, kind = found
        self.tag_place(place)
        with self.scope(escapes=False):
            more, text = self.sink(self.unpacked(kind, place))
            body = [*more, f"{out} += {text};", f"{place} = {self.packed(kind, value)};"]
        return ["for (int q = 0; q < 2; q++) {", *indented(body), "}"]

    def wrapped(self, wrap: str, value: str, out: str) -> Lines:
        """A story whose end stands inside of something. Without a value it starts there too."""
        uniform = self.flow.uniform and (wrap != "branch" or self.pick(3) > 0)
        before = self.left
        with self.scope(uniform=uniform, escapes=self.flow.escapes and wrap != "loop"):
            test = self.uniform_test() if uniform else self.condition()
            first: Lines = []
            if not value:
                first, value = self.value()
            body = indented([*first, *self.told(value, out)])
        if self.left > before:
            self.leave()
        match wrap:
            case "loop":
                return ["for (int q = 0; q < 2; q++) {", *body, "}"]
            case "block":
                return ["{", *body, "}"]
            case "switch":
                other = ["    default:", "    {", f"        {out} = 0.5;", "    }", "    break;"]
                body = ["    case 3:", "    {", *indented(body), "    }", "    break;"]
                return ["switch (u_n) {", *body, *other, "}"]
        return [f"if ({test}) {{", *body, "}"]

    def leave_early(self, depth: int) -> Lines:
        """A jump out of where the writer stands."""
        raise NotImplementedError


def indented(lines: Lines) -> Lines:
    """One step to the right."""
    return [f"    {line}" for line in lines]
