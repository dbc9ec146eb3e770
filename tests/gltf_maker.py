"""Small glTF models: a skinned tower, a morphed sheet, a hierarchy of boxes, a textured quad."""

from __future__ import annotations

import base64
import io
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from shadercache.scene.models.write_gltf import GltfWriter


@dataclass
class Maker(GltfWriter):
    """A glTF document of a test."""

    def squares(self, color: tuple[int, int, int] = (200, 90, 40), form: str = "PNG") -> int:
        """A texture of two colours, embedded."""
        pixels = np.zeros((8, 8, 3), np.uint8)
        pixels[:4], pixels[4:] = color, (20, 60, 160)
        packed = io.BytesIO()
        Image.fromarray(pixels).save(packed, form)
        return self.picture(packed.getvalue(), f"image/{form.lower()}")

    def gltf(self, path: Path, embedded: bool = False) -> Path:
        """Write a glTF file with its bytes beside it, or inside."""
        uri = f"{path.stem}.bin"
        if embedded:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        else:
            (path.parent / uri).write_bytes(self.data)
        self.document["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        path.write_text(json.dumps(self.document))
        return path


def grid(across: int = 8, up: int = 8) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Positions of a unit square in x and y, its texture coordinates, its triangles."""
    x, y = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, up + 1))
    uv = np.stack([x.ravel(), y.ravel()], 1)
    i, j = np.meshgrid(np.arange(across), np.arange(up))
    here = (j * (across + 1) + i).ravel()
    over = here + across + 1
    faces = np.stack([here, here + 1, over + 1, here, over + 1, over], 1).reshape(-1, 3)
    return np.concatenate([uv - 0.5, np.zeros((len(uv), 1))], 1), uv, faces


def tower() -> Maker:
    """A tube along y from 0 to 2; its upper half hangs at a bone that bends within a second."""
    made = Maker()
    _, uv, faces = grid(16, 16)
    angle = 2 * np.pi * uv[:, 0]
    round_about = np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], 1)
    position = 0.3 * round_about + np.stack([0 * angle, 2 * uv[:, 1], 0 * angle], 1)
    upper = np.clip(position[:, 1] - 0.5, 0.0, 1.0)
    zero = np.zeros_like(upper)
    primitive = {
        "attributes": {
            "POSITION": made.array(position),
            "NORMAL": made.array(round_about),
            "JOINTS_0": made.array(np.tile([0, 1, 0, 0], (len(uv), 1)), "u1"),
            "WEIGHTS_0": made.array(np.stack([1 - upper, upper, zero, zero], 1)),
        },
        "indices": made.array(faces.ravel(), "u2"),
    }
    made.add("meshes", primitives=[primitive])
    inverse = np.tile(np.eye(4), (2, 1, 1))
    inverse[1, 3, 1] = -1.0  # by columns
    made.add("skins", joints=[1, 2], inverseBindMatrices=made.array(inverse.reshape(2, 16)))
    made.add("nodes", name="Tower", mesh=0, skin=0, translation=[7, 7, 7])
    made.add("nodes", name="Hip", children=[2])
    made.add("nodes", name="Head", translation=[0, 1, 0])
    half = np.sin(np.radians(30)), np.cos(np.radians(30))
    turns = [[0, 0, 0, 1], [0, 0, half[0], half[1]], [0, 0, 0, 1]]
    times, values = made.array([0.0, 0.5, 1.0]), made.array(turns)
    made.add(
        "animations",
        name="Bend",
        channels=[{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
        samplers=[{"input": times, "output": values}],
    )
    made.roots(0, 1)
    return made


def sheet() -> Maker:
    """A square whose morph targets lift a bump and slide it, the first of them within a second."""
    made = Maker()
    position, uv, faces = grid(12, 12)
    lifted, slid = np.zeros_like(position), np.zeros_like(position)
    lifted[:, 2] = 0.5 * np.exp(-20 * (position[:, :2] ** 2).sum(1))
    slid[:, 0] = 0.4 * position[:, 1]
    primitive = {
        "attributes": {
            "POSITION": made.array(position),
            "NORMAL": made.array(np.tile([0, 0, 1], (len(uv), 1))),
            "TEXCOORD_0": made.array(uv),
        },
        "indices": made.array(faces.ravel(), "u2"),
        "targets": [{"POSITION": made.array(lifted)}, {"POSITION": made.array(slid)}],
    }
    made.add("meshes", primitives=[primitive], weights=[0.0, 0.25], name="Sheet")
    made.add("nodes", mesh=0)
    made.add(
        "animations",
        channels=[{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
        samplers=[
            {
                "input": made.array([0.0, 0.5, 1.0]),
                "output": made.array([0.0, 0.25, 1.0, 0.25, 0.0, 0.25]),
            }
        ],
    )
    made.roots(0)
    return made


def arms() -> Maker:
    """A base that turns, an arm on it that slides and jumps, and two materials on the arm."""
    made = Maker()
    position, uv, faces = grid(6, 6)
    attributes = {"POSITION": made.array(position), "TEXCOORD_0": made.array(uv)}
    red = made.add("materials", pbrMetallicRoughness={"baseColorFactor": [1, 0, 0, 1]})
    textured = {"baseColorTexture": {"index": made.squares()}, "roughnessFactor": 0.3}
    wood = made.add("materials", name="Wood", pbrMetallicRoughness=textured, doubleSided=True)
    indices = made.array(faces.ravel(), "u2")
    base = {"attributes": attributes, "indices": indices, "material": red}
    made.add("meshes", primitives=[base])
    front = {**attributes, "POSITION": made.array(np.add(position, [0, 0, 0.25]))}
    made.add("meshes", primitives=[base, {**base, "attributes": front, "material": wood}])
    made.add("nodes", name="Base", mesh=0, children=[1], scale=[2, 2, 2])
    made.add("nodes", name="Arm", mesh=1, translation=[0, 0, 0.5])
    quarter = np.sqrt(0.5)
    times = made.array([0.0, 1.0])
    samplers = [
        {"input": times, "output": made.array([[0, 0, 0, 1], [0, quarter, 0, quarter]])},
        {"input": times, "output": made.array([[0, 0, 0.5], [1, 0, 0.5]]), "interpolation": "STEP"},
    ]
    channels = [
        {"sampler": 0, "target": {"node": 0, "path": "rotation"}},
        {"sampler": 1, "target": {"node": 1, "path": "translation"}},
    ]
    made.add("animations", name="Swing", channels=channels, samplers=samplers)
    made.roots(0)
    return made


def quad(form: str = "PNG") -> Maker:
    """A textured square without normals."""
    made = Maker()
    position, uv, faces = grid(4, 4)
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": made.squares(form=form)}}}
    made.add("materials", **material)
    primitive = {
        "attributes": {"POSITION": made.array(position), "TEXCOORD_0": made.array(uv)},
        "indices": made.array(faces.ravel(), "u4"),
        "material": 0,
    }
    made.add("meshes", primitives=[primitive], name="Quad")
    made.add("nodes", mesh=0)
    made.roots(0)
    return made
