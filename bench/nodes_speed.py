"""How long ``shadercache nodes --json`` takes on large shaders, and how much it prints.

The shader is ``shaders/field.frag`` with more and more parts, on twenty call paths each: the
largest has 21 KB and 76,000 nodes. Time is that of the processor for the whole command, beside it
the share of the analysis; time and characters for a node should stay as they are. Part of
``./dev bench-emit``.
"""

from __future__ import annotations

import re
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from shadercache.cli.tables import format_table
from shadercache.compiler import analyse
from shadercache.source import Source

TEMPLATE = Path(__file__).with_name("shaders") / "field.frag"
PARTS = 16, 32, 64

SECONDS, MEGABYTES = 5.0, 20.0
"""What is aimed at for the largest."""

_REPEATED = re.compile(r"^float part_0.*?^\}\n\n|^    d = min.*?\n", re.MULTILINE | re.DOTALL)

Sample = dict[str, Any]


def field_of(parts: int) -> Source:
    """The template with so many parts."""

    def repeated(match: re.Match[str]) -> str:
        return "".join(match[0].replace("part_0", f"part_{number}") for number in range(parts))

    text = _REPEATED.sub(repeated, TEMPLATE.read_text(encoding="utf-8"))
    return Source(f"field of {parts}", text)


def listing(rounds: int) -> list[Sample]:
    """Seconds and characters for each size: the least of some rounds."""
    return [_least([_listed(field_of(parts)) for _ in range(rounds)]) for parts in PARTS]


def _least(samples: Sequence[Sample]) -> Sample:
    return {name: min(sample[name] for sample in samples) for name in samples[0]}


def _listed(source: Source) -> Sample:
    begin = time.process_time()
    nodes = len(analyse(source).nodes)
    analysing = time.process_time() - begin
    every, characters = _run(source)
    offered, _ = _run(source, "--offered")
    return {
        "characters": len(source.text),
        "nodes": nodes,
        "analyse": analysing,
        "seconds": every,
        "seconds of --offered": offered,
        "printed": characters,
    }


def _run(source: Source, *options: str) -> tuple[float, int]:
    """Seconds of processor time of one command line, and the characters that it prints."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "field.frag"
        path.write_text(source.text, encoding="utf-8")
        line = [sys.executable, "-m", "shadercache", "nodes", "--json", *options, str(path)]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(line, capture_output=True, text=True, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return used, len(done.stdout)


def listing_table(rows: Sequence[Sample]) -> str:
    """Seconds, megabytes, and both for a node."""
    head = ("shader KB", "nodes", "analyse s", "all s", "--offered s", "us/node", "MB", "B/node")
    lines = []
    for row in rows:
        nodes, seconds, printed = row["nodes"], row["seconds"], row["printed"]
        lines.append(
            (
                f"{row['characters'] / 1e3:.1f}",
                str(nodes),
                *(f"{row[name]:.2f}" for name in ("analyse", "seconds", "seconds of --offered")),
                f"{1e6 * seconds / nodes:.0f}",
                f"{printed / 1e6:.1f}",
                f"{printed / nodes:.0f}",
            )
        )
    return format_table(head, lines, right=" ".join(head))


def listing_targets(rows: Sequence[Sample]) -> list[tuple[str, float, float]]:
    """Name, value and limit of what is aimed at."""
    last = rows[-1]
    return [
        ("nodes --json, 76,000 nodes, processor s", last["seconds"], SECONDS),
        ("nodes --json, 76,000 nodes, MB", last["printed"] / 1e6, MEGABYTES),
    ]
