"""The root of the command line: usage errors, diagnostics as JSON, exit status, broken output."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from shadercache import __version__
from shadercache.cli import list_nodes
from shadercache.cli.app import COMMANDS

from .conftest import Shell

CLI = [sys.executable, "-W", "error", "-m", "shadercache"]


def test_version(shell: Shell) -> None:
    outcome = shell("--version")
    assert (outcome.status, outcome.out) == (0, f"shadercache {__version__}\n")


@pytest.mark.parametrize("args", [(), ("--help",)])
def test_help_names_every_command(shell: Shell, args: tuple[str, ...]) -> None:
    outcome = shell(*args)
    assert outcome.status == 0
    assert all(f"  {name} " in outcome.out for name in COMMANDS if name != "demo")


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help(shell: Shell, name: str) -> None:
    outcome = shell(name, "--help")
    assert outcome.status == 0
    assert f"Usage: shadercache {name}" in outcome.out


@pytest.mark.parametrize(
    ("args", "message"),
    [
        (("nodes", "--colour", "x.frag"), "no such option: --colour"),
        (("nodes",), "missing argument 'FRAG'"),
        (("node", "x.frag"), "no such command 'node'. Did you mean 'nodes'?"),
        (("nodes", "x.frag", "--sort", "size"), "invalid value for '--sort'"),
        (("--diagnostics=xml", "doctor"), "invalid value for '--diagnostics'"),
        (("rewrite", "x.frag", "--node", "a"), "missing option '-o' / '--output'"),
    ],
)
def test_usage_errors_are_diagnostics(shell: Shell, args: tuple[str, ...], message: str) -> None:
    outcome = shell(*args)
    assert outcome.status == 2
    assert outcome.out == ""
    assert message in outcome.err
    assert "[SC003]" in outcome.err


def test_the_hint_names_the_command(shell: Shell) -> None:
    assert "'shadercache nodes --help'" in shell("nodes", "--colour").err


@pytest.mark.parametrize(
    "args",
    [
        ("--diagnostics=json", "nodes", "missing.frag"),
        ("nodes", "missing.frag", "--diagnostics=json"),
        ("nodes", "--diagnostics", "json", "missing.frag"),
        ("nodes", "--diagnostics", "json", "--", "missing.frag"),
    ],
)
def test_diagnostics_as_json(shell: Shell, args: tuple[str, ...]) -> None:
    outcome = shell(*args)
    assert outcome.status == 1
    diagnostic = json.loads(outcome.err)
    assert diagnostic["code"] == "SC001"
    assert diagnostic["severity"] == "error"
    assert "missing.frag" in diagnostic["message"]


def test_a_usage_error_as_json(shell: Shell) -> None:
    outcome = shell("nodes", "--colour", "--diagnostics=json")
    assert outcome.status == 2
    assert json.loads(outcome.err)["code"] == "SC003"


def test_behind_two_dashes_everything_is_a_file(shell: Shell) -> None:
    outcome = shell("nodes", "--", "--diagnostics=json")
    assert outcome.status == 1
    assert "cannot read --diagnostics=json" in outcome.err


def test_an_interrupt_ends_with_130(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(path: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(list_nodes, "read_source", interrupt)
    outcome = shell("nodes", "x.frag")
    assert (outcome.status, outcome.out, outcome.err) == (130, "", "")


def test_an_error_of_the_system_is_a_diagnostic(
    shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: str) -> None:
        raise OSError(24, "Too many open files", path)

    monkeypatch.setattr(list_nodes, "read_source", refuse)
    outcome = shell("nodes", "x.frag")
    assert outcome.status == 2
    assert outcome.err == "error: x.frag: Too many open files [SC004]\n"


def test_a_reader_that_goes_away_is_no_error(fragment: Path) -> None:
    with subprocess.Popen(
        [*CLI, "nodes", str(fragment)], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait() == 141


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_a_full_disk_behind_stdout_is_a_diagnostic(fragment: Path) -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [*CLI, "nodes", str(fragment)], stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert done.returncode == 2
    assert done.stderr == b"error: No space left on device [SC004]\n"


def test_a_closed_output_is_no_reason_for_a_traceback(fragment: Path) -> None:
    line = f'"{sys.executable}" -m shadercache nodes "{fragment}" >&-'
    done = subprocess.run(["sh", "-c", line], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
