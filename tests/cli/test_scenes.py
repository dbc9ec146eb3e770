"""Which nodes are meant on a command line about a scene."""

from __future__ import annotations

import pytest

from shadercache.cli.scenes import choose_nodes
from shadercache.compiler import Analysis
from shadercache.diagnostics import UsageError
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import Scene, load_scene


@pytest.fixture(scope="module")
def dragon() -> tuple[Scene, Analysis]:
    return analyse_scene(load_scene(data_path("corpus", "dragon", "scene.toml")))


def test_nodes_have_ids_and_names_and_go_together(dragon: tuple[Scene, Analysis]) -> None:
    scene, analysis = dragon
    octaves, albedo = (scene.nodes[name] for name in ("two octaves", "albedo"))
    found = choose_nodes(scene, analysis, [albedo, f"two octaves+{albedo}"])
    assert [(payload.label, list(payload.ids)) for payload in found] == [
        (albedo, [albedo]),
        (f"two octaves+{albedo}", [octaves, albedo]),
    ]


@pytest.mark.parametrize(
    ("wanted", "said"),
    [
        ("albedo+nothing", "no node 'nothing'"),
        ("albedo+", "lacks an id beside a '+'"),
        ("", "no node ''"),
    ],
)
def test_what_is_not_there(dragon: tuple[Scene, Analysis], wanted: str, said: str) -> None:
    with pytest.raises(UsageError, match="SC010") as caught:
        choose_nodes(*dragon, [wanted])
    assert said in str(caught.value)
