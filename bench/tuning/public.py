"""``tune`` on shaders that nobody here wrote: what it chooses, and when it leaves them alone.

``python -m bench.tuning.public FRAG...`` prints a row for each: full-screen shaders, and fragment
shaders with a vertex shader beside them. Each is read from where it was fetched to; only the names
go into ``bench/results/<machine>/tuning/public.json``.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from bench.tuning.grid import RESULTS
from shadercache.cli.tables import format_table, shorten
from shadercache.diagnostics import DiagnosticError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.linking.user_places import at_home
from shadercache.measure.result_files import environment, machine_name, write_json
from shadercache.render.render_scene import RenderScene
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.choose import TuneQuestion, tune
from shadercache.tuning.result import to_json, told

HEADER = ("shader", "original, ms", "gain", "error", "choice")


def main() -> None:
    """Tune each shader for one bound."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shaders", nargs="+", type=Path)
    parser.add_argument("--bound", type=float, default=0.01)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--size", type=int, default=512)
    asked = parser.parse_args()
    rows, reports = [], {}
    for path in asked.shaders:
        row, report = _tuned(path, asked)
        rows.append(row)
        reports["/".join(path.resolve().parts[-3:])] = report
        print(" | ".join(row), flush=True)
    print(format_table(HEADER, rows))
    with open_context() as gpu:
        where = environment(gpu)
    path = RESULTS / machine_name(where) / "tuning" / "public.json"
    write_json(path, {"environment": where, "shaders": reports})


def _tuned(path: Path, asked: argparse.Namespace) -> tuple[tuple[str, ...], Any]:
    name = "/".join(path.parts[-2:])
    budget = Budget(asked.seconds)
    bound = Bound("rmse", asked.bound)
    try:
        linker = Linker(*open_scene(path, ReadOptions(dialect="auto")))
        with (
            open_context() as gpu,
            at_home(linker.analysis),
            RenderScene(gpu, linker.scene, (asked.size, asked.size)) as world,
        ):
            question = TuneQuestion((bound,), asked.seconds)
            found = tune(world, linker, question, budget, lambda spent, what: None)
            report = to_json(found, linker.scene, environment(gpu))
    except DiagnosticError as error:
        first = error.diagnostics[0]
        words = f"{first.message} [{first.code}]"
        return (name, "", "", "", words), {"refused": words}
    [answer] = found.answers
    original = f"{found.drawings.original * 1e3:.1f}"
    if answer.chosen is None:
        return (name, original, "", "", f"leave it alone: {answer.why}"), report
    proven = answer.chosen
    [(family, period)] = proven.plan.parts
    gain = f"{proven.speedup.median:.2f}x [{proven.speedup.low:.2f}-{proven.speedup.high:.2f}]"
    choice = f"{shorten(family.value.text, 32)}: {told(family.at(period))}"
    return (name, original, gain, f"{proven.worst:.4f}", choice), report


if __name__ == "__main__":
    main()
