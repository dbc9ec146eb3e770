"""``./dev bench-parse``: how fast the front end is, beside glslangValidator and crosstl.

Everything is timed in turns (A B C A B C ...) on files over 10 KB: parse to a positioned tree;
parse and types; glslangValidator, a process whose start-up (an empty shader) is taken off;
crosstl's parser (PyPI, the extra ``bench``). Then how time grows with size, from 10 KB to 1 MB, how
long the saved grammar takes to load, and how long a whole ``shadercache check`` of a small file.

Files: a made one of 35 KB, and public ones where ``./dev corpus`` has fetched them.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from itertools import count
from pathlib import Path
from typing import Any

from shadercache.ast.large import allow_deep_trees
from shadercache.cli.tables import format_table
from shadercache.front import grammar
from shadercache.front.parse import parse
from shadercache.gpu.context import open_context
from shadercache.measure.result_files import environment, machine_name, write_json
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.valid.validate import validate

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PUBLIC = ROOT / "out" / "public" / "shaders"
TINY = ROOT / "tests" / "cli" / "shaders" / "small.frag"

HEAD = "#version 330\nuniform sampler2D u_image;\nuniform vec3 u_eye;\nin vec3 v_position;\n"
TAIL = "out vec4 o;\nvoid main() { o = piece0(v_position, v_position.xy, 1.0); }\n"
SIZES = (10, 30, 100, 300, 1000)
"""Kilobytes of the made files that show how time grows."""

PUBLIC_FILES = 8
SMALLEST = 10_000
COPIES = 10


@dataclass(frozen=True, slots=True)
class File:
    """A shader that is timed."""

    name: str
    text: str
    world: Stage = "fragment"


def made_file(kilobytes: int) -> File:
    """A valid shader of about this size: the piece of ``parse_speed.glsl``, again and again."""
    piece = (HERE / "parse_speed.glsl").read_text(encoding="utf-8")
    text = HEAD
    for number in count():
        text += piece.replace("NUMBER", str(number))
        if len(text) >= kilobytes * 1000:
            return File(f"made, {kilobytes} KB", text + TAIL)
    raise AssertionError


def public_files() -> list[File]:
    """Valid public shaders over 10 KB, spread over the sizes that there are."""
    found: list[tuple[int, Path]] = []
    for path in sorted(PUBLIC.glob("three/ShaderLib/*.frag")):
        if path.stat().st_size >= SMALLEST and _reads(_file(path)):
            found.append((path.stat().st_size, path))
    found.sort()
    step = max(1, len(found) // PUBLIC_FILES)
    return [_file(path) for _, path in found[step - 1 :: step][:PUBLIC_FILES]]


def _file(path: Path) -> File:
    return File(path.stem, path.read_text(encoding="utf-8"))


def _reads(file: File) -> bool:
    try:
        _parse_and_check(file)
    except Exception:
        return False
    return True


# --- contenders -----------------------------------------------------------------------------------


def _parse(file: File) -> None:
    parse(Source(file.name, file.text))


def _parse_and_check(file: File) -> None:
    source = Source(file.name, file.text)
    validate(parse(source), source, file.world)


def _crosstl(file: File) -> None:
    from crosstl.backend.GLSL.OpenglLexer import GLSLLexer
    from crosstl.backend.GLSL.OpenglParser import GLSLParser

    GLSLParser(GLSLLexer(file.text).tokenize(), file.world).parse()


def _glslang(file: File) -> None:
    """Many times in one process, for its start-up takes longer than most files."""
    with tempfile.NamedTemporaryFile("w", suffix=f".{file.world[:4]}") as copy:
        copy.write(file.text)
        copy.flush()
        command = ["glslangValidator", *[copy.name] * COPIES]
        subprocess.run(command, capture_output=True, check=True)


EMPTY = File("empty", "#version 330\nvoid main() {}\n")

CONTENDERS: dict[str, Callable[[File], None]] = {
    "parse": _parse,
    "typed": _parse_and_check,
    "glslang": _glslang,
    "crosstl": _crosstl,
}


def time_in_turns(
    actions: Mapping[str, Callable[[], None]], rounds: int
) -> dict[str, list[float] | None]:
    """Seconds of each action in each round; ``None`` for an action that fails."""
    times: dict[str, list[float] | None] = {}
    for name, action in actions.items():
        try:
            action()  # The first run loads what is needed.
            times[name] = []
        except Exception:
            times[name] = None
    for _ in range(rounds):
        for name, action in actions.items():
            samples = times[name]
            if samples is not None:
                begin = time.perf_counter()
                action()
                samples.append(time.perf_counter() - begin)
    return times


def compare(files: Iterable[File], rounds: int) -> list[dict[str, Any]]:
    """The raw samples of every contender on every file, glslang's without its start-up."""
    rows = []
    for file in files:
        actions = {name: partial(action, file) for name, action in CONTENDERS.items()}
        times = time_in_turns(actions | {"start-up": partial(_glslang, EMPTY)}, rounds)
        startup, glslang = times.pop("start-up"), times["glslang"]
        if startup is not None and glslang is not None:
            off = statistics.median(startup)
            times["glslang"] = [max(0.0, sample - off) / COPIES for sample in glslang]
        rows.append({"file": file.name, "bytes": len(file.text), "seconds": times})
    return rows


def growth(rounds: int) -> list[dict[str, Any]]:
    """The same for made files of growing size, without the peers."""
    rows = []
    for kilobytes in SIZES:
        file = made_file(kilobytes)
        actions = {name: partial(CONTENDERS[name], file) for name in ("parse", "typed")}
        times = time_in_turns(actions, rounds)
        rows.append({"file": file.name, "bytes": len(file.text), "seconds": times})
    return rows


