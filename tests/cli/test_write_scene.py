"""``shadercache scene``: from a model and a pair of shaders to a benchmark in two commands."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.gltf_maker import quad, tower

from .conftest import Shell

pytestmark = pytest.mark.xdist_group("gl")

SHADERS = Path(__file__).parents[1] / "linking" / "first_scene"


@pytest.fixture
def model(tmp_path: Path) -> Path:
    return tower().glb(tmp_path / "tower.glb")


def test_two_commands_measure_ones_own_model(shell: Shell, tmp_path: Path, model: Path) -> None:
    out = tmp_path / "a" / "b"
    pair = "--frag", SHADERS / "plain.frag", "--vert", SHADERS / "skinned.vert"
    outcome = shell("scene", model, *pair, "-o", out)
    assert outcome.status == 0, outcome.err
    assert f"next: shadercache bench {out / 'scene.toml'}" in outcome.out
    assert "what these are: uWarp [SC039]" in outcome.err
    told = shell(
        *("bench", out / "scene.toml", "--size", "64", "--frames", "4", "--passes", "2"),
        *("--until", "0", "--seconds", "0", "-o", tmp_path / "results", "--json"),
    )
    assert told.status == 0, told.err
    assert any("waves(vPos)" in str(line) for line in told.out.splitlines())


def test_a_scene_that_is_there_is_kept(shell: Shell, tmp_path: Path) -> None:
    model = quad().gltf(tmp_path / "q.gltf")
    wanted = "scene", model, "--frag", SHADERS / "three.frag", "-o", tmp_path / "out"
    assert shell(*wanted).status == 0
    kept = tmp_path / "out" / "scene.toml"
    kept.write_text("mine")
    outcome = shell(*wanted)
    assert outcome.status == 2 and "SC038" in outcome.err and kept.read_text() == "mine"
    assert shell(*wanted, "--force").status == 0
    assert kept.read_text() != "mine"


@pytest.mark.parametrize(
    ("model", "fragment", "status", "code"),
    [
        ("none.glb", "plain.frag", 1, "SC510"),
        ("m.fbx", "plain.frag", 1, "SC510"),
        ("tower.glb", "none.frag", 2, "SC005"),
        ("tower.glb", "three.frag", 1, "SC521"),
    ],
)
def test_what_cannot_be_written(
    shell: Shell, tmp_path: Path, model: str, fragment: str, status: int, code: str
) -> None:
    tower().glb(tmp_path / "tower.glb")
    out = tmp_path / "out"
    outcome = shell("scene", tmp_path / model, "--frag", SHADERS / fragment, "-o", out)
    assert outcome.status == status and code in outcome.err
    assert not out.exists()
