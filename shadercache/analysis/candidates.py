"""Every node of a shader, offered for caching or refused with a reason.

A node is one expression on one call path from ``main`` (DESIGN section 2). The checks stand in
:meth:`_Judge.refusal` in the order in which they are reported.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from hashlib import blake2b

from shadercache.analysis.call_paths import Instance, Place, Use, find_instances, path_to
from shadercache.analysis.cost import FETCH, CostTable
from shadercache.analysis.derivative_uses import (
    Dependents,
    SharedUses,
    cube_lookups,
    derivatives,
    discards,
)
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.analysis.refusals import Code, Refusal
from shadercache.analysis.slices import DERIVATIVE, Slice, SliceTable
from shadercache.ast import nodes as n
from shadercache.ast.walk import expressions
from shadercache.diagnostics import shortened
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE, Source, Span

FIRST_TEXEL, SECOND_TEXEL = 3, 4
"""Channels for the payload in the two texels that a cache can have; the eighth holds the depth."""

STORABLE = frozenset[str | None](("float", "int", "uint", "bool"))
"""Scalar types that a channel of 32 bits can hold."""

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
    on one line, cut off behind :data:`MAX_TEXT` characters.
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


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """The nodes of a shader with the tables they were judged by."""

    nodes: tuple[Candidate, ...]
    instances: tuple[Instance, ...]
    slices: SliceTable
    derivatives: SharedUses
    total_cost: float


def find_candidates(
    module: n.Module,
    facts: Facts,
    source: Source,
    printed: dict[str, str],
    table: EffectTable,
    mapping: MappingKind = "surface",
) -> Candidates:
    """Judge every expression of ``main`` and of every function it reaches.

    ``module`` has unique names; ``printed`` holds the text of each function and initialised
    global as the user's source has it, from which the ids are made. Raises :class:`InputError`
    SC401 on too many call paths.
    """
    instances = find_instances(table, source)
    costs = CostTable(facts)
    slices = SliceTable(module, instances, table, costs)
    takes = SharedUses(instances, slices, derivatives(table))
    cubes = SharedUses(instances, slices, cube_lookups(table, facts))
    drops = discards(instances, slices)
    judge = _Judge(module, facts, source, table, slices, (takes, cubes, drops), costs, mapping)
    digests = _digests(instances, printed)
    found: list[Candidate] = []
    for instance in instances:
        # What has no place in the source was added: the user's own expressions are the nodes.
        own = (place for place in instance.places.all if place.expr.span != NOWHERE)
        found.extend(judge.candidate(instance, place, digests) for place in own)
    found.extend(_initialisers(module, facts, source, printed))
    return Candidates(tuple(found), instances, slices, takes, judge.total)


class _Judge:
    """Decides on one expression of one instance at a time."""

    def __init__(
        self,
        module: n.Module,
        facts: Facts,
        source: Source,
        table: EffectTable,
        slices: SliceTable,
        uses: tuple[SharedUses, SharedUses, Dependents],
        costs: CostTable,
        mapping: MappingKind,
    ) -> None:
        self.facts, self.source, self.table, self.slices = facts, source, table, slices
        (self.derivatives, self.cubes, self.discards), self.costs = uses, costs
        self.texts: dict[n.Expr, str] = {}
        main = table.functions["main"]
        self.total = costs.function(main) or 1.0
        bit = slices.leaf_bit
        written = written_anywhere(module, table)
        self.mutable = sum({bit(name) for name in written})
        self.structs = {d.type.struct for d in module.decls if isinstance(d, n.VarDecl)} - {None}
        self.derivative = bit(DERIVATIVE)
        self.reused = reused_builtins(module, mapping)
        self.varying = sum({bit(name) for name in varyings(module) | self.reused})

    def candidate(
        self, instance: Instance, place: Place, digests: dict[Instance, str]
    ) -> Candidate:
        kind = self.facts.types[place.expr]
        found = self.slices.value(instance, place)
        cost = self.slices.cost(found.atoms) + self.costs.of(place.expr)
        refusal = self.refusal(instance, place, kind, found, cost)
        return Candidate(
            id=_node_id(instance, place, digests),
            instance=instance,
            place=place,
            expr=place.expr,
            text=self._text(place.expr),
            path=path_to(instance, place, self.source),
            type=kind,
            cost=cost,
            ratio=cost / self.total,
            inputs=_inputs(self.slices.leaf_names(found.leaves)),
            refusal=refusal,
        )

    def _text(self, expr: n.Expr) -> str:
        if expr not in self.texts:
            self.texts[expr] = _text(self.source, expr, self.facts)
        return self.texts[expr]

    def refusal(
        self, instance: Instance, place: Place, kind: Type, found: Slice, cost: float
    ) -> Refusal | None:
        return (
            self._by_place(instance, place)
            or self._by_type(place.expr, kind)
            or self._by_effects(instance, place)
            or self._by_inputs(place.expr, found)
            or self._by_use(instance, place)
            or self._by_cost(kind, cost)
        )

    def _by_cost(self, kind: Type, cost: float) -> Refusal | None:
        fetches = 1 if kind.components_or_one <= FIRST_TEXEL else 2
        return Refusal(Code.CHEAP) if cost < fetches * FETCH else None

    def _by_place(self, instance: Instance, place: Place) -> Refusal | None:
        uses = (instance.use, place.use)
        if Use.LOOP in uses:
            return Refusal(Code.LOOP)
        if place.use is Use.LVALUE:
            return Refusal(Code.LVALUE)
        if Use.CONSTANT in uses or self.facts.is_constant(place.expr):
            return Refusal(Code.CONSTANT)
        return Refusal(Code.CONDITIONAL) if Use.CONDITIONAL in uses else None

    def _by_type(self, expr: n.Expr, kind: Type) -> Refusal | None:
        if kind.is_void or kind.holds_opaque:
            return Refusal(Code.OPAQUE, str(kind))
        if kind.components is None or kind.components > FIRST_TEXEL + SECOND_TEXEL:
            return Refusal(Code.WIDE, str(kind))
        spelled = not isinstance(expr, n.InitList)  # Else its type has no name of its own.
        if not (spelled and kind.bases <= STORABLE and self._declared_outside(kind)):
            return Refusal(Code.UNSTORABLE, str(kind))
        return None

    def _declared_outside(self, kind: Type) -> bool:
        """Can a global variable of the type be declared?"""
        if kind.struct is None:
            return True
        if not kind.struct.name:
            return False
        known = self.facts.structs.get(kind.struct) in self.structs
        return known and all(map(self._declared_outside, kind.struct.fields.values()))

    def _by_effects(self, instance: Instance, place: Place) -> Refusal | None:
        effects = self.table.of(place.expr)
        if effects.writes:
            return Refusal(Code.SIDE_EFFECT, "writes " + ", ".join(sorted(effects.writes)))
        if effects.does & Does.DISCARD:
            return Refusal(Code.SIDE_EFFECT, "discards the fragment")
        if instance.order_matters or place.order_matters:
            return Refusal(Code.ORDER)
        return None

    def _by_inputs(self, expr: n.Expr, found: Slice) -> Refusal | None:
        names = self.slices.leaf_names
        if found.leaves & self.mutable:
            return Refusal(
                Code.MUTABLE_GLOBAL, ", ".join(sorted(names(found.leaves & self.mutable)))
            )
        if found.leaves & self.derivative:
            return Refusal(Code.DERIVATIVE)
        bound = {name for name in names(found.leaves) if name.startswith(("gl_", "%"))}
        screen = sorted(name.removeprefix("%") for name in bound - self.reused)
        if screen:
            return Refusal(Code.SCREEN, ", ".join(screen))
        if not found.leaves and not self.table.of(expr).does:
            return Refusal(Code.CONSTANT)
        if not found.leaves & self.varying:
            return Refusal(Code.UNIFORM, ", ".join(sorted(names(found.leaves))))
        return None

    def _by_use(self, instance: Instance, place: Place) -> Refusal | None:
        if self.derivatives.fed_by(instance, place):
            return Refusal(Code.FEEDS_DERIVATIVE)
        if self.cubes.fed_by(instance, place):
            return Refusal(Code.FEEDS_CUBE)
        return Refusal(Code.DISCARDS) if self.discards.fed_by(instance, place) else None


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
    found: set[str] = set()
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("in"):
            found |= {item.name for item in decl.declarators}
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has("in"):
            found |= {decl.instance or ""} | {i.name for f in decl.fields for i in f.declarators}
    return {name for name in found if name and not name.startswith("gl_")}


def _inputs(names: frozenset[str]) -> frozenset[str]:
    """Without the marks of varyings that are among the inputs themselves."""
    return frozenset(name for name in names if not name.startswith("%") or name[1:] not in names)


def _text(source: Source, expr: n.Expr, facts: Facts) -> str:
    start, end = expr.span
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


def _digest(*parts: str) -> str:
    return blake2b("\0".join(parts).encode(), digest_size=4).hexdigest()


def _digests(instances: tuple[Instance, ...], printed: dict[str, str]) -> dict[Instance, str]:
    """A digest of every call path: the functions on it as written, and which calls it takes."""
    found: dict[Instance, str] = {}
    for item in instances:
        own = printed[item.places.function.name]
        if item.places.unrolled:
            own += " unrolled"
        if item.parent is None or item.place is None:
            found[item] = _digest(own)
        else:
            found[item] = _digest(found[item.parent], str(item.place.ordinal), own)
    return found


def _node_id(instance: Instance, place: Place, digests: dict[Instance, str]) -> str:
    name = instance.places.function.name
    mark = "u" if instance.unrolled else ""
    return f"{name}.{place.ordinal}{mark}-{_digest(digests[instance], str(place.ordinal))}"


def _initialisers(
    module: n.Module, facts: Facts, source: Source, printed: dict[str, str]
) -> list[Candidate]:
    """The expressions in initialisers of globals: all refused (law 9: refused means told)."""
    found: list[Candidate] = []
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl):
            continue
        for item in decl.declarators:
            inside = expressions(item.init) if item.init else ()
            own = (expr for expr in inside if expr.span != NOWHERE)
            for number, expr in enumerate(own):
                code = Code.CONSTANT if facts.is_constant(expr) else Code.INITIALISER
                digest = _digest(printed[item.name], str(number))
                found.append(
                    Candidate(
                        id=f"{item.name}.{number}-{digest}",
                        instance=None,
                        place=None,
                        expr=expr,
                        text=_text(source, expr, facts),
                        path=f"(initialiser of {item.name})",
                        type=facts.types[expr],
                        cost=0.0,
                        ratio=0.0,
                        inputs=frozenset(),
                        refusal=Refusal(code),
                    )
                )
    return found
