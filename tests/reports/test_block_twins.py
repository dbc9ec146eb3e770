"""Blocks and their twins are bound as the manifest says, and the picture is the harness's.

An engine is played here: it packs each block from what the manifest lists of it, and keeps its
bytes for the next frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from manifests import plain
from runner.independent_runner import IndependentRunner
from runner.inputs import Inputs

from shadercache.compiler import Emission, analyse
from shadercache.gpu.context import Gpu
from shadercache.manifest.codec import encode
from shadercache.manifest.model import Manifest
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from shadercache.source import Source
from tests.cases.scenery import make_scene
from tests.configured import configured, rewritten, variant

pytestmark = pytest.mark.xdist_group("gl")

FOLDER = Path(__file__).with_name("block_twins")
REPORTED = "o10_block_twin_binding"
PLAIN = "plain"
NAMES = sorted(path.stem for path in FOLDER.glob("*.vert") if path.stem != PLAIN)

UNFILLED = ("array_of_blocks", "changing_defaults", "packed", "row_major", "shared")
"""Forms that the harness does not fill: its picture is that of plain uniforms."""

SEMANTICS = {"projection": "projection", "view": "model-view", "model": "model"}
"""The view turns too, so that the twin of each block matters."""

PARTS = {"Part[0]": "projection", "Part[1]": "view", "Part[2]": "model"}
CONSTANTS: dict[str, tuple[float, ...]] = {
    "tint": (0.9, 0.8, 0.7, 1.0),
    "gain": (1.5, 0.0, 0.0, 0.0),
    "bias": (0.125,),
    "u_gain": (0.25,),
}
SIZES = {"float": (4, 4), "vec2": (8, 8), "vec3": (16, 12), "vec4": (16, 16), "mat4": (16, 64)}
"""Alignment and size in std140; Mesa lays out shared and packed blocks alike if all is read."""


def emission_of(name: str) -> Emission[Manifest]:
    path = FOLDER / f"{name}.frag"
    fragment = path if path.exists() else FOLDER / "shader.frag"
    sources = [Source(p.name, p.read_text("utf-8")) for p in (fragment, FOLDER / f"{name}.vert")]
    analysis = analyse(*sources)
    node = next(n for n in analysis.nodes if n.offered and n.text.startswith("costly(v_p)"))
    mode = "plain" if name == "es_310" else "proof"
    return rewritten(analysis, node, configured(mode=mode, form="rgba32f"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The scene of the cases, turning, with a matrix for everything that a form may call one."""
    folder = make_scene(tmp_path_factory.mktemp("blocks") / "scene")
    names = {f"{prefix}{name}": word for prefix in ("", "u_") for name, word in SEMANTICS.items()}
    for instance in ("camera", "thing", "u_eyes[1]", "u_eyes[0]"):
        names |= {f"{instance}.{name}": word for name, word in SEMANTICS.items()}
    lines = [f'"{name}" = "{word}"' for name, word in names.items()]
    for name, value in CONSTANTS.items():
        number = list(value) if len(value) > 1 else value[0]
        lines += [f'"{name}" = {number}', f'"camera.{name}" = {number}']
    text = (folder / "scene.toml").read_text("utf-8")
    head, rest = text.split("[uniforms]\n")
    (folder / "scene.toml").write_text(f"{head}[uniforms]\n" + "\n".join(lines) + "\n" + rest)
    return folder


@pytest.fixture(scope="module")
def world(gpu: Gpu, folder: Path) -> Iterator[RenderScene]:
    with RenderScene(gpu, load_scene(folder), (80, 60), "rgba32f") as made:
        yield made


def number_of(name: str, element: str, values: Mapping[str, Any]) -> tuple[float, ...]:
    """What a member holds; nobody reads the others."""
    word = PARTS.get(element, name) if name == "part" else name
    found = values[word] if word in SEMANTICS else CONSTANTS.get(name, (7.0,) * 4)
    return tuple(map(float, found))


def packed(item: Mapping[str, Any], element: str, values: Mapping[str, Any]) -> bytes:
    """A block's bytes, from what the manifest lists of it."""
    data = bytearray()
    for member in item["members"]:
        align, size = SIZES[member["type"]]
        data += bytes(-len(data) % align)
        assert member.get("offset", len(data)) == len(data)
        numbers = np.array(number_of(member["name"], element, values), "f4")
        if member["type"] == "mat4":
            columns = numbers.reshape(4, 4)
            is_row = "row_major" in (member.get("layout"), item["matrices"])
            numbers = (columns.T if is_row else columns).ravel()
        data += numbers.tobytes()[:size]
    data += bytes(-len(data) % 16)
    assert item.get("size", len(data)) == len(data)
    return bytes(data)


