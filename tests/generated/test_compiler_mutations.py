"""The compiler broken on purpose, a pass at a time: each must be noticed.

By generated shaders (at night), or where those take long for it by a small shader of
``mutations``. What the analyses get wrong is mostly safe, since the programs are made from the text
anew: it shows in the goldens of the cases. The rules that are not safe to break are those of
``rules``. Other breaks are in ``laws/test_mutations.py`` (the text of the look-up) and
``cases/test_loops.py`` (loops that wait for a payload).
"""

from __future__ import annotations

import os
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from laws.slices import NIGHTLY

from shadercache import compiler
from shadercache.analysis import (
    control_dependence,
    derivative_uses,
    effect_table,
    effects,
    slices,
)
from shadercache.ast import nodes as n
from shadercache.caching import program_parts
from shadercache.emit import builder, one_pass, program_set
from shadercache.gpu.context import Gpu
from shadercache.transform import drop_parameters, lower_ternaries, remove_dead, specialise
from shadercache.transform.versions import fixed_function, raise_version
from tests.cases.cases import FOLDER as CASES
from tests.cases.cases import golden_text, sources

from .dialects import DIALECTS
from .rules import RULES, Rule, without_effects
from .suite import Nodes, pick_nodes, quick_shader
from .trial import Chooser, try_shader

pytestmark = pytest.mark.xdist_group("generated")

MUTATIONS = Path(__file__).with_name("mutations")

MOST = 25
"""Shaders that may be tried until one notices."""

Break = Callable[[pytest.MonkeyPatch], None]


def nothing_but_the_position_is_written(patch: pytest.MonkeyPatch) -> None:
    """Of a shader that writes no position everything is refused, which is another rule."""
    written = effect_table._written

    def position(target: n.Expr) -> effects.Effects:
        found = written(target)
        return found if "gl_Position" in found.writes else effects.NO_EFFECTS

    patch.setattr(effect_table, "_written", position)


