"""How long ``shadercache nodes --json`` takes on large shaders, and how much it prints.

The shader is ``shaders/field.frag`` with more and more parts, on twenty call paths each: the
largest has 21 KB and 76,000 nodes. Time is that of the processor for the whole command, beside it
the share of the analysis; time and characters for a node should stay as they are. Part of
``./dev bench-emit``.
"""

from __future__ import annotations

import re
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from bench.speed import HERE, Sample, child_seconds, target
from shadercache.cli.tables import format_table
from shadercache.compiler import analyse
from shadercache.source import Source

TEMPLATE = HERE / "shaders" / "field.frag"
PARTS = 16, 32, 64

_REPEATED = re.compile(r"^float part_0.*?^\}\n\n|^    d = min.*?\n", re.MULTILINE | re.DOTALL)


def field_of(parts: int) -> Source:
    """The template with so many parts."""

    def repeated(match: re.Match[str]) -> str:
        return "".join(match[0].replace("part_0", f"part_{number}") for number in range(parts))

    text = _REPEATED.sub(repeated, TEMPLATE.read_text(encoding="utf-8"))
    return Source(f"field of {parts}", text)


def listing(rounds: int) -> list[Sample]:
    """Seconds and characters for each size: the least of some rounds."""
    rows = []
    for source in map(field_of, PARTS):
        samples = [_listed(source) for _ in range(rounds)]
        rows.append({name: min(sample[name] for sample in samples) for name in samples[0]})
    return rows


def _listed(source: Source) -> Sample:
    begin = time.process_time()
    nodes = len(analyse(source).nodes)
    analysing = time.process_time() - begin
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "field.frag"
        path.write_text(source.text, encoding="utf-8")
        command = [sys.executable, "-m", "shadercache", "nodes", "--json", str(path)]
        every, printed = child_seconds(command, check=True)
        offered, _ = child_seconds([*command, "--offered"], check=True)
    return {
        "characters": len(source.text),
        "nodes": nodes,
        "analyse": analysing,
        "seconds": every,
        "seconds of --offered": offered,
        "printed": len(printed),
    }


def listing_table(rows: Sequence[Sample]) -> str:
    """Seconds, megabytes, and both for a node."""
    head = ("shader KB", "nodes", "analyse s", "all s", "--offered s", "us/node", "MB", "B/node")
    lines = [
        (
            f"{row['characters'] / 1e3:.1f}",
            str(row["nodes"]),
            *(f"{row[name]:.2f}" for name in ("analyse", "seconds", "seconds of --offered")),
            f"{1e6 * row['seconds'] / row['nodes']:.0f}",
            f"{row['printed'] / 1e6:.1f}",
            f"{row['printed'] / row['nodes']:.0f}",
        )
        for row in rows
    ]
    return format_table(head, lines, right=" ".join(head))


def listing_targets(rows: Sequence[Sample]) -> list[Sample]:
    """What is aimed at for the largest."""
    largest = rows[-1]
    return [
        target("nodes --json, 76,000 nodes, processor s", largest["seconds"], 5.0),
        target("nodes --json, 76,000 nodes, MB", largest["printed"] / 1e6, 20.0),
    ]
