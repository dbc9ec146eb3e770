"""Nothing in the package is of POSIX or of one locale only."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "shadercache"
TREES = {
    str(file.relative_to(PACKAGE)): ast.parse(file.read_text(encoding="utf-8"))
    for file in sorted(PACKAGE.rglob("*.py"))
}

MISSING_MODULES = frozenset(("fcntl", "grp", "posix", "pty", "pwd", "resource", "termios", "tty"))
"""Modules that Windows lacks."""

MISSING_NAMES = frozenset(
    (
        *("fork", "forkpty", "getpgid", "getuid", "geteuid", "getloadavg", "killpg"),
        *("mkfifo", "sched_getaffinity", "sched_setaffinity", "setsid", "sysconf", "uname"),
        *("SIGALRM", "SIGHUP", "SIGKILL", "SIGUSR1", "setitimer", "pass_fds", "preexec_fn"),
        *("symlink_to", "hardlink_to", "symlink"),
    )
)
"""Names of ``os``, ``signal`` and ``subprocess`` that it lacks, or that need rights there."""

ALLOWED = {("paths.py", "getuid")}
"""Asked for by ``hasattr`` first."""

ENCODED = frozenset(("read_text", "write_text"))
OF_BYTES_OR_OWN = frozenset(("read_bytes", "foreign.read_text", "read_text"))
"""Functions of our own with such names, which say what the encoding is."""


def calls() -> Iterator[tuple[str, ast.Call, str]]:
    """Each call with its file, and the name of what is called."""
    for path, tree in TREES.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Call):
                yield path, node, ast.unparse(node.func)


def words(call: ast.Call) -> set[str | None]:
    return {keyword.arg for keyword in call.keywords}


def test_no_module_that_windows_lacks() -> None:
    found = {
        (path, name)
        for path, tree in TREES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for name in (
            [alias.name for alias in node.names]
            if isinstance(node, ast.Import)
            else [node.module or ""]
        )
        if name.partition(".")[0] in MISSING_MODULES
    }
    assert found == set()


def test_no_name_that_windows_lacks() -> None:
    found = set()
    for path, tree in TREES.items():
        for node in ast.walk(tree):
            name = getattr(node, "attr", None) or getattr(node, "arg", None)
            if isinstance(node, ast.Attribute | ast.keyword) and name in MISSING_NAMES:
                found.add((path, name))
    assert found == ALLOWED


def test_every_text_file_has_an_encoding() -> None:
    bare = []
    for path, call, name in calls():
        method = name.rpartition(".")[2]
        if method in ENCODED and name not in OF_BYTES_OR_OWN and "encoding" not in words(call):
            bare.append((path, name))
        binary = any(isinstance(a, ast.Constant) and "b" in str(a.value) for a in call.args)
        if name in ("open", "os.fdopen") and not binary and "encoding" not in words(call):
            bare.append((path, name))
    assert bare == []


def test_line_ends_are_those_that_were_written() -> None:
    """Windows turns each into two characters, unless told otherwise."""
    bare = [
        path
        for path, call, name in calls()
        if name.endswith(".write_text") and "newline" not in words(call)
    ]
    assert bare == []


def test_what_processes_say_has_an_encoding() -> None:
    bare = [
        (path, name)
        for path, call, name in calls()
        if name in ("subprocess.run", "Popen", "subprocess.Popen")
        and (words(call) & {"text", "universal_newlines", "shell"})
    ]
    assert bare == []


def test_no_place_that_only_posix_has() -> None:
    places = [
        (path, node.value)
        for path, tree in TREES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
        if node.value.startswith(("/tmp", "/dev/", "/var/", "/usr/", "/home/", "/proc/"))
    ]
    # It is asked in vain elsewhere.
    assert places == [("measure/result_files.py", "/proc/cpuinfo")]


SHADER = (
    "#version 330\r\n// Größe × 2 → „語“\r\nin vec3 v_position;\r\nout vec4 o_color;\r\n"
    "void main() {\r\n    float gross = sin(exp(sin(exp(sin(v_position.x)))));\r\n"
    "    o_color = vec4(gross);  // ≤ 1\r\n}\r\n"
)
VERTEX = (
    "#version 330\r\nin vec3 in_position;\r\nout vec3 v_position;\r\nuniform mat4 u_view;\r\n"
    "void main() {\r\n    v_position = in_position;\r\n"
    "    gl_Position = u_view * vec4(in_position, 1.0);\r\n}\r\n"
)

NODE = "sin(exp(sin(exp(sin(v_position.x)))))"

LOCALES = {
    "cp1252": {"PYTHONIOENCODING": "cp1252", "PYTHONUTF8": "0"},
    "C": {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    "cp437": {"PYTHONIOENCODING": "cp437", "PYTHONUTF8": "0"},
}


def shadercache(folder: Path, locale: str, *arguments: str) -> tuple[int, bytes, bytes]:
    line = [sys.executable, "-X", "warn_default_encoding", "-m", "shadercache", *arguments]
    env = os.environ | LOCALES[locale]
    done = subprocess.run(line, cwd=folder, env=env, capture_output=True, check=False)
    return done.returncode, done.stdout, done.stderr


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder whose name has a space and letters of other alphabets, with files of Windows."""
    made = tmp_path / "Meine Schäder 語"
    made.mkdir()
    (made / "größe 1.frag").write_bytes(SHADER.encode())
    (made / "größe 1.vert").write_bytes(VERTEX.encode())
    return made


@pytest.mark.parametrize("locale", LOCALES)
def test_nodes_and_rewrite_in_every_locale(folder: Path, locale: str) -> None:
    status, out, err = shadercache(folder, locale, "nodes", "größe 1.frag", "--json")
    assert (status, err) == (0, b"") and b'"nodes"' in out
    status, out, err = shadercache(folder, locale, "nodes", "größe 1.frag")
    assert (status, err) == (0, b"") and b"gross" in out
    line = ("rewrite", "größe 1.frag", "--node", NODE, "-o", "aus gabe ü")
    status, out, err = shadercache(folder, locale, *line)
    assert status == 0 and b"Traceback" not in err and b"EncodingWarning" not in err
    written = folder / "aus gabe ü"
    assert "größe 1.frag" in (written / "manifest.json").read_text(encoding="utf-8")
    # The shader's own line ends, or those of the compiler; never one carriage return too many.
    assert all(b"\r\r" not in path.read_bytes() for path in written.iterdir())


@pytest.mark.parametrize("locale", LOCALES)
def test_a_mistake_beside_letters_that_the_locale_lacks(folder: Path, locale: str) -> None:
    (folder / "größe 1.frag").write_bytes(SHADER.replace("gross =", "gross = „").encode())
    status, _, err = shadercache(folder, locale, "check", "größe 1.frag")
    assert (status, b"Traceback" in err) == (1, False) and b":6:" in err, err


def test_a_long_path(folder: Path) -> None:
    """Longer than the 260 characters of Windows; a system that has no longer ones says so."""
    out = Path(*["x" * 60] * 6, "out")
    line = ("rewrite", "größe 1.frag", "--node", NODE, "-o", str(out))
    status, _, err = shadercache(folder, "C", *line)
    assert (status, (folder / out / "manifest.json").is_file()) == (0, True) or b"[SC002]" in err
