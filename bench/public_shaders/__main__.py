"""``./dev corpus``: measure acceptance on public shaders; see the package's description."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from bench.public_shaders.acceptance import read_all
from bench.public_shaders.collection import Shader
from bench.public_shaders.glslang import Judge
from bench.public_shaders.packages import FetchError
from bench.public_shaders.report import Row, failures, failures_text, figures, table, to_json
from bench.public_shaders.sources import COLLECTIONS, piglit_shaders

ROOT = Path(__file__).resolve().parent.parent.parent


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 3 where packages or tools cannot be had."""
    options = _options(arguments)
    folder: Path = options.folder.resolve()
    rows: dict[str, list[Row]] = {}
    try:
        judge = Judge(folder / "shaders", folder / "verdicts.json")
        for name in options.collections or COLLECTIONS:
            begin = time.monotonic()
            rows[name] = _measure(name, folder, judge, options)
            _say(f"{name}: {len(rows[name])} shaders in {time.monotonic() - begin:.0f} s")
    except FetchError as error:
        _say(str(error))
        return 3
    counts = {name: figures(found) for name, found in rows.items()}
    print(table(counts))
    texts = [
        failures_text(name, failures(found), str(folder / "shaders"))
        for name, found in rows.items()
    ]
    options.failures.write_text(f"```\n{table(counts)}\n```\n\n" + "\n".join(texts))
    options.json.write_text(json.dumps(to_json(rows), indent=1) + "\n")
    print(f"\nfailures: {options.failures}\nresult: {options.json}")
    return 0


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev corpus", description=__doc__)
    parser.add_argument("collections", nargs="*", metavar="COLLECTION", help="; ".join(COLLECTIONS))
    parser.add_argument("--all", action="store_true", help="every shader of piglit's families")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--folder", type=Path, default=ROOT / "out" / "public", metavar="DIR")
    parser.add_argument("--failures", type=Path, metavar="FILE", help="the list of failures")
    parser.add_argument("--json", type=Path, metavar="FILE", help="the result")
    options = parser.parse_args(arguments)
    for name in options.collections:
        if name not in COLLECTIONS:
            parser.error(f"no collection '{name}'; there are {', '.join(COLLECTIONS)}")
    options.failures = options.failures or options.folder / "failures.md"
    options.json = options.json or options.folder / "result.json"
    return options


def _measure(name: str, folder: Path, judge: Judge, options: argparse.Namespace) -> list[Row]:
    whole = name == "piglit" and options.all
    shaders = piglit_shaders(folder, None) if whole else COLLECTIONS[name](folder)
    verdicts = judge.judge(shaders)
    outcomes = read_all(shaders, options.jobs)
    printed = {
        shader.key: Shader(f"printed/{shader.name}", shader.stage, outcome.printed)
        for shader, outcome, verdict in zip(shaders, outcomes, verdicts, strict=True)
        if verdict.accepted and outcome.printed is not None
    }
    reread = dict(zip(printed, judge.judge(list(printed.values())), strict=True))
    return [
        Row(shader, verdict, replace(outcome, printed=None), reread.get(shader.key))
        for shader, verdict, outcome in zip(shaders, verdicts, outcomes, strict=True)
    ]


def _say(message: str) -> None:
    print(f"corpus: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
