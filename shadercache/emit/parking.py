"""What a fragment's misses leave for a later pass over the screen: inputs, as bits in lanes.

The program of misses reads what was interpolated. Drawn over the screen it finds the same bits in
targets of unsigned integers, four lanes of 32 bits each::

    in vec3 v_position;         uniform usampler2D sc_parked_1;
    void main() {        =>     vec3 v_position;
        ...                     void sc_unpark() {
    }                               uvec4 sc_lanes_1 = texelFetch(sc_parked_1, ...);
                                    v_position = uintBitsToFloat(sc_lanes_1.xyz);
                                }
                                void main() { sc_unpark(); ... }

Interpolation has been done by then, so ``flat``, ``centroid`` and the like make no difference. What
only the object's own draw knows is parked as well: ``gl_FragCoord.zw``, ``gl_FrontFacing``, the
number of the object.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.algorithms import PARKED
from shadercache.caching.layout import XYZW
from shadercache.caching.read_template import parse_template
from shadercache.emit.assemble import Shader, interface, merge, without_main
from shadercache.lang.types import Type, builtin_type
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE
from shadercache.transform.reachable import declared_names
from shadercache.transform.rename import rename

LANES = 4
"""Of a target."""

# Three channels need not be a render target (OpenGL 4.6 section 8.5.1).
_FORMATS = {"uint": "r32ui", "uvec2": "rg32ui", "uvec3": "rgba32ui", "uvec4": "rgba32ui"}

_SWIZZLES = ("xyzw", "rgba", "stpq")

# What stands for a built-in input when nothing is drawn but a triangle over the screen.
_BUILTINS = {
    "gl_FragCoord": ("frag_coord", "vec4"),
    "gl_FrontFacing": ("front_facing", "bool"),
    "gl_PointCoord": ("point_coord", "vec2"),
    "gl_PrimitiveID": ("primitive", "int"),
}

# Of the pipeline or of the language, and so the same in every pass.
_EVERYWHERE = ("gl_DepthRange", "gl_Max", "gl_Min")

_OF_INPUTS = ("interpolateAtCentroid", "interpolateAtOffset", "interpolateAtSample")


class NotParkableError(Exception):
    """Why something cannot be parked."""


@dataclass(frozen=True, slots=True)
class Parked:
    """A scalar or vector: its text where it is parked, where it is taken, and its type.

    ``components``: those of a vector that are read; empty for a scalar.
    """

    source: str
    target: str
    base: str
    components: str = ""

    @property
    def lanes(self) -> tuple[str, ...]:
        """The bits of each of its components."""
        scalars = [f"{self.source}.{c}" for c in self.components] or [self.source]
        if self.base == "uint":
            return tuple(scalars)
        bits = "floatBitsToUint" if self.base == "float" else "uint"
        return tuple(f"{bits}({scalar})" for scalar in scalars)

    @property
    def taken(self) -> str:
        """What is assigned."""
        return f"{self.target}.{self.components}" if self.components else self.target

    def of_bits(self, bits: str) -> str:
        """Its value from the bits of its lanes, a scalar or vector."""
        if self.base in ("float", "uint"):
            return f"uintBitsToFloat({bits})" if self.base == "float" else bits
        count = len(self.components)
        return f"{f'{self.base[0]}vec{count}' if count > 1 else self.base}({bits})"


@dataclass(frozen=True, slots=True)
class Parking:
    """Everything that a program of misses reads of its fragment, in the order of its lanes."""

    prefix: str
    parts: tuple[Parked, ...]

    @property
    def lanes(self) -> int:
        """How many there are."""
        return sum(len(part.lanes) for part in self.parts)

    @property
    def widths(self) -> tuple[int, ...]:
        """The lanes of each target."""
        full, rest = divmod(self.lanes, LANES)
        return (LANES,) * full + ((rest,) if rest else ())

    def names(self, name: str) -> list[str]:
        """``sc_name_1``, ``sc_name_2``: one for each target."""
        return [f"{self.prefix}{name}_{number}" for number in range(1, len(self.widths) + 1)]

    def parking_text(self) -> str:
        """Outputs, and ``sc_park`` that writes them."""
        lanes = [lane for part in self.parts for lane in part.lanes]
        targets = list(zip(self.names("park"), self.widths, strict=True))
        lines = [f"out {_unsigned(width)} {name};" for name, width in targets]
        lines.append(f"void {self.prefix}park() {{")
        for at, (name, width) in enumerate(targets):
            own = ", ".join(lanes[LANES * at : LANES * at + width])
            lines.append(f"{name} = {own if width == 1 else f'{_unsigned(width)}({own})'};")
        return "\n".join([*lines, "}"])

    def taking_text(self) -> str:
        """Samplers, and ``sc_unpark`` that takes everything from them."""
        p, samplers = self.prefix, self.names(PARKED)
        lines = [f"uniform usampler2D {name};" for name in samplers]
        lines += [f"void {p}unpark() {{", f"ivec2 {p}place = ivec2(gl_FragCoord.xy);"]
        for name, local in zip(samplers, self.names("lanes"), strict=True):
            lines.append(f"uvec4 {local} = texelFetch({name}, {p}place, 0);")
        if any(part.source == "gl_FragCoord" for part in self.parts):
            # The pixel of the screen is the same.
            lines.append(f"{p}frag_coord.xy = gl_FragCoord.xy;")
        at = 0
        for part in self.parts:
            bits = _lanes(f"{p}lanes", at, len(part.lanes))
            lines.append(f"{part.taken} = {part.of_bits(bits)};")
            at += len(part.lanes)
        return "\n".join([*lines, "}"])


def parking_of(shader: Shader, facts: Facts, prefix: str, ahead: Mapping[str, Type]) -> Parking:
    """What of the fragment a shader reads.

    Args:
        ahead: global variables that another pass has computed, with their types.

    Raises:
        NotParkableError: something in it cannot be parked.
    """
    module = shader.module
    for node in walk(module):
        if isinstance(node, n.Call) and node.name in _OF_INPUTS:
            raise NotParkableError(f"the shader asks for inputs at another place ({node.name})")
    used = _used(module)
    declared = {s.name: s.type for s in facts.declared.values() if s.is_global}
    parts: list[Parked] = []
    for name in _inputs(module):
        vec4 = builtin_type("vec4")
        assert vec4 is not None
        parts += _parts(name, name, declared.get(name, vec4), used.get(name, ""))
    for name, kind in ahead.items():
        if name in used:
            parts += _parts(name, name, kind, used[name])
    if f"{prefix}object" in shader.uniforms and f"{prefix}object" in used:
        parts.append(Parked(f"{prefix}object", f"{prefix}object", "int"))
    parts += _builtins(used, prefix)
    _check_initialisers(module, {*_inputs(module), *ahead})
    return Parking(prefix, tuple(parts))


def parked_formats(module: n.Module, start: str) -> tuple[str, ...]:
    """The formats of the targets that a shader parks in; their outputs' names start so."""
    outputs = (decl for decl in module.decls if isinstance(decl, n.VarDecl))
    return tuple(
        _FORMATS[decl.type.name]
        for decl in outputs
        if decl.qualifiers.has("out") and decl.declarators[0].name.startswith(start)
    )


