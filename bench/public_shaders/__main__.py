"""``./dev corpus``: how many shaders that nobody here wrote the front end gets right.

glslangValidator is the judge. Some shaders come from packages, which ``fetch.sh`` fetches by name
into ``out/public/``; others from folders (``--shaders``). ``docs/use/acceptance.md`` says what is
measured.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from functools import partial
from multiprocessing import Pool
from pathlib import Path

from bench.public_shaders.drawing import draw_all
from bench.public_shaders.reading import TOOL, Row, examine, table, to_json
from bench.public_shaders.shaders import Shader, evenly, evenly_by_folder, folder_shaders
from shadercache.ast.large import allow_deep_trees

COLLECTIONS = ("three", "gl-transitions", "piglit")
FAMILY_LIMIT = 40  # of one folder of piglit, whose generated families have thousands alike


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 3 where packages or tools cannot be had."""
    options = _options(arguments)
    if shutil.which(TOOL) is None:
        print(f"corpus: {TOOL} is not installed (glslang-tools)", file=sys.stderr)
        return 3
    rows: dict[str, list[Row]] = {}
    try:
        for name, shaders in _collections(options):
            rows[name] = _measure(evenly(shaders, options.limit), options)
            print(f"corpus: {name}: {len(rows[name])} shaders", file=sys.stderr)
    except subprocess.CalledProcessError as error:
        print(f"corpus: {error.cmd[-1]} cannot be fetched", file=sys.stderr)
        return 3
    print(table(rows))
    result = options.folder / "result.json"
    figures = {name: to_json(measured) for name, measured in rows.items()}
    result.write_text(json.dumps(figures, indent=1) + "\n")
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
    add("--folder", type=Path, default=Path("out/public"), metavar="DIR")
    options = parser.parse_args(arguments)
    options.folder = options.folder.resolve()
    # argparse checks choices of an empty list too, so that "*" and `choices` do not go together.
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
        limit = FAMILY_LIMIT if name == "piglit" and not options.all else None
        yield name, evenly_by_folder(folder_shaders(packages / name), limit)
    for folder in options.shaders:
        yield folder.resolve().name, folder_shaders(folder, options.include)


def _measure(shaders: list[Shader], options: argparse.Namespace) -> list[Row]:
    with Pool(options.jobs, allow_deep_trees) as pool:
        rows = pool.map(partial(examine, options.folder / "shaders"), shaders, chunksize=8)
    if options.render:
        drawn = [row for row in rows if row.printed is not None and row.shader.stage == "fragment"]
        pictures = draw_all([(row.shader, row.printed or "") for row in drawn], options.jobs)
        for row, picture in zip(drawn, pictures, strict=True):
            row.picture = picture
            if picture.same is not None:
                row.problems["same image"] = picture.why
    return rows


if __name__ == "__main__":
    sys.exit(main())
