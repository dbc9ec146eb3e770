"""Scene files: what is read, and one diagnostic for each mistake."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.scene.camera import look_at, perspective, rotation, uniform_values
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.motion import Motion


def broken(folder: Path, old: str, new: str) -> InputError:
    """What is said of the torus scene with one piece of text replaced."""
    text = (folder / "scene.toml").read_text()
    assert old in text
    path = folder / "broken.toml"
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(InputError) as caught:
        load_scene(path)
    return caught.value


def test_a_scene_may_ask_for_unrolled_loops(scene: Scene, scene_folder: Path) -> None:
    assert not analyse_scene(scene)[1].reading.unroll
    path = scene_folder / "unrolled.toml"
    path.write_text("unroll = true\n" + (scene_folder / "scene.toml").read_text())
    assert analyse_scene(load_scene(path))[1].reading.unroll
    assert analyse_scene(scene, ReadOptions(unroll=True))[1].reading.unroll


def test_a_scene_may_ask_for_values_of_the_screen(scene: Scene, scene_folder: Path) -> None:
    assert not analyse_scene(scene)[1].reading.approximate
    path = scene_folder / "approximate.toml"
    path.write_text("approximate = true\n" + (scene_folder / "scene.toml").read_text())
    assert analyse_scene(load_scene(path))[1].reading.approximate
    assert analyse_scene(scene, ReadOptions(approximate=True))[1].reading.approximate


def test_a_folder_stands_for_its_scene_file(scene: Scene, scene_folder: Path) -> None:
    assert scene.path == scene_folder / "scene.toml"
    assert scene.name == "torus"
    item = scene.common
    assert item.fragment.is_file() and item.mesh.is_file()
    assert item.verify_mesh == item.mesh
    assert item.inputs.constants["u_light"] == (0.4, 0.8, 0.5)
    assert item.inputs.semantics["u_model"] == "model"
    assert scene.demo is not None and scene.demo.nodes == ("payload",)
    assert not item.cull


@pytest.mark.parametrize(
    ("old", "new", "code", "words", "line"),
    [
        ('name = "torus"', 'name = "torus', "SC502", "not TOML", 1),
        ('mesh = "torus.npz"', "", "SC503", "mesh is missing", None),
        ('mesh = "torus.npz"', 'mesh = "no.npz"', "SC507", "mesh: there is no file", 5),
        ('mesh = "torus.npz"', "mesh = 3", "SC505", "mesh must be a string, not 3", 5),
        ("[camera]\neye = [0.0,", '[camera]\neye = ["x",', "SC505", "camera.eye must be", 13),
        ("fov_degrees = 45.0", "fov_degrees = 180", "SC505", "between 0 and 180", 16),
        ("near = 0.5", "near = 20", "SC505", "camera.near must be above 0", 17),
        ("near = 0.5", "", "SC503", "camera.near is missing", 12),
        ("eye = [0.0, 1.2, 2.6]", "eye = [0.0, 3.0, 0.0]", "SC505", "do not span", 13),
        ("near = 0.5", "near = inf", "SC505", "must be a finite number", 17),
        ("frames = 64", "frames = 0", "SC505", "a whole number from 1 up", 24),
        ("axis = [1.0, 0.2, 0.0]", "axis = [0, 0, 0]", "SC505", "axis must not be zero", 21),
        ('semantic = "model" }', 'semantic = "modle" }', "SC506", "semantic 'modle'", 28),
        ('{ semantic = "model" }', "{ semantics = 1 }", "SC505", "u_model must be", 28),
        ("u_scale = 5.0", "u_scale = [[1, 2], [3]]", "SC505", "u_scale must be", 30),
        ("block = 4", "block = 1", "SC505", "from 2 up", 38),
        ("block = 4", "blocks = 4", "SC504", "unknown key demo.blocks", 38),
        ('nodes = ["payload"]', "nodes = [1]", "SC505", "an array of strings", 36),
        ("[nodes]", "[changes]\nlight = 'u'\n[nodes]", "SC505", "changes.light must be", 33),
        ("[nodes]", "[changes]\nwind = ['u']\n[nodes]", "SC504", "unknown key changes.wind", 33),
        ("[nodes]", "[knots]", "SC504", "unknown key knots", None),
        ("[nodes]", "[nodes]\nx = 1\n[textures.u_t]\nfile='torus.npz'\nwrap='mirror'", "SC505",
         "one of repeat, clamp", 36),
    ],
)  # fmt: skip
def test_one_mistake(
    scene_folder: Path, old: str, new: str, code: str, words: str, line: int | None
) -> None:
    error = broken(scene_folder, old, new)
    found = [item for item in error.diagnostics if words in item.message]
    assert [item.code for item in found] == [code], str(error)
    rendered = found[0].render()
    assert "broken.toml" in rendered
    if line is not None:
        assert f"broken.toml:{line}:" in rendered


@pytest.mark.parametrize(
    ("old", "new", "hint", "line"),
    [
        ('mesh = "torus.npz"', "mesh = torus.npz", 'quotes: "torus.npz"', 5),
        ('mesh = "torus.npz"', r"mesh = 'C:\meshes\torus.npz'", "write / between folders", 5),
        ("u_scale = 5.0", "u_scale = True", "write true", 30),
        ("u_scale = 5.0", "lamps[1].power = 5.0", '"lamps[1].power" = ...', 30),
        ("u_scale = 5.0", 'camera.view = "view"', 'write "camera.view" in quotes', 30),
        ("u_scale = 5.0", "lamp.power = 2.0", 'write "lamp.power" in quotes', 30),
        ("u_scale = 5.0", "u_scale = {begin = 1, step = 2}", "start and per_frame", 30),
        ("u_scale = 5.0", "u_scale = {strt = 1, per_frame = 2}", "did you mean start?", 30),
        ("u_scale = 5.0", 'u_scale = {start = 1, per_frame = "2"}', None, 30),
        ("u_scale = 5.0", 'u_scale = {table = "none.npz", array = "a"}', None, 30),
        ('"model"', '"modell"', "did you mean 'model'?", 28),
        ("fov_degrees = 45.0", "fov_degree = 45.0", "did you mean fov_degrees?", 16),
        ("frames = 64", "frame = 64", "did you mean frames?", 24),
        ("[nodes]", "[nods]", "did you mean nodes?", 32),
    ],
)
def test_what_was_meant(
    scene_folder: Path, old: str, new: str, hint: str | None, line: int | None
) -> None:
    error = broken(scene_folder, old, new)
    hints = [item.hint for item in error.diagnostics if item.hint]
    assert (hint is None and not hints) or any(hint in text for text in hints if hint), str(error)
    if line is not None:
        assert f"broken.toml:{line}:" in str(error)


OBJECTS = """
[[objects]]
name = "one"
motion = { axis = [0, 1, 0], frams = 3 }
[[objects]]
name = "two"
textures.u_t = { file = "torus.npz", wrap = "round" }
uniforms."a.b" = "modle"
motion.jumps = [
    { frame = 3, position = [0, 0, 0] },
    { frame = "4", position = [0, 0, 0] },
]
"""


def test_places_inside_of_braces(scene_folder: Path) -> None:
    path = scene_folder / "braces.toml"
    text = (scene_folder / "scene.toml").read_text()
    start = text.count("\n") + 1
    path.write_text(text + OBJECTS)
    with pytest.raises(InputError) as caught:
        load_scene(path)
    said = str(caught.value)
    for words, line in (("motion.frams", 3), ("u_t.wrap", 6), ("a.b", 7), ("[1].frame must", 10)):
        [told] = [item.render() for item in caught.value.diagnostics if words in item.message]
        assert f"braces.toml:{start + line}:" in told, said


def test_parts_belong_to_models(scene_folder: Path) -> None:
    error = broken(scene_folder, 'mesh = "torus.npz"', 'mesh = "torus.npz"\npart = "a"')
    assert "part: only a model has parts (.glb" in str(error) and ":6:" in str(error)
    error = broken(scene_folder, 'mesh = "torus.npz"', 'mesh = "torus.npz"\nanimation = "a"')
    assert "animation needs the part that it moves" in str(error)


def test_all_mistakes_are_told_at_once(scene_folder: Path) -> None:
    error = broken(scene_folder, "near = 0.5", 'near = "x"\nfra = 1\nup = 3')
    assert len(error.diagnostics) == 1, "a key given twice is not TOML"
    error = broken(scene_folder, "near = 0.5", 'near = "x"\nfra = 1')
    assert [item.code for item in error.diagnostics] == ["SC505", "SC504"]


def test_why_uniforms_change(scene_folder: Path) -> None:
    text = (scene_folder / "scene.toml").read_text()
    table = '[changes]\nlight = ["u_light"]\ntime = ["u_scale"]\n'
    path = scene_folder / "changing.toml"
    path.write_text(text.replace("[nodes]", f"{table}[nodes]", 1))
    found = load_scene(path).changes
    assert found["u_light"] == "light" and found["u_scale"] == "time"
    assert found["u_model"] == "view", "told by its semantic"


def test_no_such_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="SC501"):
        load_scene(tmp_path / "none.toml")
    (tmp_path / "scene.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match="not UTF-8"):
        load_scene(tmp_path)


def test_matrices(scene: Scene) -> None:
    turn = rotation(Motion((0.0, 1.0, 0.0), 90.0, 0.0, 4), 1)
    assert np.allclose(turn @ [0, 0, 1, 1], [1, 0, 0, 1])
    view = look_at(scene.view.camera)
    assert np.allclose(view @ [*scene.view.camera.eye, 1], [0, 0, 0, 1])
    assert np.allclose((view @ [*scene.view.camera.target, 1])[:2], 0)
    project = perspective(scene.view.camera, 1.5)
    near = project @ [0, 0, -scene.view.camera.near, 1]
    far = project @ [0, 0, -scene.view.camera.far, 1]
    assert near[2] / near[3] == pytest.approx(-1) and far[2] / far[3] == pytest.approx(1)


def test_uniform_values_are_in_upload_order(scene: Scene) -> None:
    values = uniform_values(scene.view, scene.common, 3, (64, 64))
    model = rotation(scene.common.motion, 3)
    assert values["u_model"].tolist() == model.T.ravel().tolist()
    assert values["u_light"].tolist() == [0.4, 0.8, 0.5]
    assert values["u_scale"].tolist() == [5.0]


def test_line_ends_of_windows(scene: Scene, scene_folder: Path) -> None:
    """Nothing is read differently, and mistakes are told in the same lines."""
    path = scene_folder / "windows.toml"
    text = (scene_folder / "scene.toml").read_bytes().replace(b"\n", b"\r\n")
    path.write_bytes(text)
    assert load_scene(path).common.inputs.semantics == scene.common.inputs.semantics
    path.write_bytes(text.replace(b"near = 0.5", b"near = 20"))
    with pytest.raises(InputError) as caught:
        load_scene(path)
    assert "windows.toml:17:" in caught.value.diagnostics[0].render()
