"""How many programs of a tutorial have a best value that is rewritten and exact.

Each fragment shader of a folder is analysed with its vertex shader; the value that saves most is
rewritten, drawn and verified in proof mode (laws 2 to 4 and 7); see ``docs/use/acceptance.md``.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from bench.tutorials.mesh import write_ring, write_sheet
from bench.tutorials.programs import Program, programs_of
from bench.tutorials.trial import (
    BROKEN,
    EXACT,
    INVALID,
    LEFT_OUT,
    NOTHING,
    REFUSED,
    TOOL,
    Outcome,
    attempt,
)
from shadercache import processes
from shadercache.gpu.context import open_context
from shadercache.measure.result_files import environment, write_json
from shadercache.processes import LostTaskError

KINDS = (EXACT, BROKEN, REFUSED, NOTHING, LEFT_OUT, INVALID)
CRASHED = "the process that drew it died, twice: the driver crashes"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 1 where a law is broken, 3 where glslang is not there."""
    parser = argparse.ArgumentParser(prog="python -m bench.tutorials", description=__doc__)
    add = parser.add_argument
    add("collection", type=Path, metavar="FOLDER", help="with the shaders")
    add("-o", "--output", type=Path, required=True, metavar="FILE", help="the result, JSON")
    add("--resume", action="store_true", help="keep what FILE has")
    add("--only", metavar="TEXT", help="programs with this in their names")
    add("--before", default="", metavar="TEXT", help="what the host puts before shaders")
    add("--work", type=Path, default=Path("out/tutorials/work"), metavar="DIR")
    options = parser.parse_args(arguments)
    if not options.collection.is_dir():
        parser.error(f"{options.collection}: there is no such folder")
    if shutil.which(TOOL) is None:
        print(f"tutorials: {TOOL} is not installed (glslang-tools)", file=sys.stderr)
        return 3
    with open_context() as gpu:
        where = environment(gpu)
    kept = _kept(options.output) if options.resume else {}
    programs = [
        _hosted(one, options.before)
        for one in programs_of(options.collection)
        if (options.only or "") in one.name
    ]
    for outcome in _outcomes(programs, kept, options.work.resolve()):
        kept[outcome.name] = outcome
        print(f"{outcome.kind:20}{outcome.name}", *outcome.told[:2], sep="  ", file=sys.stderr)
        rows = [kept[one.name] for one in programs if one.name in kept]
        write_json(options.output, _report(where, rows))
    rows = [kept[one.name] for one in programs]
    write_json(options.output, _report(where, rows))
    print(summary(rows))
    return int(any(row.kind == BROKEN for row in rows))


def _hosted(program: Program, before: str) -> Program:
    vertex = None if program.vertex is None else before + program.vertex
    return replace(program, fragment=before + program.fragment, vertex=vertex)


def _kept(path: Path) -> dict[str, Outcome]:
    if not path.is_file():
        return {}
    rows = json.loads(path.read_text())["programs"]
    return {row["name"]: Outcome(**{**row, "told": tuple(row["told"])}) for row in rows}


def _outcomes(
    programs: Sequence[Program], kept: dict[str, Outcome], work: Path
) -> Iterator[Outcome]:
    """Those that are not known, one after another in a process that may die."""
    work.mkdir(parents=True, exist_ok=True)
    models = work / "ring.glb", work / "sheet.glb"
    write_ring(models[0])
    write_sheet(models[1])
    left = [program for program in programs if program.name not in kept]
    tasks = [(one, work / f"{at:03}", models) for at, one in enumerate(left)]
    for at, found in processes.spread(1, attempt, tasks):
        if isinstance(found, LostTaskError):
            found = Outcome(left[at].name, BROKEN, left[at].also, told=(CRASHED,))
        yield found


def figures(rows: Sequence[Outcome]) -> dict[str, Any]:
    """How many programs came to what, and the shares that are exact."""
    kinds = Counter(row.kind for row in rows)
    tried = [row for row in rows if row.kind in (EXACT, BROKEN, REFUSED)]
    # What is refused as a whole has no value that could be dear.
    worth = [row for row in tried if row.offered or not row.node]
    taken = [row for row in rows if row in tried or row.kind == NOTHING]
    groups = {
        "that glslang takes": taken,
        "with a value that may be cached": tried,
        "with one that is dearer than a fetch": worth,
    }
    found: dict[str, Any] = {kind: kinds[kind] for kind in KINDS}
    for words, group in groups.items():
        found[words] = len(group)
        share = sum(row.kind == EXACT for row in group) / len(group) if group else None
        found[f"exact, of those {words}"] = share
    return {**found, "more with the same texts": sum(row.also for row in rows)}


def _report(where: dict[str, Any], rows: Sequence[Outcome]) -> dict[str, Any]:
    return {
        "schema_version": 1,
        "environment": where,
        "figures": figures(rows),
        "told": _told(rows),
        "programs": [asdict(row) for row in rows],
    }


def _told(rows: Sequence[Outcome]) -> dict[str, dict[str, list[str]]]:
    """By outcome and by what is told first, the programs."""
    groups: dict[str, dict[str, list[str]]] = {}
    for row in rows:
        if row.told:
            groups.setdefault(row.kind, {}).setdefault(row.told[0], []).append(row.name)
    return groups


def summary(rows: Sequence[Outcome]) -> str:
    """The figures, and what is told of all that is not exact."""
    lines = [
        f"{key}: {f'{value:.2%}' if isinstance(value, float) else value}"
        for key, value in figures(rows).items()
    ]
    for kind, told in _told(rows).items():
        lines += ["", kind]
        lines += [f"  {len(names)} x {words}" for words, names in told.items()]
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
