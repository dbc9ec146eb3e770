"""The fragment shaders of all passes of the variants of a node, or of a set of nodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.effects import Does, EffectTable
from shadercache.analysis.instances import Use
from shadercache.analysis.loops import decided_loops
from shadercache.analysis.neighbours import SharedUse, evaluation_order
from shadercache.analysis.precision import PrecisionTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.emit.assemble import (
    Shader,
    call_all,
    interface,
    merge,
    variable,
    with_locations,
    without_main,
)
from shadercache.emit.keep_globals import call_keeping
from shadercache.emit.layout import Layout
from shadercache.emit.runtime import Located, load_part, runtime_names
from shadercache.options import CURRENT_CLIP, MappingKind
from shadercache.sema.facts import Facts, Symbol
from shadercache.transform.compound import contract
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.guard_loops import guard_loops
from shadercache.transform.names import FreshNames
from shadercache.transform.reachable import names_in
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.rename import rename
from shadercache.transform.specialise import Clones, Cut, CutKind, insert_clones, specialise

_LATE = ("passes/here_late", "passes/hit_late")
"""Passes that fragments without a payload go through, up to a discard at the end."""


@dataclass(frozen=True, slots=True, eq=False)
class FragmentProgram:
    """The user's fragment shader, checked and with unique names, and how to extend it.

    ``parsed`` is the same as the user wrote it, ``original`` the one before loops were unrolled;
    ``memo`` is what its variants share.
    """

    parsed: n.Module
    module: n.Module
    facts: Facts
    candidates: Candidates
    color: str
    prefix: str
    original: n.Module
    mapping: MappingKind = "surface"
    memo: Memo = field(default_factory=Memo)

    @property
    def unrolled(self) -> bool:
        """Are there loops that were unrolled?"""
        return self.original is not self.module

    @property
    def located(self) -> Located:
        """How the passes find their texels."""
        if self.mapping != "user":
            return Located(self.mapping)
        functions = (d.name for d in self.module.decls if isinstance(d, n.FunctionDef))
        return Located(self.mapping, CURRENT_CLIP in functions)


class FragmentEmitter:
    """Makes the passes of nodes that are cached together. Each method returns a finished shader."""

    def __init__(self, program: FragmentProgram, nodes: Sequence[Candidate]) -> None:
        self.program, self.nodes = program, tuple(nodes)
        precisions = PrecisionTable(program.module, program.facts)
        self.precisions = precisions
        self.layout = Layout(
            tuple(node.type for node in nodes),
            program.module.profile == "es",
            tuple(precisions.of(node.expr) for node in nodes),
        )
        self.payloads = self.layout.variables(program.prefix + "payload")
        stores = ("store", "store_2") if self.layout.second else ("store",)
        self.stores = [program.prefix + name for name in stores]
        discards = EffectTable(program.module, program.memo).summary("main").does & Does.DISCARD
        self.whole = any(node.unsure for node in nodes) or bool(discards)
        """Do fragments do without a payload, so that each pass goes through the shader?"""
        self.fetches = _fetches(program.candidates, self.nodes)

    def one(self) -> Shader:
        """One pass: look up, else compute; then shade."""
        if self.whole:
            return self._finish("passes/here", [self._shade("fill")], both=True)
        return self._made_ahead

    @cached_property
    def _made_ahead(self) -> Shader:
        made = self._one(())
        changed = self._left_changed(made)
        return self._one(changed) if changed else made

    def _one(self, kept: tuple[Symbol, ...]) -> Shader:
        """``kept`` are the globals which the payload's code must not be seen to change."""
        names = self._names()
        fetched = [(use, f"fetch_{i}") for i, use in enumerate(self.fetches)]
        clones: list[Clones] = []
        cuts: list[Cut] = []
        for use, name in fetched:
            clones.append(
                self._clone(names, f"{name}_ahead", (*cuts, _cut(use, self._own(name), "goal")))
            )
            cuts.append(_cut(use, self._own(name), "use"))
        keep = partial(call_keeping, kept=kept, prefix=self.program.prefix)
        ahead, entries = self._own("fetch_ahead"), [group.entry for group in clones]
        extra: list[n.Decl] = [keep(ahead, entries) if entries else call_all(ahead, ())]
        compute = "compute_only" if kept else "compute"
        clones.append(self._clone(names, compute, (*cuts, *self._node_cuts("goal"))))
        if self._only_main_colors():
            extra.append(variable("vec4", self._own("color"), self._highp))
            clones = [self._with_own_color(group) for group in clones]
        if kept:
            extra.append(keep(self._own("compute"), [self._own(compute)]))
        clones.append(self._shade("use", names))
        extra += [self._fetched(use.place.expr, name) for use, name in fetched]
        return self._finish("passes/one", clones, extra, both=True)

    def _only_main_colors(self) -> bool:
        """Is the colour a matter of ``main`` alone?"""
        functions = (d for d in self.program.module.decls if isinstance(d, n.FunctionDef))
        return not any(self.program.color in names_in(d) for d in functions if d.name != "main")

    def _with_own_color(self, group: Clones) -> Clones:
        """The payload's code with a variable for the colour: it goes, with what only feeds it,
        where the payload does not need it. The output itself would count as needed."""
        names = {self.program.color: self._own("color")}
        return replace(group, made=tuple((old, rename(new, names)) for old, new in group.made))

    @property
    def _highp(self) -> str | None:
        return "highp" if self.program.module.profile == "es" else None

    def _left_changed(self, made: Shader) -> tuple[Symbol, ...]:
        """The user's globals that the payload's code of a one-pass shader changes."""
        table = EffectTable(made.module, self.program.memo)
        ahead = ("fetch_ahead", "compute")
        entries = [name for name in map(self._own, ahead) if name in table.functions]
        written = frozenset[str]().union(*(table.summary(name).writes for name in entries))
        declared = self.program.facts.declared.values()
        return tuple(s for s in declared if s.kind == "global" and s.name in written)

    def hit(self) -> Shader:
        """Two passes, first. The discard comes last where the shading takes derivatives, where a
        loop writes into an array, and where the payload decides on a loop: there it is certain that
        fragments without a payload leave the loop, whatever a driver does behind a discard."""
        if self.whole:
            early = self._finish("passes/here", [self._shade("need")], both=True)
        else:
            early = self._finish("passes/hit", [self._shade("use")], both=True)
        if (
            not self._takes_derivatives(early.module)
            and not _loops_over_arrays(early.module)
            and not self._decides_loops
        ):
            return early
        if self.whole:
            return self._finish("passes/here_late", [self._shade("lack")], both=True)
        return self._finish("passes/hit_late", [self._shade("use")], both=True)

    def _takes_derivatives(self, module: n.Module) -> bool:
        does = EffectTable(module, self.program.memo).summary("main").does
        return bool(does & (Does.DERIVATIVE | Does.IMPLICIT_LOD))

    def miss(self) -> Shader:
        """Two passes, second: the original, keeping the payload."""
        kind: CutKind = "keep" if self.whole else "store"
        return self._finish("passes/miss", [self._shade(kind)], both=True)

    def reuse(self) -> Shader:
        """Three passes, first: carry payloads over. What the shader discards is discarded, and
        where it takes derivatives for that, the misses are discarded behind them."""
        early = self._finish("passes/reuse", [self._shade("use")] if self.whole else [])
        if not self._takes_derivatives(early.module):
            return early
        return self._finish("passes/reuse_late", [self._shade("use")])

    def payload_only(self) -> Shader:
        """Three passes, second: compute payloads."""
        if self.whole:
            return self._finish("passes/miss", [self._shade("keep")])
        return self._finish("passes/payload", [self._compute()])

    def shade(self) -> Shader:
        """Three passes, third: the colour from the payload."""
        return self._finish("passes/shade", [self._shade("use")], store=False)

    def payload_alone(self) -> Shader:
        """The payloads in place of the colour, for their cost (P of P/T)."""
        wanted = {self._own("value"): 0}
        clones = [self._shade("keep") if self.whole else self._compute()]
        return self._build("passes/payload_alone", clones, (), wanted)

    def hit_mask(self) -> Shader:
        """What the look-up says, for the eyes and for the hit rate."""
        wanted = {self._own("outcome"): 0}
        clones = [self._shade("keep")] if self.whole else []
        return self._build("passes/hit_mask", clones, (), wanted)

    def unneeded(self) -> tuple[Candidate, ...]:
        """The nodes that the colour does not need where the others are reused."""
        named = names_in(self.shade().module)
        return tuple(
            node
            for node, payload in zip(self.nodes, self.payloads, strict=True)
            if payload not in named
        )

    def unfit(self, passes: int) -> str | None:
        """Why the nodes cannot be cached in so many passes, if so."""
        if passes == 1:
            return self._unfit_here() if self.whole else self._unfit_ahead()
        if passes == 3 and self._decides_loops:
            return (
                "the value decides how long a loop runs, and in the last of three passes fragments "
                "along edges read the payloads of others, with which it might never end"
            )
        return None

    @cached_property
    def _decides_loops(self) -> bool:
        """Does a payload decide how long a loop runs?"""
        user = insert_clones(self.program.module, self._shade("use"))
        return bool(decided_loops(user, self.payloads))

    def _unfit_here(self) -> str | None:
        table = EffectTable(self.program.module, self.program.memo)
        shared = Does.DERIVATIVE | Does.IMPLICIT_LOD
        if any(table.of(node.expr).does & shared for node in self.nodes):
            return (
                "the value takes derivatives under a condition, and in one pass neighbouring "
                "fragments would not compute it together"
            )
        return None

    def _unfit_ahead(self) -> str | None:
        """Why the payload cannot be computed in a branch before the shader proper, if so."""
        declared = self.program.facts.declared.values()
        if any(symbol.kind == "global" and not symbol.type.name for symbol in declared):
            return (
                "the shader has a global variable of a struct without a name, which cannot be "
                "kept while the payload is computed"
            )
        for use in self.fetches:
            plain = use.instance.use is Use.PLAIN and use.place.use is Use.PLAIN
            moves = use.instance.order_matters or use.place.order_matters
            left = use.instance.after_exit or use.place.step.after_exit
            if not plain or moves or left:
                return (
                    "the payload fetches a texture with implicit level of detail at a place "
                    "from which the fetch cannot be moved before the branch"
                )
        table = EffectTable(self._made_ahead.module, self.program.memo)
        compute = self._own("compute")
        if compute in table.functions and table.summary(compute).does & (
            Does.DERIVATIVE | Does.IMPLICIT_LOD
        ):
            return (
                "the payload's code takes derivatives that it does not need and that cannot be "
                "told apart from it"
            )
        return None

    def _fetched(self, expr: n.Expr, name: str) -> n.VarDecl:
        """The variable that holds a texture fetch, as precise as the fetch."""
        kind = str(self.program.facts.types[expr])
        return variable(kind, self._own(name), self.precisions.of(expr))

    def _own(self, name: str) -> str:
        return self.program.prefix + name

    def _names(self) -> FreshNames:
        made = {self._own(f"fetch_{i}") for i in range(len(self.fetches))}
        return FreshNames(runtime_names(self.program.prefix) | made | set(self.payloads))

    def _clone(self, names: FreshNames, entry: str, cuts: tuple[Cut, ...]) -> Clones:
        prefix = self.program.prefix
        return specialise(self.program.module, cuts, prefix + entry, names, prefix)

    def _shade(self, kind: CutKind, names: FreshNames | None = None) -> Clones:
        """The whole shader with the nodes cut out in one way."""
        return self._clone(names or self._names(), "shade", self._node_cuts(kind))

    def _compute(self) -> Clones:
        """The payloads alone."""
        return self._clone(self._names(), "compute", self._node_cuts("goal"))

    def _node_cuts(self, kind: CutKind) -> tuple[Cut, ...]:
        flags = self.layout.variables(self._own("valid"))
        return tuple(
            Cut(node.instance.path, node.expr, payload, kind, flag)
            for node, payload, flag in zip(self.nodes, self.payloads, flags, strict=True)
            if node.instance is not None
        )

    def _finish(
        self,
        template: str,
        clones: list[Clones],
        extra: list[n.Decl] | None = None,
        both: bool = False,
        store: bool = True,
    ) -> Shader:
        """``both``: colour and cache are written; else the cache if ``store``, else the colour."""
        outputs = [self.program.color] if both or not store else []
        outputs += self.stores if store else []
        locations = {name: i for i, name in enumerate(outputs)}
        return self._build(template, clones, extra or (), locations)

    def _build(
        self,
        template: str,
        clones: list[Clones],
        extra: list[n.Decl] | tuple[()],
        locations: dict[str, int],
    ) -> Shader:
        prefix = self.program.prefix
        # ``main`` comes last: GLSL wants functions declared before they are called.
        names = ("lookup", "wide", "store", template)
        options = (self.layout, prefix, self.whole, self.program.located)
        parts = [load_part(name, *options) for name in names]
        user = insert_clones(self.program.module, *clones)
        if template in _LATE and self._decides_loops:
            user = guard_loops(user, decided_loops(user, self.payloads), self._own("lacks"))
        module = merge(self.program.module, without_main(user), extra, *parts)
        made = {clone.name for group in clones for _, clone in group.made}
        memo = self.program.memo
        module = contract(_shrink(module, locations, made, memo), memo)
        return interface(with_locations(module, locations))


