"""The fragment shaders of all passes of a node's variants."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.effects import Does, EffectTable
from shadercache.analysis.instances import Use
from shadercache.analysis.neighbours import SharedUse
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
from shadercache.emit.runtime import load_part, runtime_names
from shadercache.sema.facts import Facts, Symbol
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.names import FreshNames
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.specialise import Clones, Cut, CutKind, insert_clones, specialise


@dataclass(frozen=True, slots=True, eq=False)
class FragmentProgram:
    """The user's fragment shader, checked and with unique names, and how to extend it.

    ``parsed`` is the same as the user wrote it; ``memo`` is what its variants share.
    """

    parsed: n.Module
    module: n.Module
    facts: Facts
    candidates: Candidates
    color: str
    prefix: str
    memo: Memo = field(default_factory=Memo)


class FragmentEmitter:
    """Makes the passes of one node. Each method returns a finished shader."""

    def __init__(self, program: FragmentProgram, node: Candidate) -> None:
        assert node.instance is not None and node.place is not None
        self.program, self.node = program, node
        self.layout = Layout(node.type, program.module.profile == "es")
        self.precisions = PrecisionTable(program.module, program.facts)
        self.payload = program.prefix + "payload"
        stores = ("store", "store_2") if self.layout.second else ("store",)
        self.stores = [program.prefix + name for name in stores]
        discards = EffectTable(program.module, program.memo).summary("main").does & Does.DISCARD
        self.whole = node.unsure or bool(discards)
        """Do fragments do without the payload, so that each pass goes through the shader?"""
        found = program.candidates.slices.value(node.instance, node.place)
        self._clones: dict[str, Clones] = {}
        self.fetches = program.candidates.derivatives.inside(node.instance, node.place, found)

    def one(self) -> Shader:
        """One pass: look up, else compute; then shade."""
        if self.whole:
            return self._finish("passes/here", [self._shade("fill")], both=True)
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
        clones.append(self._clone(names, compute, (*cuts, self._node_cut("goal"))))
        if kept:
            extra.append(keep(self._own("compute"), [self._own(compute)]))
        clones.append(self._shade("use", names))
        extra += [self._fetched(use.place.expr, name) for use, name in fetched]
        return self._finish("passes/one", clones, extra, both=True)

    def _left_changed(self, made: Shader) -> tuple[Symbol, ...]:
        """The user's globals that the payload's code of a one-pass shader changes."""
        table = EffectTable(made.module, self.program.memo)
        ahead = ("fetch_ahead", "compute")
        entries = [name for name in map(self._own, ahead) if name in table.functions]
        written = frozenset[str]().union(*(table.summary(name).writes for name in entries))
        declared = self.program.facts.declared.values()
        return tuple(s for s in declared if s.kind == "global" and s.name in written)

    def hit(self) -> Shader:
        """Two passes, first. The discard comes last where the shading takes derivatives, and where
        a loop writes into an array."""
        if self.whole:
            early = self._finish("passes/here", [self._shade("need")], both=True)
        else:
            early = self._finish("passes/hit", [self._shade("use")], both=True)
        does = EffectTable(early.module, self.program.memo).summary("main").does
        if not does & (Does.DERIVATIVE | Does.IMPLICIT_LOD) and not _loops_over_arrays(
            early.module
        ):
            return early
        if self.whole:
            return self._finish("passes/here_late", [self._shade("lack")], both=True)
        return self._finish("passes/hit_late", [self._shade("use")], both=True)

    def miss(self) -> Shader:
        """Two passes, second: the original, keeping the payload."""
        kind: CutKind = "keep" if self.whole else "store"
        return self._finish("passes/miss", [self._shade(kind)], both=True)

    def reuse(self) -> Shader:
        """Three passes, first: carry payloads over."""
        return self._finish("passes/reuse", [self._shade("use")] if self.whole else [])

    def payload_only(self) -> Shader:
        """Three passes, second: compute payloads."""
        if self.whole:
            return self._finish("passes/miss", [self._shade("keep")])
        return self._finish("passes/payload", [self._compute()])

    def shade(self) -> Shader:
        """Three passes, third: the colour from the payload."""
        return self._finish("passes/shade", [self._shade("use")], store=False)

    def payload_alone(self) -> Shader:
        """The payload in place of the colour, for the cost of the payload (P of P/T)."""
        wanted = {self._own("value"): 0}
        clones = [self._shade("keep") if self.whole else self._compute()]
        return self._build("passes/payload_alone", clones, (), wanted)

    def hit_mask(self) -> Shader:
        """What the look-up says, for the eyes and for the hit rate."""
        wanted = {self._own("outcome"): 0}
        clones = [self._shade("keep")] if self.whole else []
        return self._build("passes/hit_mask", clones, (), wanted)

    def unfit_for_one_pass(self) -> str | None:
        """Why the node cannot be cached in one pass, if so."""
        return self._unfit_here() if self.whole else self._unfit_ahead()

    def _unfit_here(self) -> str | None:
        table = EffectTable(self.program.module, self.program.memo)
        if table.of(self.node.expr).does & (Does.DERIVATIVE | Does.IMPLICIT_LOD):
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
        return None

    def _fetched(self, expr: n.Expr, name: str) -> n.VarDecl:
        """The variable that holds a texture fetch, as precise as the fetch."""
        kind = str(self.program.facts.types[expr])
        return variable(kind, self._own(name), self.precisions.of(expr))

    def _own(self, name: str) -> str:
        return self.program.prefix + name

    def _names(self) -> FreshNames:
        return FreshNames(runtime_names(self.program.prefix))

    def _clone(self, names: FreshNames, entry: str, cuts: tuple[Cut, ...]) -> Clones:
        prefix = self.program.prefix
        return specialise(self.program.module, cuts, prefix + entry, names, prefix)

    def _shade(self, kind: CutKind, names: FreshNames | None = None) -> Clones:
        """The whole shader with the node cut out in one way."""
        if names is not None:
            return self._clone(names, "shade", (self._node_cut(kind),))
        return self._alone("shade", kind)

    def _compute(self) -> Clones:
        """The payload alone."""
        return self._alone("compute", "goal")

    def _alone(self, entry: str, kind: CutKind) -> Clones:
        """The only clones of a pass. Other passes have the same, and then share what is found out
        about them."""
        if kind not in self._clones:
            self._clones[kind] = self._clone(self._names(), entry, (self._node_cut(kind),))
        return self._clones[kind]

    def _node_cut(self, kind: CutKind) -> Cut:
        assert self.node.instance is not None
        return Cut(self.node.instance.path, self.node.expr, self.payload, kind)

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
        options = (self.layout, prefix, self.precisions.of(self.node.expr), self.whole)
        parts = [load_part(name, *options) for name in names]
        user = insert_clones(self.program.module, *clones)
        module = merge(self.program.module, without_main(user), extra, *parts)
        made = {clone.name for group in clones for _, clone in group.made}
        module = _shrink(module, locations, made, self.program.memo)
        return interface(with_locations(module, locations))


def _loops_over_arrays(module: n.Module) -> bool:
    """Does a loop use an element of something? Behind a discard llvmpipe writes it wrongly, and
    what is written by a function or in part is not told from what is read."""
    loops = (item for item in walk(module) if isinstance(item, n.For | n.While | n.DoWhile))
    return any(isinstance(item, n.Index) for loop in loops for item in walk(loop))


def exact_original(program: FragmentProgram) -> Shader:
    """The user's shader with unique names and without what it does not need, for proof mode."""
    module = remove_dead(program.module, (program.color,), program.memo)
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
