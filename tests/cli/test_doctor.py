"""``shadercache doctor`` with and without OpenGL."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from shadercache.cli import doctor
from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.gpu.context import APT_LINE

from .conftest import Shell

FEATURES_OF_IMAGES = "GL_ARB_shader_image_load_store"


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


@pytest.mark.parametrize(
    ("system", "words"),
    [
        ("linux", f"sudo {APT_LINE}"),
        ("darwin", "logged in at the screen"),
        ("win32", "the graphics card's driver"),
    ],
)
def test_what_each_system_needs(
    shell: Shell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, system: str, words: str
) -> None:
    def fail() -> None:
        raise GraphicsError(Diagnostic("SC601", "no usable OpenGL"))

    monkeypatch.setattr(doctor, "_opengl", fail)
    monkeypatch.setattr(doctor.shutil, "which", lambda name: None)
    monkeypatch.setattr(sys, "platform", system)
    context, validator = shell("doctor", "--json").json["advice"]
    assert words in context
    assert ("apt-get" in context, "apt-get" in validator) == (system == "linux",) * 2


def test_what_falls_away_on_older_drivers() -> None:
    """OpenGL 4.1 is what macOS has; proof mode is there."""
    apple = doctor._missing(410, {"GL_ARB_texture_storage"})
    assert [line.rpartition(" ")[2] for line in apple] == ["4.2", "4.2", "4.3", "4.3", "4.4", "4.5"]
    assert not any("proof" in line for line in apple)
    assert "storage buffers: needs OpenGL 4.3" in apple
    assert "proof" in doctor._missing(330, ())[0]
    assert doctor._missing(460, ()) == []
    # A driver may have them sooner.
    assert not any("images" in line for line in doctor._missing(410, {FEATURES_OF_IMAGES}))


def test_a_driver_of_opengl_4_1() -> None:
    """Mesa can be told to be one; another driver hears nothing of it."""
    taken = [f"-{extension}" for _, extension, _ in doctor.FEATURES if extension]
    done = doctor_in(MESA_GL_VERSION_OVERRIDE="4.1", MESA_EXTENSION_OVERRIDE=" ".join(taken))
    assert (done.returncode, done.stderr) == (0, "")
    if "OpenGL            4.1" in done.stdout and "Mesa" in done.stdout:
        assert "missing           storage buffers: needs OpenGL 4.3\n" in done.stdout
        assert "proof" not in done.stdout
