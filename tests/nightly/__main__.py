"""``./dev nightly``: what is drawn by a seed, with the day's seed, and more of it than else.

Part after part, two processes, twenty minutes at most. What has passed is kept in
``out/nightly/<seed>.json``; with ``--resume`` only the rest is run. The exit status is 1 where a
part failed, and what repeats it is printed; parts for which there was no time are named.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUTPUT = ROOT / "out" / "nightly"
MINUTES = 20.0

PARTS = {
    "cases": ["tests/cases/test_cases.py", "-k", "laws or reference"],
    "costs": ["tests/analysis/test_shared_work.py", "-k", "no_pass"],
    "corpus": ["tests/laws/test_slice.py", "-k", "laws_1_to_4"],
    "sets": ["tests/laws/test_sets.py", "-k", "random_sets"],
    "cache options": ["tests/laws/test_cache_options.py"],
    "independent runner": ["tests/render/test_independent_runner.py", "-k", "compiler_writes"],
    "damaged shaders": ["tests/stress/test_stress.py", "-k", "random_cases"],
    "versions": ["tests/laws/test_versions.py", "-k", "reference_compiler"],
    "broken passes": ["tests/generated/test_compiler_mutations.py", "-k", "broken_pass"],
    "generated shaders": ["tests/generated/test_generated.py"],
}
"""The tests of each part, as pytest takes them; the longest comes last."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the parts; the exit status."""
    parser = argparse.ArgumentParser(prog="./dev nightly", description=__doc__)
    parser.add_argument("--seed", type=int, default=date.today().toordinal(), help="not the day's")
    parser.add_argument("--resume", action="store_true", help="leave out what has passed")
    parser.add_argument("--minutes", type=float, default=MINUTES, help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    seed = str(options.seed)
    print(f"seed: {seed}", flush=True)
    end = time.monotonic() + 60.0 * options.minutes
    done = _passed(seed) if options.resume else {}
    failed, left = list[str](), list[str]()
    for name in (name for name in PARTS if name not in done):
        begin = time.monotonic()
        status = _run(name, seed, end - begin)
        if status == 0:
            done[name] = round(time.monotonic() - begin, 1)
            _keep(seed, done)
        (left if status is None else failed if status else []).append(name)
    return _tell(seed, failed, left)


def _run(name: str, seed: str, seconds: float) -> int | None:
    """Run one part; the status of pytest, or nothing where the time was over."""
    if seconds <= 0.0:
        return None
    print(f"\n{name}", flush=True)
    env = os.environ | {"SHADERCACHE_SEED": seed, "SHADERCACHE_NIGHTLY": "1"}
    run = subprocess.Popen(_line(name), cwd=ROOT, env=env, start_new_session=True)
    try:
        return run.wait(seconds)
    except BaseException as error:  # what pytest started goes with it, whatever stops this
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        if not isinstance(error, subprocess.TimeoutExpired):
            raise
        return None


def _line(name: str) -> list[str]:
    return [sys.executable, "-m", "pytest", "-q", "-n", "2", "--dist", "loadgroup", *PARTS[name]]


def _passed(seed: str) -> dict[str, float]:
    """The parts that have passed with a seed, and the seconds they took."""
    file = OUTPUT / f"{seed}.json"
    return dict(json.loads(file.read_text(encoding="utf-8"))) if file.exists() else {}


def _keep(seed: str, done: dict[str, float]) -> None:
    OUTPUT.mkdir(parents=True, exist_ok=True)
    new = OUTPUT / f"{seed}.new"
    new.write_text(json.dumps(done, indent=2) + "\n", encoding="utf-8")
    new.replace(OUTPUT / f"{seed}.json")


def _tell(seed: str, failed: Sequence[str], left: Sequence[str]) -> int:
    for name in failed:
        words = " ".join(f"'{word}'" if " " in word else word for word in PARTS[name])
        print(f"\n{name} failed; this repeats it:")
        print(
            f"    SHADERCACHE_SEED={seed} SHADERCACHE_NIGHTLY=1 .venv/bin/python -m pytest {words}"
        )
    if left:
        print(f"\nno time was left for: {', '.join(left)}")
        print(f"    ./dev nightly --seed {seed} --resume")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
