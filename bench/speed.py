"""What the scripts share that time the tool itself: targets, processor time, the result file."""

from __future__ import annotations

import argparse
import resource
import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from shadercache.ast.large import allow_deep_trees
from shadercache.cli.tables import format_table
from shadercache.gpu.context import open_context
from shadercache.measure.result_files import environment, machine_name, write_json

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PUBLIC = ROOT / "out" / "public" / "shaders" / "three" / "ShaderLib"
"""Shaders of three.js, where ``./dev corpus`` has fetched them."""

Sample = dict[str, Any]


def child_seconds(command: Sequence[str], **options: Any) -> tuple[float, str]:
    """Seconds of processor time of a command, and what it prints; options as for ``run``."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def target(name: str, value: float | None, limit: float, at_least: bool = False) -> Sample:
    """What was aimed at and what is reached; ``met`` is None where nothing was measured."""
    return {
        "name": name,
        "value": value,
        "target": f"{'>=' if at_least else '<='} {limit:g}",
        "met": None if value is None else (value >= limit if at_least else value <= limit),
    }


def targets_table(targets: Sequence[Sample]) -> str:
    """One line for each target."""
    words = {True: "met", False: "MISSED", None: "not measured"}
    rows = [
        (
            row["name"],
            "-" if row["value"] is None else f"{row['value']:.3g}",
            row["target"],
            words[row["met"]],
        )
        for row in targets
    ]
    return format_table(("target", "value", "wanted", ""), rows, right="value wanted")


def time_and_store(
    parser: argparse.ArgumentParser,
    name: str,
    parts: Callable[[argparse.Namespace], Mapping[str, Any]],
    arguments: Sequence[str] | None,
) -> int:
    """Run a script: ``parts`` measures, prints its tables and has ``targets`` among its results.

    Returns the exit status.
    """
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="the result as JSON")
    options = parser.parse_args(arguments)
    allow_deep_trees()
    with open_context() as gpu:
        about = environment(gpu)
    result = parts(options)
    print(f"\n{targets_table(result['targets'])}")
    path = options.output or HERE / "results" / machine_name(about) / f"{name}.json"
    write_json(path, {"schema_version": 1, "environment": about, **result})
    print(f"\nresult: {path}")
    return 0
