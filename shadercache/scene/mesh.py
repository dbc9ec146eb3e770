"""Indexed triangle meshes from models (``models/``) and from ``.npz`` files, plain or quantised.

Arrays of an ``.npz`` file (n vertices, m triangles):

* ``position`` (n, 3), or ``position_u16`` (n, 3) with ``bounds`` (2, 3): the lowest and highest
  corner of the box that 0..65535 spans;
* ``normal`` (n, 3), or ``normal_i16`` / ``normal_i8``: signed normalised, made unit length again;
  ``tangent`` likewise, or (n, 4) with the sign of the bitangent as it is in glTF;
* any other (n, c) or (n,) array of numbers, with 1 to 4 components (``uv``, ``color``, ...);
* ``index`` (m, 3), or ``index_delta`` (3 m,): differences of the flattened indices.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import InputError, input_error, usage_error
from shadercache.scene.description import Scene
from shadercache.scene.models.load import is_model, load_model, whole_model
from shadercache.scene.npz import load_npz

_HELPERS = ("bounds", "index", "index_delta")
_WIDTHS = {"position": (3,), "normal": (3,), "tangent": (3, 4)}
_LARGEST = {"u16": 65535.0, "i16": 32767.0, "i8": 127.0}


@dataclass(frozen=True, eq=False)
class Mesh:
    """Vertex arrays (n, c) float32 by name, and triangles ``index`` (m, 3) uint32."""

    name: str
    arrays: Mapping[str, NDArray[np.float32]]
    index: NDArray[np.uint32]


def load_mesh(path: Path, part: str | None = None) -> Mesh:
    """Read a mesh and check that it can be drawn: of a model one part, or all that it has at rest.

    Raises:
        InputError: SC510 unreadable file, SC511 no positions or no triangles, SC512 an array of a
            wrong shape or with values that are not finite, SC513 an index out of range; of a model
            as ``load_model``, and SC515 for a part that it does not have.
    """
    if is_model(path):
        model = load_model(path)
        chosen = whole_model(model) if part is None else model.part(part)
        name = str(path) if part is None else f"{path} ({part})"
        return Mesh(name, chosen.arrays, chosen.index)
    raw = load_npz(path, "SC510", "the mesh")
    arrays = dict(_decode(path, key, raw) for key in raw if key not in _HELPERS)
    if "position" not in arrays:
        raise input_error("SC511", f"the mesh {path} has no array 'position'")
    count = len(arrays["position"])
    for name, array in arrays.items():
        _check_array(path, name, array, count)
    return Mesh(str(path), arrays, _index(path, raw, count))


# One triangle, larger than the picture: two would shade the quads along their diagonal twice.
FULL_SCREEN = Mesh(
    "full-screen triangle",
    {
        "position": np.array([[-1, -1, 0], [3, -1, 0], [-1, 3, 0]], np.float32),
        "uv": np.array([[0, 0], [2, 0], [0, 2]], np.float32),
        "normal": np.array([[0, 0, 1]] * 3, np.float32),
    },
    np.array([[0, 1, 2]], np.uint32),
)
"""Covers the picture: with the arrays as clip-space positions, or with a vertex shader that needs
none of them."""


def replacement_mesh(scene: Scene, path: Path | None) -> Mesh | None:
    """What is drawn in place of the scene's mesh, if anything is.

    Raises as :func:`load_mesh`, and :class:`UsageError` SC008 where the scene has no mesh.
    """
    if path is None:
        return None
    if scene.common.mesh is None or scene.objects:
        why = "has several objects" if scene.objects else "is full-screen and draws no mesh"
        raise usage_error("SC008", f"--mesh: {scene.name} {why}")
    return load_mesh(path)


def _decode(
    path: Path, key: str, raw: Mapping[str, NDArray[np.generic]]
) -> tuple[str, NDArray[np.float32]]:
    """Name and values of a stored array."""
    array = raw[key]
    if array.dtype.kind not in "fiu" or array.ndim not in (1, 2) or not array.size:
        raise _bad_shape(path, key, f"{array.dtype} {array.shape}")
    values = array.astype(np.float64).reshape(len(array), -1)
    name, _, suffix = key.rpartition("_")
    largest = _LARGEST.get(suffix)
    if largest is None:
        return key, np.ascontiguousarray(values, np.float32)
    values /= largest
    if suffix != "u16":
        # Rounding has made directions a little too short or too long.
        values /= np.maximum(np.linalg.norm(values, axis=1, keepdims=True), 1e-12)
    elif name == "position":
        bounds = raw.get("bounds")
        if bounds is None or bounds.shape != (2, 3):
            raise input_error("SC511", f"the mesh {path} has position_u16 but no 'bounds' (2, 3)")
        low, high = bounds.astype(np.float64)
        values = low + values * (high - low)
    return name, np.ascontiguousarray(values, np.float32)


def _check_array(path: Path, name: str, array: NDArray[np.float32], count: int) -> None:
    wanted = _WIDTHS.get(name, (1, 2, 3, 4))
    if len(array) != count or count == 0 or array.shape[1] not in wanted:
        raise _bad_shape(path, name, f"{array.shape}, with {count} positions")
    if not np.isfinite(array).all():
        raise input_error("SC512", f"array '{name}' of the mesh {path} holds NaN or infinity")


def _bad_shape(path: Path, name: str, shape: str) -> InputError:
    return input_error("SC512", f"array '{name}' of the mesh {path} has a wrong shape: {shape}")


def _index(path: Path, raw: Mapping[str, NDArray[np.generic]], count: int) -> NDArray[np.uint32]:
    stored = raw.get("index", raw.get("index_delta"))
    if stored is None:
        raise input_error("SC511", f"the mesh {path} has no array 'index'")
    if stored.dtype.kind not in "iu" or stored.size == 0 or stored.size % 3:
        raise _bad_shape(path, "index", f"{stored.dtype} {stored.shape}")
    # Differences are stored in few bits, which their sums would overflow.
    flat = stored.astype(np.int64).ravel()
    if "index" not in raw:
        flat = np.cumsum(flat)
    least, most = int(np.min(flat)), int(np.max(flat))
    if least < 0 or most >= count:
        wrong = least if least < 0 else most
        message = f"the mesh {path} has triangles of vertex {wrong}, but {count} vertices"
        raise input_error("SC513", message)
    return np.ascontiguousarray(flat.reshape(-1, 3), np.uint32)
