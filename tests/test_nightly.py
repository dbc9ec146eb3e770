"""``./dev nightly``: what it runs, what it keeps, what it says of what failed or was left."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from tests.nightly import __main__ as nightly

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture
def parts(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Two parts; each is a process that notes its name, and ``bad`` fails."""
    log = tmp_path / "log"
    program = (
        "import os, sys, time; name = sys.argv[1]; wait = float(sys.argv[2]); time.sleep(wait);"
        "open(sys.argv[3], 'a').write(f'{name} {os.environ[\"SHADERCACHE_SEED\"]}\\n');"
        "sys.exit(name == 'bad' and not os.path.exists(sys.argv[3] + '.repaired'))"
    )

    def line(name: str) -> list[str]:
        return [sys.executable, "-c", program, name, "60" if name == "long" else "0", str(log)]

    monkeypatch.setattr(nightly, "OUTPUT", tmp_path / "out")
    monkeypatch.setattr(nightly, "PARTS", {"good": ["a"], "bad": ["b", "-k", "c d"]})
    monkeypatch.setattr(nightly, "_line", line)
    monkeypatch.chdir(tmp_path)


def noted() -> list[str]:
    file = Path("log")
    found = file.read_text().splitlines() if file.exists() else []
    file.unlink(missing_ok=True)
    return found


@pytest.mark.usefixtures("parts")
def test_what_failed_is_told_and_run_again(capfd: pytest.CaptureFixture[str]) -> None:
    assert nightly.main(["--seed", "7"]) == 1
    assert noted() == ["good 7", "bad 7"]
    told = capfd.readouterr().out
    assert told.startswith("seed: 7\n")
    line = "SHADERCACHE_SEED=7 SHADERCACHE_NIGHTLY=1 .venv/bin/python -m pytest b -k 'c d'"
    assert line in told
    Path("log.repaired").touch()
    assert nightly.main(["--seed", "7", "--resume"]) == 0
    assert noted() == ["bad 7"]
    assert set(json.loads(Path("out/7.json").read_text())) == {"good", "bad"}
    assert nightly.main(["--seed", "7"]) == 0
    assert noted() == ["good 7", "bad 7"]


@pytest.mark.usefixtures("parts")
def test_what_there_is_no_time_for_is_left(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(nightly, "PARTS", {"long": ["a"], "good": ["b"]})
    assert nightly.main(["--seed", "7", "--minutes", "0.001"]) == 0
    assert noted() == []
    told = capfd.readouterr().out
    assert "no time was left for: long, good\n    ./dev nightly --seed 7 --resume" in told


def test_every_part_names_tests() -> None:
    for arguments in nightly.PARTS.values():
        text = (ROOT / arguments[0]).read_text(encoding="utf-8")
        words = arguments[2].split(" or ") if len(arguments) > 1 else [""]
        assert all(word in text for word in words), arguments
