"""What ``tune`` chooses for the dragon beside what was found by hand before there was ``tune``.

``python -m bench.tuning.by_hand`` tunes the dragon for a bound of .005 and then draws that choice
and the one by hand (the whole noise, carried samples) in turns with the original, until the
payloads are as old as they get: from the first frame, as it was found, and behind all frames that
the search has seen, at the usual speed and at twice that. It writes
``bench/results/<machine>/tuning/by-hand-dragon.json``.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path
from typing import Any

from bench.tuning.grid import RESULTS
from shadercache.caching.configuration import Assignment, Configuration, Filter
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table
from shadercache.gpu.context import open_context
from shadercache.linking.cache_settings import configured
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.result_files import environment, machine_name, plain, write_json
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.choose import TuneQuestion, Tuning, tune
from shadercache.tuning.groups import assignment_of, groups_of
from shadercache.tuning.laboratory import Drawn, Laboratory, Run
from shadercache.tuning.result import told

BOUND = 0.005
VALUE = "whole noise"
PERIODS = (6, 48, 128)
LAST = 12
"""Frames at the end of a run that are compared."""


def main() -> None:
    """Print a row for each choice and passage."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--seconds", type=float, default=90.0)
    asked = parser.parse_args()
    budget = Budget(asked.seconds)
    linker = Linker(*open_scene(Path(data_path("corpus", "dragon", "scene.toml"))))
    question = TuneQuestion((Bound("rmse", BOUND),), asked.seconds, size_is_fixed=True)
    with (
        open_context() as gpu,
        progress("dragon", 4) as advance,
        RenderScene(gpu, linker.scene, (asked.size, asked.size)) as world,
    ):
        found = tune(world, linker, question, budget, lambda spent, what: None)
        advance(1)
        choices = _choices(linker, found)
        rows = []
        with Laboratory(world, linker) as laboratory:
            seen = found.drawings.trials.seen
            for start, step in ((0, 1), (seen, 1), (seen, 2)):
                run = _run(choices, start, step)
                drawn = laboratory.draw(list(choices.values()), run)
                rows += [
                    _row(name, choices[name], run, one)
                    for name, one in zip(choices, drawn, strict=True)
                ]
                advance(1)
        where = environment(gpu)
    report = {"environment": where, "size": asked.size, "spent": found.drawings.spent, "rows": rows}
    write_json(RESULTS / machine_name(where) / "tuning" / "by-hand-dragon.json", plain(report))
    print(f"tuned in {found.drawings.spent:.0f} s")
    cells = [
        [f"{cell:.4f}" if isinstance(cell, float) else str(cell) for cell in row.values()]
        for row in rows
    ]
    print(format_table(list(rows[0]), cells))


def _choices(linker: Linker, found: Tuning) -> dict[str, Assignment]:
    """The choice of ``tune``, if there is one, and those by hand."""
    node = linker.scene.nodes[VALUE]
    base = replace(configured(linker.scene, Configuration(), None), nodes=(node,))
    carried = replace(base, filter=Filter("carried"))
    [group] = groups_of(linker)
    choices = {
        f"by hand, {period}": assignment_of(linker.scene, {group: carried.with_refresh(period, 4)})
        for period in PERIODS
    }
    [answer] = found.answers
    if answer.chosen is not None:
        choices["tune"] = answer.chosen.plan.assignment(linker.scene)
    return choices


def _of(assignment: Assignment) -> Configuration:
    return next(chosen for _, chosen in assignment.objects if chosen is not None)


def _run(choices: dict[str, Assignment], start: int, step: int) -> Run:
    """Until the oldest payloads are as old as they get."""
    frames = 1 + max(_of(one).refresh.period for one in choices.values()) + LAST
    return Run(frames, tuple(range(frames - LAST, frames)), start=start, step=step)


def _row(name: str, choice: Assignment, run: Run, drawn: Drawn) -> dict[str, Any]:
    gain = drawn.speedup
    return {
        "choice": name,
        "configuration": told(_of(choice)),
        "from": run.start,
        "speed": run.step,
        "gain": gain.median,
        "low": gain.low,
        "high": gain.high,
        "mean": drawn.mean,
        "worst": drawn.worst,
    }


if __name__ == "__main__":
    main()
