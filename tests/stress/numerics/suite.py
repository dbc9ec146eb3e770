"""Runs the numerical stress tests by number, prints what each measured, and keeps it as JSON."""

from __future__ import annotations

import os
import time
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from shadercache.cli.tables import format_table
from shadercache.harness.context import open_context
from shadercache.harness.results import SCHEMA_VERSION, environment, machine_name, write_json

from .criteria import DEEP, PROPERTY, stress_number

FOLDER = Path(__file__).parent
ROOT = FOLDER.parent.parent.parent

HEADER = ("test", "case", "what", "measured", "demanded", "")


@dataclass
class Collector:
    """A pytest plugin that keeps outcome, time and findings of every test."""

    found: list[dict[str, Any]] = field(default_factory=list)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Called by pytest after set-up, call and tear-down of each test."""
        if report.when != "call" and report.passed:
            return
        file, _, case = report.nodeid.partition("::")
        self.found.append(
            {
                "test": f"S{stress_number(file)}",
                "case": case.removeprefix("test_"),
                "outcome": report.outcome,
                "seconds": round(report.duration, 2),
                "findings": [value for name, value in report.user_properties if name == PROPERTY],
                "reason": _reason(report),
            }
        )


def _reason(report: pytest.TestReport) -> str:
    if report.skipped and isinstance(report.longrepr, tuple):
        return str(report.longrepr[2]).removeprefix("Skipped: ")
    return report.longreprtext.strip().splitlines()[-1] if report.failed else ""


def run_numerics(names: Collection[str], deep: bool, results: Path | None) -> int:
    """Run the tests of these names (``S9``; none: all); returns pytest's exit status.

    The result is written as ``stress-numerics.json`` into ``results``, or where results of this
    machine lie, if all were run.
    """
    wanted = {int(name.upper().removeprefix("S")) for name in names}
    files = sorted(FOLDER.glob("test_s*.py"), key=stress_number)
    chosen = [file for file in files if not wanted or stress_number(file) in wanted]
    missing = wanted - {stress_number(file) for file in files}
    if missing:
        print("there is no test " + ", ".join(f"S{name}" for name in sorted(missing)))
        return 2
    os.environ[DEEP] = "deep" if deep else "short"
    collector = Collector()
    start = time.monotonic()
    arguments = ["-q", "--no-header", "--tb=short", "-p", "no:cacheprovider", "--timeout=1800"]
    status = int(pytest.main([*arguments, *map(str, chosen)], plugins=[collector]))
    print(table(collector.found))
    with open_context() as gpu:
        about = environment(gpu)
    print(f"{about['gl']}: {time.monotonic() - start:.0f} s")
    if results is not None or not wanted:
        folder = results or ROOT / "bench" / "results" / machine_name(about)
        write_json(folder / "stress-numerics.json", _json(collector.found, about, deep))
    return status


def table(found: Collection[Mapping[str, Any]]) -> str:
    """Every finding in a line, skips and failures with their reason."""
    rows: list[tuple[str, ...]] = []
    for item in found:
        head = (item["test"], item["case"])
        rows += [(*head, *_cells(finding)) for finding in item["findings"]]
        if item["outcome"] == "skipped":
            rows.append((*head, item["reason"], "", "", "skipped"))
        elif item["outcome"] == "failed" and all(one["holds"] for one in item["findings"]):
            rows.append((*head, item["reason"], "", "", "FAILED"))
    return format_table(HEADER, rows)


def _cells(finding: Mapping[str, Any]) -> tuple[str, str, str, str]:
    mark = ("holds" if finding["holds"] else "BROKEN") if finding["demand"] else ""
    return finding["what"], finding["measured"], finding["demand"], mark


def _json(
    found: Collection[Mapping[str, Any]], about: Mapping[str, Any], deep: bool
) -> dict[str, Any]:
    return {
        "schema_version": SCHEMA_VERSION,
        "environment": dict(about),
        "form": "deep" if deep else "short",
        "tests": list(found),
    }
