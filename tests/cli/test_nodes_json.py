"""``shadercache nodes --json``: everything is said once, and takes no more than there is."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from bench.nodes_speed import field_of
from shadercache.analysis.costs.shared_work import SharedWorkTable
from shadercache.paths import data_path

from .conftest import Shell

TABLES = ("expressions", "paths", "inputs", "refusals", "on_cpu")
DRAGON = data_path("corpus", "dragon") / "dragon.frag"


@pytest.fixture
def walks(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often a function is walked, or a whole shader."""
    found: Counter[str] = Counter()
    for name in ("_walk", "parts_of_set"):
        monkeypatch.setattr(SharedWorkTable, name, _counted(found, name))
    return found


def _counted(found: Counter[str], name: str) -> Any:
    inner = getattr(SharedWorkTable, name)

    def counted(*arguments: Any) -> Any:
        found[name] += 1
        return inner(*arguments)

    return counted


def listed(shell: Shell, parts: int, *options: str) -> Any:
    text = field_of(parts).text.encode()
    return shell("nodes", "-", "--json", *options, stdin=text)


def test_what_is_printed_grows_with_the_shader(shell: Shell) -> None:
    small, large = listed(shell, 4), listed(shell, 16)
    nodes = [len(outcome.json["nodes"]) for outcome in (small, large)]
    assert nodes[1] > 3 * nodes[0]
    sizes = [len(outcome.out) / count for outcome, count in zip((small, large), nodes, strict=True)]
    assert sizes[1] < 1.05 * sizes[0] < 1.05 * 250


def test_a_path_more_takes_no_more_walks(shell: Shell, walks: Counter[str]) -> None:
    nodes = listed(shell, 4).json["nodes"]
    first = walks.total()
    legal = sum("payload" in node for node in nodes)
    assert first < legal / 2 and not walks["parts_of_set"]
    more = listed(shell, 16).json["nodes"]
    assert walks.total() - first < 4.5 * first and len(more) > 3 * len(nodes)


def test_everything_is_said_once(shell: Shell) -> None:
    told = listed(shell, 8).json
    for name in TABLES:
        said = [str(value) for value in told[name]]
        assert len(set(said)) == len(said), name
    assert len(told["expressions"]) * 10 < len(told["nodes"])
    assert len(told["inputs"]) < 20 and len(told["refusals"]) < 20


@pytest.mark.parametrize("options", [(), ("--offered",), ("--sort", "ratio")])
def test_the_tables_hold_what_is_needed_and_no_more(shell: Shell, options: tuple[str, ...]) -> None:
    told = shell("nodes", DRAGON, "--json", *options).json
    names = {"expressions": "expression", "paths": "path", "refusals": "refusal"}
    for table in TABLES:
        name = names.get(table, table)
        used = {node[name] for node in told["nodes"] if name in node}
        assert used == set(range(len(told[table])))
    assert all(told["nodes"][n["group"]]["group"] == n["group"] for n in told["nodes"])


def test_offered_ones_are_told_as_among_all(shell: Shell) -> None:
    every = {node["id"]: node for node in shell("nodes", DRAGON, "--json").nodes}
    offered = shell("nodes", DRAGON, "--json", "--offered").nodes
    assert offered == [node for node in every.values() if node["offered"]]


def test_offered_leaves_the_work_for_others_undone(shell: Shell, walks: Counter[str]) -> None:
    listed(shell, 4)
    every = walks.total()
    listed(shell, 4, "--offered")
    assert walks.total() - every < every


def test_passes_add_up(shell: Shell) -> None:
    told = shell("nodes", DRAGON, "--json").json
    for node in told["nodes"]:
        assert ("payload" in node) == ("remainder" in node)
        if "payload" in node:
            assert max(node["payload"], node["remainder"]) <= told["whole"]
            assert node["payload"] + node["remainder"] >= told["whole"]
    assert told["schema_version"] == 2


def test_a_shader_without_nodes(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "empty.frag"
    path.write_text("#version 330\nout vec4 c;\nvoid main() {}\n")
    told = shell("nodes", path, "--json").json
    assert told["nodes"] == [] and told["whole"] == 0