def start_up(rounds: int) -> dict[str, list[float] | None]:
    """Loading the saved grammar, and a whole run of ``check`` on a small file."""

    def load() -> None:
        grammar.load_parser.cache_clear()
        grammar.load_parser()

    def run() -> None:
        command = [sys.executable, "-m", "shadercache", "check", "--no-glslang", str(TINY)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, cwd=ROOT)

    return time_in_turns({"load the saved grammar": load, "check tiny.frag": run}, rounds)


# --- output ---------------------------------------------------------------------------------------


def _median(samples: list[float] | None) -> float | None:
    return statistics.median(samples) if samples else None


def _ms(samples: list[float] | None) -> str:
    middle = _median(samples)
    return "-" if middle is None else f"{middle * 1e3:.1f}"


def _times(one: list[float] | None, other: list[float] | None) -> str:
    first, second = _median(one), _median(other)
    return "-" if not first or not second else f"{first / second:.2f}"


def comparison_table(rows: Sequence[dict[str, Any]]) -> str:
    """Medians in milliseconds, and the two ratios that matter."""
    head = ("file", "KB", *CONTENDERS, "KB/s", "typed/parse", "crosstl/parse")
    lines = []
    for row in rows:
        seconds = row["seconds"]
        middle = _median(seconds["parse"])
        lines.append(
            (
                row["file"],
                f"{row['bytes'] / 1000:.1f}",
                *(_ms(seconds[name]) for name in CONTENDERS),
                f"{row['bytes'] / middle / 1000:.0f}" if middle else "-",
                _times(seconds["typed"], seconds["parse"]),
                _times(seconds["crosstl"], seconds["parse"]),
            )
        )
    return format_table(head, lines, right=" ".join(head[1:]))


def growth_table(rows: Sequence[dict[str, Any]]) -> str:
    """Kilobytes a second by size: constant where time grows with the size."""
    lines = []
    for row in rows:
        cells = [row["file"]]
        for samples in row["seconds"].values():
            middle = _median(samples)
            cells += [_ms(samples), f"{row['bytes'] / middle / 1000:.0f}" if middle else "-"]
        lines.append(cells)
    head = ("file", "parse", "KB/s", "typed", "KB/s")
    return format_table(head, lines, right=" ".join(head[1:]))


def targets(
    compared: Sequence[dict[str, Any]],
    grown: Sequence[dict[str, Any]],
    started: Mapping[str, list[float] | None],
) -> list[dict[str, Any]]:
    """What was aimed at and what is reached: names, numbers, and whether each is met.

    Of several files the times are added up, over the files that both contenders read. Growth is the
    time for a byte of the largest made file over that of the smallest.
    """
    typed = [row["bytes"] / (_median(row["seconds"]["typed"]) or 1e9) for row in grown]
    found: list[tuple[str, float | None, float, bool]] = [
        ("crosstl / parse", _added("crosstl", "parse", compared), 2.0, True),
        ("parse and types / parse", _added("typed", "parse", compared), 2.0, False),
        ("growth: 1 MB / 10 KB, time for a byte", typed[0] / typed[-1], 1.5, False),
        ("35 KB parsed and typed, s", _median(compared[0]["seconds"]["typed"]), 0.2, False),
        ("load the saved grammar, s", _median(started["load the saved grammar"]), 0.03, False),
        ("check tiny.frag, s", _median(started["check tiny.frag"]), 0.4, False),
    ]
    return [
        {
            "name": name,
            "value": value,
            "target": f"{'>=' if at_least else '<='} {limit:g}",
            "met": None if value is None else (value >= limit) == at_least or value == limit,
        }
        for name, value, limit, at_least in found
    ]


def _added(one: str, other: str, rows: Sequence[dict[str, Any]]) -> float | None:
    pairs = [(_median(row["seconds"][one]), _median(row["seconds"][other])) for row in rows]
    both = [(first, second) for first, second in pairs if first and second]
    return sum(first for first, _ in both) / sum(second for _, second in both) if both else None


def targets_table(found: Sequence[dict[str, Any]]) -> str:
    """One line for each target."""
    words = {True: "met", False: "MISSED", None: "not measured"}
    lines = [
        (
            item["name"],
            "-" if item["value"] is None else f"{item['value']:.3g}",
            item["target"],
            words[item["met"]],
        )
        for item in found
    ]
    return format_table(("target", "value", "wanted", ""), lines, right="value wanted")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev bench-parse", description=__doc__)
    parser.add_argument("--rounds", type=int, default=9, metavar="N")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="the result as JSON")
    options = parser.parse_args(arguments)
    allow_deep_trees()
    if find_spec("crosstl") is None:
        print("crosstl is not installed (pip install -e '.[bench]')", file=sys.stderr)
    with open_context() as gpu:
        about = environment(gpu)
    compared = compare([made_file(35), *public_files()], options.rounds)
    print(f"{comparison_table(compared)}\n\nmedians in ms; glslang without its start-up\n")
    grown = growth(options.rounds)
    print(growth_table(grown))
    started = start_up(options.rounds)
    print()
    for name, samples in started.items():
        print(f"{name}: {_ms(samples)} ms")
    reached = targets(compared, grown, started)
    print(f"\n{targets_table(reached)}")
    result = {
        "schema_version": 1,
        "environment": about,
        "comparison": compared,
        "growth": grown,
        "start-up": started,
        "targets": reached,
    }
    default = HERE / "results" / machine_name(about) / "parse-speed.json"
    write_json(options.output or default, result)
    print(f"\nresult: {options.output or default}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
