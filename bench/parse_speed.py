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
from functools import partial
from importlib.util import find_spec
from itertools import count

from bench.speed import HERE, PUBLIC, ROOT, Sample, target, time_and_store
from shadercache.cli.tables import format_table
from shadercache.front import grammar
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.valid.validate import validate

TINY = ROOT / "tests" / "cli" / "shaders" / "small.frag"

HEAD = "#version 330\nuniform sampler2D u_image;\nuniform vec3 u_eye;\nin vec3 v_position;\n"
TAIL = "out vec4 o;\nvoid main() { o = piece0(v_position, v_position.xy, 1.0); }\n"
SIZES = (10, 30, 100, 300, 1000)
"""Kilobytes of the made files that show how time grows."""

PUBLIC_FILES = 8
SMALLEST = 10_000
COPIES = 10


def made_file(kilobytes: int) -> Source:
    """A valid shader of about this size: the piece of ``parse_speed.glsl``, again and again."""
    piece = (HERE / "parse_speed.glsl").read_text(encoding="utf-8")
    text = HEAD
    for number in count():
        text += piece.replace("NUMBER", str(number))
        if len(text) >= kilobytes * 1000:
            break
    return Source(f"made, {kilobytes} KB", text + TAIL)


def public_files() -> list[Source]:
    """Public shaders over 10 KB, spread over the sizes that there are."""
    files = [Source(path.stem, path.read_text(encoding="utf-8")) for path in PUBLIC.glob("*.frag")]
    large = sorted((file for file in files if len(file.text) >= SMALLEST), key=_size)
    step = max(1, len(large) // PUBLIC_FILES)
    return large[step - 1 :: step][:PUBLIC_FILES]


def _size(file: Source) -> tuple[int, str]:
    return len(file.text), file.name


# --- contenders -----------------------------------------------------------------------------------


def _typed(file: Source) -> None:
    validate(parse(file), file, "fragment")


def _crosstl(file: Source) -> None:
    from crosstl.backend.GLSL.OpenglLexer import GLSLLexer
    from crosstl.backend.GLSL.OpenglParser import GLSLParser

    GLSLParser(GLSLLexer(file.text).tokenize(), "fragment").parse()


def _glslang(file: Source) -> None:
    """Many times in one process, for its start-up takes longer than most files."""
    with tempfile.NamedTemporaryFile("w", suffix=".frag") as copy:
        copy.write(file.text)
        copy.flush()
        command = ["glslangValidator", *[copy.name] * COPIES]
        subprocess.run(command, capture_output=True, check=True)


EMPTY = Source("empty", "#version 330\nvoid main() {}\n")

CONTENDERS: dict[str, Callable[[Source], object]] = {
    "parse": parse,
    "typed": _typed,
    "glslang": _glslang,
    "crosstl": _crosstl,
}


def time_in_turns(
    actions: Mapping[str, Callable[[], object]], rounds: int
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


def compare(files: Iterable[Source], rounds: int) -> list[Sample]:
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


def growth(rounds: int) -> list[Sample]:
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


def comparison_table(rows: Sequence[Sample]) -> str:
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


def growth_table(rows: Sequence[Sample]) -> str:
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
    compared: Sequence[Sample],
    grown: Sequence[Sample],
    started: Mapping[str, list[float] | None],
) -> list[Sample]:
    """What was aimed at and what is reached: names, numbers, and whether each is met.

    Of several files the times are added up, over the files that both contenders read. Growth is the
    time for a byte of the largest made file over that of the smallest.
    """
    typed = [row["bytes"] / (_median(row["seconds"]["typed"]) or 1e9) for row in grown]
    times = {name: _median(samples) for name, samples in started.items()}
    return [
        target("crosstl / parse", _added("crosstl", "parse", compared), 2.0, at_least=True),
        target("parse and types / parse", _added("typed", "parse", compared), 2.0),
        target("growth: 1 MB / 10 KB, time for a byte", typed[0] / typed[-1], 1.5),
        target("35 KB parsed and typed, s", _median(compared[0]["seconds"]["typed"]), 0.2),
        target("load the saved grammar, s", times["load the saved grammar"], 0.03),
        target("check tiny.frag, s", times["check tiny.frag"], 0.4),
    ]


def _added(one: str, other: str, rows: Sequence[Sample]) -> float | None:
    pairs = [(_median(row["seconds"][one]), _median(row["seconds"][other])) for row in rows]
    both = [(first, second) for first, second in pairs if first and second]
    return sum(first for first, _ in both) / sum(second for _, second in both) if both else None


def _parts(options: argparse.Namespace) -> Sample:
    if find_spec("crosstl") is None:
        print("crosstl is not installed (pip install -e '.[bench]')", file=sys.stderr)
    compared = compare([made_file(35), *public_files()], options.rounds)
    print(f"{comparison_table(compared)}\n\nmedians in ms; glslang without its start-up\n")
    grown = growth(options.rounds)
    print(f"{growth_table(grown)}\n")
    started = start_up(options.rounds)
    for name, samples in started.items():
        print(f"{name}: {_ms(samples)} ms")
    reached = targets(compared, grown, started)
    return {"comparison": compared, "growth": grown, "start-up": started, "targets": reached}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev bench-parse", description=__doc__)
    parser.add_argument("--rounds", type=int, default=9, metavar="N")
    return time_and_store(parser, "parse-speed", _parts, arguments)


if __name__ == "__main__":
    sys.exit(main())
