"""``./dev refused``: how much of the cost of the corpus and of the cases cannot be cached.

For every shader a program is made that computes whatever may be cached (and what need not be:
constants, values of uniforms only, values cheaper than a fetch), and nothing else. What the shader
itself costs beyond that is refused: by static cost, and by time, without the bare geometry. The two
programs and the geometry are drawn in turns; the clock is the process's own, since other processes
shall not count. Writes ``bench/results/<machine>/refused.json``. Exit status 1 above 10 %.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table
from shadercache.compiler import Analysis, emit_original
from shadercache.diagnostics import InputError
from shadercache.gpu.clock import no_collection
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.result_files import environment, machine_name, write_json
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import GeometryRunner, OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from tests.cases.cases import NAMES, analysed
from tests.cases.scenery import make_scene, scene_of

from .folder import folder_costs
from .offers import Refused, programs, refused_cost

CORPUS = ("dragon", "trashcan")
MOST = 0.1
SIZE = (512, 512)
ROUNDS = 11

Row = dict[str, Any]


def static_rows() -> Iterator[tuple[str, Analysis | None]]:
    """Every shader by name; ``None`` for one that is refused as a whole."""
    for name in CORPUS:
        yield name, analyse_scene(load_scene(data_path("corpus", name)))[1]
    for name in NAMES:
        try:
            yield f"cases/{name}", analysed(name)
        except InputError:
            yield f"cases/{name}", None


def measured(gpu: Gpu, scene: Scene, analysis: Analysis, rounds: int) -> dict[str, float]:
    """Least seconds of processor time for the original, the offers and the bare geometry."""
    written = emit_original(analysis)
    made = {name: Bundle(written.manifest, files) for name, files in programs(analysis).items()}
    found: dict[str, list[float]] = {"original": [], "offers": [], "geometry": []}
    with (
        RenderScene(gpu, scene, SIZE) as world,
        OriginalRunner(world, made["original"]) as whole,
        OriginalRunner(world, made["offers"]) as part,
        GeometryRunner(world, made["original"]) as bare,
        no_collection(),
    ):
        for frame in range(rounds + 1):  # the first draws of a program are slow
            for samples, runner in zip(found.values(), (whole, part, bare), strict=True):
                samples.append(_seconds(gpu, partial(runner.draw, frame)))
    return {name: min(samples[1:]) for name, samples in found.items()}


def _seconds(gpu: Gpu, draw: Callable[[], None]) -> float:
    gpu.ctx.finish()
    start = time.process_time()
    draw()
    gpu.ctx.finish()
    return time.process_time() - start


def row_of(name: str, cost: Refused, times: dict[str, float] | None) -> Row:
    """What is stored of a shader."""
    row: Row = {"shader": name, "static": cost.total, "static_refused": cost.cost}
    row["codes"] = {code: found for code, found in sorted(cost.codes.items()) if found}
    if times is not None:
        row["seconds"] = {key: float(f"{value:.3g}") for key, value in times.items()}
    return row


def summary(rows: Sequence[Row]) -> dict[str, float]:
    """The refused share over all shaders, and the mean of their shares, static and measured."""
    static = [(row["static"], row["static_refused"]) for row in rows]
    found = {"static": _share(static), "static, mean of shaders": _mean(static)}
    timed = [row["seconds"] for row in rows if "seconds" in row]
    if timed:
        seconds = [(t["original"] - t["geometry"], t["original"] - t["offers"]) for t in timed]
        # Where nothing is refused the difference is noise of either sign: it stays in the sums.
        found["measured"] = _share(seconds)
        found["measured, mean of shaders"] = _mean(seconds)
    return found


def _share(pairs: Sequence[tuple[float, float]]) -> float:
    return sum(refused for _, refused in pairs) / sum(total for total, _ in pairs)


def _mean(pairs: Sequence[tuple[float, float]]) -> float:
    return sum(refused / total for total, refused in pairs if total > 0) / len(pairs)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev refused", description=__doc__)
    parser.add_argument("--static", action="store_true", help="nothing is drawn or written")
    text = "in place of corpus and cases: the shaders in this folder (static, nothing is written)"
    parser.add_argument("--shaders", type=Path, metavar="DIR", help=text)
    parser.add_argument("--rounds", type=int, default=ROUNDS, metavar="N")
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="for the result file")
    options = parser.parse_args(arguments)
    if options.shaders is not None:
        if not options.shaders.is_dir():
            parser.error(f"{options.shaders}: there is no such folder")
        return _folder(options.shaders)
    shaders = list(static_rows())
    accepted = [(name, analysis) for name, analysis in shaders if analysis is not None]
    whole = [name for name, analysis in shaders if analysis is None]
    if options.static:
        rows = [row_of(name, refused_cost(analysis), None) for name, analysis in accepted]
        _print(rows, whole)
        return int(summary(rows)["static"] > MOST)
    with open_context() as gpu, tempfile.TemporaryDirectory() as folder:
        scenes = make_scene(Path(folder) / "scene")
        rows = []
        with progress("measuring", len(accepted)) as advance:
            for name, analysis in accepted:
                kind, _, case = name.rpartition("/")
                path = data_path("corpus", name) if not kind else None
                scene = load_scene(path) if path is not None else scene_of(case, scenes)
                times = measured(gpu, scene, analysis, options.rounds)
                rows.append(row_of(name, refused_cost(analysis), times))
                advance(1)
        about = environment(gpu)
    found = summary(rows)
    result = {
        "schema_version": 1,
        "environment": about,
        "size": SIZE,
        "rounds": options.rounds,
        "clock": "processor time of the process, least of the rounds",
        "refused": {name: float(f"{share:.4g}") for name, share in found.items()},
        "refused as a whole": whole,
        "shaders": rows,
    }
    output = options.output or Path("bench/results") / machine_name(about)
    write_json(output / "refused.json", result)
    _print(rows, whole)
    return int(max(found["static"], found["measured"]) > MOST)


def _folder(folder: Path) -> int:
    """Print the refused cost of a folder's shaders; returns the exit status."""
    found = folder_costs(folder)
    rows = [row_of(item.name, item.cost, None) for item in found if item.cost is not None]
    if not rows:
        print(f"refused: no shader in {folder} can be analysed", file=sys.stderr)
        return 1
    _print(rows, [f"{item.name} ({item.code})" for item in found if item.cost is None])
    return 0


