"""Choose what to cache in a scene, and prove the choice by running it."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass, field
from math import prod

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import input_error, usage_error
from shadercache.linking.cache_settings import configured
from shadercache.linking.linker import Linker
from shadercache.render.render_scene import RenderScene
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import COMPILING, Budget
from shadercache.tuning.groups import ShaderGroup, groups_of
from shadercache.tuning.laboratory import Laboratory
from shadercache.tuning.proof import Proof, Proven
from shadercache.tuning.search import LEAST_FRAMES, Finalist, Search
from shadercache.tuning.space import Space
from shadercache.tuning.trials import AGES, FRAMES, Tell, Trials, TrialSetting
from shadercache.tuning.values import Pool, changing_inputs, pool_of

SMALL = 0.35
"""A small picture is looked at where it takes less than this share of the time: full size tells
times as well."""


COMFORT = 4.0
"""A budget is comfortable that allows for so many values and proofs."""

SMALLEST = 128
"""Pixels, along the shorter edge, below which no size is made smaller."""


@dataclass(frozen=True, slots=True)
class TuneQuestion:
    """What is asked: bounds of one metric, the time that tuning may take (seconds), and the choices
    that it has. ``base``: what all configurations have in common. Unless the ``size_is_fixed``, a
    scene that is slow to draw is tuned at a smaller one."""

    bounds: tuple[Bound, ...]
    seconds: float = 75.0
    size_is_fixed: bool = False
    space: Space = field(default_factory=Space)
    base: Configuration = field(default_factory=Configuration)

    def __post_init__(self) -> None:
        """Raises :class:`UsageError` SC008 without bounds, or with those of two metrics."""
        if len({bound.metric for bound in self.bounds}) != 1:
            raise usage_error("SC008", "all bounds must be of one metric")


@dataclass(frozen=True)
class Answer:
    """The choice for a bound, proven; None: leave the shader alone, and ``why``."""

    bound: Bound
    chosen: Proven | None
    why: str


@dataclass(frozen=True)
class Drawings:
    """What was drawn: at which size, in how many seconds (``spent``); ``original``: seconds of a
    frame of it."""

    size: tuple[int, int]
    original: float
    spent: float
    trials: Trials
    finalists: tuple[Finalist, ...]


@dataclass(frozen=True)
class Tuning:
    """All that was found. ``combinations`` there are, of which ``drawn`` were drawn."""

    question: TuneQuestion
    pools: dict[ShaderGroup, Pool]
    drawings: Drawings
    proven: tuple[Proven, ...]
    answers: tuple[Answer, ...]

    @property
    def drawn(self) -> int:
        """How many configurations were drawn."""
        return len(self.drawings.trials.drawn)

    @property
    def combinations(self) -> int:
        """How many there are: of every offered value, alone, with every choice; of several shaders
        with each other."""
        space = self.question.space
        kinds = len(space.algorithms) + len(space.rates) - 1
        slots = (space.periods, space.filters, space.blocks, space.formats)
        each = kinds * prod(map(len, slots)) * (1 + len(space.adaptive))
        counts = (len(group.analysis.savings.ranked()) for group in self.pools)
        return prod(1 + count * each for count in counts) - 1


def tune(
    world: RenderScene, linker: Linker, question: TuneQuestion, budget: Budget, tell: Tell
) -> Tuning:
    """The fastest configurations of a scene within bounds of its error.

    Args:
        world: the scene at the size it is tuned for.
        budget: it may have begun before, when the shaders were read.

    Raises:
        InputError: SC048 where nothing moves; as ``Linker.link``.
        UsageError: SC047 where the budget is too short for one trial.
    """
    scene = linker.scene
    groups = groups_of(linker)
    if not any(changing_inputs(group, scene) for group in groups):
        message = f"nothing moves in the scene {scene.name}, so no error can be measured"
        hint = "give it a [motion] or a camera path, or recorded frames with --frames"
        raise input_error("SC048", message, hint=hint)
    pools = {group: pool_of(group, scene) for group in groups}
    with ExitStack() as held:
        laboratory = _laboratory(world, linker, question, budget, held)
        original = laboratory.originals(small=False)
        small = laboratory.originals(small=True) < SMALL * original
        base = configured(scene, question.base, None)
        setting = TrialSetting(scene, question.space, base, question.bounds[0].metric, small)
        trials = Trials(laboratory, setting, budget, tell)
        search = Search(trials, pools, question.bounds)
        proof = Proof(search)
        chosen: dict[Bound, Proven | None] = dict.fromkeys(question.bounds)
        if any(pool.values for pool in pools.values()):
            _require(budget, original)
            search.run()
            chosen = proof.run()
        size = laboratory.size
    answers = tuple(
        Answer(bound, one, "" if one else _why(search, proof, bound))
        for bound, one in chosen.items()
    )
    drawn = Drawings(size, original, budget.spent, trials, tuple(search.finalists))
    return Tuning(question, pools, drawn, tuple(proof.proven), answers)


def _laboratory(
    world: RenderScene, linker: Linker, question: TuneQuestion, budget: Budget, held: ExitStack
) -> Laboratory:
    """One at the size of the world, or at a smaller one if that may be and time is short."""
    while True:
        laboratory = Laboratory(world, linker)
        width, height = world.size
        needed = COMFORT * _needed(laboratory.originals(small=False))
        if question.size_is_fixed or needed < budget.left() or min(width, height) <= SMALLEST:
            return held.enter_context(laboratory)
        laboratory.release()
        world = world.drawn_apart((width // 2, height // 2), world.scene.view.engine)
        held.enter_context(world)


def _needed(original: float) -> float:
    """Seconds that one value and its proof take."""
    draws = 2 * (AGES[-1] + 1 + FRAMES) + 2 * 2 * LEAST_FRAMES
    return draws * original + COMPILING


def _require(budget: Budget, original: float) -> None:
    """Is there time for one value, at full size, and for its proof?"""
    needed = _needed(original)
    if budget.left() < needed:
        message = f"a budget of {budget.seconds:g} s is too short: one trial with its proof takes"
        seconds = budget.spent + needed
        hint = f"give --budget {int(2.0 * seconds + 1)}s, or a smaller --size"
        raise usage_error("SC047", f"{message} about {seconds:.0f} s here", hint)


def _why(search: Search, proof: Proof, bound: Bound) -> str:
    """Why nothing was chosen for a bound, as a sentence."""
    pools, trials = search.pools, search.trials
    if not any(pool.values for pool in pools.values()):
        counts = [(n, why) for pool in pools.values() for why, n in pool.left_out.items()]
        told = ", ".join(f"{count} {why}" for count, why in counts)
        return (
            f"there is no value to cache: of the shader's nodes {told}"
            if told
            else ("there is no value to cache: the shader computes nothing that may be reused")
        )
    if not trials.families:
        why = trials.failed[0].why if trials.failed else "the budget was spent before"
        return f"no variant could be drawn: {why}"
    return _why_none(search, proof, bound) + _untried(search)


def _untried(search: Search) -> str:
    count = sum(map(len, search.untried.values()))
    if not count:
        return ""
    values = "value was" if count == 1 else "values were"
    return f" ({count} {values} not tried for want of time: a longer --budget tries them)"


def _why_none(search: Search, proof: Proof, bound: Bound) -> str:
    """Why none of what was drawn was chosen."""
    trials = search.trials
    longest = trials.setting.space.periods[-1]
    best = min(trials.families, key=lambda one: one.share(longest))
    if best.share(longest) >= 1.0:
        return (
            f"no value is worth a look-up here: with the best, '{best.value.text}', a frame takes "
            f"{best.share(longest):.2f} times as long as the original's"
        )
    tried = [one for one in proof.proven if one.speedup.low > 1.0]
    if tried:
        least = min(tried, key=lambda one: one.worst)
        return (
            "what is faster than the original errs more on frames that were not chosen by: at "
            f"least {bound.told(least.worst)}"
        )
    measured = [one for one in search.finalists if one.pays]
    if measured:
        least_drawn = min(one.drawn.worst for one in measured)
        told = f"what is faster than the original errs by at least {bound.told(least_drawn)}"
        if least_drawn > bound.aim:
            return told
        return f"{told}, and there was no time to prove it"
    return "what is near enough to the original is no faster"
