"""How long a plan will take, roughly: before anything of it is drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from shadercache.caching.algorithms import PROFILED
from shadercache.sweep.plan import SceneFile, SweepTrial

COMPILING = 1.5
"""Seconds that compiling and the pictures of a configuration take here (two cores, llvmpipe)."""

BESIDE = 2.5
"""Originals' worth that a turn draws beside the configurations: the original, its geometry, parts
of the floor."""

PROFILE = 10.0
"""Originals' worth that a turn of a profile draws: programs with and without each part."""

PROBES = 1.5
"""Times that a configuration is drawn in a fixed frame, masks and reading back included."""


def trial_seconds(trial: SweepTrial, original: float) -> float:
    """What a trial takes if a frame of the original takes ``original`` seconds.

    Frames past the fixed ones are counted as one half of the cap: some ratios are known at once,
    others never.
    """
    count = len(trial.configurations)
    turn = original * (BESIDE + PROBES * count)
    fixed = trial.scene.frames * turn * (2.0 if trial.limits.perceptual else 1.0)
    once = COMPILING * count + fixed + 0.5 * min(trial.limits.seconds, 4.0 * fixed)
    if not trial.limits.profile:
        return once
    each = trial.scene.frames * PROFILE * original
    profiled = sum(one.algorithm == PROFILED for one in trial.configurations)
    return once + profiled * (each + 0.5 * min(trial.limits.seconds, 4.0 * each))


def plan_seconds(trials: Sequence[SweepTrial], originals: Mapping[SceneFile, float]) -> float:
    """The same of a plan; scenes whose original cannot be drawn take nothing."""
    return sum(
        trial_seconds(trial, originals[trial.file]) for trial in trials if trial.file in originals
    )
