"""``./dev corpus``: measure acceptance on public shaders; see the package's description."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from bench.public_shaders.drawing import ROOT, draw_all
from bench.public_shaders.judge import TOOL, judge
from bench.public_shaders.reading import read_all
from bench.public_shaders.report import Row, figures, table, to_json
from bench.public_shaders.shaders import Shader, evenly, evenly_by_folder, folder_shaders
from bench.public_shaders.typing import compare_types

COLLECTIONS = ("three", "gl-transitions", "piglit")
FAMILY_LIMIT = 40
"""Shaders taken from one folder of piglit, whose generated families have thousands alike."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 3 where packages or tools cannot be had."""
    options = _options(arguments)
    if shutil.which(TOOL) is None:
        _say(f"{TOOL} is the judge, and it is not installed (glslang-tools)")
        return 3
    rows: dict[str, list[Row]] = {}
    try:
        for name, shaders in _collections(options):
            begin = time.monotonic()
            rows[name] = _measure(evenly(shaders, options.limit), options)
            _say(f"{name}: {len(rows[name])} shaders in {time.monotonic() - begin:.0f} s")
    except subprocess.CalledProcessError as error:
        _say(f"{error.cmd[-1]} cannot be fetched: its tool's words are above")
        return 3
    print(table({name: figures(found) for name, found in rows.items()}))
    result = options.folder / "result.json"
    result.write_text(json.dumps({name: to_json(f) for name, f in rows.items()}, indent=1) + "\n")
    print(f"\nfigures and failures: {result}\nthe shaders: {options.folder / 'shaders'}")
    return 0


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev corpus", description=__doc__)
    add = parser.add_argument
    add("collections", nargs="*", metavar="COLLECTION", help="; ".join(COLLECTIONS))
    add("-s", "--shaders", type=Path, action="append", default=[], help="measure this folder")
    add("-I", "--include", type=Path, action="append", default=[], help="where #include looks too")
    add("--limit", type=int, metavar="N", help="N shaders of each, evenly spread")
    add("--all", action="store_true", help="every shader of piglit's families")
    add("--no-render", dest="render", action="store_false", help="draw nothing")
    add("-j", "--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    add("--folder", type=Path, default=ROOT / "out" / "public", metavar="DIR")
    options = parser.parse_args(arguments)
    options.folder = options.folder.resolve()
    for name in options.collections:
        if name not in COLLECTIONS:
            parser.error(f"no collection '{name}'; there are {', '.join(COLLECTIONS)}")
    for folder in (*options.shaders, *options.include):
        if not folder.is_dir():
            parser.error(f"{folder}: there is no such folder")
    return options


def _collections(options: argparse.Namespace) -> Iterator[tuple[str, list[Shader]]]:
    """What is asked for by name: all packages, where neither they nor folders are named."""
    packages = options.folder / "packages"
    for name in options.collections or (() if options.shaders else COLLECTIONS):
        fetch = [Path(__file__).parent / "fetch.sh", packages, name]
        subprocess.run(fetch, check=True, stdout=sys.stderr)
        found = folder_shaders(packages / name)
        limited = name == "piglit" and not options.all
        yield name, evenly_by_folder(found, FAMILY_LIMIT if limited else None)
    for folder in options.shaders:
        yield folder.resolve().name, folder_shaders(folder, options.include)


def _measure(shaders: list[Shader], options: argparse.Namespace) -> list[Row]:
    folder = options.folder / "shaders"
    verdicts = judge(shaders, folder)
    outcomes = read_all(shaders, options.jobs)
    taken = {
        shader: Shader(f"printed/{shader.name}", shader.stage, outcome.printed)
        for shader, outcome, verdict in zip(shaders, outcomes, verdicts, strict=True)
        if verdict.accepted and outcome.printed is not None
    }
    reread = dict(zip(taken, judge(list(taken.values()), folder), strict=True))
    typing = dict(zip(taken, compare_types(list(taken), folder, options.jobs), strict=True))
    drawn = [shader for shader in taken if shader.stage == "fragment" and options.render]
    pairs = [(shader, taken[shader].text) for shader in drawn]
    pictures = dict(zip(drawn, draw_all(pairs, options.jobs), strict=True))
    return [
        Row(
            shader,
            verdict,
            replace(outcome, printed=None),
            typing.get(shader, ""),
            reread.get(shader),
            pictures.get(shader),
        )
        for shader, verdict, outcome in zip(shaders, verdicts, outcomes, strict=True)
    ]


def _say(message: str) -> None:
    print(f"corpus: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
