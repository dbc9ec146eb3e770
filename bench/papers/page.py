"""The page of all claims: ``docs/PAPERS.md``."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from bench.papers.claims import CLAIMS, ELSEWHERE, NOT_BUILT, Claim, Verdict
from bench.papers.result import Result
from bench.speed import HERE
from shadercache.files import write_bytes

QUICK = (
    "> **From a quick run.** Pictures are small, frames and nodes few: the table shows what is "
    "measured, and its numbers mean nothing. `./dev papers` makes the page that counts.\n"
)


INTRODUCTION = """\
`./dev papers` makes this page. Each claim has a verdict for the renderer named below. *Not decided*
means that intervals are too wide, or that something is missing. T2, T5, T9 to T11 and T15 are facts
about hardware, and need not hold on another renderer. The rules of the verdicts stand beside the
experiments in `bench/papers/`, and were written before these measurements. A difference inside a
95 % interval counts as none. Look-ups are bilinear and blocks are refreshed by a hash, as in the
papers; that is not what `shadercache` does by default.
"""


def write_page(path: Path, results: Sequence[Result], folder: Path) -> None:
    """Write the page; ``folder`` holds the plots. Raises :class:`UsageError` SC025."""
    write_bytes(path, page_text(path, results, folder).encode())


def page_text(path: Path, results: Sequence[Result], folder: Path) -> str:
    """The page as Markdown."""
    quick = any(result.options.quick for result in results)
    # The plots of a run that is not kept are not there for other readers.
    kept = folder.resolve().is_relative_to(HERE)
    parts = [
        "# What the papers claim, and what was measured\n",
        INTRODUCTION,
        *([QUICK] if quick else []),
        "\n".join(_about(results)) + "\n",
        "\n".join(_claims(results)) + "\n",
        "## Tested by other commands\n",
        "\n".join(_elsewhere()) + "\n",
        "## Not built yet\n",
        "\n".join(_not_built()) + "\n",
    ]
    if kept and not quick:
        parts += ["## Plots\n", "\n".join(_plots(path, results, folder))]
    return "\n".join(parts)


def _about(results: Sequence[Result]) -> Iterator[str]:
    yield "| experiment | measured | renderer | picture | seconds |"
    yield "|---|---|---|---|---|"
    for result in results:
        about, size = result.about, result.options.size
        machine = f"{about['gl']['renderer']}, {about['gl']['version']}, {about['cores']} cores"
        name = f"{result.experiment.name}: {result.experiment.title}"
        date = about["date"][:10]
        yield f"| {name} | {date} | {machine} | {size} x {size} | {result.seconds:.0f} |"


def _claims(results: Sequence[Result]) -> Iterator[str]:
    found = {verdict.claim: (verdict, result) for result in results for verdict in result.verdicts}
    yield "| claim | verdict | measured | command |"
    yield "|---|---|---|---|"
    for claim in CLAIMS.values():
        said = f"**{claim.id}** {claim.sentence} ({_source(claim)})"
        cells = _cells(*found[claim.id]) if claim.id in found else "not measured | |"
        yield f"| {said} | {cells} |"


def _cells(verdict: Verdict, result: Result) -> str:
    word = f"quick run: {verdict.word}" if result.options.quick else f"**{verdict.word}**"
    return f"{word} | {verdict.numbers} | `{result.experiment.command}`"


def _source(claim: Claim) -> str:
    return f"{claim.paper}, {claim.section}"


def _elsewhere() -> Iterator[str]:
    yield "| claim | command |"
    yield "|---|---|"
    for claim, command in ELSEWHERE:
        yield f"| {claim.sentence} ({_source(claim)}) | `{command}` |"


def _not_built() -> Iterator[str]:
    yield from (f"* {claim.sentence} ({_source(claim)})" for claim in NOT_BUILT)


def _plots(path: Path, results: Sequence[Result], folder: Path) -> Iterator[str]:
    for result in results:
        for name in result.experiment.draw(result.data):
            place = os.path.relpath(folder / f"{name}.png", path.parent)
            yield f"![{result.experiment.title}]({place})\n"
