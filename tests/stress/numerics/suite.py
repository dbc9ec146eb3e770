"""Runs the numerical stress tests by number, prints what each measured, and keeps it as JSON."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Collection, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from shadercache.cli.tables import format_table
from shadercache.gpu.context import open_context
from shadercache.measure.result_files import environment, machine_name, write_json

from .collector import OUT
from .criteria import DEEP, stress_number

FOLDER = Path(__file__).parent
ROOT = FOLDER.parent.parent.parent

HEADER = ("test", "case", "what", "measured", "demanded", "")

SAME = {19: 3}
"""S19 measures what S3 does, with the other filters beside it; both stand in one file."""

PYTEST = ("-q", "--no-header", "--tb=short", "-p", "no:cacheprovider", "--timeout=3600")


def run_numerics(names: Collection[str], deep: bool, results: Path | None) -> int:
    """Run the tests of these names (``S9``; none: all); returns pytest's exit status.

    The result is written as ``stress-numerics.json`` into ``results``, or where results of this
    machine lie, if all were run in the long form.
    """
    asked = {int(name.upper().removeprefix("S")) for name in names}
    wanted = {SAME.get(number, number) for number in asked}
    files = sorted(FOLDER.glob("test_s*.py"), key=stress_number)
    missing = wanted - {stress_number(file) for file in files}
    if missing:
        print("there is no test " + ", ".join(f"S{name}" for name in sorted(missing)))
        return 2
    start = time.monotonic()
    chosen = [file for file in files if not wanted or stress_number(file) in wanted]
    status, found = _run(chosen, deep)
    print(table(found))
    with open_context() as gpu:
        about = environment(gpu)
    print(f"{about['gl']['renderer']}: {len(found)} tests, {time.monotonic() - start:.0f} s")
    if results is not None or (deep and not wanted):
        folder = results or ROOT / "bench" / "results" / machine_name(about)
        head = {"schema_version": 1, "environment": about}
        form = {"form": "deep" if deep else "short", "tests": found}
        write_json(folder / "stress-numerics.json", head | form)
    return status


def _run(files: Collection[Path], deep: bool) -> tuple[int, list[dict[str, Any]]]:
    with TemporaryDirectory() as folder:
        out = Path(folder) / "found.jsonl"
        out.touch()
        more = {DEEP: "deep" if deep else "short", OUT: str(out)}
        plugin = "tests.stress.numerics.collector"
        command = [sys.executable, "-m", "pytest", *PYTEST, "-p", plugin, *map(str, files)]
        done = subprocess.run(command, cwd=ROOT, env=os.environ | more, check=False)
        lines = out.read_text(encoding="utf-8").splitlines()
    return done.returncode, [json.loads(line) for line in lines]


def table(found: Collection[Mapping[str, Any]]) -> str:
    """Every finding in a line; tests without any, skips and failures with their reason."""
    rows: list[tuple[str, ...]] = []
    for item in found:
        head = (item["test"], item["case"])
        rows += [(*head, *_cells(finding)) for finding in item["findings"]]
        if item["outcome"] == "skipped":
            rows.append((*head, item["reason"], "", "", "skipped"))
        elif item["outcome"] == "failed" and all(one["holds"] for one in item["findings"]):
            rows.append((*head, item["reason"], "", "", "FAILED"))
        elif not item["findings"]:
            rows.append((*head, "", "", "", "holds"))
    return format_table(HEADER, rows)


def _cells(finding: Mapping[str, Any]) -> tuple[str, str, str, str]:
    mark = ("holds" if finding["holds"] else "BROKEN") if finding["demand"] else ""
    return finding["what"], finding["measured"], finding["demand"], mark
