"""``shadercache doctor`` with and without OpenGL."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from shadercache.cli import doctor
from shadercache.diagnostics import Diagnostic, GraphicsError

from .conftest import Shell


def doctor_in(**environment: str) -> subprocess.CompletedProcess[str]:
    """In another process, so that this one keeps its only context."""
    line = [sys.executable, "-W", "error", "-m", "shadercache", "doctor"]
    env = os.environ | environment
    return subprocess.run(line, capture_output=True, text=True, check=False, env=env)


def test_what_there_is() -> None:
    done = doctor_in()
    assert (done.returncode, done.stderr) == (0, "")
    assert "renderer" in done.stdout and "clock" in done.stdout
    assert "GL_MAX_TEXTURE_SIZE" in done.stdout


def test_without_opengl_it_says_what_to_install(
    shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> None:
        raise GraphicsError(Diagnostic("SC601", "no usable OpenGL"))

    monkeypatch.setattr(doctor, "_opengl", fail)
    outcome = shell("doctor", "--json")
    assert outcome.status == 3
    assert outcome.json["opengl"] is None
    assert any("libegl1 libgl1" in advice for advice in outcome.json["advice"])
    assert "[SC601]" in outcome.err


def test_no_driver_is_exit_status_3(tmp_path: Path) -> None:
    done = doctor_in(__EGL_VENDOR_LIBRARY_FILENAMES=str(tmp_path / "none.json"), DISPLAY="")
    assert done.returncode == 3
    assert "OpenGL            none" in done.stdout
    assert "Traceback" not in done.stderr and "[SC601]" in done.stderr


def test_a_missing_validator_is_told(
    shell: Shell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(doctor, "_opengl", lambda: {"renderer": "stub", "limits": {}})
    monkeypatch.setenv("PATH", str(tmp_path))
    report = shell("doctor", "--json").json
    assert report["glslangValidator"] is None
    assert any("glslang-tools" in advice for advice in report["advice"])
