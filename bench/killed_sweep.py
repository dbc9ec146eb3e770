"""Kill a sweep at random moments, let it go on, and compare its rows with an undisturbed one's.

``python -m bench.killed_sweep trashcan --kills 20`` takes about ten minutes. The exit status is 1
where a row is missing, is there twice, or differs in anything but times.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from pathlib import Path
from subprocess import DEVNULL, Popen, TimeoutExpired, run
from tempfile import TemporaryDirectory
from typing import Any

import msgspec

from shadercache.sweep.row import Row
from shadercache.sweep.store import Store


def main() -> int:
    """Read the command line and compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--size", default="128")
    parser.add_argument("--seed", type=int, default=1)
    given, sweep_options = parser.parse_known_args()
    with TemporaryDirectory() as folder:
        options = [given.scene, "--size", given.size, *(sweep_options or ["--period", "8,32"])]
        whole, killed = Path(folder, "whole.db"), Path(folder, "killed.db")
        begun = time.monotonic()
        run(command(options, whole), check=True)
        whole_seconds = time.monotonic() - begun
        run(command(options, whole), check=True)  # with nothing to do, so this is the start alone
        start = time.monotonic() - begun - whole_seconds
        # On average it works for half of its share, so that it is still at work at the last kill.
        longest = 2.0 * start + (whole_seconds - start) / given.kills
        kills = kill_often(command(options, killed), longest, given.kills, given.seed)
        run(command(options, killed), check=True)
        differences = compare(read(whole), read(killed))
        print(f"killed {kills} times; {len(read(whole))} rows, {len(differences)} differences")
        print("\n".join(differences))
        return 1 if differences else 0


def command(options: list[str], store: Path) -> list[str]:
    """The sweep, as a user would start it."""
    return [sys.executable, "-m", "shadercache", "sweep", *options, "-o", str(store)]


def kill_often(sweep: list[str], longest: float, kills: int, seed: int) -> int:
    """Start the sweep again and again, and kill it each time; returns how often it was.

    It lives for up to ``longest`` seconds.
    """
    moments = random.Random(seed)
    killed = 0
    while killed < kills:
        process = Popen(sweep, stdout=DEVNULL, stderr=DEVNULL)
        try:
            process.wait(moments.uniform(0.0, longest))
            # It came to its end: later kills would find nothing to do.
            if process.returncode == 0:
                break
        except TimeoutExpired:
            process.kill()
            process.wait()
            killed += 1
    return killed


def read(path: Path) -> list[Row]:
    """The rows of a store."""
    with Store(path) as store:
        return store.rows()


def compare(whole: list[Row], killed: list[Row]) -> list[str]:
    """What tells two lists of rows apart, times aside, as lines."""
    ours, theirs = ({row.key: lasting(row) for row in rows} for rows in (whole, killed))
    lines = [f"missing: {key}" for key in ours.keys() - theirs.keys()]
    lines += [f"too many: {key}" for key in theirs.keys() - ours.keys()]
    lines += [f"twice: {len(killed) - len(theirs)} rows"] * (len(killed) != len(theirs))
    for key in ours.keys() & theirs.keys():
        if ours[key] != theirs[key]:
            names = [name for name in ours[key] if ours[key][name] != theirs[key].get(name)]
            lines.append(f"{key} differs in {', '.join(names)}")
    return lines


def lasting(row: Row) -> dict[str, Any]:
    """A row without what follows from the clock."""
    data: dict[str, Any] = msgspec.to_builtins(row)
    data["outcome"].pop("times", None)
    del data["written"]
    return data


if __name__ == "__main__":
    sys.exit(main())
