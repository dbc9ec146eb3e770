"""The ./dev script on machines that lack something: stand-ins on an otherwise empty PATH."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
TOOLS = ("sh", "dirname", "cksum", "cat", "tr", "env", "rm", "echo", "ln", "true")

APT = """\
case "$*" in
*update) : >"{bin}/known" ;;
*) [ -e "{bin}/known" ] || exit 100 ;;
esac
case "$*" in
*update | *" -s "*) ;;
*) ln -s echo "{bin}/glslangValidator" ;;
esac"""
"""Knows no package before the first update, as on a fresh image; then installs the validator."""


class Machine:
    """A copy of the script in a folder, and the commands that it finds."""

    def __init__(self, folder: Path) -> None:
        self.root = folder / "a project"
        self.bin = folder / "bin"
        self.log = folder / "log"
        self.root.mkdir()
        self.bin.mkdir()
        self.log.touch()
        for name in ("dev", "pyproject.toml"):
            shutil.copy(ROOT / name, self.root)
        for tool in TOOLS:
            path = shutil.which(tool)
            assert path
            (self.bin / tool).symlink_to(path)
        self.has("python3", f'exec "{sys.executable}" "$@"')
        self.has("id", "echo 1000")

    def has(self, command: str, script: str = "", folder: Path | None = None) -> None:
        """Add a command that notes its call in the log and then runs ``script``."""
        path = (folder or self.bin) / command
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'#!/bin/sh\necho "{command} $*" >>"{self.log}"\n{script}\n')
        path.chmod(0o755)

    def has_environment(self, python: str = "") -> None:
        """Add a .venv whose pip does nothing but what ``python`` says, and which runs nothing."""
        for command, script in (("python", python), ("shadercache", "")):
            self.has(command, script, self.root / ".venv" / "bin")

    def installed(self) -> list[str]:
        """What pip was told to install since the log was emptied, which this does."""
        calls = [call for call in self.calls("python") if " install " in call]
        self.log.write_text("")
        return [call.split()[-1] for call in calls]

    def dev(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(self.root / "dev"), *arguments],
            cwd="/",
            env={"PATH": str(self.bin)},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )

    def calls(self, command: str) -> list[str]:
        lines = self.log.read_text().splitlines()
        return [line for line in lines if line.split()[0] == command]


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


@pytest.mark.parametrize(
    ("command", "script"), [(None, ""), ("apt-get", ""), ("sudo", "exit 1")], ids=str
)
def test_where_it_may_not_install_it_prints_the_line(
    machine: Machine, command: str | None, script: str
) -> None:
    if command:
        machine.has("apt-get")
        machine.has(command, script)
    done = machine.dev("setup")
    assert (done.returncode, done.stdout) == (3, "")
    line = (
        "    sudo apt-get update && sudo apt-get install -y --no-install-recommends glslang-tools"
    )
    assert line in done.stderr.splitlines()
    assert not (machine.root / ".venv").exists()
    assert not machine.calls("apt-get")


@pytest.mark.parametrize("root", [True, False])
def test_it_installs_what_is_missing(machine: Machine, root: bool) -> None:
    machine.has_environment()
    if root:
        machine.has("id", "echo 0")
    else:
        machine.has("sudo", 'shift; exec "$@"')
    machine.has("apt-get", APT.format(bin=machine.bin))
    done = machine.dev("setup")
    assert done.returncode == 0, done.stderr
    assert "installing system packages: glslang-tools" in done.stderr
    calls = machine.calls("apt-get")
    assert calls[-2:] == [
        "apt-get -qq update",
        "apt-get -qq install -y --no-install-recommends glslang-tools",
    ]
    assert bool(machine.calls("sudo")) is not root


def test_a_failure_of_apt_is_told(machine: Machine) -> None:
    machine.has("id", "echo 0")
    machine.has("apt-get", "echo E: no network >&2; exit 100")
    done = machine.dev("setup")
    assert done.returncode == 3
    assert "E: no network" in done.stderr
    assert "apt-get could not install: glslang-tools" in done.stderr


def test_no_python_at_all(machine: Machine) -> None:
    (machine.bin / "python3").unlink()
    machine.has("glslangValidator")
    done = machine.dev("setup")
    assert done.returncode == 3
    assert "--no-install-recommends python3 python3-venv libegl1 libgl1" in done.stderr


def test_an_old_python_will_not_do(machine: Machine) -> None:
    machine.has("python3", "exit 1")
    done = machine.dev("setup")
    assert done.returncode == 3
    assert "Python 3.11 or newer is needed" in done.stderr


def test_a_second_run_does_nothing(machine: Machine) -> None:
    machine.has("glslangValidator")
    machine.has_environment()
    first = machine.dev("setup")
    assert first.returncode == 0, first.stderr
    assert "set up" in first.stderr
    assert any("install" in call for call in machine.calls("python"))
    machine.log.write_text("")
    second = machine.dev("setup")
    assert (second.returncode, second.stdout, second.stderr) == (0, "", "")
    assert machine.log.read_text() == ""


def test_new_requirements_are_installed(machine: Machine) -> None:
    machine.has("glslangValidator")
    machine.has_environment()
    machine.dev("setup")
    machine.log.write_text("")
    with (machine.root / "pyproject.toml").open("a") as file:
        file.write("# changed\n")
    assert machine.dev("setup").returncode == 0
    assert any("install" in call for call in machine.calls("python"))


def test_the_demo_installs_less_than_the_tests(machine: Machine) -> None:
    machine.has_environment()
    demo = machine.dev("demo", "--full")
    assert demo.returncode == 0, demo.stderr
    assert machine.calls("shadercache") == ["shadercache demo -o out/demo --full"]
    assert machine.installed() == ["."]
    machine.has("glslangValidator")
    for verb, installed in (("demo", []), ("setup", [".[dev]"]), ("setup", []), ("demo", [])):
        assert machine.dev(verb).returncode == 0
        assert machine.installed() == installed, verb


def test_new_requirements_are_installed_for_either(machine: Machine) -> None:
    machine.has("glslangValidator")
    machine.has_environment()
    machine.dev("setup")
    machine.installed()
    with (machine.root / "pyproject.toml").open("a") as file:
        file.write("# changed\n")
    for verb, installed in (("demo", ["."]), ("setup", [".[dev]"]), ("demo", [])):
        assert machine.dev(verb).returncode == 0
        assert machine.installed() == installed, verb


@pytest.mark.parametrize(("verb", "wanted"), [("demo", "."), ("setup", ".[dev]")])
def test_where_pip_fails_the_next_run_tries_again(machine: Machine, verb: str, wanted: str) -> None:
    machine.has("glslangValidator")
    machine.has_environment('case "$*" in *install*) echo no network >&2; exit 1 ;; esac')
    for _ in range(2):
        done = machine.dev(verb)
        assert done.returncode == 3
        assert "no network" in done.stderr
        assert "pip could not install" in done.stderr
        assert machine.installed() == [wanted]
        assert not machine.calls("shadercache")
    machine.has_environment()
    assert machine.dev(verb).returncode == 0
    assert machine.installed() == [wanted]


def test_when_the_rest_cannot_be_installed_the_demo_still_runs(machine: Machine) -> None:
    machine.has("glslangValidator")
    machine.has_environment()
    machine.dev("demo")
    machine.has_environment('case "$*" in *install*) exit 1 ;; esac')
    assert machine.dev("setup").returncode == 3
    machine.installed()
    assert machine.dev("demo").returncode == 0
    assert machine.installed() == []


def test_a_half_made_environment_is_made_anew(machine: Machine) -> None:
    machine.has("glslangValidator")
    machine.has_environment("exit 1")  # no pip: it was interrupted
    (machine.root / ".venv" / "rest").touch()
    make = f"""case "$*" in
    "-m venv "*) /bin/mkdir -p "$3/bin"; ln -s /bin/true "$3/bin/python" ;;
    *) exec "{sys.executable}" "$@" ;;
    esac"""
    machine.has("python3", make)
    done = machine.dev("setup")
    assert done.returncode == 0, done.stderr
    assert "making .venv" in done.stderr
    assert not (machine.root / ".venv" / "rest").exists()


@pytest.mark.parametrize("verb", ["", "help", "--help"])
def test_help_names_every_verb(machine: Machine, verb: str) -> None:
    done = machine.dev(*verb.split())
    assert done.returncode == 0
    verbs = [
        "setup",
        "demo",
        "quick",
        "test",
        "nightly",
        "verify-all",
        "goldens",
        "lint",
        "corpus",
        "stress",
        "peers",
    ]
    for name in [*verbs, "bench", "bench-parse", "bench-emit", "clean"]:
        assert f"\n  {name} " in done.stdout
    assert machine.log.read_text() == ""


def test_an_unknown_verb(machine: Machine) -> None:
    done = machine.dev("tset")
    assert done.returncode == 2
    assert "there is no verb 'tset'" in done.stderr