def read_parameters_are_dropped(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(
        drop_parameters,
        "_unread",
        lambda function, *_: {
            place for place, item in enumerate(function.proto.params) if not item.writes_back
        },
    )


BROKEN: dict[str, tuple[str, Break]] = {
    "one_pass: no global kept": (
        "gl330",
        lambda patch: patch.setattr(one_pass, "_left_changed", lambda *_: ()),
    ),
    "drop_parameters: used ones": ("gl330", read_parameters_are_dropped),
    "unique_names: nothing": (
        "gl330",
        lambda patch: patch.setattr(compiler, "make_names_unique", lambda module, facts: module),
    ),
    "precisions: nothing": (
        "es300",
        lambda patch: patch.setattr(program_set, "with_precisions", lambda module, *_: module),
    ),
    "candidates: order": ("gl330", without_effects),
}


at_night = pytest.mark.skipif(
    not os.environ.get(NIGHTLY), reason="takes minutes: a part of ./dev nightly"
)


def of_laws(problems: list[str]) -> list[str]:
    """Those of the problems that are not the break's own, which no longer fits what it breaks."""
    return [item for item in problems if not item.startswith(("TypeError", "AttributeError"))]


def noticed(gpu: Gpu, dialect: str, most: int = MOST) -> list[str]:
    """The problems of the first shader that has any."""
    for number in range(most):
        shader = quick_shader(dialect, number)
        pick = random.Random(number).randrange
        report = try_shader(gpu, shader.text, shader.dialect, partial(pick_nodes, pick=pick))
        problems = of_laws(report.problems)
        if problems:
            print(f"shader {number}: {problems[0]}")
            return problems
    return []


@at_night
@pytest.mark.parametrize(("dialect", "change"), BROKEN.values(), ids=BROKEN.keys())
def test_a_broken_pass_is_noticed(
    gpu: Gpu, monkeypatch: pytest.MonkeyPatch, dialect: str, change: Break
) -> None:
    change(monkeypatch)
    assert noticed(gpu, dialect), f"{MOST} shaders passed"


def choices_are_swapped(patch: pytest.MonkeyPatch) -> None:
    chosen = lower_ternaries._Lowerer._chosen

    def swapped(self: lower_ternaries._Lowerer, choice: n.Expr, name: str) -> Iterator[n.Stmt]:
        for stmt in chosen(self, choice, name):
            if isinstance(stmt, n.If) and stmt.other is not None:
                yield replace(stmt, then=stmt.other, other=stmt.then)
            else:
                yield stmt

    patch.setattr(lower_ternaries._Lowerer, "_chosen", swapped)


def nothing_is_stored(patch: pytest.MonkeyPatch) -> None:
    own = specialise._CloneBody._own_statements
    patch.setattr(
        specialise._CloneBody,
        "_own_statements",
        lambda self, item: (
            [] if item.cut and item.cut.kind in ("store", "keep") else own(self, item)
        ),
    )


def a_bias_is_dropped(patch: pytest.MonkeyPatch) -> None:
    modern = raise_version.modern_call

    def without(*args: Any) -> n.Expr | None:
        made = modern(*args)
        return replace(made, args=made.args[:2]) if isinstance(made, n.Call) else made

    patch.setattr(raise_version, "modern_call", without)


def the_second_texel_is_empty(patch: pytest.MonkeyPatch) -> None:
    text, packing = program_parts.payload_text, re.compile(r"(\w+) (\w*pack_2\(\)) {.*}")
    forget_parts()
    patch.setattr(
        program_parts,
        "payload_text",
        lambda *about: packing.sub(r"\1 \2 { return \1(0); }", text(*about)),
    )


def forget_parts() -> None:
    """What passes have beside the user's code is to be made anew."""
    program_parts.program_part.cache_clear()
    program_parts._library.cache_clear()


def calls_are_dead(patch: pytest.MonkeyPatch) -> None:
    """In the original of proof mode too: only what the user wrote can tell."""
    matters = remove_dead._Pruner._matters
    patch.setattr(
        remove_dead._Pruner,
        "_matters",
        lambda self, expr, live: not isinstance(expr, n.Call) and matters(self, expr, live),
    )


def fetches_stay(patch: pytest.MonkeyPatch) -> None:
    """And nobody asks whether that is allowed."""
    patch.setattr(derivative_uses.SharedUses, "inside", lambda *_: [])
    patch.setattr(program_set, "unfit", lambda *_: None)


def nothing(*_: object) -> tuple[()]:
    return ()


NOTICED: dict[str, tuple[str, Break]] = {
    "split: nothing": (
        "gl330-declarators",
        lambda patch: patch.setattr(compiler, "split_declarations", lambda module: module),
    ),
    "lower_ternaries: swapped": ("gl330-choice", choices_are_swapped),
    "specialise: nothing stored": ("gl330-choice", nothing_is_stored),
    "remove_dead: calls": ("gl330-written_out", calls_are_dead),
    "make_precise: nothing": (
        "gl330-folded",
        lambda patch: patch.setattr(
            program_set, "make_precise", lambda module, *_: replace(module, version=400)
        ),
    ),
    "make_arguments_opaque: nothing": (
        "gl330-known_part",
        lambda patch: patch.setattr(program_set, "make_arguments_opaque", lambda module, _: module),
    ),
    "write_out_matrices: nothing": (
        "gl330-turned",
        lambda patch: patch.setattr(program_set, "write_out_matrices", lambda module, *_: module),
    ),
    "legacy_calls: no bias": ("gl120-bias", a_bias_is_dropped),
    "fixed_function: nothing declared": (
        "gl120-bias",
        lambda patch: patch.setattr(fixed_function.FixedFunction, "declarations", nothing),
    ),
    "store: the second texel": ("gl330-wide", the_second_texel_is_empty),
    "effects: out arguments": (
        "gl330-written_out",
        lambda patch: patch.setattr(
            effect_table, "out_arguments", lambda call, table: tuple(False for _ in call.args)
        ),
    ),
    "drop_parameters: what is given back": (
        "gl330-inout_global",
        lambda patch: patch.setattr(drop_parameters, "_given_back", lambda *_: set()),
    ),
    "derivative_uses: no hoisted fetch": ("gl330-fetched", fetches_stay),
    "emission: discards too early": (
        "gl330-discarded",
        lambda patch: patch.setattr(
            builder.PassBuilder, "takes_derivatives", lambda self, module: False
        ),
    ),
}
"""The small shader that notices, and how the compiler is broken."""

TOLD: dict[str, tuple[str, Break]] = {
    "slices: arguments": (
        "called_twice",
        lambda patch: patch.setattr(slices.SliceTable, "_entry", lambda *_: slices.NOTHING),
    ),
    "slices: writes": (
        "derivative_of_value",
        lambda patch: patch.setattr(
            slices.SliceTable, "_written", lambda *_: (slices.NOTHING, True)
        ),
    ),
    "control_dependence: nothing flows": (
        "implicit_lod_conditional",
        lambda patch: patch.setattr(
            control_dependence.ControlDependence,
            "_closure",
            lambda *_, **__: control_dependence.Flow(frozenset(), ()),
        ),
    ),
    "derivative_uses: feeds nothing": (
        "derivative_of_value",
        lambda patch: patch.setattr(derivative_uses.Dependents, "fed_by", lambda *_: False),
    ),
    "effects: functions write nothing": (
        "writes_globals",
        nothing_but_the_position_is_written,
    ),
}
"""The case whose golden changes, and how the analysis is broken."""


def some_nodes(legal: Nodes, near: Nodes) -> Nodes:
    """Five of the nodes, from all over the shader."""
    return legal[:: -(-len(legal) // 5)]


def near_first(legal: Nodes, near: Nodes) -> Nodes:
    """Two of those that may come to what fragments share; where there are none, any."""
    return near[:2] or some_nodes(legal, near)


def small_shader(gpu: Gpu, name: str, chooser: Chooser = some_nodes) -> list[str]:
    """The problems of one of the small shaders, with some of its legal nodes."""
    text = (MUTATIONS / f"{name}.frag").read_text(encoding="utf-8")
    dialect = DIALECTS[name.partition("-")[0]]
    return try_shader(gpu, text, dialect, chooser).problems


@pytest.mark.parametrize(("name", "change"), NOTICED.values(), ids=NOTICED.keys())
def test_a_small_shader_notices(
    gpu: Gpu, monkeypatch: pytest.MonkeyPatch, name: str, change: Break
) -> None:
    with monkeypatch.context() as patch:
        change(patch)
        problems = small_shader(gpu, name)
    forget_parts()
    assert of_laws(problems), problems
    print(problems[0].partition("\n")[0])


def test_unbroken_they_have_no_problems(gpu: Gpu) -> None:
    for name in sorted({name for name, _ in NOTICED.values()}):
        assert not small_shader(gpu, name), name
    for rule in RULES:
        assert not small_shader(gpu, rule.shader, near_first), rule.shader


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_a_broken_rule_is_noticed(gpu: Gpu, rule: Rule) -> None:
    with pytest.MonkeyPatch.context() as patch:
        rule.broken(patch)
        problems = small_shader(gpu, rule.shader, near_first)
    assert of_laws(problems), problems
    print(problems[0].partition("\n")[0])


@pytest.mark.parametrize(("name", "change"), TOLD.values(), ids=TOLD.keys())
def test_a_golden_notices(monkeypatch: pytest.MonkeyPatch, name: str, change: Break) -> None:
    expected = (CASES / f"{name}.txt").read_text(encoding="utf-8")
    assert golden_text(name, compiler.analyse(*sources(name))) == expected
    with monkeypatch.context() as patch:
        change(patch)
        assert golden_text(name, compiler.analyse(*sources(name))) != expected
