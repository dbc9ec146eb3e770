"""Models with all that a vertex shader commonly asks for: a ring, and a flat sheet.

Positions, normals, tangents, two sets of texture coordinates, colours, joints and weights of two
bones. They reach from -0.9 to 0.9.
"""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import numpy as np

AROUND, ACROSS = 48, 24
_COMPONENTS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
_TYPES = {"<f4": 5126, "<u4": 5125, "<u2": 5123}


def write_ring(path: Path) -> None:
    """Write the ring as glTF."""
    long, short = _steps()
    turn, roll = -2.0 * np.pi * long, 2.0 * np.pi * short
    outward = np.stack([np.cos(turn), 0.0 * turn, np.sin(turn)], 1)
    normal = np.cos(roll)[:, None] * outward + np.sin(roll)[:, None] * [0.0, 1.0, 0.0]
    along = np.stack([np.sin(turn), 0.0 * turn, -np.cos(turn)], 1)
    uv = np.stack([4.0 * long, 2.0 * short], 1)
    _write(path, 0.6 * outward + 0.3 * normal, (normal, along), uv)


def write_sheet(path: Path) -> None:
    """Write a square in x and y as glTF, for what is drawn flat."""
    uv = np.stack(_steps(), 1)
    flat = np.zeros((len(uv), 1))
    normal, along = np.tile([0.0, 0.0, 1.0], (len(uv), 1)), np.tile([1.0, 0.0, 0.0], (len(uv), 1))
    _write(path, np.concatenate([1.8 * uv - 0.9, flat], 1), (normal, along), uv)


def _steps() -> tuple[np.ndarray, np.ndarray]:
    steps = (np.linspace(0.0, 1.0, count + 1) for count in (AROUND, ACROSS))
    long, short = np.meshgrid(*steps, indexing="ij")
    return long.ravel(), short.ravel()


def _write(
    path: Path, position: np.ndarray, frame: tuple[np.ndarray, np.ndarray], uv: np.ndarray
) -> None:
    normal, along = frame
    one = np.ones((len(uv), 1))
    upper = 0.5 + 0.5 * position[:, :1]
    arrays = {
        "POSITION": position,
        "NORMAL": normal,
        "TANGENT": np.concatenate([along, one], 1),
        "TEXCOORD_0": uv,
        "TEXCOORD_1": 0.25 * uv,
        "COLOR_0": 0.5 + 0.5 * np.concatenate([normal, one], 1),
        "WEIGHTS_0": np.concatenate([upper, 1.0 - upper, 0.0 * one, 0.0 * one], 1),
    }
    document = _Document()
    attributes = {name: document.add(values, "<f4") for name, values in arrays.items()}
    attributes["JOINTS_0"] = document.add(np.tile([0, 1, 0, 0], (len(uv), 1)), "<u2")
    primitive = {"attributes": attributes, "indices": document.add(_triangles(), "<u4")}
    bones = document.add(np.tile(np.eye(4).reshape(1, 16), (2, 1)), "<f4")
    document.write(path, primitive, bones)


def _triangles() -> np.ndarray:
    i, j = np.meshgrid(np.arange(AROUND), np.arange(ACROSS), indexing="ij")
    here = (i * (ACROSS + 1) + j).ravel()
    over = here + ACROSS + 1
    return np.stack([here, over, over + 1, here, over + 1, here + 1], 1).reshape(-1, 1)


class _Document:
    def __init__(self) -> None:
        self._data = b""
        self._accessors: list[dict[str, Any]] = []
        self._views: list[dict[str, int]] = []

    def add(self, values: np.ndarray, kind: str) -> int:
        """An array of float32, uint32 or uint16; returns its number."""
        stored = np.asarray(values, kind).tobytes()
        self._views.append({"buffer": 0, "byteOffset": len(self._data), "byteLength": len(stored)})
        self._data += stored
        self._accessors.append(
            {
                "bufferView": len(self._views) - 1,
                "componentType": _TYPES[kind],
                "count": len(values),
                "type": _COMPONENTS[values.shape[1]],
            }
        )
        return len(self._accessors) - 1

    def write(self, path: Path, primitive: dict[str, Any], bones: int) -> None:
        packed = base64.b64encode(self._data).decode()
        uri = f"data:application/octet-stream;base64,{packed}"
        document = {
            "asset": {"version": "2.0"},
            "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"name": "ring", "mesh": 0, "skin": 0}, {"name": "one"}, {"name": "other"}],
            "skins": [{"joints": [1, 2], "inverseBindMatrices": bones}],
            "meshes": [{"primitives": [primitive]}],
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._data), "uri": uri}],
        }
        path.write_text(json.dumps(document))
