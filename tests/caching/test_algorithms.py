"""The table of algorithms, and that it is where they are known."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

import shadercache
from shadercache.caching import algorithms
from shadercache.caching.algorithms import (
    ALGORITHMS,
    CACHE,
    COLOR,
    NAMES,
    Algorithm,
    AlgorithmPass,
    algorithm,
)
from shadercache.emit.builder import function_named
from tests.configured import rewritten
from tests.shaders import analysed, find

PACKAGE = Path(shadercache.__file__).parent


def test_every_maker_and_check_is_there() -> None:
    for record in ALGORITHMS:
        checks = [record.unfit] if record.unfit else []
        for text in [*checks, *(item.maker for item in record.passes)]:
            assert callable(function_named(text)), text


def test_names_and_files_are_told_apart() -> None:
    files = [record.file_of(item) for record in ALGORITHMS for item in record.passes]
    assert len(set(files)) == len(files)
    assert len(set(NAMES)) == len({record.word for record in ALGORITHMS}) == len(ALGORITHMS)
    assert algorithm("2-pass").resets_at_once and not algorithm("1-pass").resets_at_once
    assert [record.name for record in ALGORITHMS if record.reads_back] == ["3-pass"]


def test_each_begins_anew_without_the_last_frame() -> None:
    """What is drawn on a reset writes colour and cache, in one pass or in several."""
    for record in ALGORITHMS:
        written = {target for item in record.passes if item.on_reset for target in item.targets}
        assert {"color", "cache"} <= written


def test_a_record_is_all_that_a_pass_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    """One that draws the screen has a vertex shader of its own, and its depth is the record's."""
    made = AlgorithmPass(
        "all", "two_passes:miss", (COLOR, CACHE), draws="screen", depth_write=False
    )
    toy = Algorithm("toy", "toy", (made,))
    monkeypatch.setitem(algorithms._BY_NAME, "toy", toy)
    analysis = analysed("o_color = vec4(sin(v_position) * cos(v_normal), 1.0);")
    node = find(analysis, "sin(v_position) * cos(v_normal)")
    emission = rewritten(analysis, node, algorithms=["toy"], unprofitable=True)
    [variant] = emission.manifest.variants
    [told] = variant.passes
    assert (told.depth.test, told.depth.write) == ("less", False)
    assert "gl_VertexID" in emission.files["toy.vert"] and not told.attributes


def test_no_other_file_names_an_algorithm() -> None:
    named = re.compile("|".join(rf'"{name}"' for name in NAMES))
    for path in PACKAGE.rglob("*.py"):
        if path.name != "algorithms.py":
            assert not named.search(path.read_text(encoding="utf-8")), path


def test_the_schema_knows_the_same() -> None:
    text = (PACKAGE / "manifest.schema.json").read_text(encoding="utf-8")
    lists = [json.loads(found) for found in re.findall(r"\[[^][{}]*-pass[^][{}]*\]", text)]
    assert lists and all(tuple(names) == NAMES for names in lists)
