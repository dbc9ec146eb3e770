"""Files that others wrote: whatever they claim, one diagnostic says what is wrong with them."""

from __future__ import annotations

import io
import json
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from shaders import analysed

from shadercache import foreign_files as foreign
from shadercache.cli.app import main
from shadercache.diagnostics import InputError, UsageError
from shadercache.gpu import textures
from shadercache.gpu.textures import load_pixels
from shadercache.manifest.codec import encode
from shadercache.measure.result_files import read_json
from shadercache.render.bundle import Bundle, bundle_of, load_bundle
from shadercache.scene import npz
from shadercache.scene.description import load_scene
from shadercache.scene.mesh import load_mesh
from shadercache.scene.npz import load_npz
from shadercache.scene.object_inputs import Rows
from tests.configured import rewritten


def told(read: Callable[[Path], object], path: Path, code: str) -> str:
    """The message of the one diagnostic with which a file is turned down."""
    with pytest.raises(InputError) as caught:
        read(path)
    (found,) = caught.value.diagnostics
    assert found.code == code
    assert len(found.render()) < 2_000
    return found.message


# --- .npz -----------------------------------------------------------------------------------------


def header(shape: str, dtype: str = "'<f4'") -> bytes:
    """The beginning of an ``.npy`` file."""
    text = f"{{'descr': {dtype}, 'fortran_order': False, 'shape': {shape}, }}"
    text += " " * (-(len(text) + 11) % 64) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text.encode()


def packed(data: bytes, name: str = "position.npy", how: int = zipfile.ZIP_DEFLATED) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", how) as archive:
        archive.writestr(name, data)
    return file.getvalue()


def patched(data: bytes, local: int, central: int, value: bytes) -> bytes:
    """A zip file with a field of both of its headers overwritten."""
    found = bytearray(data)
    for sign, offset in ((b"PK\x03\x04", local), (b"PK\x01\x02", central)):
        at = found.index(sign) + offset
        found[at : at + len(value)] = value
    return bytes(found)


PLAIN = header("(2, 3)") + bytes(24)
OBJECTS = io.BytesIO()
np.save(OBJECTS, np.array([{}, []], object), allow_pickle=True)

NPZ = {
    "twelve billion numbers": packed(header("(4000000000, 3)") + bytes(64)),
    "the same, not in a zip": header("(4000000000, 3)") + bytes(64),
    "more than the file holds": packed(header("(9, 3)") + bytes(24)),
    "less than the file holds": packed(header("(1, 3)") + bytes(24)),
    "a negative size": packed(header("(-2, -3)") + bytes(24)),
    "a size of 70 bits": packed(header(f"({2**62}, 256)") + bytes(24)),
    "nothing times a size of 70 bits": packed(header(f"(0, {2**70})")),
    "numbers of no bytes": packed(header("(4000000000, 3)", "'V0'")),
    "objects": packed(OBJECTS.getvalue()),
    "a pickle": packed(b"\x80\x04\x95cos\nsystem\n."),
    "deep brackets": packed(header("(" * 4_000 + ")" * 4_000)),
    "brackets of other kinds": packed(header("((9,}")),
    "a word without its end": packed(header("(3, '''")),
    "a type of nothing": packed(header("(2, 3)", "()") + bytes(24)),
    "a type without a type": packed(header("(2, 3)", "[()]") + bytes(24)),
    "a type with half a shape": packed(header("(2, 3)", "('<f4',)") + bytes(24)),
    "many signs": packed(header("(" + "-" * 8_000 + "1,)")),
    "a long header": packed(header(f"({'1, ' * 20_000})")),
    "no header": packed(b""),
    "half a header": packed(PLAIN[:20]),
    "another version": packed(PLAIN[:6] + b"\x09" + PLAIN[7:]),
    "half a file": packed(PLAIN)[:60],
    "no end": packed(PLAIN)[:-10],
    "absurdly packed": patched(packed(PLAIN), 22, 24, struct.pack("<I", 900_000_000)),
    "more than the limit": patched(packed(PLAIN), 22, 24, struct.pack("<I", 4_000_000_000)),
    "broken data": patched(packed(PLAIN), 50, 70, b"\xff\xff\xff\xff"),
    "a password": patched(packed(PLAIN), 6, 8, b"\x01\x00"),
    "an unknown compression": patched(packed(PLAIN), 8, 10, b"\x63\x00"),
    "text": b"v 1 2 3\nf 1 2 3\n",
    "nothing": b"",
}