def given(manifest: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """What an engine has in a frame: numbers under the names of uniforms, bytes under blocks'."""
    matrices = {name: tuple(map(float, values[name])) for name in SEMANTICS}
    found: dict[str, Any] = {f"u_{name}": matrices[name] for name in SEMANTICS}
    found |= {f"u_eyes[{at}].{name}": matrices[name] for at in (0, 1) for name in SEMANTICS}
    found["u_gain"] = CONSTANTS["u_gain"][0]
    for item in manifest["inputs"]:
        if item["kind"] == "uniform block" and "previous_of" not in item:
            (size,) = item["dims"] or (None,)
            names = [item["name"]] if size is None else [f"Part[{at}]" for at in range(size)]
            found |= {name: packed(item, name, values) for name in names}
    return found


def independent(world: RenderScene, folder: Path, algorithm: str) -> IndependentRunner:
    mesh = world.drawables[0].mesh
    arrays = {
        name: mesh.arrays[array] for name, array in world.scene.common.inputs.attributes.items()
    }
    textures = {"u_map": world.drawables[0].texture("u_map")}
    return IndependentRunner(
        *(world.gpu.ctx, folder, algorithm, world.size, arrays, mesh.index, textures)
    )


def written(name: str, folder: Path) -> Emission[Manifest]:
    emission = emission_of(name)
    for file, text in emission.files.items():
        (folder / file).write_text(text)
    (folder / "manifest.json").write_text(encode(emission.manifest))
    return emission


def same_frames(
    world: RenderScene,
    reference: Emission[Manifest],
    folder: Path,
    manifest: Mapping[str, Any],
    algorithm: str,
) -> list[bool]:
    """Which of six frames in motion are the same bits."""
    other = independent(world, folder, algorithm)
    bundle = Bundle(reference.manifest, reference.files)
    found = []
    with variant(world, bundle, algorithm, period=5, block=4) as runner:
        for frame in range(6):
            expected = runner.image(frame)
            assert expected.any(), "an empty picture proves nothing"
            drawn = other.draw(frame, given(manifest, world.drawables[0].values(frame)), 5, 4)
            found.append(drawn.tobytes() == expected.tobytes())
        seen = runner.hit_mask(6)
        assert (seen == bundle.mask_values["hit"]).sum() > 0.5 * (seen > 0).sum()
    return found


@pytest.mark.parametrize("name", NAMES)
def test_the_manifest_is_enough_to_bind_blocks_and_twins(
    world: RenderScene, tmp_path: Path, name: str
) -> None:
    emission = written(name, tmp_path)
    reference = emission_of(PLAIN) if name in UNFILLED else emission
    for algorithm in ("1-pass", "2-pass", "3-pass"):
        same = same_frames(world, reference, tmp_path, plain(emission.manifest), algorithm)
        assert all(same), (algorithm, same)


def test_a_twin_left_alone_reads_the_current_block(
    world: RenderScene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What happened where the manifest told nothing, and still does to blocks without a binding."""
    emission = written("no_bindings", tmp_path)
    inputs = plain(emission.manifest)["inputs"]
    twin = next(item["name"] for item in inputs if item.get("previous_of") == "Camera")
    kept = Inputs._bind

    def bind(self: Inputs, block: Any, index: int, name: str, content: bytes) -> None:
        if name != twin:
            kept(self, block, index, name, content)

    monkeypatch.setattr(Inputs, "_bind", bind)
    same = same_frames(world, emission, tmp_path, plain(emission.manifest), "2-pass")
    assert not all(same)


def test_the_reported_block_is_told() -> None:
    manifest = plain(emission_of(REPORTED).manifest)
    inputs = {item["name"]: item for item in manifest["inputs"]}
    (twin,) = (item for item in inputs.values() if item.get("previous_of") == "Camera")
    assert inputs["Camera"]["kind"] == twin["kind"] == "uniform block"
    assert (inputs["Camera"]["binding"], twin["binding"]) == (0, 1)
    assert inputs["u_model"]["kind"] == "uniform"
    assert inputs["u_model"]["location"] == 0
    assert any("binding point 0" in sentence for sentence in manifest["frame"])
