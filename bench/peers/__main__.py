"""``./dev peers``: what one would do instead of caching a value, measured beside it.

Prints a table for each scene and a sentence for each metric on who wins where, and writes
SCENE.json and SCENE.png, which shows error against time.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

import msgspec

from bench.peers.comparison import CACHE, MULTIPLE, PEERS, Setting, compare
from bench.peers.outcomes import SceneOutcome, pareto_front
from bench.peers.plane import plot_planes
from bench.peers.rows import peer_rows
from bench.peers.scene_programs import ScenePrograms
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table
from shadercache.diagnostics import DiagnosticError
from shadercache.files import write_bytes
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.sweep.results import Blobs
from shadercache.sweep.store import Store

SCENES = ("dragon", "trashcan", "heroine", "colonnade")
"""Those that are compared unless others are named."""

_COLUMNS = ("rmse", "p99", "flip", "ssim", "flicker")


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare, print and write; returns the exit status."""
    options = _options(arguments)
    try:
        with open_context() as gpu:
            for name in options.scenes:
                outcome = _compare(gpu, name, options)
                print(outcome_table(outcome), *outcome.winners.values(), "", sep="\n", flush=True)
                _write(options.output, outcome)
    except DiagnosticError as error:
        for diagnostic in error.diagnostics:
            print(diagnostic.render(), file=sys.stderr)
        return error.exit_code
    return 0


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench.peers", description=__doc__)
    add, known = parser.add_argument, (*PEERS, CACHE)
    add(
        "scenes", nargs="*", metavar="SCENE", help=f"of the corpus ({', '.join(SCENES)}), or a file"
    )
    add("--size", type=int, default=512, metavar="N", help=f"a multiple of {MULTIPLE}")
    add("--frames", type=int, default=64, metavar="N")
    add("--only", metavar="NAMES", help=f"apart by commas: {', '.join(known)}")
    add("-o", "--output", type=Path, default=Path("out/peers"), metavar="DIR")
    add("--store", type=Path, metavar="FILE", help="also write the peers into a result store")
    options = parser.parse_args(arguments)
    options.scenes = options.scenes or SCENES
    options.only = options.only.split(",") if options.only else known
    if options.size < MULTIPLE or options.size % MULTIPLE:
        parser.error(f"--size must be a multiple of {MULTIPLE}")
    if options.frames < 4:
        parser.error("--frames must be at least 4")
    for name in options.only:
        if name not in known:
            parser.error(f"there is no peer '{name}'; there are {', '.join(known)}")
    return options


def _compare(gpu: Gpu, name: str, options: argparse.Namespace) -> SceneOutcome:
    is_file = name.endswith(".toml")
    path = Path(name) if is_file else data_path("corpus", name, "scene.toml")
    linker = Linker(*open_scene(path, mapping="surface"))
    setting = Setting(linker, ScenePrograms.of(linker), options.frames)
    with progress(linker.scene.name, 1000) as advance:
        done = 0

        def told(step: int, steps: int, what: str) -> None:
            nonlocal done
            reached = 1000 * step // steps
            advance(reached - done)
            done = reached

        outcome, measured = compare(gpu, setting, options.size, options.only, told)
    if options.store is not None:
        blobs = Blobs()
        rows = list(peer_rows(gpu, linker, measured, outcome, blobs))
        with Store(options.store, create=True) as store:
            store.keep(rows, blobs.data)
    return outcome


def outcome_table(outcome: SceneOutcome) -> str:
    """One line for everything that was drawn, the fastest first; stars mark the front by RMSE."""
    front = {point.label for point in pareto_front(outcome.points, "rmse")}
    head = (
        f"{outcome.scene}, {outcome.size[0]} x {outcome.size[1]}, {outcome.frames} frames: "
        f"the original takes {outcome.original:.1f} ms ({outcome.clock})\n"
    )
    rows = [
        (
            f"{point.label}{' *' if point.label in front else ''}",
            point.kind,
            f"{point.milliseconds:.1f}",
            f"{point.ratio:.2f}",
            f"{point.low:.2f}-{point.high:.2f}",
            *(f"{point.errors[name]:.4f}" if name in point.errors else "-" for name in _COLUMNS),
        )
        for point in sorted(outcome.points, key=lambda point: -point.ratio)
    ]
    columns = ("", "kind", "ms", "ratio", "interval", *_COLUMNS)
    return head + format_table(columns, rows, right=" ".join(columns[2:]))


def _write(folder: Path, outcome: SceneOutcome) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    text = msgspec.json.format(msgspec.json.encode(outcome), indent=1)
    write_bytes(folder / f"{outcome.scene}.json", text + b"\n")
    write_bytes(folder / f"{outcome.scene}.png", plot_planes(outcome))
    print(f"{folder / outcome.scene}.json and .png\n")


if __name__ == "__main__":
    sys.exit(main())
