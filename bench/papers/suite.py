"""All experiments: ``./dev papers``, or ``python -m bench.papers``.

Each result is written when its experiment ends. The page is made from all results that are there.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from bench.papers import (
    ages,
    alignment,
    figure5,
    figure8,
    figure9,
    figure10,
    figure11,
    figure12,
    filters,
)
from bench.papers.experiment import Experiment, Options
from bench.papers.page import write_page
from bench.papers.result import Result, load, stands, store
from bench.speed import HERE, ROOT
from shadercache.cli.progress import progress
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.context import Gpu, open_context
from shadercache.measure.result_files import environment, machine_name

EXPERIMENTS: tuple[Experiment[Any], ...] = tuple(
    module.EXPERIMENT
    for module in (
        figure5,
        figure8,
        figure9,
        figure10,
        figure11,
        figure12,
        alignment,
        ages,
        filters,
    )
)
QUICK_SIZE, SIZE = 128, 512


def run(gpu: Gpu, experiment: Experiment[Any], options: Options) -> Result:
    """Measure one experiment. Raises as its ``gather``."""
    begun = time.monotonic()
    with _steps(experiment.name) as tell:
        data = experiment.gather(gpu, options, tell)
    return Result(experiment, options, environment(gpu), time.monotonic() - begun, data)


@contextmanager
def _steps(name: str) -> Iterator[Callable[[int, int], None]]:
    # In thousandths, since only the experiment knows how many steps it has.
    with progress(name, 1000) as advance:
        shown = 0

        def tell(done: int, total: int) -> None:
            nonlocal shown
            reached = 1000 * done // max(1, total)
            advance(reached - shown)
            shown = reached

        yield tell


def chosen(names: Sequence[str]) -> list[Experiment[Any]]:
    """The experiments of these names, or all; in their own order."""
    return [one for one in EXPERIMENTS if not names or one.name in names]


def _size(text: str) -> int:
    if not text.isdigit() or not 16 <= int(text) <= 8192:
        raise argparse.ArgumentTypeError(f"{text!r} is no edge from 16 to 8192 pixels")
    return int(text)


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    names = [one.name for one in EXPERIMENTS]
    parser = argparse.ArgumentParser(prog="./dev papers", description=__doc__)
    parser.add_argument("--only", action="append", choices=names, help="this one (repeatable)")
    parser.add_argument(
        "--resume", action="store_true", help="keep results of this commit, driver and size"
    )
    parser.add_argument(
        "--quick", action="store_true", help="small, short, few nodes: numbers mean little"
    )
    parser.add_argument("--size", type=_size, metavar="PIXELS", help="edge of the picture")
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="for JSON and plots")
    parser.add_argument("--page", type=Path, metavar="FILE", help="the page (docs/PAPERS.md)")
    return parser.parse_args(arguments)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what was chosen, print tables and verdicts, write the page; returns the exit status."""
    try:
        _run_all(_arguments(arguments))
    except DiagnosticError as error:
        print(error, file=sys.stderr)
        return error.exit_code
    return 0


def _run_all(given: argparse.Namespace) -> None:
    options = Options(given.size or (QUICK_SIZE if given.quick else SIZE), given.quick)
    with open_context() as gpu:
        about = environment(gpu)
        kept = HERE / "results" / machine_name(about) / "papers"
        folder = given.output or (ROOT / "out" / "papers" if given.quick else kept)
        for experiment in chosen(given.only or []):
            path = _path(folder, experiment)
            if given.resume and stands(path, options, about):
                print(f"{experiment.name}: stands in {path}", flush=True)
                continue
            result = run(gpu, experiment, options)
            store(path, result)
            print(result.text, end="\n\n", flush=True)
    results = [load(_path(folder, one), one) for one in EXPERIMENTS]
    beside = folder / "PAPERS.md" if given.quick or given.output else ROOT / "docs" / "PAPERS.md"
    page = given.page or beside
    write_page(page, [one for one in results if one is not None], folder)
    print(f"results: {folder}\npage: {page}")


def _path(folder: Path, experiment: Experiment[Any]) -> Path:
    return folder / f"{experiment.name.lower()}.json"
