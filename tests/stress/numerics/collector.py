"""A pytest plugin that keeps outcome, time and findings of every stress test, as JSON lines."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tests.stress.numerics.criteria import PROPERTY, stress_number

OUT = "SHADERCACHE_STRESS_OUT"
"""The environment variable with the file that the lines are added to."""


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Called by pytest after set-up, call and tear-down of each test."""
    if report.when != "call" and report.passed:
        return
    file, _, case = report.nodeid.partition("::")
    found = {
        "test": f"S{stress_number(file)}",
        "case": case.removeprefix("test_"),
        "outcome": report.outcome,
        "seconds": round(report.duration, 2),
        "findings": [value for name, value in report.user_properties if name == PROPERTY],
        "reason": _reason(report),
    }
    with Path(os.environ[OUT]).open("a", encoding="utf-8") as lines:
        lines.write(json.dumps(found) + "\n")


def _reason(report: pytest.TestReport) -> str:
    if report.skipped and isinstance(report.longrepr, tuple):
        return str(report.longrepr[2]).removeprefix("Skipped: ")
    return report.longreprtext.strip().splitlines()[-1] if report.failed else ""
