"""The makers of parked misses: hits are shaded, and what misses need is kept; then a pass over the
screen shades these behind the early depth test.

``find`` leaves an open texel in the cache where it misses. ``mark`` turns these into depths of a
buffer of their own, and ``fix_up`` is drawn at the depth of a group: the early depth test leaves it
nothing but the misses of that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from shadercache.analysis.derivative_uses import SharedUse, evaluation_order
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.payload_text import recalled
from shadercache.caching.read_template import parse_template
from shadercache.emit.ahead import LEVELS_SINCE, caller, left_changed, movable, variable
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.emit.parking import NotParkableError, Parking, parking_of, taking
from shadercache.lang.types import Type, builtin_type
from shadercache.sema.facts import Symbol
from shadercache.transform.hoist_fetches import FetchForm, form_of, type_ahead
from shadercache.transform.specialise import Clones, Cut, CutKind


@dataclass(frozen=True, slots=True)
class _Ahead:
    """A derivative or fetch that is made ahead: the cut, and the type of its variable."""

    cut: Cut
    kind: Type
    precision: str | None


def find(builder: PassBuilder) -> Shader:
    """Shade hits; park what misses need."""
    shader = _finding(builder, ())
    changed = left_changed(builder, shader, ("fetch_ahead",))
    return _finding(builder, changed) if changed else shader


def mark(builder: PassBuilder) -> Shader:
    """Depths of the pixels that wait."""
    return builder.build("mark", [], ["gl_FragDepth"])


def fix_up(builder: PassBuilder) -> Shader:
    """The original for misses, keeping the payload."""
    return taking(builder.made(_missing), _parking(builder))


def unfit(builder: PassBuilder) -> str | None:
    """Why misses cannot be parked, if so."""
    if builder.tells_instances:
        return (
            "instances are told apart (ids=on), and what computes parked misses draws none: a pass "
            "over the screen does not know which one it computes for"
        )
    targets = builder.free_targets
    ahead = _ahead(builder)
    if len(ahead) > 4 * targets:
        return (
            f"misses would have to park the values or levels of detail of {len(ahead)} texture "
            f"fetches, and {targets} targets beside colour and cache hold {4 * targets} numbers"
        )
    missing = builder.made(_missing)
    if builder.takes_derivatives(missing.module) or _looks_at_cubes(missing.module):
        return (
            "the shader takes derivatives, fetches with implicit level of detail or looks at cube "
            "maps at a place from which that cannot be moved ahead, and a pass over the screen has "
            "other neighbours"
        )
    try:
        parking = _parking(builder)
    except NotParkableError as problem:
        return str(problem)
    if len(parking.widths) > targets:
        return (
            f"misses would have to park {parking.lanes} numbers, and {targets} targets beside "
            f"colour and cache hold {4 * targets}"
        )
    return None


def _looks_at_cubes(module: n.Module) -> bool:
    """Is there a cube map in use? A call passes it on or fetches from it."""
    declared = (node for node in walk(module) if isinstance(node, n.VarDecl | n.Param))
    return any("Cube" in decl.type.name for decl in declared)


def _missing(builder: PassBuilder) -> Shader:
    """The program of misses as objects would draw it, with what is made ahead in variables."""
    ahead = _ahead(builder)
    kind: CutKind = "keep" if builder.whole else "store"
    uses = tuple(replace(one.cut, kind="use") for one in ahead)
    clones = builder.clone(builder.names(), "shade", (*uses, *builder.node_cuts(kind)))
    return _raised(
        builder.build("fix_up", [clones], builder.colors_and_stores, _variables(ahead)), ahead
    )


def _parking(builder: PassBuilder) -> Parking:
    facts, prefix = builder.program.facts, builder.program.prefix
    kinds = {one.cut.variable: one.kind for one in _ahead(builder)}
    for name, word in recalled(builder.layout, prefix).items():
        kind = builtin_type(word)
        assert kind is not None
        kinds[name] = kind
    return parking_of(builder.made(_missing), facts, prefix, kinds)


def _finding(builder: PassBuilder, kept: tuple[Symbol, ...]) -> Shader:
    """``kept`` are the globals which what is made ahead must not be seen to change."""
    parking, ahead, names = _parking(builder), _ahead(builder), builder.names()
    clones: list[Clones] = []
    uses: list[Cut] = []
    for one in ahead:
        name = f"fetch_{len(clones)}_ahead"
        clones.append(builder.clone(names, name, (*uses, one.cut)))
        uses.append(replace(one.cut, kind="use"))
    entries = [group.entry for group in clones]
    kind: CutKind = "lack" if builder.whole else "use"
    clones.append(builder.clone(names, "shade", (*uses, *builder.node_cuts(kind))))
    prefix = builder.program.prefix
    extra = (
        *_variables(ahead),
        caller(builder, "fetch_ahead", entries, kept),
        *parse_template(parking.parking_text(), prefix).decls,
    )
    outputs = [*builder.colors_and_stores, *parking.names("park")]
    template = "find_here" if builder.whole else "find"
    return _raised(builder.build(template, clones, outputs, extra), ahead)


def _ahead(builder: PassBuilder) -> list[_Ahead]:
    """What takes its neighbours' values and can be computed ahead, in order of evaluation."""
    types = builder.program.facts.types
    found: list[_Ahead] = []
    for number, (use, is_cube) in enumerate(_with_neighbours(builder)):
        if not movable(use):
            continue
        expr = use.place.expr
        form: FetchForm = "whole" if is_cube else form_of(expr, builder.fetch_form, types)
        name = builder.own(f"fetch_{number}")
        cut = Cut(use.instance.path, expr, name, "goal", form=form)
        found.append(_Ahead(cut, type_ahead(expr, form, types), builder.precisions.of(expr)))
    return found


def _with_neighbours(builder: PassBuilder) -> list[tuple[SharedUse, bool]]:
    """Derivatives, fetches that take one, and look-ups in cube maps (true), in order of evaluation.

    Where other fragments lie in the same vector, some drivers round a look-up in a cube map
    differently.
    """
    candidates = builder.program.candidates
    cubes = {(use.instance, use.place.expr): use for use in candidates.cubes.all}
    uses = {(use.instance, use.place.expr): use for use in candidates.derivatives.all} | cubes
    ordered = sorted(uses.items(), key=lambda one: evaluation_order(one[1]))
    return [(use, key in cubes) for key, use in ordered]


def _variables(ahead: Sequence[_Ahead]) -> list[n.Decl]:
    return [variable(one.kind, one.cut.variable, one.precision) for one in ahead]


def _raised(shader: Shader, ahead: Sequence[_Ahead]) -> Shader:
    """The shader in a version that has what is made ahead."""
    if all(one.cut.form != "level" for one in ahead):
        return shader
    version = max(shader.module.version, LEVELS_SINCE)
    return replace(shader, module=replace(shader.module, version=version))
