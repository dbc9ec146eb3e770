"""``./dev bench-emit``: the shaders it makes and reads, and what it makes of the times."""

from __future__ import annotations

from typing import Any

import pytest

from bench.emit_speed import VERIFIED, growth, made_shader, shaders, targets
from bench.speed import HERE, targets_table
from shadercache.compiler import analyse
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.scene.description import load_scene


def _emission(plain: float, proof: float) -> list[dict[str, Any]]:
    rows = [("weathered", "plain", plain), ("weathered", "proof", proof), ("other", "plain", 9.0)]
    return [{"shader": name, "mode": mode, "seconds": [value]} for name, mode, value in rows]


@pytest.mark.parametrize(
    ("plain", "proof", "last", "used", "met"),
    [
        (0.014, 0.015, 12.0, (59.0, 119.0), [True, True, True, True, True, True]),
        (0.016, 0.014, 12.0, (61.0, 119.0), [False, True, True, True, False, True]),
        (0.014, 0.016, 13.0, (59.0, 121.0), [True, False, False, True, True, False]),
        (0.014, 0.014, 12.0, (), [True, True, True, True]),
    ],
)
def test_targets(
    plain: float, proof: float, last: float, used: tuple[float, ...], met: list[bool]
) -> None:
    grown = [
        {"nodes": 100, "analyse": 1.0, "groups": 1.0},
        {"nodes": 800, "analyse": last, "groups": 8.0},
    ]
    verified = [{"processor seconds": seconds, "cores": 2} for seconds in used]
    found = targets(_emission(plain, proof), grown, verified)
    assert [item["met"] for item in found] == met
    assert targets_table(found).count("MISSED") == met.count(False)


def test_made_shaders_grow_as_they_should() -> None:
    one, two = (len(analyse(made_shader(pieces)).nodes) for pieces in (4, 8))
    assert 1.9 < two / one < 2.1
    assert growth(1)[0]["nodes"] < growth(1)[-1]["nodes"]


def test_the_shaders_have_the_length_that_the_targets_speak_of() -> None:
    fragment, _ = next(shaders())
    assert fragment.name == "weathered"
    assert 295 <= fragment.text.count("\n") <= 310
    lines = (HERE / "shaders" / "lantern.frag").read_text(encoding="utf-8").count("\n")
    assert lines == 100


def test_the_scene_that_is_verified_can_be_read() -> None:
    _, analysis = analyse_scene(load_scene(VERIFIED))
    assert sum(node.offered for node in analysis.nodes) > 100
