"""The compiler broken on purpose, a pass at a time: generated shaders must notice each."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

from shadercache import compiler
from shadercache.analysis import candidates
from shadercache.emit import fragment, program_set
from shadercache.harness.context import Gpu
from shadercache.transform import drop_parameters

from .suite import pick_nodes, quick_shader
from .trial import try_shader

pytestmark = pytest.mark.xdist_group("generated")

MOST = 25
"""Shaders that may be tried until one notices."""

Break = Callable[[pytest.MonkeyPatch], None]


def the_payload_is_stored_late(patch: pytest.MonkeyPatch) -> None:
    """As if order did not matter for what stands in a statement with side effects."""
    patch.setattr(candidates._Judge, "_by_effects", lambda self, instance, place: None)


def read_parameters_are_dropped(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(
        drop_parameters,
        "_unread",
        lambda function: {
            place for place, item in enumerate(function.proto.params) if not item.writes_back
        },
    )


BROKEN: dict[str, tuple[str, Break]] = {
    "keep_globals: nothing kept": (
        "gl330",
        lambda patch: patch.setattr(
            fragment.FragmentEmitter, "_left_changed", lambda self, made: ()
        ),
    ),
    "drop_parameters: used ones": ("gl330", read_parameters_are_dropped),
    "unique_names: nothing": (
        "gl330",
        lambda patch: patch.setattr(compiler, "make_names_unique", lambda module, facts: module),
    ),
    "precisions: nothing": (
        "es300",
        lambda patch: patch.setattr(program_set, "with_precisions", lambda module: module),
    ),
    "candidates: order": ("gl330", the_payload_is_stored_late),
}


def noticed(gpu: Gpu, dialect: str, most: int = MOST) -> list[str]:
    """The problems of the first shader that has any."""
    for number in range(most):
        shader = quick_shader(dialect, number)
        pick = random.Random(number).randrange
        report = try_shader(
            gpu, shader.text, shader.dialect, lambda legal, pick=pick: pick_nodes(legal, pick)
        )
        if report.problems:
            print(f"shader {number}: {report.problems[0]}")
            return report.problems
    return []


@pytest.mark.parametrize(("dialect", "change"), BROKEN.values(), ids=BROKEN.keys())
def test_a_broken_pass_is_noticed(
    gpu: Gpu, monkeypatch: pytest.MonkeyPatch, dialect: str, change: Break
) -> None:
    change(monkeypatch)
    assert noticed(gpu, dialect), f"{MOST} shaders passed"
