"""Open a model, whatever its format, and draw all of it as one mesh."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np

from shadercache.diagnostics import input_error
from shadercache.scene.models.gltf_model import load_gltf
from shadercache.scene.models.other_formats import ENDINGS, load_other, unreadable
from shadercache.scene.models.parts import Floats, Model, ModelPart

GLTF = (".glb", ".gltf")
FORMATS = (*GLTF, *ENDINGS)
"""Endings of the files that are models."""


def is_model(path: Path) -> bool:
    """Is it a model, by its name?"""
    return path.suffix.lower() in FORMATS


def load_model(path: Path) -> Model:
    """A model; the last few are kept.

    Raises:
        InputError: SC510 to SC514, SC516 as the readers; SC510 also for another format.
    """
    if not is_model(path):
        message = f"'{path.suffix}' is no format of models that is read"
        raise input_error("SC510", f"{path}: {message}", f"give one of {', '.join(FORMATS)}")
    try:
        state = path.stat()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise unreadable(path, reason) from None
    return _load(path, state.st_mtime_ns, state.st_size)


@lru_cache(maxsize=4)
def _load(path: Path, _changed: int, _size: int) -> Model:
    return (load_gltf if path.suffix.lower() in GLTF else load_other)(path)


def whole_model(model: Model) -> ModelPart:
    """All parts of a model as it is at rest, in one."""
    placed = [_at_rest(model, part) for part in model.parts]
    # Vertices stand where joints and morph targets at rest have put them.
    moving = ("joints", "weights", "morph")
    names = [name for name in placed[0] if not name.startswith(moving)]
    arrays = {name: _joined([one[name] for one in placed]) for name in names}
    starts = np.cumsum([0, *(len(one["position"]) for one in placed)])
    index = np.concatenate(
        [part.index + np.uint32(start) for part, start in zip(model.parts, starts, strict=False)]
    )
    return ModelPart(model.path.stem, arrays, index, model.parts[0].material)


def _joined(arrays: list[Floats]) -> Floats:
    # Colours may have three numbers or four.
    width = min(array.shape[1] for array in arrays)
    return np.concatenate([array[:, :width] for array in arrays])


def _at_rest(model: Model, part: ModelPart) -> dict[str, Floats]:
    """The arrays of a part in the space of the model."""
    if part.node is None:
        return dict(part.arrays)
    skeleton = model.skeleton
    matrices = skeleton.matrices({})
    if part.skin is None:
        # One for all, which broadcasting lays over every vertex.
        transform = matrices[part.node][None]
    else:
        bones = skeleton.bones(part.skin, matrices)
        chosen = np.clip(part.arrays["joints"].astype(np.int64), 0, len(bones) - 1)
        shares = part.arrays["weights"].astype(np.float64)
        transform = np.einsum("nj,njab->nab", shares, bones[chosen])
    placed = dict(_morphed(part, skeleton.weights(part.node, {})))
    linear = transform[:, :3, :3]
    moved = np.einsum(
        "nab,nb->na", np.broadcast_to(linear, (len(placed["position"]), 3, 3)), placed["position"]
    )
    placed["position"] = (moved + transform[:, :3, 3]).astype(np.float32)
    turning = np.linalg.pinv(linear).transpose(0, 2, 1)
    for name, by in (("normal", turning), ("tangent", linear), ("bitangent", linear)):
        if name in placed:
            placed[name] = _turned(placed[name], by)
    return placed


def _morphed(part: ModelPart, weights: np.ndarray) -> dict[str, Floats]:
    arrays = dict(part.arrays)
    for at, weight in enumerate(weights[: part.targets]):
        for name in ("position", "normal"):
            if weight and f"morph{at}_{name}" in arrays:
                arrays[name] = arrays[name] + np.float32(weight) * arrays[f"morph{at}_{name}"]
    return arrays


def _turned(directions: Floats, by: np.ndarray) -> Floats:
    every = np.broadcast_to(by, (len(directions), 3, 3))
    turned = np.einsum("nab,nb->na", every, directions[:, :3])
    turned /= np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-30)
    return np.concatenate([turned, directions[:, 3:]], 1).astype(np.float32)
