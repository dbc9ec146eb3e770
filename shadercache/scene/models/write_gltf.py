"""A glTF document as it grows, for models that are made and not read."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

_TYPES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
_SHAPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}

_ATTRIBUTES = {
    **{"position": "POSITION", "normal": "NORMAL", "tangent": "TANGENT", "uv": "TEXCOORD_0"},
    **{"uv1": "TEXCOORD_1", "color": "COLOR_0", "weights": "WEIGHTS_0", "joints": "JOINTS_0"},
}


@dataclass
class GltfWriter:
    """What has been added so far: the document, and the bytes that its views are of."""

    document: dict[str, Any] = field(default_factory=lambda: {"asset": {"version": "2.0"}})
    data: bytes = b""

    def add(self, kind: str, **entry: Any) -> int:
        """Another entry of a list; returns its number."""
        self.document.setdefault(kind, []).append(entry)
        return len(self.document[kind]) - 1

    def view(self, data: bytes, **more: Any) -> int:
        """Bytes in a view of their own."""
        self.data += b"\0" * (-len(self.data) % 4)
        offset = len(self.data)
        self.data += data
        return self.add("bufferViews", buffer=0, byteOffset=offset, byteLength=len(data), **more)

    def array(self, values: ArrayLike, dtype: str = "f4", **more: Any) -> int:
        """An accessor."""
        array = np.asarray(values, f"<{dtype}")
        array = array.reshape(len(array), -1)
        return self.add(
            "accessors",
            bufferView=self.view(array.tobytes()),
            componentType=_TYPES[dtype],
            count=len(array),
            type=_SHAPES[array.shape[1]],
            **more,
        )

    def picture(self, data: bytes, mime: str = "image/png", **more: Any) -> int:
        """A texture of an encoded image, embedded."""
        image = self.add("images", bufferView=self.view(data), mimeType=mime, **more)
        return self.add("textures", source=image)

    def mesh(self, arrays: Mapping[str, ArrayLike], index: ArrayLike, **more: Any) -> int:
        """A mesh of one primitive; arrays by the names of ``ModelPart``."""
        attributes = {
            _ATTRIBUTES[name]: self.array(values, "u2" if name == "joints" else "f4")
            for name, values in arrays.items()
        }
        whole = {"attributes": attributes, "indices": self.array(np.ravel(index), "u4")}
        return self.add("meshes", primitives=[{**whole, **more}])

    def hung(self, mesh: int, name: str) -> None:
        """Show a mesh that has joints, two of them, at rest."""
        ones = np.tile(np.eye(4).reshape(1, 16), (2, 1))
        skin = self.add("skins", joints=[1, 2], inverseBindMatrices=self.array(ones))
        self.add("nodes", name=name, mesh=mesh, skin=skin)
        self.add("nodes", name="one")
        self.add("nodes", name="other")
        self.roots(0, 1, 2)

    def roots(self, *nodes: int) -> None:
        """What the scene shows."""
        self.add("scenes", nodes=list(nodes))

    def glb(self, path: Path) -> Path:
        """Write a GLB file."""
        data = self.data + b"\0" * (-len(self.data) % 4)
        self.document["buffers"] = [{"byteLength": len(data)}]
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
        return path
