"""A crash of a worker process is one red test with its name, and the run goes on to its end."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

HEAD = """
import os, signal, pytest

def die():
    os.kill(os.getpid(), signal.SIGSEGV)
"""

GROUP = """
@pytest.mark.xdist_group("{group}")
@pytest.mark.parametrize("number", range({count}))
def test_{group}(number):
    if number in {deadly}:
        die()
"""

ALONE = GROUP.replace('@pytest.mark.xdist_group("{group}")\n', "")

AT_THE_END = """
@pytest.fixture(scope="session")
def context():
    yield
    die()

def test_last(context):
    pass
"""


def group(name: str, count: int, *deadly: int, text: str = GROUP) -> str:
    return text.format(group=name, count=count, deadly=deadly)


def run(folder: Path, text: str) -> tuple[str, set[str]]:
    """The last line of a run of two workers, and the tests that failed in it."""
    (folder / "test_deadly.py").write_text(HEAD + text, encoding="utf-8")
    (folder / "pytest.ini").write_text("[pytest]\n", encoding="utf-8")
    options = "-p tests.crashes -n 2 --dist loadgroup --max-worker-restart 100 -q -rf"
    line = [sys.executable, "-m", "pytest", *options.split(), "-c", str(folder / "pytest.ini")]
    done = subprocess.run(
        [*line, str(folder)], cwd=ROOT, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 1, done.stdout + done.stderr
    failed = re.findall(r"^FAILED \S*test_deadly\.py::(\S+)", done.stdout, re.MULTILINE)
    assert len(set(failed)) == len(failed), "a crashed test ran again"
    return done.stdout.splitlines()[-1], {name.partition("@")[0] for name in failed}


DEADLY = {
    "alone and in groups": (
        group("alone", 6, 3, text=ALONE) + group("one", 6, 0, 5) + group("two", 6, 2),
        {"test_alone[3]", "test_one[0]", "test_one[5]", "test_two[2]"},
        14,
    ),
    "more than workers are restarted by default": (
        group("alone", 4, *range(4), text=ALONE) + group("one", 8, *range(1, 8)),
        {f"test_alone[{at}]" for at in range(4)} | {f"test_one[{at}]" for at in range(1, 8)},
        1,
    ),
    "as a worker ends": (group("alone", 5, text=ALONE) + AT_THE_END, {"test_last"}, 6),
}


@pytest.mark.parametrize(("text", "deadly", "passed"), DEADLY.values(), ids=DEADLY.keys())
def test_a_crash_is_one_red_test(tmp_path: Path, text: str, deadly: set[str], passed: int) -> None:
    last, failed = run(tmp_path, text)
    assert failed == deadly
    assert last.startswith(f"{len(deadly)} failed, {passed} passed")
