"""``./dev stress``: the front end on bad, odd and huge input, for as long as one likes.

First every written case, then real shaders that are damaged at random until the time is up. Real
ones are those of the tests, and the public ones where ``./dev corpus`` has fetched them. Last,
shaders that are generated: the laws on nodes of each. Exit status 1 if anything is wrong;
``out/stress`` and ``out/generated`` then have the texts.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from tests.generated.many import try_many
from tests.generated.suite import Coverage

from .cases import written_cases
from .suite import ROOT, random_rounds, run_apart
from .trial import Result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev stress", description=__doc__)
    parser.add_argument("--seconds", type=float, default=300.0, help="for the random cases")
    parser.add_argument("--seed", type=int, default=int(time.time()), help="of the random cases")
    parser.add_argument("--generated", type=int, default=2000, help="shaders to generate")
    parser.add_argument("--only", metavar="TEXT", help="the written cases with TEXT in their name")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "out" / "stress")
    options = parser.parse_args(arguments)
    wrong: list[Result] = []
    count = 0
    for case in written_cases():
        if options.only is None or options.only in case.name:
            count += 1
            wrong += _told(run_apart([case]))
    if options.only is None:
        for cases in random_rounds(options.seed, options.seconds):
            count += len(cases)
            wrong += _told(run_apart(cases))
    _save(wrong, options.output)
    print(f"{count} cases, {len(wrong)} went wrong (seed {options.seed})")
    broken = 0 if options.only is not None else _generated(options.generated, options.seed)
    return int(bool(wrong or broken))


def _generated(count: int, seed: int) -> int:
    """Try generated shaders, print what occurred; how many seeds found something broken."""
    coverage, broken = Coverage(), 0
    for seen, problem in try_many(count, seed):
        coverage.merge(seen)
        if problem:
            broken += 1
            print(problem, flush=True)
    print(coverage.table())
    print(f"{broken} batches broke a law (seed {seed})")
    return broken


def _told(results: Sequence[Result]) -> list[Result]:
    wrong = [result for result in results if result.wrong]
    for result in wrong:
        print(f"{result.case.name}: {result.wrong}", flush=True)
    return wrong


def _save(wrong: Sequence[Result], folder: Path) -> None:
    for number, result in enumerate(wrong):
        suffix = ".vert" if result.case.stage == "vertex" else ".frag"
        folder.mkdir(parents=True, exist_ok=True)
        data = result.case.text.encode("utf-8", "surrogatepass")
        (folder / f"{number:03}{suffix}").write_bytes(data)
    if wrong:
        lines = [
            f"{number:03}  {result.seconds:6.1f} s  {result.case.name}: {result.wrong}"
            for number, result in enumerate(wrong)
        ]
        (folder / "wrong.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
        print(f"their texts: {folder}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())
