"""One value names one configuration."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.diagnostics import InputError
from tests.configured import DEFAULT, configured

CHOSEN = replace(
    configured(mode="proof", form="rgba32f", period=7, block=2, epsilon=0.5, ids=True, age=True),
    nodes=("main.0-1", "main.1-2"),
    algorithm="3-pass",
)


@pytest.mark.parametrize("configuration", [DEFAULT, CHOSEN])
def test_what_is_written_down_is_read_back(configuration: Configuration) -> None:
    text = json.dumps(configuration.to_json())
    back = Configuration.from_json(json.loads(text))
    assert back == configuration and hash(back) == hash(configuration)
    assert back.key == configuration.key and len(back.key) == 12


def test_what_is_left_out_has_its_default() -> None:
    assert Configuration.from_json({"refresh": {"period": 8}}) == configured(period=8)


@pytest.mark.parametrize(
    ("data", "path"),
    [
        (3, "configuration cannot"),
        ({"colour": "red"}, "configuration.colour"),
        ({"refresh": {"schedule": "often"}}, "configuration.refresh.schedule"),
        ({"refresh": {"period": True}}, "configuration.refresh.period"),
        ({"nodes": ["a", 2]}, r"configuration.nodes\[1\]"),
        ({"algorithm": "9-pass"}, "configuration.algorithm"),
        ({"storage": None}, "configuration.storage"),
    ],
)
def test_a_mistake_is_told_at_its_path(data: Any, path: str) -> None:
    with pytest.raises(InputError, match=path) as caught:
        Configuration.from_json(data)
    assert caught.value.diagnostics[0].code == "SC029"


def test_when_everything_is_renewed() -> None:
    assert configured(period=1).refresh.renews
    assert configured(period=1, refresh="none", age=True).refresh.renews
    assert not configured(period=1, refresh="none").refresh.renews
    assert not configured(period=2).refresh.renews


def test_uniforms_never_recompile() -> None:
    for same in ({"period": 8}, {"block": 2}, {"epsilon": 0.25}, {"form": "rgba32f"}):
        other = configured(CHOSEN, **same)
        assert other.program_key == CHOSEN.program_key, same
        assert other == CHOSEN or other.key != CHOSEN.key
    for apart in ({"ids": False}, {"filter": "nearest"}, {"mode": "plain"}, {"fetches": "level"}):
        assert configured(CHOSEN, **apart).program_key != CHOSEN.program_key, apart
    assert replace(CHOSEN, algorithm="1-pass").program_key != CHOSEN.program_key


def test_an_assignment_gives_each_object_a_configuration_or_its_original() -> None:
    assigned = Assignment((("a", CHOSEN), ("b", CHOSEN), ("c", None)))
    assert [item["objects"] for item in assigned.to_json()] == [["a", "b"], ["c"]]
    assert assigned.to_json()[1]["configuration"] is None
    left = assigned.with_originals(["a"])
    assert [chosen for _, chosen in left.objects] == [None, CHOSEN, None]
    assert hash(left) != hash(assigned)
