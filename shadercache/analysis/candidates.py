"""Every node of a shader, offered for caching or refused with a reason.

A node is one expression on one call path from ``main``. Why one is refused
stands in :mod:`analysis.refusals`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from shadercache.analysis.call_paths import Instance, Place, Use, find_instances, path_to
from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.derivative_uses import (
    SharedUses,
    cube_lookups,
    derivatives,
    discards,
)
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.node_ids import NodeIds
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.analysis.refusals import (
    AT_REST,
    Code,
    Evidence,
    Refusal,
    Trial,
    bound_to_screen,
    refusal_of,
)
from shadercache.analysis.slices import DERIVATIVE, SliceTable
from shadercache.ast import nodes as n
from shadercache.ast.large import without_collector
from shadercache.ast.walk import expressions
from shadercache.diagnostics import shortened
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE, Source, Span

OF_PIXEL = frozenset(("gl_FragCoord", "gl_FrontFacing", "gl_PointCoord", "gl_PrimitiveID"))
"""Built-in inputs that are the same again at the same pixel, if nothing changes. (Those of samples
and layers are not among them: a cache has neither.)"""

_LAST_COMMA = re.compile(r"\s*,\s*\)")
"""A list may end in a comma, a constructor may not."""

MAX_TEXT = 2_000
"""Characters of a node's text: each of 10,000 sums in a row holds those before it."""


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A node: an expression, how it is reached, what it costs, whether it may be cached.

    ``cost`` is the static cost P of computing its value alone (its backward slice), in scalar
    operations; ``ratio`` is P/T with T the cost of the whole shader. ``inputs`` are the uniforms,
    varyings and built-in variables that the value depends on; ``text`` the expression as written,
    on one line, cut off behind :data:`MAX_TEXT` characters. ``on_screen``: does it depend on where
    or how large a surface is seen?
    """

    id: str
    instance: Instance | None
    place: Place | None
    expr: n.Expr
    text: str
    path: str
    type: Type
    cost: float
    ratio: float
    inputs: frozenset[str]
    refusal: Refusal | None
    on_screen: bool = False

    @property
    def unsure(self) -> bool:
        """Are there fragments that do without the value, where a branch or a return skips it?"""
        if self.instance is None or self.place is None:
            return False
        branch = Use.BRANCH in (self.instance.use, self.place.use)
        return branch or self.instance.after_exit or self.place.step.after_exit

    @property
    def offered(self) -> bool:
        """May it be cached, and might that pay?"""
        return self.refusal is None

    @property
    def legal(self) -> bool:
        """May it be cached, whether or not it pays?"""
        return self.refusal is None or self.refusal.unprofitable

    @property
    def approximate(self) -> bool:
        """May it be cached only because that was asked for, since reuse is exact at rest alone?"""
        return self.on_screen and self.legal


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """The nodes of a shader with the tables they were judged by."""

    nodes: tuple[Candidate, ...]
    ids: NodeIds
    instances: tuple[Instance, ...]
    slices: SliceTable
    derivatives: SharedUses
    cubes: SharedUses


@dataclass(frozen=True, slots=True)
class Origin:
    """What the user wrote: the file, and the text of each function and initialised global as it
    stands there, from which the ids are made."""

    source: Source
    printed: Mapping[str, str]


class ReuseMode(NamedTuple):
    """How values are found again, and whether those of the screen may be (``approximate``)."""

    mapping: MappingKind = "surface"
    approximate: bool = False


@without_collector()
def find_candidates(
    module: n.Module,
    facts: Facts,
    table: EffectTable,
    origin: Origin,
    reuse: ReuseMode,
) -> Candidates:
    """Judge every expression of ``main`` and of every function it reaches.

    ``module`` has unique names. Raises :class:`InputError` SC401 on too many call paths.
    """
    instances = find_instances(table, origin.source)
    costs = CostTable(facts)
    slices = SliceTable(module, instances, table, costs)
    evidence = _evidence(module, facts, slices, table, reuse)
    total = costs.function(table.functions["main"]) or 1.0
    ids = NodeIds(instances, origin.printed)
    texts: dict[n.Expr, str] = {}
    nodes: list[Candidate] = []
    for instance in instances:
        for place in instance.places.all:
            expr = place.expr
            if expr.span == NOWHERE:
                continue  # It was added: the user's own expressions are the nodes.
            if expr not in texts:
                texts[expr] = _text(origin.source, expr, facts)
            value = slices.value(instance, place)
            cost = slices.atom_costs.of(value.atoms) + costs.of(expr)
            trial = Trial(evidence, instance, place, facts.types[expr], value, cost)
            nodes.append(
                Candidate(
                    id=ids.short(instance, place),
                    instance=instance,
                    place=place,
                    expr=expr,
                    text=texts[expr],
                    path=path_to(instance, place, origin.source),
                    type=trial.type,
                    cost=cost,
                    ratio=cost / total,
                    inputs=_inputs(slices.leaves.names(value.leaves)),
                    refusal=refusal_of(trial),
                    on_screen=bool(bound_to_screen(evidence, value.leaves)),
                )
            )
    nodes.extend(_initialisers(module, facts, origin.source, ids))
    return Candidates(
        _told_apart(nodes, ids), ids, instances, slices, evidence.derivatives, evidence.cubes
    )


def _evidence(
    module: n.Module, facts: Facts, slices: SliceTable, table: EffectTable, reuse: ReuseMode
) -> Evidence:
    instances, bit = slices.instances, slices.leaves.bit
    reused = reused_builtins(module, reuse.mapping)
    # What differs from fragment to fragment and may be reused.
    different = varyings(module) | reused | (AT_REST if reuse.approximate else frozenset())
    structs = (decl.type.struct for decl in module.decls if isinstance(decl, n.VarDecl))
    return Evidence(
        facts=facts,
        table=table,
        slices=slices,
        derivatives=SharedUses(instances, slices, derivatives(table)),
        cubes=SharedUses(instances, slices, cube_lookups(table, facts)),
        discards=discards(instances, slices),
        structs=frozenset(structs) - {None},
        # Each name has a bit of its own, so that a sum over a set is its union.
        mutable=sum({bit(name) for name in written_anywhere(module, table)}),
        derivative=bit(DERIVATIVE),
        varying=sum({bit(name) for name in different}),
        reused=reused,
        approximate=reuse.approximate,
    )


def reused_builtins(module: n.Module, mapping: MappingKind) -> frozenset[str]:
    """The built-in inputs that do not bind a value to the place on the screen in this mapping.

    Where the user says what a pixel shows, and no varying does, its place is how the shader gets
    at what it shows. Beside varyings it is what it always is: the place on the screen.
    """
    if mapping == "screen":
        return OF_PIXEL
    return frozenset(() if mapping == "surface" or varyings(module) else ("gl_FragCoord",))


def varyings(module: n.Module) -> set[str]:
    """Names of the inputs that differ from fragment to fragment, built-in ones apart."""
    names: set[str] = set()
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("in"):
            names |= {variable.name for variable in decl.declarators}
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has("in"):
            names |= {decl.instance or ""} | {i.name for f in decl.fields for i in f.declarators}
    return {name for name in names if name and not name.startswith("gl_")}


def _inputs(names: frozenset[str]) -> frozenset[str]:
    """Without the marks of varyings that are among the inputs themselves."""
    return frozenset(name for name in names if not name.startswith("%") or name[1:] not in names)


def _text(source: Source, expr: n.Expr, facts: Facts) -> str:
    start, end = expr.span
    # Twice what is shown, for white space shrinks; never all of a long chain, at each of its links.
    excerpt = source.excerpt(Span(start, min(end, start + 2 * MAX_TEXT)))
    if excerpt.startswith("{"):
        excerpt = _spelled(excerpt, expr, facts)
    text = " ".join(excerpt.split())
    return shortened(text if end <= start + 2 * MAX_TEXT else f"{text}…", MAX_TEXT)


def _spelled(excerpt: str, root: n.Expr, facts: Facts) -> str:
    """The text of an initialiser list with a constructor's name and brackets for each pair of
    braces: as it is rewritten."""
    pieces = list(excerpt)
    for expr in expressions(root):
        first, last = expr.span.start - root.span.start, expr.span.end - root.span.start - 1
        if isinstance(expr, n.Construct) and pieces[first : first + 1] == ["{"]:
            pieces[first] = f"{facts.types[expr]}("
            if pieces[last : last + 1] == ["}"]:
                pieces[last] = ")"
    return _LAST_COMMA.sub(")", "".join(pieces))


def _told_apart(nodes: list[Candidate], ids: NodeIds) -> tuple[Candidate, ...]:
    """The nodes, with longer ids where two would have the same."""
    counts = Counter(node.id for node in nodes)
    if len(counts) == len(nodes):
        return tuple(nodes)
    apart = tuple(
        replace(node, id=ids.long(node.instance, node.place))
        if counts[node.id] > 1 and node.instance is not None and node.place is not None
        else node
        for node in nodes
    )
    assert len({node.id for node in apart}) == len(apart), "two nodes have one id"
    return apart


def _initialisers(
    module: n.Module, facts: Facts, source: Source, ids: NodeIds
) -> Iterator[Candidate]:
    """The expressions in initialisers of globals: all refused (law 9: refused means told)."""
    variables = (decl for decl in module.decls if isinstance(decl, n.VarDecl))
    for owner in (owner for decl in variables for owner in decl.declarators):
        inside = expressions(owner.init) if owner.init else ()
        for number, expr in enumerate(expr for expr in inside if expr.span != NOWHERE):
            code = Code.CONSTANT if facts.is_constant(expr) else Code.INITIALISER
            yield Candidate(
                id=ids.of_initialiser(owner.name, number),
                instance=None,
                place=None,
                expr=expr,
                text=_text(source, expr, facts),
                path=f"(initialiser of {owner.name})",
                type=facts.types[expr],
                cost=0.0,
                ratio=0.0,
                inputs=frozenset(),
                refusal=Refusal(code),
            )