def _fetches(candidates: Candidates, nodes: Sequence[Candidate]) -> list[SharedUse]:
    """The derivatives and implicit fetches that the nodes' values need, in order of evaluation."""
    found: dict[SharedUse, None] = {}
    for node in nodes:
        assert node.instance is not None and node.place is not None
        value = candidates.slices.value(node.instance, node.place)
        found |= dict.fromkeys(candidates.derivatives.inside(node.instance, node.place, value))
    return sorted(found, key=evaluation_order)


def _loops_over_arrays(module: n.Module) -> bool:
    """Does a loop use an element of something? Behind a discard llvmpipe writes it wrongly, and
    what is written by a function or in part is not told from what is read."""
    loops = (item for item in walk(module) if isinstance(item, n.For | n.While | n.DoWhile))
    return any(isinstance(item, n.Index) for loop in loops for item in walk(loop))


def exact_original(program: FragmentProgram) -> Shader:
    """The user's shader with unique names and without what it does not need, for proof mode."""
    needed = remove_dead(program.original, (program.color,), program.memo)
    module = contract(needed, program.memo)
    return interface(with_locations(module, {program.color: 0}))


def _cut(use: SharedUse, name: str, kind: CutKind) -> Cut:
    return Cut(use.instance.path, use.place.expr, name, kind)


def _shrink(module: n.Module, wanted: dict[str, int], clones: set[str], memo: Memo) -> n.Module:
    """Remove what is dead; a parameter that nobody reads keeps its argument alive, and a result
    that nobody uses what it is made of: so in turns."""
    while True:
        module = remove_dead(module, wanted, memo)
        smaller = drop_parameters(drop_results(module, clones, memo), clones, memo)
        if smaller is module:
            return module
        module = smaller