def by_code(rows: Sequence[Row]) -> dict[str, tuple[float, float]]:
    """By code: its share of the static cost of all shaders, and the mean of its shares in each."""
    codes = sorted({code for row in rows for code in row["codes"]})
    pairs = {code: [(row["static"], row["codes"].get(code, 0.0)) for row in rows] for code in codes}
    return {code: (_share(found), _mean(found)) for code, found in pairs.items()}


def _print(rows: Sequence[Row], whole: Sequence[str]) -> None:
    table: list[tuple[str, ...]] = []
    for row in rows:
        measured_share = ""
        if "seconds" in row:
            t = row["seconds"]
            share = (t["original"] - t["offers"]) / max(t["original"] - t["geometry"], 1e-9)
            measured_share = f"{share:.1%}"
        codes = ", ".join(f"{code} {cost:.0f}" for code, cost in row["codes"].items())
        share = row["static_refused"] / max(row["static"], 1.0)
        table.append((row["shader"], f"{row['static']:.0f}", f"{share:.1%}", measured_share, codes))
    header = ("shader", "static", "refused", "measured", "where it stands")
    print(format_table(header, table, "static refused measured"))
    for code, (all_cost, mean) in by_code(rows).items():
        print(f"{code}: {all_cost:.2%} of the cost of all shaders; mean of shaders {mean:.2%}")
    for name, share in summary(rows).items():
        print(f"refused, {name}: {share:.2%}")
    print(f"refused as a whole, and not counted: {', '.join(whole)}")


if __name__ == "__main__":
    sys.exit(main())
