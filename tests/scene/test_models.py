"""glTF, OBJ, PLY and STL files: what is read, and what is told of broken ones."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.scene.mesh import load_mesh
from shadercache.scene.models import other_formats
from shadercache.scene.models.load import load_model
from shadercache.scene.models.parts import Model
from shadercache.scene.models.pose import MOST_BONES, Pose
from tests.gltf_maker import Maker, arms, quad, sheet, tower


def told(path: Path) -> tuple[str, str]:
    """The code and the words of what is told of a model."""
    with pytest.raises(InputError) as caught:
        load_mesh(path)
    [problem] = caught.value.diagnostics
    return problem.code, problem.message


def test_all_forms_hold_the_same(tmp_path: Path) -> None:
    made = quad()
    meshes = [
        load_mesh(made.glb(tmp_path / "q.glb")),
        load_mesh(made.gltf(tmp_path / "q.gltf")),
        load_mesh(made.gltf(tmp_path / "e.gltf", embedded=True)),
    ]
    for mesh in meshes:
        assert {"position", "normal", "uv", "tangent", "bitangent"} == set(mesh.arrays)
        assert np.array_equal(mesh.index, meshes[0].index)
        for name, array in mesh.arrays.items():
            assert array.dtype == np.float32 and np.array_equal(array, meshes[0].arrays[name])
    assert np.allclose(meshes[0].arrays["normal"], [0, 0, 1]), "computed"
    assert np.allclose(meshes[0].arrays["tangent"], [1, 0, 0, 1])
    assert np.allclose(meshes[0].arrays["bitangent"], [0, 1, 0])
    files = load_model(tmp_path / "q.gltf").files
    assert [path.name for path in files] == ["q.gltf", "q.bin"]


def test_a_hierarchy_has_a_part_for_each_primitive(tmp_path: Path) -> None:
    model = load_model(arms().glb(tmp_path / "a.glb"))
    assert [part.name for part in model.parts] == ["Base", "Arm", "Arm 2"]
    assert model.parts[0].material.color == (1, 0, 0, 1)
    wood = model.parts[2].material
    assert wood.name == "Wood" and wood.two_sided and wood.roughness == 0.3
    assert set(wood.textures) == {"albedo"}
    whole = load_mesh(model.path)
    assert len(whole.index) == 3 * 72
    assert whole.arrays["position"].min(0).tolist() == [-1, -1, 0]
    assert whole.arrays["position"].max(0).tolist() == [1, 1, 1.5], "scaled, and the arm in front"
    alone = load_mesh(model.path, "Arm 2")
    assert alone.arrays["position"].max() == 0.5 and "Arm 2" in alone.name


def test_nodes_are_animated(tmp_path: Path) -> None:
    path = arms().glb(tmp_path / "a.glb")
    rest = Pose(path, "Arm")
    assert rest.at(0.7).matrix[:3, 3].tolist() == [0, 0, 1]
    moving = Pose(path, "Arm", "Swing", 0.5)
    # Half of a quarter turn, after a second at half the speed; the step has not come yet.
    matrix = moving.at(1.0).matrix
    assert np.allclose(matrix[:3, 3], [np.sqrt(0.5), 0, np.sqrt(0.5)])
    assert np.allclose(matrix[:3, 0], [np.sqrt(2.0), 0, -np.sqrt(2.0)])
    assert np.allclose(moving.at(2.5).matrix, moving.at(0.5).matrix), "in a circle"


def test_splines_go_through_their_values(tmp_path: Path) -> None:
    made = arms()
    rows = [[0, 0, 0], [0, 0, 0.5], [2, 0, 0], [2, 0, 0], [1, 0, 0.5], [0, 0, 0]]
    sampler = {"input": made.document["animations"][0]["samplers"][1]["input"]}
    sampler |= {"output": made.array(rows), "interpolation": "CUBICSPLINE"}
    made.document["animations"][0]["samplers"][1] = sampler
    path = made.glb(tmp_path / "a.glb")
    channel = load_model(path).animation("Swing").channels[1]
    assert channel.at(0.0).tolist() == [0, 0, 0.5] and channel.at(1.0).tolist() == [1, 0, 0.5]
    # (t3 - 2 t2 + t) 2 + (3 t2 - 2 t3) + (t3 - t2) 2 at one quarter
    assert channel.at(0.25)[0] == pytest.approx(0.28125 + 0.15625 - 0.09375)


def test_skins_move_with_their_bones(tmp_path: Path) -> None:
    path = tower().glb(tmp_path / "t.glb")
    pose = Pose(path, "Tower", "Bend")
    assert pose.bone_count == 2
    start, bent = pose.at(0.0), pose.at(0.5)
    assert start.bones.shape == (MOST_BONES, 4, 4)
    assert np.allclose(start.bones, np.eye(4)), "as they were bound"
    assert np.array_equal(bent.matrix, np.eye(4)), "the node of a skin does not move it"
    # The top of the tower turns by 60 degrees about the joint one below it.
    assert np.allclose(bent.bones[1] @ [0, 2, 0, 1], [-np.sin(np.pi / 3), 1.5, 0, 1])
    part = load_model(path).part("Tower")
    assert part.arrays["joints"][0].tolist() == [0, 1, 0, 0]
    assert np.allclose(part.arrays["weights"].sum(1), 1)
    whole = load_mesh(path)
    assert np.allclose(whole.arrays["position"], part.arrays["position"], atol=1e-6)
    assert "joints" not in whole.arrays


def test_parts_without_a_skin_fit_the_same_shader(tmp_path: Path) -> None:
    made = tower()
    first = made.document["meshes"][0]["primitives"][0]
    plain = {key: first["attributes"][key] for key in ("POSITION", "NORMAL")}
    made.add("meshes", primitives=[{**first, "attributes": plain}])
    made.document["nodes"][1]["mesh"] = 1
    path = made.glb(tmp_path / "t.glb")
    part = load_model(path).part("Hip")
    assert part.skin is None and part.arrays["weights"][0].tolist() == [1, 0, 0, 0]
    assert Pose(path, "Hip", "Bend").at(0.5).bones[3].tolist() == np.eye(4).tolist()


def test_morph_targets_have_weights(tmp_path: Path) -> None:
    path = sheet().glb(tmp_path / "s.glb")
    part = load_model(path).part("Sheet")
    assert part.targets == 2 and part.arrays["morph0_position"].shape == (169, 3)
    assert Pose(path, "Sheet").at(0.5).weights[:3].tolist() == [0.0, 0.25, 0.0], "at rest"
    weights = Pose(path, "Sheet", "animation 0").at(0.25).weights
    assert weights[:2].tolist() == [0.5, 0.25]
    slid = load_mesh(path).arrays["position"]
    assert slid[:, 0].max() == pytest.approx(0.55), "all of it at rest has its morphs"


def test_strips_fans_and_what_is_quantised(tmp_path: Path) -> None:
    made = Maker()
    corners = made.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "i2")
    uv = made.array([[0, 0], [255, 0], [0, 255], [255, 255]], "u1", normalized=True)
    attributes = {"POSITION": corners, "TEXCOORD_0": uv}
    strip = {"attributes": attributes, "mode": 5}
    fan = {"attributes": attributes, "mode": 6}
    points = {"attributes": attributes, "mode": 0}
    made.add("meshes", primitives=[strip, fan, points])
    made.add("nodes", mesh=0)
    made.document["extensionsRequired"] = ["KHR_mesh_quantization"]
    model = load_model(made.glb(tmp_path / "s.glb"))
    assert [part.index.tolist() for part in model.parts] == [
        [[0, 1, 2], [1, 3, 2]],
        [[0, 1, 2], [0, 2, 3]],
    ]
    assert model.parts[0].arrays["uv"].max() == 1.0


def test_sparse_and_interleaved_arrays(tmp_path: Path) -> None:
    made = Maker()
    rows = np.arange(18, dtype="<f4").reshape(3, 6)
    view = made.view(rows.tobytes(), byteStride=24)
    entry = {"bufferView": view, "componentType": 5126, "count": 3, "type": "VEC3"}
    changed = {"bufferView": made.view(np.array([1], "<u2").tobytes()), "componentType": 5123}
    values = {"bufferView": made.view(np.array([7, 8, 9], "<f4").tobytes())}
    sparse = {"count": 1, "indices": changed, "values": values}
    position = made.add("accessors", **entry, byteOffset=12, sparse=sparse)
    made.add("meshes", primitives=[{"attributes": {"POSITION": position}}])
    made.add("nodes", mesh=0)
    found = load_mesh(made.glb(tmp_path / "s.glb")).arrays["position"]
    assert found.tolist() == [[3, 4, 5], [7, 8, 9], [15, 16, 17]]


def _cut_off(path: Path) -> Path:
    quad().glb(path)
    path.write_bytes(path.read_bytes()[:-40])
    return path


def _without_bytes(path: Path) -> Path:
    made = quad().gltf(path.with_suffix(".gltf"))
    path.with_suffix(".bin").unlink()
    return made


def _changed(change: Callable[[Maker], object]) -> Callable[[Path], Path]:
    def write(path: Path) -> Path:
        made = quad()
        change(made)
        return made.glb(path)

    return write


def _accessor(at: int, **entries: object) -> Callable[[Path], Path]:
    return _changed(lambda made: made.document["accessors"][at].update(entries))


def _primitive(**entries: object) -> Callable[[Path], Path]:
    return _changed(lambda made: made.document["meshes"][0]["primitives"][0].update(entries))


def _needs(name: str) -> Callable[[Path], Path]:
    return _changed(lambda made: made.document.update(extensionsRequired=[name]))


def _nan(made: Maker) -> None:
    made.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = made.array(
        np.full((25, 3), np.nan)
    )


def _written(data: bytes) -> Callable[[Path], Path]:
    def write(path: Path) -> Path:
        path.write_bytes(data)
        return path

    return write


@pytest.mark.parametrize(
    ("write", "code", "words"),
    [
        (_written(b""), "SC510", "not a GLB file"),
        (_written(b"solid of something else entirely"), "SC510", "not a GLB file"),
        (_cut_off, "SC510", "cut off"),
        (_without_bytes, "SC510", "q.bin that it names: No such file"),
        (lambda path: path, "SC510", "No such file"),
        (_changed(_nan), "SC512", "'position'"),
        (_changed(lambda made: made.document.update(nodes=[], scenes=[])), "SC511", "no triangles"),
        (_primitive(mode=1), "SC511", "no triangles"),
        (_primitive(attributes={}), "SC511", "no POSITION"),
        (_primitive(attributes={"POSITION": 99}), "SC510", "accessor 99, and has 3"),
        (_primitive(mode="4"), "SC510", "primitives[0].mode"),
        (_accessor(0, count=10_000), "SC510", "inside of its buffer view"),
        (_accessor(0, count=-1), "SC510", "-1 elements"),
        (_accessor(0, count=3), "SC513", "of vertex 24, but 3"),
        (_accessor(0, componentType=1), "SC510", "no component type 1"),
        (_accessor(0, type="VEC2"), "SC510", "'position' has 2 components"),
        (_changed(lambda made: made.document["bufferViews"][0].update(byteOffset=-1)),
         "SC510", "inside of its buffer"),
        (_changed(lambda made: made.document["nodes"][0].update(children=[0])),
         "SC510", "hangs at two places"),
        (_changed(lambda made: made.document.update(asset={"version": "1.0"})), "SC510", "2.0"),
        (_needs("KHR_draco_mesh_compression"), "SC514", "compressed with Draco"),
        (_needs("EXT_meshopt_compression"), "SC514", "compressed with meshopt"),
        (_needs("EXT_mesh_gpu_instancing"), "SC514", "needs EXT_mesh_gpu_instancing"),
    ],
)  # fmt: skip
def test_broken_models(
    tmp_path: Path, write: Callable[[Path], Path], code: str, words: str
) -> None:
    found, message = told(write(tmp_path / "q.glb"))
    assert found == code and words in message, message
    assert "\n" not in message


def test_deep_json_is_no_model(tmp_path: Path) -> None:
    path = tmp_path / "deep.gltf"
    path.write_text('{"asset": {"version": "2.0"}, "extras": ' + "[" * 200_000)
    assert told(path)[0] == "SC510"


def test_draco_without_a_requirement(tmp_path: Path) -> None:
    made = quad()
    extension = {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}}
    made.document["meshes"][0]["primitives"][0]["extensions"] = extension
    assert load_mesh(made.glb(tmp_path / "q.glb")).index.size, "the plain form is there as well"
    del made.document["accessors"][0]["bufferView"]
    assert told(made.glb(tmp_path / "r.glb"))[0] == "SC514"


def test_what_a_model_does_not_have(tmp_path: Path) -> None:
    path = arms().glb(tmp_path / "a.glb")
    with pytest.raises(InputError, match="SC515") as caught:
        load_mesh(path, "Leg")
    assert caught.value.diagnostics[0].hint == "it has: Base, Arm, Arm 2"
    with pytest.raises(InputError, match="no animation 'Walk'"):
        Pose(path, "Arm", "Walk").at(0.0)


OBJ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"
STL = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
STL += "endloop\nendfacet\nendsolid s\n"
PLY = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
PLY += "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
PLY += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
PLY += "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n3 0 1 2\n"


@pytest.mark.parametrize(
    ("name", "text", "more"),
    [
        ("m.obj", OBJ, {"uv", "tangent", "bitangent"}),
        ("m.stl", STL, set()),
        ("m.ply", PLY, {"color"}),
    ],
)  # fmt: skip
def test_other_formats(tmp_path: Path, name: str, text: str, more: set[str]) -> None:
    path = tmp_path / name
    path.write_text(text)
    mesh = load_mesh(path)
    assert set(mesh.arrays) == {"position", "normal"} | more
    assert mesh.arrays["position"].tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0]]
    assert np.allclose(mesh.arrays["normal"], [0, 0, 1])
    assert mesh.index.tolist() == [[0, 1, 2]]
    if "color" in more:
        assert mesh.arrays["color"][0].tolist() == [1, 0, 0, 1]


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("m.ply", PLY[:60], "SC510"),
        ("m.ply", "no ply", "SC510"),
        ("m.stl", "", "SC511"),
        ("m.obj", "v 0 0 0\n", "SC511"),
        ("m.obj", OBJ.replace("v 1 1 0", "v nan 1 0"), "SC512"),
    ],
)
def test_broken_files_of_other_formats(tmp_path: Path, name: str, text: str, code: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    assert told(path)[0] == code


def test_a_missing_library_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
    with pytest.raises(InputError, match="SC516") as caught:
        other_formats.load_other(tmp_path / "m.obj")
    assert "pip install 'shadercache[mesh]'" in str(caught.value)


def test_another_format_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no format of models") as caught:
        load_model(tmp_path / "m.fbx")
    assert ".glb" in str(caught.value)


def test_models_are_read_again_when_they_change(tmp_path: Path) -> None:
    path = quad().glb(tmp_path / "m.glb")
    first: Model = load_model(path)
    assert load_model(path) is first
    arms().glb(path)
    assert len(load_model(path).parts) == 3
