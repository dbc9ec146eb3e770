"""The maker of one pass: look up, else compute; then shade."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from shadercache.analysis.call_paths import Use
from shadercache.analysis.derivative_uses import SharedUse
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.ast import nodes as n
from shadercache.emit.assemble import Shader, call_all, variable
from shadercache.emit.builder import PassBuilder
from shadercache.emit.fragment import FragmentEmitter
from shadercache.emit.keep_globals import call_keeping
from shadercache.sema.facts import Symbol
from shadercache.transform.hoist_fetches import FetchForm, type_ahead
from shadercache.transform.reachable import names_in
from shadercache.transform.rename import rename
from shadercache.transform.specialise import Clones, Cut

_QUERIES = 400
"""The version of GLSL that has ``textureQueryLod``."""


def shade_or_reuse(builder: PassBuilder) -> Shader:
    """One pass: look up, else compute; then shade."""
    if builder.whole:
        return builder.finish("passes/here", [builder.shaded("fill")], both=True)
    made = _made(builder, ())
    changed = _left_changed(builder, made)
    return _made(builder, changed) if changed else made


def _made(builder: PassBuilder, kept: tuple[Symbol, ...]) -> Shader:
    """``kept`` are the globals which the payload's code must not be seen to change."""
    names = builder.names()
    clones: list[Clones] = []
    cuts: list[Cut] = []
    for use, name, form in builder.fetches:
        path, fetch = use.instance.path, use.place.expr
        goal = Cut(path, fetch, name, "goal", form=form)
        clones.append(builder.clone(names, f"fetch_{len(clones)}_ahead", (*cuts, goal)))
        cuts.append(replace(goal, kind="use"))
    keep = partial(call_keeping, kept=kept, prefix=builder.program.prefix)
    ahead, entries = builder.own("fetch_ahead"), [group.entry for group in clones]
    extra: list[n.Decl] = [keep(ahead, entries) if entries else call_all(ahead, ())]
    compute = "compute_only" if kept else "compute"
    clones.append(builder.clone(names, compute, (*cuts, *builder.node_cuts("goal"))))
    if _only_main_colors(builder):
        extra.append(variable("vec4", builder.own("color"), _highp(builder)))
        clones = [_with_own_color(builder, group) for group in clones]
    if kept:
        extra.append(keep(builder.own("compute"), [builder.own(compute)]))
    clones.append(builder.shaded("use", names))
    extra += [_fetched(builder, *fetch) for fetch in builder.fetches]
    made = builder.finish("passes/one", clones, extra, both=True)
    return (
        _at_least(made, _QUERIES) if any(form == "level" for *_, form in builder.fetches) else made
    )


def _only_main_colors(builder: PassBuilder) -> bool:
    """Is the colour a matter of ``main`` alone?"""
    functions = (d for d in builder.program.module.decls if isinstance(d, n.FunctionDef))
    return not any(builder.program.color in names_in(d) for d in functions if d.name != "main")


def _with_own_color(builder: PassBuilder, group: Clones) -> Clones:
    """The payload's code with a variable for the colour: it goes, with what only feeds it,
    where the payload does not need it. The output itself would count as needed."""
    names = {builder.program.color: builder.own("color")}
    return replace(group, made=tuple((old, rename(new, names)) for old, new in group.made))


def _left_changed(builder: PassBuilder, made: Shader) -> tuple[Symbol, ...]:
    """The user's globals that the payload's code of a one-pass shader changes."""
    table = EffectTable(made.module, builder.program.memo)
    ahead = ("fetch_ahead", "compute")
    entries = [name for name in map(builder.own, ahead) if name in table.functions]
    written = frozenset[str]().union(*(table.summary(name).writes for name in entries))
    declared = builder.program.facts.declared.values()
    return tuple(s for s in declared if s.kind == "global" and s.name in written)


def unfit(emitter: FragmentEmitter) -> str | None:
    """Why the nodes cannot be cached in one pass, if so."""
    found = _unfit_here(emitter) if emitter.whole else _unfit_ahead(emitter)
    return found or _unfit_as_made(emitter, emitter.made(shade_or_reuse))


def _unfit_as_made(builder: PassBuilder, made: Shader) -> str | None:
    """The same, as the pass that was made shows it."""
    table = EffectTable(made.module, builder.program.memo)
    compute, shared = builder.own("compute"), Does.DERIVATIVE | Does.IMPLICIT_LOD
    if builder.whole or compute not in table.functions:
        return None
    if not table.summary(compute).does & shared:
        return None
    return (
        "the payload's code takes derivatives that it does not need and that cannot be told apart "
        "from it"
    )


def _unfit_here(builder: PassBuilder) -> str | None:
    table = EffectTable(builder.program.module, builder.program.memo)
    shared = Does.DERIVATIVE | Does.IMPLICIT_LOD
    if any(table.of(node.expr).does & shared for node in builder.nodes):
        return (
            "the value takes derivatives under a condition, and in one pass neighbouring "
            "fragments would not compute it together"
        )
    return None


def _unfit_ahead(builder: PassBuilder) -> str | None:
    """Why the payload cannot be computed in a branch before the shader proper, if so."""
    declared = builder.program.facts.declared.values()
    if any(symbol.kind == "global" and not symbol.type.name for symbol in declared):
        return (
            "the shader has a global variable of a struct without a name, which cannot be "
            "kept while the payload is computed"
        )
    for use, *_ in builder.fetches:
        plain = use.instance.use is Use.PLAIN and use.place.use is Use.PLAIN
        moves = use.instance.order_matters or use.place.order_matters
        left = use.instance.after_exit or use.place.step.after_exit
        if not plain or moves or left:
            return (
                "the payload fetches a texture with implicit level of detail at a place "
                "from which the fetch cannot be moved before the branch"
            )
    return None


def _fetched(builder: PassBuilder, use: SharedUse, name: str, form: FetchForm) -> n.VarDecl:
    """The variable that holds what was done ahead, as precise as the fetch."""
    fetch = use.place.expr
    kind = type_ahead(fetch, form, builder.program.facts.types)
    return variable(kind, name, builder.precisions.of(fetch))


def _highp(builder: PassBuilder) -> str | None:
    return "highp" if builder.program.module.profile == "es" else None


def _at_least(shader: Shader, version: int) -> Shader:
    return replace(
        shader, module=replace(shader.module, version=max(shader.module.version, version))
    )
