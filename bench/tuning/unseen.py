"""Does what ``tune`` promises hold? Its choices on frames that neither search nor proof saw.

``python -m bench.tuning.unseen [SCENE...]`` tunes each corpus scene for four bounds, then draws
what was chosen on two further parts of its path, at the usual speed and at twice that. It writes
``bench/results/<machine>/tuning/unseen-<scene>.json``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from bench.tuning.grid import RESULTS, SCENES
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table, shorten
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.result_files import environment, machine_name, write_json
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.choose import TuneQuestion, Tuning, tune
from shadercache.tuning.laboratory import Drawn, Laboratory
from shadercache.tuning.proof import Proven
from shadercache.tuning.result import to_json, told
from shadercache.tuning.search import whole_run

BOUNDS = (0.0025, 0.005, 0.01, 0.02)
SPEEDS = (1, 2)


def main() -> None:
    """Tune, check, and print a row for each bound. Exit status 1 where a bound is broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--seconds", type=float, default=90.0)
    asked = parser.parse_args()
    rows = [row for name in asked.scenes for row in _checked(name, asked.size, asked.seconds)]
    print(format_table(("scene", "bound", "gain", "proof", "further", "holds", "choice"), rows))
    broken = [row for row in rows if row[5] == "no"]
    raise SystemExit(1 if broken else 0)


def _checked(name: str, size: int, seconds: float) -> list[tuple[str, ...]]:
    budget = Budget(seconds)
    linker = Linker(*open_scene(Path(data_path("corpus", name, "scene.toml"))))
    question = TuneQuestion(tuple(Bound("rmse", limit) for limit in BOUNDS), seconds)
    with (
        open_context() as gpu,
        progress(name, 1000) as advance,
        RenderScene(gpu, linker.scene, (size, size)) as world,
    ):
        found = tune(world, linker, question, budget, lambda spent, what: None)
        advance(900)
        chosen = [answer.chosen for answer in found.answers if answer.chosen is not None]
        with Laboratory(world, linker) as laboratory:
            further = _further(laboratory, linker, chosen, found.drawings.trials.seen)
        where = environment(gpu)
        report: dict[str, Any] = to_json(found, linker.scene, where)
    worst = {id(one): max(drawn.worst for drawn in seen) for one, seen in further}
    report["further"] = [
        None if answer.chosen is None else worst[id(answer.chosen)] for answer in found.answers
    ]
    write_json(RESULTS / machine_name(where) / "tuning" / f"unseen-{name}.json", report)
    return [_row(name, found, number, worst) for number in range(len(found.answers))]


def _further(
    laboratory: Laboratory, linker: Linker, chosen: Sequence[Proven], seen: int
) -> list[tuple[Proven, list[Drawn]]]:
    """Each choice on frames behind all that were drawn before."""
    rows = []
    for one in {id(proven): proven for proven in chosen}.values():
        run = whole_run([one.plan], "rmse")
        assignment = one.plan.assignment(linker.scene)
        runs = [replace(run, start=seen, step=step) for step in SPEEDS]
        rows.append((one, [laboratory.draw([assignment], each)[0] for each in runs]))
    return rows


def _row(name: str, found: Tuning, number: int, worst: dict[int, float]) -> tuple[str, ...]:
    answer = found.answers[number]
    proven, limit = answer.chosen, answer.bound.limit
    if proven is None:
        return (name, f"{limit:g}", "", "", "", "", f"leave it alone: {answer.why}")
    parts = [
        f"{shorten(family.value.text, 24)} {told(family.at(period))}"
        for family, period in proven.plan.parts
    ]
    further = worst[id(proven)]
    return (
        name,
        f"{limit:g}",
        f"{proven.speedup.median:.2f}x [{proven.speedup.low:.2f}-{proven.speedup.high:.2f}]",
        f"{proven.worst:.4f}",
        f"{further:.4f}",
        "yes" if further <= limit else "no",
        "; ".join(parts),
    )


if __name__ == "__main__":
    main()
