"""The maker of one pass: look up, else compute; then shade.

The payload's code runs before the shader proper, which must find every global as it was::

    float g = 1.0;                             void sc_compute() {
    void sc_compute_only() {                       float sc_kept_1 = g;
        g *= 2.0; sc_payload = ...;      =>        sc_compute_only();
    }                                              g = sc_kept_1;
                                               }
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.ast import nodes as n
from shadercache.emit.ahead import LEVELS_SINCE, caller, left_changed, movable, variable
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.lang.types import Type
from shadercache.sema.facts import Symbol
from shadercache.transform.hoist_fetches import type_ahead
from shadercache.transform.reachable import names_in
from shadercache.transform.rename import rename
from shadercache.transform.specialise import Clones, Cut

_SHARED = Does.DERIVATIVE | Does.IMPLICIT_LOD
"""What neighbouring fragments have to do together."""


def shade_or_reuse(builder: PassBuilder) -> Shader:
    """One pass: look up, else compute; then shade."""
    if builder.whole:
        return builder.build("here", [builder.cut("fill")], builder.colors_and_stores)
    shader = _keeping(builder, ())
    # Only the finished pass shows what has to be kept: most of what the payload's code would change
    # has been removed as dead by then.
    changed = left_changed(builder, shader, ("fetch_ahead", "compute"))
    return _keeping(builder, changed) if changed else shader


def _keeping(builder: PassBuilder, kept: tuple[Symbol, ...]) -> Shader:
    """``kept`` are the globals which the payload's code must not be seen to change."""
    names = builder.names()
    clones: list[Clones] = []
    cuts: list[Cut] = []
    for use, name, form in builder.fetches:
        goal = Cut(use.instance.path, use.place.expr, name, "goal", form=form)
        clones.append(builder.clone(names, f"fetch_{len(clones)}_ahead", (*cuts, goal)))
        # A later fetch may need an earlier one: it finds that in the variable.
        cuts.append(replace(goal, kind="use"))
    entries = [group.entry for group in clones]
    extra: list[n.Decl] = [caller(builder, "fetch_ahead", entries, kept if entries else ())]
    compute = "compute_only" if kept else "compute"
    # Its fetches have been made ahead of the branch, where whole quads make them together.
    clones.append(builder.clone(names, compute, (*cuts, *builder.node_cuts("goal"))))
    # An output counts as needed, a variable only where something reads it: so what only feeds the
    # colour goes from the payload's code.
    own = _written_by_main(builder)
    precision = "highp" if builder.program.module.profile == "es" else None
    extra += (variable(kind, name, precision) for kind, name in own.values())
    new_names = {name: new for name, (_, new) in own.items()}
    clones = [_renamed(group, new_names) for group in clones]
    if kept:
        extra.append(caller(builder, "compute", [builder.own(compute)], kept))
    clones.append(builder.clone(names, "shade", builder.node_cuts("use")))
    for use, name, form in builder.fetches:
        fetch = use.place.expr
        kind = type_ahead(fetch, form, builder.program.facts.types)
        extra.append(variable(kind, name, builder.precisions.of(fetch)))
    shader = builder.build("one", clones, builder.colors_and_stores, extra)
    if any(form == "level" for *_, form in builder.fetches):
        version = max(shader.module.version, LEVELS_SINCE)
        return replace(shader, module=replace(shader.module, version=version))
    return shader


def _written_by_main(builder: PassBuilder) -> dict[str, tuple[Type, str]]:
    """The outputs that are a matter of ``main`` alone: name -> type, name of a variable for it."""
    # Only clones can be given outputs of their own, and other functions need not be cloned.
    functions = (d for d in builder.program.module.decls if isinstance(d, n.FunctionDef))
    elsewhere = {name for d in functions if d.name != "main" for name in names_in(d)}
    return {
        output.name: (output.type, builder.own(f"color{output.location or ''}"))
        for output in builder.program.outputs
        if output.name not in elsewhere
    }


def _renamed(group: Clones, names: Mapping[str, str]) -> Clones:
    """The payload's code with variables for outputs."""
    return replace(group, pairs=tuple((old, rename(new, names)) for old, new in group.pairs))


def unfit(builder: PassBuilder) -> str | None:
    """Why the nodes cannot be cached in one pass, if so."""
    if builder.whole:
        return _unfit_here(builder)
    return _unfit_ahead(builder) or _unfit_as_made(builder)


def _unfit_here(builder: PassBuilder) -> str | None:
    table = EffectTable(builder.program.module, builder.program.memo)
    if any(table.of(node.expr).does & _SHARED for node in builder.nodes):
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
    if not all(movable(use) for use, *_ in builder.fetches):
        return (
            "the payload takes a derivative, or fetches a texture with implicit level of detail, "
            "at a place from which that cannot be moved before the branch"
        )
    return None


def _unfit_as_made(builder: PassBuilder) -> str | None:
    """The same, as the pass that was made shows it."""
    table = EffectTable(builder.made(shade_or_reuse).module, builder.program.memo)
    compute = builder.own("compute")
    if compute not in table.functions or not table.summary(compute).does & _SHARED:
        return None
    return (
        "the payload's code takes derivatives that it does not need and that cannot be told apart "
        "from it"
    )
