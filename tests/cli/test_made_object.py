"""Commands on a fragment shader without a scene, which is shown by a made object."""

from __future__ import annotations

import json
import shutil
import tempfile
from contextlib import ExitStack
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest
import typer

from shadercache.cli.app import Reporter
from shadercache.cli.options import SceneOptions
from shadercache.linking.linker import Linker
from shadercache.scene.camera import uniform_values

from .conftest import Shell

MADE = Path(__file__).parents[1] / "linking" / "made"
SMALL = ("--size", "48", "--frames", "4", "--seconds", "1")

pytestmark = pytest.mark.xdist_group("gl")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the shaders, where made things go to a folder beside them."""
    for path in MADE.iterdir():
        shutil.copy(path, tmp_path)
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def left_behind(folder: Path) -> list[Path]:
    return list((folder / "temporary").glob("shadercache-*"))


def test_bench_takes_a_pair(shell: Shell, folder: Path) -> None:
    chosen = ("--nodes", "sum", "--passes", "2", *SMALL, "--json", "-o", "out")
    done = shell("bench", "textured.frag", *chosen)
    assert done.status == 0, done.err
    assert done.json["scene"] == "textured"
    assert "note: textured.frag has no scene, and what it needs is guessed: texture1" in done.err
    assert "[SC040]" in done.err
    shutil.move("textured.vert", "other.vert")
    done = shell("bench", "textured.frag", "--vert", "other.vert", *chosen)
    assert done.status == 0 and left_behind(folder) == []


def test_run_and_verify_take_a_fragment_shader_alone(shell: Shell, folder: Path) -> None:
    node = ("--node", "bands(uv)")
    done = shell("run", "alone.frag", *node, "--passes", "1", "--size", "48", "-o", "out")
    assert done.status == 0 and "mapping: surface" in done.out
    assert "FragPos is taken for the position, in the space of the world" in done.err
    done = shell("verify", "alone.frag", *node, "-j", "1")
    assert (done.status, left_behind(folder)) == (0, [])
    assert "laws 2-4: 1 of 1 nodes exact in proof mode" in done.out


def test_processes_of_verify_see_what_was_made(shell: Shell, folder: Path) -> None:
    flat = (folder / "textured.vert").read_text()
    flat = flat.replace("projection * view * model * ", "")
    (folder / "flat.vert").write_text(flat)
    node = ("--node", "sum", "--unprofitable", "-j", "2")
    for more, mapping in (((), "surface"), (("--vert", "flat.vert"), "screen")):
        done = shell("verify", "textured.frag", *more, *node)
        assert done.status == 0, done.err
        assert f"mapping: {mapping}" in done.out


def test_a_sweep_can_be_resumed(shell: Shell, folder: Path) -> None:
    sweep = ("sweep", "alone_es.frag", "--nodes", "rings", "--passes", "1", *SMALL, "-o", "s.db")
    assert "written to s.db: 1, of which failures: 0" in shell(*sweep).out
    done = shell(*sweep, "--export", "rows.json")
    assert "nothing to do" in done.out
    [row] = json.loads((folder / "rows.json").read_text())["rows"]
    assert row["scene"]["path"].endswith("alone_es.frag")
    assert left_behind(folder) == []
    # The text of the shader counts, wherever its scene was made.
    text = (folder / "alone_es.frag").read_text()
    (folder / "alone_es.frag").write_text(f"{text}// changed\n")
    assert "1 row is stale" in shell(*sweep).out


@pytest.mark.parametrize("vert", [None, "flat.vert"])
def test_a_recording_is_played_by_what_was_made(folder: Path, vert: str | None) -> None:
    flat = (folder / "textured.vert").read_text().replace("projection * view * model * ", "")
    (folder / "flat.vert").write_text(flat)
    (folder / "frames.csv").write_text("time,cut\n7.0,0\n9.0,1\n")
    source = SceneOptions(target="textured.frag", vert=vert and Path(vert))
    with ExitStack() as stack:
        context = SimpleNamespace(with_resource=stack.enter_context, obj=Reporter())
        scene, analysis = source.open(cast(typer.Context, context), Path("frames.csv"))
        Linker(scene, analysis)
    assert (scene.common.mesh is None) == (vert is not None)
    part = scene.parts[0]
    assert uniform_values(scene.view, part, 1, (8, 8))["time"] == 9.0
    assert scene.view.camera_path.cuts == {1}


def test_what_cannot_be_shown(shell: Shell, folder: Path) -> None:
    text = (folder / "alone_es.frag").read_text()
    (folder / "thing.frag").write_text(text.replace("vUv", "vThing"))
    done = shell("bench", "thing.frag")
    assert done.status == 2 and "what vThing (vec2) is [SC005]" in done.err
    done = shell("bench", "dragon", "--vert", "mapped.vert")
    assert done.status == 2 and "names its vertex shader itself [SC008]" in done.err
    assert left_behind(folder) == []
