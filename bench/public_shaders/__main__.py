"""``./dev corpus``: measure acceptance on public shaders; see the package's description."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from bench.public_shaders.acceptance import read_all
from bench.public_shaders.collection import Shader, evenly
from bench.public_shaders.folder import folder_shaders
from bench.public_shaders.glslang import Judge
from bench.public_shaders.packages import FetchError
from bench.public_shaders.rendering import Picture, render_all
from bench.public_shaders.report import Row, failures, failures_text, figures, table, to_json
from bench.public_shaders.sources import COLLECTIONS, piglit_shaders
from bench.public_shaders.typing import compare_types

ROOT = Path(__file__).resolve().parent.parent.parent


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 3 where packages or tools cannot be had."""
    options = _options(arguments)
    folder: Path = options.folder
    rows: dict[str, list[Row]] = {}
    try:
        judge = Judge(folder / "shaders", folder / "verdicts.json")
        for name, find in _collections(options).items():
            begin = time.monotonic()
            rows[name] = _measure(evenly(find(), options.limit), judge, options)
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


_SHADERS = "measure the shaders in this folder; may be given several times"
_INCLUDE = "where --shaders looks for included files, beside the file apart"


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev corpus", description=__doc__)
    parser.add_argument("collections", nargs="*", metavar="COLLECTION", help="; ".join(COLLECTIONS))
    add = parser.add_argument
    add("-s", "--shaders", type=Path, action="append", default=[], metavar="DIR", help=_SHADERS)
    add("-I", "--include", type=Path, action="append", default=[], metavar="DIR", help=_INCLUDE)
    add("--limit", type=int, metavar="N", help="N shaders of each, evenly spread")
    add("--all", action="store_true", help="every shader of piglit's families")
    add("--no-render", dest="render", action="store_false", help="draw nothing")
    add("-j", "--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    add("--folder", type=Path, default=ROOT / "out" / "public", metavar="DIR")
    add("--failures", type=Path, metavar="FILE", help="the list of failures")
    add("--json", type=Path, metavar="FILE", help="the result")
    options = parser.parse_args(arguments)
    options.folder = options.folder.resolve()
    for name in options.collections:
        if name not in COLLECTIONS:
            parser.error(f"no collection '{name}'; there are {', '.join(COLLECTIONS)}")
    for folder in (*options.shaders, *options.include):
        if not folder.is_dir():
            parser.error(f"{folder}: there is no such folder")
    options.failures = options.failures or options.folder / "failures.md"
    options.json = options.json or options.folder / "result.json"
    return options


def _collections(options: argparse.Namespace) -> dict[str, Callable[[], list[Shader]]]:
    """What is asked for by name: all packages, where neither they nor folders are named."""
    names = options.collections or (() if options.shaders else COLLECTIONS)
    found: dict[str, Callable[[], list[Shader]]] = {
        name: partial(COLLECTIONS[name], options.folder) for name in names
    }
    if options.all and "piglit" in found:
        found["piglit"] = partial(piglit_shaders, options.folder, None)
    for folder in options.shaders:
        found[folder.resolve().name] = partial(folder_shaders, folder, options.include)
    return found


def _measure(shaders: list[Shader], judge: Judge, options: argparse.Namespace) -> list[Row]:
    verdicts = judge.judge(shaders)
    outcomes = read_all(shaders, options.jobs)
    printed = {
        shader.key: Shader(f"printed/{shader.name}", shader.stage, outcome.printed)
        for shader, outcome, verdict in zip(shaders, outcomes, verdicts, strict=True)
        if verdict.accepted and outcome.printed is not None
    }
    reread = dict(zip(printed, judge.judge(list(printed.values())), strict=True))
    accepted = [shader for shader in shaders if shader.key in printed]
    differences = compare_types(accepted, judge.folder, options.jobs)
    typing = {shader.key: text for shader, text in zip(accepted, differences, strict=True)}
    pictures = _render(accepted, printed, options.jobs) if options.render else {}
    return [
        Row(
            shader,
            verdict,
            replace(outcome, printed=None),
            typing.get(shader.key, ""),
            reread.get(shader.key),
            pictures.get(shader.key),
        )
        for shader, verdict, outcome in zip(shaders, verdicts, outcomes, strict=True)
    ]


def _render(
    shaders: list[Shader], printed: dict[str, Shader], processes: int
) -> dict[str, Picture]:
    pairs = [(shader, printed[shader.key].text) for shader in shaders if shader.stage == "fragment"]
    pictures = render_all(pairs, processes)
    return {shader.key: found for (shader, _), found in zip(pairs, pictures, strict=True)}


def _say(message: str) -> None:
    print(f"corpus: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
