"""Programs that leave something out, for profiles."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from shadercache.caching.algorithms import PROFILED, LeftOut
from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis, rewrite
from tests.cases.cases import analysed
from tests.glslang import needs_glslang, objections

BOTH: tuple[LeftOut, ...] = ("look-up", "look-up and store")


def first_pass(analysis: Analysis, left_out: LeftOut) -> str:
    """The fragment shader of the first pass, for the first node that is offered."""
    return texts(analysis, left_out)["2-pass.hit.frag"]


def texts(analysis: Analysis, left_out: LeftOut) -> dict[str, str]:
    node = next(node for node in analysis.nodes if node.offered)
    chosen = Configuration((node.id,), PROFILED)
    return dict(rewrite(analysis, chosen, left_out=left_out).files)


@pytest.mark.parametrize("name", ["discard_before", "matrices"])
def test_nothing_is_looked_up(name: str) -> None:
    text = first_pass(analysed(name), "look-up")
    assert "sc_cache" not in text
    assert "discard" not in text or name == "discard_before"
    assert re.search(r"out \w+ sc_store;", text)


@pytest.mark.parametrize("name", ["discard_before", "matrices"])
def test_nothing_is_stored(name: str) -> None:
    text = first_pass(analysed(name), "look-up and store")
    assert "sc_store" not in text
    assert "sc_epsilon" in text, "the payload is no constant"


@needs_glslang
@pytest.mark.parametrize("left_out", BOTH)
@pytest.mark.parametrize("name", ["discard_before", "matrices", "integers_booleans", "es_100"])
def test_glslang_takes_the_programs(left_out: LeftOut, name: str, tmp_path: Path) -> None:
    assert not objections(texts(analysed(name), left_out).items(), tmp_path)
