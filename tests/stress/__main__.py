"""``./dev stress``: the front end on bad, odd and huge input, for as long as one likes.

First every written case, then real shaders that are damaged at random until the time is up. Real
ones are those of the tests, and the public ones where ``./dev corpus`` has fetched them. Exit
status 1 if anything is wrong; ``out/stress`` then has the texts.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from .cases import written_cases
from .suite import ROOT, random_rounds, run_apart
from .trial import Result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev stress", description=__doc__)
    parser.add_argument("--seconds", type=float, default=300.0, help="for the random cases")
    parser.add_argument("--seed", type=int, default=int(time.time()), help="of the random cases")
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
    return int(bool(wrong))


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