@pytest.mark.parametrize("kind", NPZ)
def test_hostile_arrays(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "x.npz"
    path.write_bytes(NPZ[kind])
    assert "cannot read the mesh" in told(load_mesh, path, "SC510")
    assert "cannot read the texture" in told(load_pixels, path, "SC530")
    animation = Rows(path, "position", 0.0, 1.0)
    assert "cannot read the animation" in told(lambda _: animation.at(1), path, "SC541")


def test_what_is_claimed_is_said(tmp_path: Path) -> None:
    path = tmp_path / "x.npz"
    path.write_bytes(NPZ["twelve billion numbers"])
    message = "its array 'position' claims 12,000,000,000 numbers, which the file does not hold"
    assert told(load_mesh, path, "SC510").endswith(message)


def test_there_are_limits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "x.npz"
    np.savez(path, position=np.zeros((40, 3)), normal=np.zeros((40, 3)))
    for name, value in (("MAX_NUMBERS", 200), ("MAX_BYTES", 1_000), ("MAX_ARRAYS", 1)):
        with monkeypatch.context() as patch:
            patch.setattr(npz, name, value)
            told(load_mesh, path, "SC510")


@pytest.mark.parametrize("dtype", ["<f4", ">f8", "|u1", "<i8", "|b1", "<U3", "<f4,<i2", "<c8"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_what_numpy_writes_is_read(dtype: str, order: str, tmp_path: Path) -> None:
    array = np.array(np.ones((5, 3)), np.dtype(dtype), order=order)  # type: ignore[call-overload]
    for write in (np.savez, np.savez_compressed):
        write(tmp_path / "x.npz", one=array, none=array[:0], scalar=array[0, 0])
        found = load_npz(tmp_path / "x.npz", "SC510", "the mesh")
        assert found["one"].dtype == array.dtype
        assert (found["one"] == array).all() and found["none"].shape == (0, 3)


def test_other_files_in_it_are_no_arrays(tmp_path: Path) -> None:
    (tmp_path / "x.npz").write_bytes(packed(b"hello", "position.txt"))
    assert "no array 'position'" in told(load_mesh, tmp_path / "x.npz", "SC511")


# --- PNG ------------------------------------------------------------------------------------------


def chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(width: int, height: int, data: bytes = b"", extra: bytes = b"") -> bytes:
    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
    body = chunk(b"IDAT", zlib.compress(data))
    return b"\x89PNG\r\n\x1a\n" + head + extra + body + chunk(b"IEND", b"")


def gif() -> bytes:
    file = io.BytesIO()
    Image.new("RGB", (4, 4)).save(file, "GIF")
    return file.getvalue()


PNG = {
    "60,000 by 60,000": png(60_000, 60_000),
    "10,000 by 10,000": png(10_000, 10_000),
    "8,000 by 8,000 in a hundred bytes": png(8_000, 8_000),
    "four thousand million wide": png(2**32 - 1, 1),
    "no pixels": png(0, 0),
    "less than is claimed": png(64, 64, bytes(100)),
    "half a file": png(4, 4, bytes(68))[:44],
    "a wrong sum": png(4, 4, bytes(68)).replace(b"IHDR", b"IHDS"),
    "a chunk of two gigabytes": png(4, 4, extra=b"\x7f\xff\xff\xffzTXt"),
    "a bomb of text": png(
        4, 4, bytes(68), chunk(b"zTXt", b"a\0\0" + zlib.compress(bytes(9 << 20)))
    ),
    "broken data": png(4, 4, bytes(68)).replace(zlib.compress(bytes(68))[:4], b"\xff\xff\xff\xff"),
    "another format": gif(),
    "text": b"not a picture",
    "nothing": b"",
}


@pytest.mark.parametrize("kind", PNG)
def test_hostile_pictures(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "x.png"
    path.write_bytes(PNG[kind])
    assert "cannot read the texture" in told(load_pixels, path, "SC530")


def test_a_picture_is_read(tmp_path: Path) -> None:
    path = tmp_path / "x.png"
    path.write_bytes(png(4, 4, bytes(68)))
    assert load_pixels(path)[0].shape == (4, 4, 4)
    Image.new("1", (3000, 3000)).save(path)  # packs as well as any
    assert load_pixels(path)[0].shape == (3000, 3000, 4)


def test_the_limit_of_pictures_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(textures, "MAX_PIXELS", 15)
    path = tmp_path / "x.png"
    path.write_bytes(png(4, 4, bytes(68)))
    assert "4 x 4 pixels; at most 15" in told(load_pixels, path, "SC530")


# --- scenes ---------------------------------------------------------------------------------------

SCENES = {
    "nested brackets": "x = " + "[" * 5_000 + "]" * 5_000,
    "brackets that stay open": "x = " + "[" * 5_000,
    "nested tables": "x = " + "{a=" * 5_000 + "1" + "}" * 5_000,
    "brackets behind a string": 'y = "]]]]"\n' + "x = " + "[" * 500 + "]" * 500,
    "a number of a hundred thousand digits": "x = " + "1" * 100_000,
    "a number of thousands of digits": "[camera]\nnear = 1" + "0" * 4_000,
    "half a string": 'name = "abc',
    "a control character": "name = 'a\x00b'",
    "two of a name": "x = 1\nx = 2",
    "no TOML": "#version 330\nvoid main() {}\n",
    "more than the limit": "#" * (2 << 20),
}


@pytest.mark.parametrize("kind", SCENES)
def test_hostile_scenes(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "x.toml"
    path.write_text(SCENES[kind], encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_scene(path)
    assert all(len(item.render()) < 3_000 for item in caught.value.diagnostics)
    options = ["--node", "main.0-00000000", "--passes", "2", "-o", str(tmp_path / "out")]
    assert main(["run", str(path), *options]) == 1
    assert "Traceback" not in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_scene_of_bytes(tmp_path: Path) -> None:
    (tmp_path / "x.toml").write_bytes(b"\xff\xfe\x00")
    assert "is not UTF-8" in told(load_scene, tmp_path / "x.toml", "SC501")


@pytest.mark.parametrize("name", ["a" * 5_000, "a\\u0000b"])
def test_files_that_cannot_be(name: str, tmp_path: Path) -> None:
    (tmp_path / "x.toml").write_text(f'fragment = "{name}"\n', encoding="utf-8")
    with pytest.raises(InputError):
        load_scene(tmp_path / "x.toml")


def test_a_table_with_ten_thousand_parts(tmp_path: Path) -> None:
    text = f"[[{'.'.join('a' * 10_000)}]]\nb = 1\n"
    (tmp_path / "x.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError):
        load_scene(tmp_path / "x.toml")


# --- JSON -----------------------------------------------------------------------------------------

JSON = {
    "nested lists": b"[" * 100_000 + b"]" * 100_000,
    "nested objects": b'{"a":' * 100_000,
    "nested behind a string": b'{"a": "]]", "b": ' + b"[" * 200 + b"]" * 200 + b"}",
    "a number of ten thousand digits": b'{"schema_version": ' + b"1" * 10_000 + b"}",
    "half a file": b'{"schema_version": 1, "passes": [',
    "no object": b"[1, 2]",
    "another version": b'{"schema_version": "1"}',
    "not UTF-8": b'{"a": "\xff"}',
    "nothing": b"",
}


@pytest.mark.parametrize("kind", JSON)
def test_hostile_json(kind: str, tmp_path: Path) -> None:
    (tmp_path / "manifest.json").write_bytes(JSON[kind])
    code = "SC021" if kind in ("no object", "another version") else "SC020"
    told(load_bundle, tmp_path, code)
    told(read_json, tmp_path / "manifest.json", "SC023")


def test_the_limit_of_json(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(foreign, "MAX_JSON", 100)
    text = json.dumps({"schema_version": 1, "a": "b" * 100})
    (tmp_path / "manifest.json").write_text(text, encoding="utf-8")
    assert "more than 100 bytes" in told(load_bundle, tmp_path, "SC020")


def leaves(value: object, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """The paths to everything in a JSON value."""
    yield path
    if isinstance(value, dict | list):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for key, inner in items:
            yield from leaves(inner, (*path, key))


@pytest.mark.parametrize("instead", [None, 7, "x", [[]], {"a": None}, 10**400])
def test_manifests_with_anything_anywhere(instead: object) -> None:
    analysis = analysed("o_color = vec4(sin(v_position * 3.0) * exp(v_uv.x), 1.0);")
    node = next(node for node in analysis.nodes if node.offered)
    emission = rewritten(analysis, node)
    whole = encode(emission.manifest)
    for path in leaves(json.loads(whole)):
        broken = [json.loads(whole)]
        at: Any = broken
        for key, after in pairwise((0, *path, None)):
            if after is None:
                at[key] = instead
            else:
                at = at[key]
        with suppress(InputError):
            use(bundle_of(broken[0], emission.files, "manifest.json"))


def use(bundle: Bundle) -> None:
    """Ask a manifest for all that the renderer asks it for."""
    names = [name for name, kind in vars(Bundle).items() if isinstance(kind, cached_property)]
    for name in names:
        with suppress(InputError, UsageError):
            getattr(bundle, name)


# --- shaders --------------------------------------------------------------------------------------


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="the system has no /dev/zero")
def test_a_shader_without_end(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "/dev/zero"]) == 1
    assert f"more than {foreign.MAX_SHADER:,} bytes" in capsys.readouterr().err
