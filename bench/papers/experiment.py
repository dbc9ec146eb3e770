"""What an experiment is: how it measures, what it concludes, and how it shows both.

Measuring is apart from judging. A stored measurement is judged and drawn again when a rule changes,
and the tests judge made-up measurements.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from bench.papers.claims import Verdict
from shadercache.gpu.context import Gpu

Data = TypeVar("Data")


@dataclass(frozen=True, slots=True)
class Options:
    """How large, and how thoroughly.

    ``size``: edge of the picture in pixels. ``quick``: few frames and few nodes, enough to see that
    everything runs; its numbers mean little.
    """

    size: int = 512
    quick: bool = False

    def frames(self, wanted: int) -> int:
        """How many frames an experiment draws that wants so many."""
        return min(wanted, 10) if self.quick else wanted

    def seconds(self, most: float) -> float:
        """How long an experiment may repeat its frames that may do so for so long."""
        return 0.0 if self.quick else most

    def some(self, things: Sequence[Data], quick: int = 4) -> Sequence[Data]:
        """All of them; of a quick run a few, from the first to the last."""
        if not self.quick or len(things) <= quick:
            return things
        last = len(things) - 1
        return [things[number * last // (quick - 1)] for number in range(quick)]


@dataclass(frozen=True, slots=True)
class Experiment(Generic[Data]):
    """One figure of a paper, or one claim.

    ``kind`` is the type of what ``gather`` measures: dataclasses of plain values, which can be
    stored as JSON. ``gather`` is told what to call with (steps done, steps in all). ``draw`` gives
    PNG files by name.
    """

    name: str
    title: str
    kind: type[Data]
    gather: Callable[[Gpu, Options, Callable[[int, int], None]], Data]
    judge: Callable[[Data], Sequence[Verdict]]
    table: Callable[[Data], str]
    draw: Callable[[Data], Mapping[str, bytes]]

    @property
    def command(self) -> str:
        """What prints its table and verdicts."""
        return f"./dev papers --only {self.name}"