def taking(shader: Shader, parking: Parking) -> Shader:
    """A shader that has its inputs from where they are parked."""
    module, prefix = shader.module, parking.prefix
    parked = {part.source for part in parking.parts}
    names = {name: prefix + own for name, (own, _) in _BUILTINS.items() if name in parked}
    extra = [f"{_BUILTINS[name][1]} {own};" for name, own in names.items()]
    extra += [f"int {prefix}object;"] if f"{prefix}object" in parked else []
    own = parse_template("\n".join([*extra, parking.taking_text()]), prefix).decls
    user: list[n.Decl] = []
    for decl in without_main(module):
        user += _plain(decl, f"{prefix}object")
    main = next(d for d in module.decls if isinstance(d, n.FunctionDef) and d.name == "main")
    call = n.ExprStmt(NOWHERE, n.Call(NOWHERE, f"{prefix}unpark", ()))
    main = replace(main, body=replace(main.body, body=(call, *main.body.body)))
    renamed = [rename(decl, names) for decl in user] if names else user
    main = rename(main, names) if names else main
    return interface(merge(module, renamed, own, (main,)))


def _plain(decl: n.Decl, parked: str) -> Iterator[n.Decl]:
    """A declaration of an input as one of variables, any other one as it is."""
    if isinstance(decl, n.BlockDecl) and decl.qualifiers.has("in"):
        for field in decl.fields:
            yield replace(field, qualifiers=_only_precision(field.qualifiers))
    elif isinstance(decl, n.VarDecl) and decl.qualifiers.has("in"):
        builtin = any(variable.name.startswith("gl_") for variable in decl.declarators)
        yield decl if builtin else replace(decl, qualifiers=_only_precision(decl.qualifiers))
    elif not isinstance(decl, n.VarDecl) or parked not in declared_names(decl):
        yield decl


