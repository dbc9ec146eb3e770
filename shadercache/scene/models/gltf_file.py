"""The bytes of a glTF file: the container, its buffers, and the arrays in these.

Every offset and count is compared with what is there before anything is read.
"""

from __future__ import annotations

import base64
import binascii
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar
from urllib.parse import unquote

import msgspec
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import InputError, input_error, shortened
from shadercache.foreign_files import read_bytes
from shadercache.scene.models.gltf_schema import Accessor, BufferView, Document, Sparse
from shadercache.scene.npz import MAX_BYTES, MAX_NUMBERS

T = TypeVar("T")

_MAGIC, _JSON, _BINARY = b"glTF", b"JSON", b"BIN\0"
_TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}

# What does not change where vertices are and which triangles there are.
_READ = ("KHR_mesh_quantization", "KHR_texture_transform", "KHR_lights_punctual", "EXT_texture_")
_COMPRESSED = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}


class GltfFile:
    """A glTF file: ``document`` is what its JSON says."""

    def __init__(self, path: Path) -> None:
        """Raises:
        InputError: SC510 for what is no glTF file, SC514 for one that needs an extension.
        """
        self.path = path
        text, self._binary = self._chunks(self._read(path))
        try:
            self.document = msgspec.json.decode(text, type=Document)
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
            raise self.unreadable(f"its JSON is not that of a glTF file: {error}") from None
        version = self.document.asset.version
        if not version.startswith("2."):
            raise self.unreadable(f"it is glTF {shortened(version)}, and 2.0 is read")
        self._check_extensions()
        self.files: list[Path] = [path]
        self._buffers: dict[int, bytes] = {}

    def unreadable(self, reason: str) -> InputError:
        """What is told of a file that cannot be read."""
        return input_error("SC510", f"cannot read the model {self.path}: {reason}")

    def item(self, items: Sequence[T], at: int, what: str) -> T:
        """One of the things that a document lists. Raises SC510 where there is none."""
        if not 0 <= at < len(items):
            raise self.unreadable(f"it names {what} {at}, and has {len(items)}")
        return items[at]

    def array(self, at: int) -> NDArray[np.generic]:
        """An accessor's elements (count, width) as they are stored, or normalised to float64.

        Raises:
            InputError: SC510, it claims what the file does not hold.
        """
        accessor = self.item(self.document.accessors, at, "accessor")
        if not 0 <= accessor.count <= MAX_NUMBERS // _WIDTHS[accessor.type]:
            raise self.unreadable(f"accessor {at} has {accessor.count:,} elements")
        dtype = self._dtype(accessor.component_type)
        shape = accessor.count, _WIDTHS[accessor.type]
        values = np.zeros(shape, dtype)
        if accessor.buffer_view is not None:
            values = self._stored(accessor, accessor.buffer_view, dtype)
        if accessor.sparse is not None:
            values = self._with_sparse(values, accessor.sparse)
        return _normalised(values) if accessor.normalized and dtype.kind != "f" else values

    def bytes_of(self, at: int) -> bytes:
        """What is in a buffer view. Raises SC510 where the file does not hold it."""
        view = self.item(self.document.buffer_views, at, "buffer view")
        start, data = self._bounds(view, at)
        return data[start : start + view.byte_length]

    def resource(self, uri: str) -> bytes | Path:
        """What a URI stands for: embedded data, or a file beside this one."""
        if not uri.startswith("data:"):
            if "://" in uri:
                raise self.unreadable(f"it lies elsewhere in part: {shortened(uri)}")
            return self.path.parent / unquote(uri)
        head, _, text = uri.partition(",")
        try:
            return base64.b64decode(text, validate=True) if ";base64" in head else text.encode()
        except (binascii.Error, ValueError):
            raise self.unreadable("data inside of it are not base64") from None

    def _chunks(self, data: bytes) -> tuple[bytes, bytes | None]:
        """The JSON, and the binary chunk of a GLB."""
        if self.path.suffix.lower() == ".gltf":
            return data, None
        if data[:4] != _MAGIC or len(data) < 20:
            raise self.unreadable("it is not a GLB file")
        length, size = struct.unpack_from("<I", data, 8)[0], struct.unpack_from("<I", data, 12)[0]
        if length > len(data) or 20 + size > len(data):
            message = f"it is cut off: it has {len(data):,} bytes, and says {length:,}"
            raise self.unreadable(message)
        if data[16:20] != _JSON:
            raise self.unreadable("its first chunk is not JSON")
        rest = data[20 + size :]
        if len(rest) < 8 or rest[4:8] != _BINARY:
            return data[20 : 20 + size], None
        end = 8 + struct.unpack_from("<I", rest)[0]
        if end > len(rest):
            raise self.unreadable("it is cut off: its binary chunk is longer than the file")
        return data[20 : 20 + size], rest[8:end]

    def _read(self, path: Path) -> bytes:
        try:
            return read_bytes(path, MAX_BYTES)
        except OSError as error:
            reason = error.strerror or str(error)
        if path != self.path:
            reason = f"the file {path} that it names: {reason}"
        raise self.unreadable(reason)

    def _check_extensions(self) -> None:
        for name in self.document.extensions_required:
            if name in _COMPRESSED:
                raise compressed(self.path, _COMPRESSED[name])
            if not name.startswith((*_READ, "KHR_materials_")):
                message = f"the model {self.path} needs {shortened(name)}, which is not read"
                raise input_error("SC514", message, "export it without that extension")

    def _buffer(self, at: int) -> bytes:
        if at not in self._buffers:
            buffer = self.item(self.document.buffers, at, "buffer")
            if buffer.uri is None:
                data = self._binary
                if data is None:
                    raise self.unreadable(f"buffer {at} is not in the file")
            else:
                found = self.resource(buffer.uri)
                if isinstance(found, Path):
                    self.files.append(found)
                    found = self._read(found)
                data = found
            if len(data) < buffer.byte_length:
                message = f"buffer {at} has {len(data):,} bytes of {buffer.byte_length:,}"
                raise self.unreadable(message)
            self._buffers[at] = data
        return self._buffers[at]

    def _bounds(self, view: BufferView, at: int) -> tuple[int, bytes]:
        data = self._buffer(view.buffer)
        if view.byte_offset < 0 or not 0 <= view.byte_length <= len(data) - view.byte_offset:
            raise self.unreadable(f"buffer view {at} does not lie inside of its buffer")
        return view.byte_offset, data

    def _dtype(self, code: int) -> np.dtype[np.generic]:
        if code not in _TYPES:
            raise self.unreadable(f"there is no component type {code}")
        return np.dtype(_TYPES[code])

    def _stored(
        self, accessor: Accessor, at: int, dtype: np.dtype[np.generic]
    ) -> NDArray[np.generic]:
        view = self.item(self.document.buffer_views, at, "buffer view")
        start, data = self._bounds(view, at)
        width = _WIDTHS[accessor.type]
        step = view.byte_stride or width * dtype.itemsize
        needed = accessor.byte_offset + step * (accessor.count - 1) + width * dtype.itemsize
        offset = accessor.byte_offset
        if accessor.count == 0:
            return np.zeros((0, width), dtype)
        if min(offset, step) < 0 or needed > view.byte_length:
            raise self.unreadable("an accessor does not lie inside of its buffer view")
        return np.ndarray(
            (accessor.count, width), dtype, data, start + offset, (step, dtype.itemsize)
        )

    def _with_sparse(self, values: NDArray[np.generic], sparse: Sparse) -> NDArray[np.generic]:
        width = values.shape[1]
        places = self._packed(
            *(sparse.indices.buffer_view, sparse.indices.byte_offset),
            self._dtype(sparse.indices.component_type),
            (sparse.count, 1),
        ).ravel()
        given = self._packed(
            *(sparse.values.buffer_view, sparse.values.byte_offset),
            values.dtype,
            (sparse.count, width),
        )
        if places.size and int(places.astype(np.int64).max()) >= len(values):
            raise self.unreadable("a sparse accessor sets elements that it does not have")
        values = values.copy()
        values[places.astype(np.int64)] = given
        return values

    def _packed(
        self, view: int, offset: int, dtype: np.dtype[np.generic], shape: tuple[int, int]
    ) -> NDArray[np.generic]:
        data = self.bytes_of(view)
        end = offset + shape[0] * shape[1] * dtype.itemsize
        if min(offset, shape[0]) < 0 or end > len(data):
            raise self.unreadable("a sparse accessor does not lie inside of its buffer view")
        return np.frombuffer(data[offset:end], dtype).reshape(shape)


def compressed(path: Path, how: str) -> InputError:
    """What is told of compressed geometry."""
    message = f"the geometry of the model {path} is compressed with {how}, which is not read"
    return input_error("SC514", message, "export it without compression (gltf-transform copy)")


def _normalised(values: NDArray[np.generic]) -> NDArray[np.float64]:
    """Whole numbers as shares of the largest (glTF 2.0 section 3.11)."""
    largest = np.iinfo(str(values.dtype)).max
    shares: NDArray[np.float64] = values.astype(np.float64) / largest
    return np.maximum(shares, -1.0)
