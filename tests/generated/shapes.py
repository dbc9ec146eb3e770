"""Functions with a purpose: those that take a value to where it is shared, and those that carry."""

from __future__ import annotations

from dataclasses import replace

from .carriers import CARRIERS, HELD, Carriers, Lines, indented
from .state import NAMES, Flow, Function

Place = tuple[str, str]
Params = tuple[tuple[str, str], ...]


class Shapes(Carriers):
    """Writes takers, givers and passers."""

    def begin_function(self, result: str, calls: int) -> None:
        """Forget what was said of the function before."""
        self.scopes.append({})
        self.flow, self.result, self.calls_left = Flow(), result, calls
        self.derives = self.discards = False

    def finished(self, name: str, result: str, params: Params, body: Lines) -> Lines:
        """The text of a function, which is known from here on."""
        names = list(self.scopes.pop())
        texts = [
            f"{way + ' ' if way != 'in' else ''}{self.variable(kind, given)}"
            for (way, kind), given in zip(params, names, strict=False)
        ]
        self.functions.append(Function(name, result, params, self.derives, self.discards))
        head = f"{self.typed(result)} {name}({', '.join(texts)})"
        return [f"{head} {{", *indented(body), "}"]

    def shape(self, role: str, carrier: Place, left: Place = ("", "")) -> None:
        """Note what the last function is for."""
        self.tag(role)
        self.functions[-1] = replace(self.functions[-1], role=role, carrier=carrier, left=left)

    def outside(self, kinds: tuple[str, ...]) -> Place:
        """A global that may be written, and that no local hides; with its type, or nothing."""
        found = [
            (name, item.kind)
            for name, item in self.scopes[0].items()
            if item.writable and item.kind in kinds and name not in NAMES
        ]
        return self.choose(found) if found else ("", "")

    def taker(self, number: int) -> Lines:
        """A function that brings a parameter, or a global that it reads, to a sink."""
        left = self.outside(CARRIERS)
        result = self.choose(("float", "vec3", "void" if left[0] else "float"))
        name, kind = self.outside(HELD)
        if not name or self.chance(2):
            name, kind = "", self.choose((*self.held(CARRIERS), "bool"))
        self.begin_function(result, calls=1)
        params: Params = ()
        if not name:
            params = (("in", kind), *([("in", "float")] if self.chance(3) else []))
            for (_, held), given in zip(params, ("x", "y"), strict=False):
                self.declare(given, held)
        out = f"r{self.stories}_"
        body = [f"{self.variable('float', out)} = 0.0;"]
        body += self.inner(self.unpacked(kind, name or "x"), out)
        if result == "void":
            body.append(f"{left[0]} = {self.packed(left[1], out)};")
        else:
            body.append(f"return {self.packed(result, out)};")
        lines = self.finished(f"f{number}", result, params, body)
        self.shape("taker", (name, kind if name else ""), left if result == "void" else ("", ""))
        return lines

    def inner(self, value: str, out: str) -> Lines:
        """What a taker does with its value: at once, or in a branch, a block or a loop."""
        wrap = self.choose(("plain", "plain", "branch", "block", "loop"))
        return self.told(value, out) if wrap == "plain" else self.wrapped(wrap, value, out)

    def giver(self, number: int) -> Lines:
        """A function that writes a global; without one, a taker."""
        carrier = name, kind = self.outside(self.held_kinds())
        if not name:
            return self.taker(number)
        params: Params = (("in", self.choose(("float", "vec3", "Pair"))),)
        self.begin_function("void", calls=1)
        self.declare("x", params[0][1])
        body = self.written(name, kind, self.unpacked(params[0][1], "x"))
        lines = self.finished(f"f{number}", "void", params, body)
        self.shape("giver", carrier)
        return lines

    def held_kinds(self) -> tuple[str, ...]:
        """The types of a carrier that the dialect can assign."""
        return tuple(self.held(CARRIERS))

    def written(self, place: str, kind: str, value: str) -> Lines:
        """A place is written, mostly without a condition."""
        lines: Lines = []
        if self.chance(3):
            lines, value = self.carried(value)
        if self.chance(4):
            lines += self.leave_early(0)
        last = f"{place} = {self.packed(kind, value)};"
        if self.chance(3):
            return [*lines, f"if ({self.condition()}) {{", f"    {last}", "}"]
        return [*lines, last]

    def passer(self, number: int) -> Lines:
        """A function that writes a parameter from another."""
        way, kind = self.choose(("out", "inout")), self.choose(("float", "vec3", "vec2", "vec4"))
        params: Params = (("in", self.choose(("float", "vec2", "Pair"))), (way, kind))
        result = self.choose(("void", "float"))
        self.begin_function(result, calls=1)
        self.declare("x", params[0][1])
        self.declare("y", kind)
        self.tag(f"{way} parameter")
        body = [f"y = {self.literal(kind)};"] if way == "out" else []
        body += self.written("y", kind, self.unpacked(params[0][1], "x"))
        if result == "float":
            body.append(f"return {self.expr('float', 1)};")
        lines = self.finished(f"f{number}", result, params, body)
        self.shape("passer", ("", ""))
        return lines
