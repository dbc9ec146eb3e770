"""``./dev stress``: the front end on bad, odd and huge input, for as long as one likes.

First every written case, then real shaders that are damaged at random until the time is up. Real
ones are those of the tests, and the public ones where ``./dev corpus`` has fetched them. Exit
status 1 if anything is wrong; ``out/stress`` then has the texts.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import random
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from .cases import Case, damaged, random_bytes, random_words, written_cases
from .trial import Result, limit_memory, try_case

ROOT = Path(__file__).resolve().parent.parent.parent
ROUND = 50
"""Random cases that one child process reads: what a text leaves behind in memory is found so."""


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


def random_rounds(seed: int, seconds: float) -> Iterator[list[Case]]:
    """Lists of random cases until the time is up."""
    pick = random.Random(seed)
    shaders = real_shaders()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        yield [random_case(pick, shaders) for _ in range(ROUND)]


def random_case(pick: random.Random, shaders: Sequence[Path]) -> Case:
    """A case by chance: damage is the most telling, so it is the most frequent."""
    match pick.randrange(10):
        case 0:
            return random_bytes(pick)
        case 1:
            return random_words(pick, pick.choice(shaders))
        case _:
            return damaged(pick, pick.choice(shaders))


def real_shaders() -> list[Path]:
    """The shaders that may be damaged, always in the same order."""
    folders = [ROOT / "corpus", ROOT / "tests" / "front", ROOT / "out" / "public" / "shaders"]
    paths = [path for folder in folders for path in folder.rglob("*.[fv][re][ar][gt]")]
    return sorted(path for path in paths if "printed" not in path.parts)


def run_apart(cases: Sequence[Case]) -> list[Result]:
    """Try cases in a child process, which may be killed by its limits or crash."""
    largest = max(len(case.text) + sum(map(len, case.files.values())) for case in cases)
    receive, send = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.Process(target=_child, args=(cases, largest, send))
    child.start()
    send.close()
    results: list[Result] = []
    try:
        while len(results) < len(cases):
            results.append(receive.recv())
    except EOFError:
        child.join()
        case = cases[len(results)]
        results.append(Result(case, 0.0, "died", f"the process died, status {child.exitcode}"))
        rest = cases[len(results) :]
        return results + (run_apart(rest) if rest else [])
    child.join()
    return results


def _child(
    cases: Sequence[Case], largest: int, send: multiprocessing.connection.Connection
) -> None:
    os.environ["PYTHONFAULTHANDLER"] = ""
    limit_memory(largest)
    for case in cases:
        send.send(try_case(case))


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
