"""Run command lines in this process."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from shadercache.cli.app import main

SHADERS = Path(__file__).parent / "shaders"


@dataclass(frozen=True)
class Outcome:
    """What a command line left."""

    status: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out)

    @property
    def nodes(self) -> list[dict[str, Any]]:
        """The nodes of ``nodes --json``, each with what its numbers stand for."""
        told = self.json
        return [whole_node(told, node) for node in told["nodes"]]


def whole_node(told: dict[str, Any], node: dict[str, Any]) -> dict[str, Any]:
    """One node of ``nodes --json`` with what stands in the tables (docs/use/nodes-json.md)."""
    inputs = dict(told["inputs"][node["inputs"]])
    refusal, on_cpu = node.get("refusal"), node.get("on_cpu")
    told_of = {key: value for key, value in node.items() if key != "expression"}
    return {
        **told_of,
        **told["expressions"][node["expression"]],
        "path": told["paths"][node["path"]],
        "inputs": inputs.pop("names"),
        **inputs,
        "group": told["nodes"][node["group"]]["id"],
        "refusal": None if refusal is None else told["refusals"][refusal],
        "on_cpu": None if on_cpu is None else told["on_cpu"][on_cpu],
    }


Shell = Callable[..., Outcome]


@pytest.fixture
def shell(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Shell:
    """``shell("nodes", path, stdin=b"...")``."""

    def call(*args: object, stdin: bytes = b"") -> Outcome:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin)))
        status = main([str(arg) for arg in args])
        captured = capsys.readouterr()
        return Outcome(status, captured.out, captured.err)

    return call


@pytest.fixture
def fragment() -> Path:
    return SHADERS / "small.frag"


@pytest.fixture
def rings(shell: Shell, fragment: Path) -> str:
    """The id of the node ``rings(v_position)``."""
    nodes = shell("nodes", fragment, "--json").nodes
    return next(node["id"] for node in nodes if node["text"] == "rings(v_position)")
