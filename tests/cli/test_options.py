"""Options that commands share: what becomes of them."""

from __future__ import annotations

from importlib import import_module
from inspect import Parameter, signature
from pathlib import Path

import pytest

from shadercache.caching.algorithms import NAMES, USUAL
from shadercache.cli import options
from shadercache.cli.app import COMMANDS
from shadercache.cli.options import ShaderOptions, SourceOptions
from shadercache.diagnostics import UsageError
from shadercache.front.read_options import ReadOptions


def test_without_options() -> None:
    assert SourceOptions().read_options() == ReadOptions()
    assert ShaderOptions(unroll=True).read_options() == ReadOptions(unroll=True)


def test_definitions(tmp_path: Path) -> None:
    read = SourceOptions(
        define=["A", "B=", "C=x = 1", "A=2"],
        undefine=["GL_ES"],
        include=[tmp_path],
        dialect="auto",
        max_tokens=10,
    ).read_options()
    assert read.defines == (("A", "2"), ("B", ""), ("C", "x = 1"))
    assert read.undefined == ("GL_ES",)
    assert read.include_folders == (tmp_path,)
    assert (read.dialect, read.max_tokens) == ("auto", 10)


def test_the_fields_of_a_group_stand_in_its_place() -> None:
    small = options.DrawOptions(size="512", weigh=False)

    def command(
        scene: options.SceneOptions, frames: int = 3, draw: options.DrawOptions = small
    ) -> tuple[object, ...]:
        return scene.target, scene.unroll, frames, draw.size, draw.cache_format, draw.weigh

    shown = signature(options.expanded(command)).parameters
    assert shown["target"].default is Parameter.empty, "it has to be given"
    assert (shown["unroll"].default, shown["frames"].default) == (False, 3)
    assert (shown["size"].default, shown["weigh"].default) == ("512", False)
    assert "scene" not in shown and "draw" not in shown
    given = {name: item.default for name, item in shown.items()} | {"target": "a.toml"}
    values = options.expanded(command)(**given)
    assert values == ("a.toml", False, 3, "512", "rgba16f", False)


def test_what_is_no_size_is_said_before_anything_is_compiled() -> None:
    with pytest.raises(UsageError, match="SC007"):
        options.PictureOptions(size="wide")


def test_a_list_of_rates() -> None:
    assert options.parse_rates("half,full") == ["half", "full"]


@pytest.mark.parametrize("text", ["", "third", "full,third", "half quarter"])
def test_what_is_no_rate(text: str) -> None:
    with pytest.raises(UsageError, match="--rate"):
        options.parse_rates(text)


@pytest.mark.parametrize(
    ("texts", "names"),
    [
        (["a,b", "c"], ["a", "b", "c"]),
        (["f(x, y),m[i, 1]"], ["f(x, y)", "m[i, 1]"]),
        (["a+f(x, y), :95:3"], ["a+f(x, y)", " :95:3"]),
        (["", ",a,", "f(x, y"], ["a", "f(x, y"]),
        (["a),b"], ["a)", "b"]),
    ],
)
def test_commas_part_names_of_nodes_outside_of_brackets(texts: list[str], names: list[str]) -> None:
    assert options.split_names(texts) == names


def test_a_list_of_algorithms() -> None:
    assert options.parse_passes("all") == USUAL
    assert options.parse_passes("2,parked") == ("2-pass", "parked")
    assert options.parse_passes("all,parked,2") == NAMES


@pytest.mark.parametrize("text", ["", "4", "2-pass", "all parked"])
def test_what_is_no_algorithm(text: str) -> None:
    with pytest.raises(UsageError, match="--passes"):
        options.parse_passes(text)


@pytest.mark.parametrize("name", COMMANDS)
def test_no_command_has_more_than_twelve_parameters_of_its_own(name: str) -> None:
    command = import_module(f"shadercache.cli.{COMMANDS[name]}").command
    assert len(signature(command).parameters) <= 12
