"""What a stress test demands, and what it measured: asserted, and kept for the table."""

from __future__ import annotations

import math
import os
import re
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

DEEP = "SHADERCACHE_STRESS"
"""The environment variable that is ``deep`` where the long form of each test is wanted."""

PROPERTY = "stress"
"""The name under which findings stand among a test's properties."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One measured number. ``demand`` says what it has to be, or nothing where it is only told."""

    what: str
    measured: str
    demand: str = ""
    holds: bool = True


class Criteria:
    """Takes what a test measures, and fails it where that is not what is demanded."""

    def __init__(self, properties: list[tuple[str, Any]]) -> None:
        self._properties = properties
        self.deep = os.environ.get(DEEP) == "deep"

    def at_most(self, what: str, measured: float, bound: float) -> None:
        """Demand ``measured <= bound``; NaN never is."""
        self.demand(what, number(measured), f"<= {number(bound)}", measured <= bound)

    def at_least(self, what: str, measured: float, bound: float) -> None:
        """Demand ``measured >= bound``; NaN never is."""
        self.demand(what, number(measured), f">= {number(bound)}", measured >= bound)

    def none(self, what: str, count: int) -> None:
        """Demand that there is nothing of the kind."""
        self.demand(what, str(count), "none", count == 0)

    def demand(self, what: str, measured: str, wanted: str, holds: bool) -> None:
        """Keep a finding, and fail where it does not hold."""
        finding = Finding(what, measured, wanted, bool(holds))
        self._properties.append((PROPERTY, asdict(finding)))
        assert finding.holds, f"{what}: {measured}, wanted {wanted}"

    def tell(self, what: str, measured: float | str) -> None:
        """Keep a number that nothing is demanded of."""
        text = measured if isinstance(measured, str) else number(measured)
        self._properties.append((PROPERTY, asdict(Finding(what, text))))


def number(value: float) -> str:
    """A number in few digits, the same way in every table."""
    if math.isfinite(value) and value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.4g}"


def stress_number(path: Path | str) -> int:
    """The S-number of a test file: 9 of ``test_s09_refresh.py``."""
    found = re.match(r"test_s(\d+)", Path(path).name)
    assert found is not None, f"{path} does not name its stress test"
    return int(found[1])
