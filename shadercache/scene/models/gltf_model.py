"""glTF files as models: the nodes of a scene, a part for each primitive, skins, animations."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.scene.models.gltf_file import GltfFile, compressed
from shadercache.scene.models.gltf_schema import GltfAnimation, GltfNode, Primitive
from shadercache.scene.models.parts import (
    MOST_PARTS,
    Floats,
    Material,
    Model,
    ModelPart,
    Picture,
    filled,
)
from shadercache.scene.models.skeleton import Channel, Joint, ModelAnimation, Skeleton, Skin
from shadercache.scene.models.vertex_frames import complete

_MOST_NODES = 100_000
_MOST_TARGETS = 64
_ARRAYS = {
    **{"POSITION": "position", "NORMAL": "normal", "TANGENT": "tangent"},
    **{"TEXCOORD_0": "uv", "TEXCOORD_1": "uv1", "COLOR_0": "color"},
    **{"JOINTS_0": "joints", "WEIGHTS_0": "weights"},
}
_WIDTHS = {"position": 3, "normal": 3, "tangent": 4, "uv": 2, "uv1": 2, "joints": 4, "weights": 4}
_MORPHED = {"POSITION": "position", "NORMAL": "normal", "TANGENT": "tangent"}
_PATHS = {"translation": 3, "rotation": 4, "scale": 3}


def load_gltf(path: Path) -> Model:
    """A ``.glb`` or ``.gltf`` file.

    Raises:
        InputError: SC510 for what cannot be read, SC511 for no triangles, SC514 for compressed
            geometry.
    """
    return _Reader(GltfFile(path)).model()


@dataclass
class _Reader:
    file: GltfFile
    pictures: dict[int, Picture] = field(default_factory=dict)

    def model(self) -> Model:
        document, order = self.file.document, self._order()
        places = {node: at for at, (node, _) in enumerate(order)}
        skeleton = Skeleton(
            tuple(self._joint(node, parent) for node, parent in order),
            tuple(self._skin(at, places) for at in range(len(document.skins))),
            tuple(self._animations(document.animations, places)),
        )
        parts: list[ModelPart] = []
        for at, (number, _) in enumerate(order):
            parts += self._parts(document.nodes[number], at)
            if len(parts) > MOST_PARTS:
                raise self.file.unreadable(f"it has more than {MOST_PARTS:,} parts")
        if not parts:
            raise input_error("SC511", f"the model {self.file.path} has no triangles")
        files = tuple(self.file.files)
        return Model(self.file.path, tuple(_distinct(filled(parts))), skeleton, files)

    def _order(self) -> list[tuple[int, int | None]]:
        """The nodes of the scene, parents first, each with the place of its parent."""
        document = self.file.document
        if len(document.nodes) > _MOST_NODES:
            raise self.file.unreadable(f"it has more than {_MOST_NODES:,} nodes")
        if document.scenes:
            roots = self.file.item(document.scenes, document.scene, "scene").nodes
        else:
            inner = {child for node in document.nodes for child in node.children}
            roots = [at for at in range(len(document.nodes)) if at not in inner]
        order: list[tuple[int, int | None]] = []
        known: set[int] = set()
        waiting: list[tuple[int, int | None]] = [(root, None) for root in reversed(roots)]
        while waiting:
            number, parent = waiting.pop()
            node = self.file.item(document.nodes, number, "node")
            if number in known:
                raise self.file.unreadable(f"node {number} hangs at two places")
            known.add(number)
            order.append((number, parent))
            at = len(order) - 1
            waiting += [(child, at) for child in reversed(node.children)]
        return order

    def _joint(self, number: int, parent: int | None) -> Joint:
        node = self.file.document.nodes[number]
        moved, turned, scaled = map(np.array, (node.translation, node.rotation, node.scale))
        matrix = None
        if node.matrix is not None:
            if len(node.matrix) != 16:
                raise self.file.unreadable(f"the matrix of node {number} has not 16 numbers")
            matrix = np.array(node.matrix).reshape(4, 4).T
        weights = node.weights
        if node.mesh is not None and not weights:
            weights = self.file.item(self.file.document.meshes, node.mesh, "mesh").weights
        return Joint(parent, moved, turned, scaled, matrix, np.array(weights, np.float64))

    def _skin(self, at: int, places: dict[int, int]) -> Skin:
        skin = self.file.document.skins[at]
        if not skin.joints or any(joint not in places for joint in skin.joints):
            raise self.file.unreadable(f"skin {at} has joints that are not in the scene")
        count = len(skin.joints)
        inverse = np.tile(np.eye(4), (count, 1, 1))
        if skin.inverse_bind_matrices is not None:
            stored = self.file.array(skin.inverse_bind_matrices).astype(np.float64)
            if stored.shape[1] != 16 or len(stored) < count or not np.isfinite(stored).all():
                raise self.file.unreadable(f"the matrices of skin {at} do not fit its joints")
            inverse = stored[:count].reshape(-1, 4, 4).transpose(0, 2, 1)
        return Skin(tuple(places[joint] for joint in skin.joints), inverse)

    def _animations(
        self, animations: Iterable[GltfAnimation], places: dict[int, int]
    ) -> Iterator[ModelAnimation]:
        for number, animation in enumerate(animations):
            channels = []
            for channel in animation.channels:
                target = channel.target
                if target.node in places and target.path in (*_PATHS, "weights"):
                    sampler = self.file.item(animation.samplers, channel.sampler, "sampler")
                    times = self.file.array(sampler.input).astype(np.float64).ravel()
                    values = self.file.array(sampler.output).astype(np.float64)
                    shaped = self._shaped(times, values, sampler.interpolation, target.path)
                    node = places[target.node]
                    channels.append(
                        Channel(node, target.path, times, shaped, sampler.interpolation)
                    )
            yield ModelAnimation(animation.name or f"animation {number}", tuple(channels))

    def _shaped(
        self, times: NDArray[np.float64], values: NDArray[np.float64], how: str, path: str
    ) -> NDArray[np.float64]:
        """A row for each time, or three of a spline."""
        rows = len(times) * (3 if how == "CUBICSPLINE" else 1)
        fits = rows > 0 and values.size > 0 and values.size % rows == 0
        width = values.size // rows if fits else 0
        in_order = bool((np.diff(times) >= 0.0).all())
        finite = bool(np.isfinite(times).all() and np.isfinite(values).all())
        if not (fits and in_order and finite) or width != _PATHS.get(path, width):
            raise self.file.unreadable("the times and values of an animation do not fit")
        return values.reshape(rows, width)

    def _parts(self, node: GltfNode, at: int) -> Iterator[ModelPart]:
        document = self.file.document
        if node.mesh is None:
            return
        mesh = self.file.item(document.meshes, node.mesh, "mesh")
        if node.skin is not None:
            self.file.item(document.skins, node.skin, "skin")
        name = node.name or mesh.name or f"mesh {node.mesh}"
        for primitive in mesh.primitives:
            index, arrays, computed = self._geometry(primitive, name)
            if len(index):
                skin = node.skin if "joints" in arrays else None
                yield ModelPart(
                    *(name, arrays, index, self._material(primitive.material), at, skin),
                    targets=len(primitive.targets[:_MOST_TARGETS]),
                    computed=frozenset(computed),
                )

    def _geometry(
        self, primitive: Primitive, name: str
    ) -> tuple[NDArray[np.uint32], dict[str, Floats], set[str]]:
        if "KHR_draco_mesh_compression" in primitive.extensions and not self._in_full(primitive):
            raise compressed(self.file.path, "Draco")
        if "POSITION" not in primitive.attributes:
            message = f"part '{name}' of the model {self.file.path} has no POSITION"
            raise input_error("SC511", message)
        arrays = {
            key: self._array(primitive.attributes[attribute], key)
            for attribute, key in _ARRAYS.items()
            if attribute in primitive.attributes
        }
        count = len(arrays["position"])
        for at, target in enumerate(primitive.targets[:_MOST_TARGETS]):
            for attribute, key in _MORPHED.items():
                if attribute in target:
                    moved = self._array(target[attribute], key, morph=True)
                    arrays[f"morph{at}_{key}"] = moved
        index = self._index(primitive, count)
        if len(index) and (wrong := int(index.max())) >= count:
            message = f"part '{name}' of the model {self.file.path} has triangles of vertex {wrong}"
            raise input_error("SC513", f"{message}, but {count} vertices")
        return index, arrays, complete(arrays, index) if len(index) else set()

    def _in_full(self, primitive: Primitive) -> bool:
        """Is the geometry there without the extension too?"""
        at = primitive.attributes.get("POSITION", -1)
        return self.file.item(self.file.document.accessors, at, "accessor").buffer_view is not None

    def _array(self, at: int, key: str, morph: bool = False) -> Floats:
        stored = self.file.array(at).astype(np.float32)
        wanted = 3 if morph else _WIDTHS.get(key, stored.shape[1])
        if stored.shape[1] != wanted:
            raise self.file.unreadable(f"its array '{key}' has {stored.shape[1]} components")
        if not np.isfinite(stored).all():
            message = f"array '{key}' of the mesh {self.file.path} holds NaN or infinity"
            raise input_error("SC512", message)
        if key == "weights":
            total = stored.sum(1, keepdims=True)
            stored = np.divide(stored, total, out=stored, where=total > 0.0)
        return np.ascontiguousarray(stored)

    def _index(self, primitive: Primitive, count: int) -> NDArray[np.uint32]:
        """Triangles (m, 3); none of points and lines."""
        if primitive.indices is None:
            flat = np.arange(count, dtype=np.uint32)
        else:
            flat = self.file.array(primitive.indices).astype(np.uint32).ravel()
        if primitive.mode == 4:
            return flat[: len(flat) // 3 * 3].reshape(-1, 3)
        if primitive.mode not in (5, 6) or len(flat) < 3:
            return np.zeros((0, 3), np.uint32)
        middle, end = flat[1:-1], flat[2:]
        if primitive.mode == 6:
            return np.stack([np.full_like(middle, flat[0]), middle, end], 1)
        # Every other triangle of a strip is turned round.
        odd = np.arange(len(middle)) % 2 == 1
        pair = np.where(odd[:, None], np.stack([end, middle], 1), np.stack([middle, end], 1))
        return np.concatenate([flat[:-2, None], pair], 1)

    def _material(self, at: int | None) -> Material:
        if at is None:
            return Material()
        material = self.file.item(self.file.document.materials, at, "material")
        base = material.pbr_metallic_roughness
        infos = {
            "albedo": base.base_color_texture,
            "normal": material.normal_texture,
            "roughness": base.metallic_roughness_texture,
            "occlusion": material.occlusion_texture,
            "emissive": material.emissive_texture,
        }
        found = {role: self._picture(info.index) for role, info in infos.items() if info}
        return Material(
            *(material.name, base.base_color_factor, base.metallic_factor, base.roughness_factor),
            *(material.emissive_factor, material.double_sided),
            {role: picture for role, picture in found.items() if picture is not None},
        )

    def _picture(self, texture: int) -> Picture | None:
        document = self.file.document
        source = self.file.item(document.textures, texture, "texture").source
        if source is None:
            return None
        image = self.file.item(document.images, source, "image")
        if source not in self.pictures and (image.uri or image.buffer_view is not None):
            inside = image.buffer_view
            data = self.file.resource(image.uri or "") if inside is None else None
            packed = self.file.bytes_of(inside) if inside is not None else data
            self.pictures[source] = Picture(image.name or f"image{source}", packed or b"")
        return self.pictures.get(source)


def _distinct(parts: Iterable[ModelPart]) -> Iterator[ModelPart]:
    """The same parts, each under a name of its own."""
    known: set[str] = set()
    counts: Counter[str] = Counter()
    for part in parts:
        name = part.name
        while name in known:
            counts[part.name] += 1
            name = f"{part.name} {counts[part.name] + 1}"
        known.add(name)
        yield part if name == part.name else replace(part, name=name)
