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
    nodes = shell("nodes", fragment, "--json").json["nodes"]
    return next(node["id"] for node in nodes if node["text"] == "rings(v_position)")