def _only_precision(qualifiers: n.Qualifiers) -> n.Qualifiers:
    words = tuple(word for word in qualifiers.words if word in ("highp", "mediump", "lowp"))
    return n.Qualifiers(NOWHERE, words) if words else n.NO_QUALIFIERS


def _inputs(module: n.Module) -> Iterator[str]:
    """The inputs of a fragment shader: of a block without a name of its own its members."""
    for decl in module.decls:
        if isinstance(decl, n.BlockDecl) and decl.qualifiers.has("in"):
            if decl.instance is not None:
                raise NotParkableError(f"the inputs of the block {decl.name} cannot be parked")
            yield from (v.name for field in decl.fields for v in field.declarators)
        elif isinstance(decl, n.VarDecl) and decl.qualifiers.has("in"):
            yield from (v.name for v in decl.declarators if not v.name.startswith("gl_"))


def _used(module: n.Module) -> dict[str, str]:
    """Of each variable that is read its components, ``xyzw`` for all of it."""
    used: dict[str, set[str]] = {}
    known: set[n.Node] = set()
    for node in walk(module):
        if isinstance(node, n.Member) and isinstance(node.object, n.Name):
            swizzle = next((s for s in _SWIZZLES if set(node.name) <= set(s)), "")
            letters = {XYZW[swizzle.index(letter)] for letter in node.name} if swizzle else XYZW
            used.setdefault(node.object.name, set()).update(letters)
            known.add(node.object)
        elif isinstance(node, n.Name) and node not in known:
            used.setdefault(node.name, set()).update(XYZW)
    return {name: "".join(sorted(letters, key=XYZW.index)) for name, letters in used.items()}


def _parts(source: str, target: str, kind: Type, used: str) -> Iterator[Parked]:
    """The scalars and vectors of a variable, as far as they are used."""
    if kind.is_array or kind.is_matrix:
        for at in range((kind.dims[0] or 0) if kind.is_array else kind.cols):
            yield from _parts(f"{source}[{at}]", f"{target}[{at}]", kind.element, XYZW)
    elif kind.struct is not None:
        for name, field in kind.struct.fields.items():
            yield from _parts(f"{source}.{name}", f"{target}.{name}", field, XYZW)
    elif kind.base in ("float", "int", "uint", "bool"):
        if used:
            yield Parked(source, target, kind.base, _components(kind, used))
    else:
        raise NotParkableError(f"an input of the type {kind} cannot be parked")


def _builtins(used: Mapping[str, str], prefix: str) -> Iterator[Parked]:
    for name in used:
        if not name.startswith("gl_") or name.startswith(_EVERYWHERE):
            continue
        if name not in _BUILTINS:
            raise NotParkableError(f"{name} cannot be parked")
        target, word = _BUILTINS[name]
        kind = builtin_type(word)
        assert kind is not None and kind.base is not None
        # The pixel of the screen is the same.
        read = used[name].strip("xy") if name == "gl_FragCoord" else used[name]
        if read:
            yield Parked(name, prefix + target, kind.base, _components(kind, read))


def _components(kind: Type, used: str) -> str:
    """Those of a vector that are used; none of a scalar."""
    return "".join(c for c in XYZW[: kind.rows] if c in used) if kind.rows > 1 else ""


def _check_initialisers(module: n.Module, inputs: set[str]) -> None:
    """What is computed ahead of ``main`` finds nothing there yet."""
    functions = {d.name for d in module.decls if isinstance(d, n.FunctionDef)}
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl):
            continue
        for variable in decl.declarators:
            for node in walk(variable.init) if variable.init is not None else ():
                reads = isinstance(node, n.Name) and node.name in (*inputs, *_BUILTINS)
                if reads or (isinstance(node, n.Call) and node.name in functions):
                    name = variable.name
                    raise NotParkableError(f"the global {name} is initialised ahead of main")


def _unsigned(width: int) -> str:
    return "uint" if width == 1 else f"uvec{width}"


def _lanes(name: str, at: int, count: int) -> str:
    """A number of lanes from one on, as a scalar or vector."""
    runs: list[str] = []
    for target in range(at // LANES, (at + count - 1) // LANES + 1):
        first, last = max(at, LANES * target), min(at + count, LANES * (target + 1))
        letters = XYZW[first - LANES * target : last - LANES * target]
        runs.append(f"{name}_{target + 1}.{letters}")
    return runs[0] if len(runs) == 1 else f"{_unsigned(count)}({', '.join(runs)})"
