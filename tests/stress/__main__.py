"""``./dev stress``: the numerical stress tests S1 to S20, and on request shaders nobody writes.

The numerical tests are run in their long form and printed with what each demands and measured; all
of them write ``bench/results/<machine>/stress-numerics.json``.

``--shaders``: the front end on bad, odd and huge input, for as long as one likes. First every
written case, then real shaders that are damaged at random until the time is up. Real ones are those
of the tests, and the public ones where ``./dev corpus`` has fetched them. Last, shaders that are
generated: the laws on nodes of each, in batches that can be gone on with (``--resume`` with the
same ``--seed``); what occurred is written to ``bench/results/<machine>/generated.json`` when all
are done. ``out/stress`` and ``out/generated`` then have the texts.

Exit status 1 if anything is wrong.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from shadercache.gpu.context import open_context
from shadercache.measure.result_files import environment, machine_name, write_json
from tests.generated.many import Record, batches, try_many
from tests.generated.rules import MOST, RULES, shaders_until
from tests.generated.suite import Coverage

from .cases import written_cases
from .numerics.suite import run_numerics
from .suite import ROOT, random_rounds, run_apart
from .trial import Result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev stress", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="S9", help="only these numerical tests")
    parser.add_argument("--short", action="store_true", help="their short form, as ./dev test")
    parser.add_argument("--shaders", action="store_true", help="damaged and generated ones instead")
    parser.add_argument("--seconds", type=float, default=300.0, help="for the random cases")
    parser.add_argument("--seed", type=int, default=int(time.time()), help="of the random cases")
    parser.add_argument("--only", metavar="TEXT", help="the written cases with TEXT in their name")
    parser.add_argument("--generated", type=int, default=2000, metavar="N", help="shaders to make")
    parser.add_argument("--only-generated", action="store_true", help="nothing but these")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--resume", action="store_true", help="go on with --seed where it ended")
    parser.add_argument("--limit", type=int, metavar="N", help="at most so many batches now")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "out" / "stress")
    parser.add_argument("--results", type=Path, metavar="DIR", help="for results")
    parser.add_argument("--rules", action="store_true", help="break rules: how many shaders notice")
    options = parser.parse_args(arguments)
    if options.rules:
        return _rules(options)
    if not (options.shaders or options.only_generated or options.only is not None):
        return run_numerics(options.names, not options.short, options.results)
    wrong = [] if options.only_generated else _cases(options)
    broken = 0 if options.only is not None else _generated(options)
    return int(bool(wrong or broken))


def _rules(options: argparse.Namespace) -> int:
    """Break each rule and count the shaders until one notices; how many rules none notices."""
    missed = 0
    with open_context() as gpu:
        for rule in RULES:
            found = shaders_until(gpu, rule, options.seed)
            missed += found is None
            count = f"shader {found[0]}" if found else f"none of {MOST} shaders"
            print(f"{rule.name}: {count} (seed {options.seed})", flush=True)
    return missed


def _cases(options: argparse.Namespace) -> list[Result]:
    """Try the written cases and the random ones; what went wrong."""
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
    return wrong


def _generated(options: argparse.Namespace) -> int:
    """Try generated shaders, print what occurred; how many batches found something broken."""
    record = Record(options.seed, options.resume)
    every = batches(options.generated, options.seed)
    todo = [batch for batch in every if not record.holds(batch)][: options.limit]
    print(f"generated shaders: {len(todo)} batches, seed {options.seed}", flush=True)
    broken = 0
    for number, (batch, seen, problem) in enumerate(try_many(todo, options.jobs), start=1):
        about = f"{seen.shaders.total()} shaders, {seen.nodes} nodes"
        print(f"{number} of {len(todo)} ({batch}): {about}", flush=True)
        if problem:
            broken += 1
            print(problem, flush=True)
        else:
            record.add(batch, seen)
    total = record.total()
    print(total.table())
    print(f"{broken} batches broke a law (seed {options.seed})")
    if all(record.holds(batch) for batch in every):
        _keep(total, options)
    return broken


def _keep(total: Coverage, options: argparse.Namespace) -> None:
    """Write what all batches have seen."""
    with open_context() as gpu:
        about = environment(gpu)
    folder = options.results or ROOT / "bench" / "results" / machine_name(about)
    head = {"schema_version": 1, "environment": about, "seed": options.seed}
    write_json(folder / "generated.json", head | total.to_json())


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
