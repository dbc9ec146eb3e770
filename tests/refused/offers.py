"""A shader that computes whatever of another one may be cached, and nothing else.

What the other one costs beyond it is the *refused cost* (docs/lab/rewriting.md). Values that are
refused because there is no need to cache them count as offered here: constants, what depends on
uniforms only, and what is cheaper than a fetch.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from shadercache.analysis.call_paths import Instance, Use
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.cost import UNKNOWN_TRIPS, CostTable
from shadercache.analysis.precision import PrecisionTable
from shadercache.analysis.refusals import Code
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import children, walk
from shadercache.compiler import Analysis
from shadercache.emit.assemble import Shader, interface, merge, with_locations, without_main
from shadercache.emit.printer import print_module
from shadercache.emit.runtime import runtime_names
from shadercache.emit.vertex import VertexEmitter
from shadercache.front.parse import parse
from shadercache.lang.types import Type
from shadercache.source import NOWHERE, Source
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.names import FreshNames
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.specialise import Cut, insert_clones, specialise
from shadercache.transform.trees import copied
from shadercache.transform.versions.state_precisions import with_precisions

NEEDLESS = frozenset((Code.CONSTANT, Code.UNIFORM, Code.CHEAP))
"""Refusals that say: there is nothing to gain."""

Operation = tuple[Instance, n.Node]


@dataclass(frozen=True)
class Refused:
    """The static cost of a shader, and of the operations in it that are refused, by their codes."""

    total: float
    codes: dict[str, float]

    @property
    def cost(self) -> float:
        """The refused cost."""
        return sum(self.codes.values())


def refused_cost(analysis: Analysis) -> Refused:
    """The refused cost of one shader, in the units of :mod:`analysis.costs.cost`.

    An operation is refused where its own expression is and no value that may be cached needs it: it
    lies in none of their expressions, nor in a statement or an argument that they depend on.
    """
    costs, calls = CostTable(analysis.program.facts), analysis.program.facts.calls
    held, trips = _held(analysis), _trips(analysis)
    live = set(walk(_original(analysis).module))
    total, codes = 0.0, dict[str, float]()
    for node in analysis.nodes:
        if node.instance is None or node.expr not in live:
            continue
        own = costs.of(node.expr) - sum(costs.of(child) for child in children(node.expr))
        callee = calls.get(node.expr) if isinstance(node.expr, n.Call) else None
        if isinstance(callee, n.FunctionDef):
            own -= costs.function(callee)
        own *= trips[node.instance, node.expr]
        total += own
        if node.refusal is None or node.refusal.code in NEEDLESS:
            continue
        if own and (node.instance, node.expr) not in held:
            code = node.refusal.code.code
            codes[code] = codes.get(code, 0.0) + own
    return Refused(total, codes)


def _held(analysis: Analysis) -> set[Operation]:
    """Every operation that a value which may be cached needs."""
    slices = analysis.candidates.slices
    roots: set[Operation] = set()
    atoms = 0
    for node in analysis.nodes:
        if node.instance is not None and node.place is not None and _counts_as_offered(node):
            roots.add((node.instance, node.expr))
            atoms |= slices.value(node.instance, node.place).atoms
    for instance, bits in slices.step_bits.items():
        steps = instance.places.reaching.steps
        needed = (step for step, bit in zip(steps, bits, strict=True) if bit & atoms)
        roots |= {(instance, step.stmt) for step in needed}
    for (instance, name), bit in slices.entry_bits.items():
        if bit & atoms and instance.parent is not None and name in instance.arguments:
            roots.add((instance.parent, instance.arguments[name]))
    return roots | _inside(analysis, roots)


def programs(analysis: Analysis) -> dict[str, dict[str, str]]:
    """Two shaders with both stages: the one whose cost is asked for (its loops unrolled where the
    offers' are), and the one that computes the offers, to be drawn like it."""
    shaders = {"original": _original(analysis), "offers": offers_of(analysis)}
    return {name: _files(analysis, fragment) for name, fragment in shaders.items()}


def _original(analysis: Analysis) -> Shader:
    """The shader as the analyses see it, without what it does not need."""
    program = analysis.program
    locations = {output.name: output.location for output in program.outputs}
    return interface(with_locations(remove_dead(program.module, program.colors), locations))


def _files(analysis: Analysis, fragment: Shader) -> dict[str, str]:
    assert analysis.stage is not None
    prefix = analysis.program.prefix
    raised = analysis.raised[1].module
    memo = analysis.program.memo
    vertex = VertexEmitter(raised, analysis.stage.module, prefix, memo).for_fragment(fragment)
    return {"original.frag": _text(fragment), "original.vert": _text(vertex)}


def offers_of(analysis: Analysis) -> Shader:
    """The fragment shader that computes the offers; its only output is the sum of them all."""
    program = analysis.program
    nodes = widest(analysis)
    names = [f"{program.prefix}offer_{number}" for number in range(len(nodes))]
    cuts = [
        Cut(node.instance.path, node.expr, name, "store")
        for node, name in zip(nodes, names, strict=True)
        if node.instance is not None
    ]
    fresh = FreshNames(runtime_names(program.prefix) | set(names))
    clones = specialise(
        program.module, tuple(cuts), f"{program.prefix}shade", fresh, program.prefix
    )
    value = f"{program.prefix}value"
    user = without_main(insert_clones(program.module, clones))
    module = merge(program.module, user, _glue(analysis, nodes, names, value))
    made = {clone.name for _, clone in clones.pairs}
    while (smaller := drop_parameters(remove_dead(module, [value]), made, Memo())) is not module:
        module = smaller
    return interface(with_locations(module, {value: 0}))


def widest(analysis: Analysis) -> list[Candidate]:
    """The nodes that are offered, or needlessly so, and lie in no other such node."""
    chosen = {
        (node.instance, node.expr): node
        for node in analysis.nodes
        if node.instance is not None and _counts_as_offered(node)
    }
    inside = _inside(analysis, chosen.keys())
    return [node for key, node in chosen.items() if key not in inside]


def _counts_as_offered(node: Candidate) -> bool:
    if node.refusal is None:
        return True
    assert node.place is not None and node.instance is not None
    movable = {node.place.use, node.instance.use} <= {Use.PLAIN, Use.BRANCH}
    # A constant is refused before anything else is asked of it, and it costs next to nothing; so
    # does a name, which may stand for something undefined, which nothing may be added to.
    free = node.refusal.code is Code.CONSTANT or isinstance(node.expr, n.Name)
    return node.refusal.code in NEEDLESS and movable and not free


def _inside(analysis: Analysis, roots: Iterable[Operation]) -> set[Operation]:
    """Every operation that one of the roots holds, or calls."""
    below: set[Operation] = set()
    whole: set[Instance] = set()
    tops: dict[Instance, list[n.Node]] = {}
    for instance, expr in roots:
        tops.setdefault(instance, []).append(expr)
    for instance in analysis.candidates.instances:  # callers first
        call = instance.call
        parent = instance.parent
        if parent is not None and call is not None:
            held = parent in whole or (parent, call) in below
            if held or call in tops.get(parent, ()):
                whole.add(instance)
                below.update((instance, place.expr) for place in instance.places.all)
                continue
        for expr in tops.get(instance, ()):
            below.update((instance, item) for item in walk(expr) if item is not expr)
    return below


def _glue(
    analysis: Analysis, nodes: list[Candidate], names: list[str], value: str
) -> tuple[n.Decl, ...]:
    """Declarations of the variables, and a ``main`` that adds them up."""
    program = analysis.program
    precisions = PrecisionTable(program.module, program.facts)
    structs = sorted({name for node in nodes for name in _structs(node.type)})
    lines = ["#version 330", *(f"struct {name} {{ float unknown; }};" for name in structs)]
    total = f"{program.prefix}total"
    lines += [f"out vec4 {value};", f"{_highp(analysis)} float {total};"]
    for node, name in zip(nodes, names, strict=True):
        plain = node.type.base in ("float", "int", "uint")
        word = (precisions.of(node.expr) or "") if plain else ""
        lines.append(f"{word} {node.type} {name};")
    sums = [
        f"{total} += {scalar};"
        for node, name in zip(nodes, names, strict=True)
        for scalar in _scalars(node.type, name)
    ]
    # A branch that is not taken leaves its offers as they were, and a driver may do with a sum that
    # is undefined in part what it likes.
    zeros = [f"{name} = {_zero(node.type)};" for node, name in zip(nodes, names, strict=True)]
    start = f"{total} = 0.0; {program.prefix}shade();"
    # Four numbers, as most shaders write them: a driver stores four equal ones faster.
    end = f"{value} = {total} * vec4(1.0, 0.5, 0.3, 0.7) + vec4(0.1, 0.2, 0.3, 0.0);"
    lines += ["void main() {", *zeros, start, *sums, end, "}"]
    decls = parse(Source("offers.glsl", "\n".join(lines))).decls[len(structs) :]
    return tuple(copied(decl, span=NOWHERE) for decl in decls)


def _highp(analysis: Analysis) -> str:
    return "highp" if analysis.program.module.profile == "es" else ""


def _scalars(kind: Type, path: str) -> Iterator[str]:
    """Everything inside a value as numbers: vectors by their length in one."""
    if kind.struct is not None and not kind.is_array:
        for name, field in kind.struct.fields.items():
            yield from _scalars(field, f"{path}.{name}")
    elif kind.is_array or kind.is_matrix:
        for number in range((kind.dims[0] or 0) if kind.is_array else kind.cols):
            yield from _scalars(kind.element, f"{path}[{number}]")
    else:
        letters = "xyzw"[: kind.components_or_one] if kind.is_vector else ""
        parts = [f"{path}.{letter}" for letter in letters] or [path]
        yield " + ".join(f"float({part})" for part in parts)


def _zero(kind: Type) -> str:
    if kind.struct is not None and not kind.is_array:
        parts = [_zero(field) for field in kind.struct.fields.values()]
    elif kind.is_array:
        parts = [_zero(kind.element)] * (kind.dims[0] or 0)
    else:
        parts = ["0"]
    return f"{kind}({', '.join(parts)})"


def _structs(kind: Type) -> Iterator[str]:
    if kind.struct is not None:
        yield kind.name
        for field in kind.struct.fields.values():
            yield from _structs(field)


def _text(shader: Shader) -> str:
    return print_module(with_precisions(shader.module, Memo()))


def _trips(analysis: Analysis) -> dict[Operation, float]:
    """How often each operation is taken to be executed."""
    found: dict[Operation, float] = {}
    for instance in analysis.candidates.instances:
        parent, call = instance.parent, instance.call
        base = found[parent, call] if parent is not None and call is not None else 1.0
        stack: list[tuple[n.Node, float]] = [(instance.places.function.body, base)]
        while stack:
            node, trips = stack.pop()
            found[instance, node] = trips
            inner = trips
            if isinstance(node, n.For | n.While | n.DoWhile):
                inner *= UNKNOWN_TRIPS
            stack += [(child, inner) for child in children(node)]
    return found
