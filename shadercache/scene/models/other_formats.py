"""OBJ, PLY and STL files as models, read by trimesh."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np

from shadercache.diagnostics import InputError, input_error
from shadercache.scene.models.parts import (
    MOST_PARTS,
    Floats,
    Material,
    Model,
    ModelPart,
    Picture,
    filled,
)
from shadercache.scene.models.vertex_frames import complete
from shadercache.scene.npz import MAX_BYTES

ENDINGS = (".obj", ".ply", ".stl")


def load_other(path: Path) -> Model:
    """A file of one of :data:`ENDINGS`.

    Raises:
        InputError: SC510 for what cannot be read, SC511 for no triangles, SC512 for positions that
            are not finite, SC516 where trimesh is not installed.
    """
    try:
        import trimesh
    except ImportError:
        message = f"the library trimesh, which reads {path.suffix} files, is not installed"
        raise input_error("SC516", message, "pip install 'shadercache[mesh]'") from None
    try:
        if path.stat().st_size > MAX_BYTES:
            raise unreadable(path, f"it has more than {MAX_BYTES:,} bytes")
        # Not processed: vertices are as in the file, with their normals and their order.
        scene = trimesh.load_scene(path, process=False)
    except InputError:
        raise
    except OSError as error:
        raise unreadable(path, error.strerror or str(error)) from None
    except Exception as error:  # Readers of strangers' files fail in many ways.
        raise unreadable(path, f"it is not a whole {path.suffix} file ({error})") from None
    meshes = [(name, mesh) for name, mesh in scene.geometry.items() if len(_faces(mesh))]
    if not meshes:
        raise input_error("SC511", f"the model {path} has no triangles")
    if len(meshes) > MOST_PARTS:
        raise unreadable(path, f"it has more than {MOST_PARTS:,} parts")
    # Names of materials and groups; a file of one part has its own name.
    names = [path.stem] if len(meshes) == 1 else [str(name) for name, _ in meshes]
    parts = [_part(path, name, mesh) for name, (_, mesh) in zip(names, meshes, strict=True)]
    return Model(path, tuple(filled(parts)), files=(path,))


def unreadable(path: Path, reason: str) -> InputError:
    """What is told of a file that cannot be read."""
    return input_error("SC510", f"cannot read the model {path}: {reason}")


def _faces(mesh: Any) -> Any:
    # Point clouds and paths have none.
    return getattr(mesh, "faces", ())


def _part(path: Path, name: str, mesh: Any) -> ModelPart:
    position = np.ascontiguousarray(mesh.vertices, np.float32)
    index = np.ascontiguousarray(mesh.faces, np.uint32)
    if not np.isfinite(position).all():
        raise input_error("SC512", f"array 'position' of the mesh {path} holds NaN or infinity")
    if int(index.max()) >= len(position):
        message = f"the mesh {path} has triangles of vertex {index.max()}, but {len(position)}"
        raise input_error("SC513", f"{message} vertices")
    arrays: dict[str, Floats] = {"position": position}
    # Asked for otherwise, trimesh computes them.
    if "vertex_normals" in mesh._cache:
        arrays["normal"] = np.ascontiguousarray(mesh.vertex_normals, np.float32)
    arrays |= _looks(mesh)
    return ModelPart(
        name, arrays, index, _material(mesh), computed=frozenset(complete(arrays, index))
    )


def _looks(mesh: Any) -> dict[str, Floats]:
    """Texture coordinates and colours."""
    found: dict[str, Floats] = {}
    visual = mesh.visual
    uv = getattr(visual, "uv", None)
    if uv is not None and np.shape(uv) == (len(mesh.vertices), 2):
        found["uv"] = np.ascontiguousarray(uv, np.float32)
    if visual.kind == "vertex":
        found["color"] = np.ascontiguousarray(visual.vertex_colors, np.float32) / np.float32(255.0)
    return {key: array for key, array in found.items() if np.isfinite(array).all()}


def _material(mesh: Any) -> Material:
    material = getattr(mesh.visual, "material", None)
    if material is None:
        return Material()
    name = str(getattr(material, "name", None) or "")
    image = getattr(material, "image", None)
    color = getattr(material, "diffuse", None)
    shares = None if color is None else tuple(float(part) / 255.0 for part in color)
    if image is None:
        return Material(name, shares)
    packed = io.BytesIO()
    image.save(packed, "PNG")
    # An OBJ file counts v from the lower edge.
    return Material(name, shares, textures={"albedo": Picture(name, packed.getvalue(), True)})
