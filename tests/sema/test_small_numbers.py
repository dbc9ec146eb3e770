"""Numbers of 8, 16 and 64 bits: what converts to what, beside glslang."""

from __future__ import annotations

from itertools import product
from pathlib import Path

from shadercache.diagnostics import InputError
from shadercache.source import Source
from shadercache.valid.read import read
from tests.glslang import errors_of, needs_glslang

HEAD = "#version 450\n#extension GL_EXT_shader_explicit_arithmetic_types : enable\n"
KINDS = (
    *("float", "float16_t", "double", "int", "uint", "int64_t", "uint64_t"),
    *("int16_t", "uint16_t", "int8_t", "uint8_t"),
)
PAIRS = (
    *("a = b;", "a + b;", "a % b;", "a << b;", "a == b;", "a < b;", "a += b;"),
    *("max(a, b);", "true ? a : b;"),
)
ALONE = ("float q[3]; q[a];", "mix(a, a, true);", "abs(a);", "sin(a);", "~a;", "-a;", "a++;")


def is_read(text: str) -> bool:
    try:
        read(Source("x.frag", text))
    except InputError:
        return False
    return True


@needs_glslang
def test_they_convert_as_in_glslang(tmp_path: Path) -> None:
    lines = [f"{a} a; {b} b; {line}" for a, b in product(KINDS, KINDS) for line in PAIRS]
    lines += [f"{a} a; {line}" for a in KINDS for line in ALONE]
    files = {}
    for number, line in enumerate(lines):
        files[tmp_path / f"{number}.frag"] = f"{HEAD}void main() {{ {line} }}\n"
    for file, text in files.items():
        file.write_text(text)
    theirs = {file: not errors for file, errors in errors_of(files).items()}
    other = [files[file] for file, right in theirs.items() if is_read(files[file]) != right]
    assert not other
    assert 400 < sum(theirs.values()) < len(lines) - 200
