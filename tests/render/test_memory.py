"""What textures take."""

from __future__ import annotations

from dataclasses import replace

import pytest

from shadercache.caching.configuration import Configuration, PayloadRate
from shadercache.caching.settings import with_settings
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.memory import bytes_per_pixel


@pytest.mark.parametrize(
    ("algorithm", "settings", "rate", "expected"),
    [
        ("2-pass", [], "full", 2 * 8),
        ("3-pass", [], "full", 2 * 8),
        # Three floats and their offsets, packed into one texel of 32-bit floats.
        ("2-pass", ["filter=carried"], "full", 2 * 16),
        ("2-pass", ["filter=carried,ids=on"], "full", 2 * 16),
        # The id takes a second texture of one half float.
        ("2-pass", ["ids=on"], "full", 2 * (8 + 2)),
        ("3-pass", [], "half", 2 * 8 / 4),
        ("3-pass", [], "quarter", 2 * 8 / 16),
        # 14 numbers of 32 bits are parked.
        ("parked", [], "full", 2 * 8 + 4 * 14),
    ],
)
def test_of_a_payload_of_three_floats(
    algorithm: str, settings: list[str], rate: PayloadRate, expected: float
) -> None:
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    plain = Configuration((scene.nodes["whole noise"],), algorithm)
    chosen = with_settings(replace(plain, payload_rate=rate), settings)
    linker = Linker(scene, analysis)
    [linked, *_] = linker.link(linker.assign(chosen))
    assert bytes_per_pixel(linked.bundle, algorithm) == expected
