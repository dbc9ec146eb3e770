"""Rules of the analyses and of the emission, each broken on purpose.

The suite must notice each within :data:`MOST` shaders: ``./dev stress --rules`` counts how many it
takes, and ``test_compiler_mutations.py`` keeps for each a small shader that notices.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import pytest

from shadercache.analysis import candidates, refusals
from shadercache.analysis.call_paths import Instance
from shadercache.analysis.refusals import Code, Refusal
from shadercache.analysis.slices import NOTHING, Slice, SliceTable
from shadercache.ast.walk import walk
from shadercache.compiler import analyse
from shadercache.emit import one_pass
from shadercache.gpu.context import Gpu
from shadercache.source import Source

from .dialects import Dialect
from .suite import BrokenError, Coverage, check_shaders
from .trial import Chooser, Report, try_shader

MOST = 300

Break = Callable[[pytest.MonkeyPatch], None]


@dataclass(frozen=True)
class Rule:
    """A rule, how to break it, a small shader of ``mutations`` that notices, and whether breaking
    it changes which nodes are legal."""

    name: str
    broken: Break
    shader: str
    judges: bool = True


def _no_flow_into_arguments(patch: pytest.MonkeyPatch) -> None:
    """What is computed in the calling step does not flow into its arguments (o16, o17)."""
    handed_down = SliceTable.handed_down

    def without(self: SliceTable, atoms: int) -> Iterator[tuple[Instance, Any]]:
        given = {
            instance.parent: [
                item
                for (other, _), bit in self.entry_bits.items()
                if other is instance and bit & atoms
                for arg in instance.arguments.values()
                for item in walk(arg)
            ]
            for instance, _ in self.entry_bits
        }
        for instance, parts in handed_down(self, atoms):
            yield instance, [item for item in parts if item in given.get(instance, ())]

    patch.setattr(SliceTable, "handed_down", without)


def _no_flow_through_globals(patch: pytest.MonkeyPatch) -> None:
    """What a caller wrote into a global does not flow to a function that reads it (o18, o19)."""
    entry = SliceTable._entry

    def without(self: SliceTable, instance: Instance, name: str) -> Slice:
        return entry(self, instance, name) if name in instance.arguments else NOTHING

    patch.setattr(SliceTable, "_entry", without)


def _without(*codes: Code) -> Break:
    """Nothing is refused with these codes."""

    def change(patch: pytest.MonkeyPatch) -> None:
        rules = tuple(_lenient(rule, codes) for rule in refusals.RULES)
        patch.setattr(refusals, "RULES", rules)

    return change


def _lenient(strict: refusals.Rule, codes: tuple[Code, ...]) -> refusals.Rule:
    def judged(trial: refusals.Trial) -> Refusal | None:
        found = strict(trial)
        return None if found is not None and found.code in codes else found

    return judged


def without_effects(patch: pytest.MonkeyPatch) -> None:
    """As if order did not matter for what stands in a statement with side effects."""
    rules = tuple(item for item in refusals.RULES if item is not refusals.by_effects)
    patch.setattr(refusals, "RULES", rules)


def _always_valid(patch: pytest.MonkeyPatch) -> None:
    """As if no branch and no return skipped a payload."""
    patch.setattr(candidates.Candidate, "unsure", property(lambda _: False))


def _fetched_from_anywhere(patch: pytest.MonkeyPatch) -> None:
    """One pass fetches ahead what a branch or a return would have skipped."""
    patch.setattr(one_pass, "_unfit_ahead", lambda _: None)


RULES = (
    Rule("values flow into arguments", _no_flow_into_arguments, "gl330-argument"),
    Rule("values flow through globals", _no_flow_through_globals, "gl330-through_global"),
    Rule("SC316: a value decides on a discard", _without(Code.DISCARDS), "gl330-discard_decided"),
    Rule("SC319: a value decides a look-up", _without(Code.FEEDS_CUBE), "gl330-cube_decided"),
    Rule("SC304, SC314: side effects", without_effects, "gl330-ordered"),
    Rule("a branch skips the payload", _always_valid, "gl330-skipped", judges=False),
    Rule("fetches ahead of a branch", _fetched_from_anywhere, "gl330-skipped_fetch", judges=False),
)


def shaders_until(
    gpu: Gpu, rule: Rule, number: int, dialect: str = "gl330", most: int = MOST
) -> tuple[int, str] | None:
    """How many shaders of a seed it takes until one notices, and what it says; ``None``: more.

    A shader whose nodes are judged as ever is passed over: nothing can show in it.
    """
    coverage = Coverage()

    def trial(gpu: Gpu, text: str, dialect: Dialect, chooser: Chooser) -> Report:
        if rule.judges and not _judged_otherwise(rule, text, dialect):
            return Report()
        with pytest.MonkeyPatch.context() as patch:
            rule.broken(patch)
            return try_shader(gpu, text, dialect, chooser)

    try:
        check_shaders(gpu, dialect, most, number, coverage, trial, shrink=False)
    except BrokenError as error:
        return coverage.shaders.total(), str(error)
    return None


def _judged_otherwise(rule: Rule, text: str, dialect: Dialect) -> bool:
    before = _legal(text, dialect)
    with pytest.MonkeyPatch.context() as patch:
        rule.broken(patch)
        return _legal(text, dialect) != before


def _legal(text: str, dialect: Dialect) -> list[str]:
    analysis = analyse(Source("made.frag", text), Source("made.vert", dialect.vertex))
    return [node.id for node in analysis.nodes if node.legal]
