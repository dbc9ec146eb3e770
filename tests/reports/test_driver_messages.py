"""What the driver says of a user's shader is told at its place in the user's file."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.cli.app import main
from shadercache.compiler import analyse, emit_original
from shadercache.source import Source

pytestmark = pytest.mark.xdist_group("gl")

FOLDER = Path(__file__).with_name("driver_messages")

REFUSED = {
    "binding": ":7:1: error: the driver says: ",
    "location": ":2:28: error: the driver says: ",
    "version": ": error: the driver says: ",
    "too_many": ": the driver refuses the program: ",
    "block_size": ": the driver refuses the program: ",
}
"""A shader that this driver does not take -> what follows the file's name."""


def verify(path: Path) -> int:
    return main(["verify", str(path), "--mapping", "screen", "-j", "1", "--proof-only"])


@pytest.mark.parametrize("name", REFUSED)
def test_the_users_file_is_named(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    path = FOLDER / f"{name}.frag"
    assert verify(path) == 1
    told = capsys.readouterr().err
    assert f"{path}{REFUSED[name]}" in told
    assert "[SC602]" in told
    assert "original." not in told


@pytest.mark.parametrize("name", ["binding", "location", "version"])
def test_run_and_bench_name_it_too(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = FOLDER / f"{name}.frag"
    source = Source(str(path), path.read_text(encoding="utf-8"))
    node = next(node.id for node in analyse(source, mapping="screen").nodes if node.legal)
    common = [str(path), "--mapping", "screen", "--size", "32", "-o", str(tmp_path)]
    for line in (
        ["run", *common, "--node", node, "--unprofitable", "--frame", "2"],
        ["bench", *common, "--nodes", node, "--until", "0"],
    ):
        assert main(line) == 1
        told = capsys.readouterr().err
        assert f"{path}{REFUSED[name]}" in told
        assert "original." not in told


@pytest.mark.parametrize("name", ["o11_driver_message_file", "unnamed"])
def test_parameters_without_names_are_given_some(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert verify(FOLDER / f"{name}.frag") == 0
    assert "nodes exact in proof mode" in capsys.readouterr().out


def test_names_are_given_to_those_without_alone() -> None:
    text = (FOLDER / "unnamed.frag").read_text(encoding="utf-8")
    printed = emit_original(analyse(Source("unnamed.frag", text))).files["original.frag"]
    assert "float one(float, vec2);" in printed
    assert "float one(float sc_unnamed_0, vec2 p)" in printed
    assert "float two(vec2 p, float[2] sc_unnamed_1, Light sc_unnamed_2)" in printed
    assert "void three(out float sc_unnamed_0, in vec2 p, inout vec2 q)" in printed
    assert "float four(int sc_unnamed_0, int sc_unnamed_1)" in printed
