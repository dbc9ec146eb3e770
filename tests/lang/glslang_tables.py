"""The table of built-in functions that glslang has, as text in our own notation."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from tests.glslang import TOOL

_ENTRY = re.compile(r"(\w+):  global (.*?) ?\b\1\((.*)\)( <[\w, ]*>)?$")
_QUALIFIERS = re.compile(
    r"^(?:(?:in|out|inout|const|temp|global|read only|highp|mediump|lowp|coherent|volatile"
    r"|nontemporal|readonly|writeonly|restrict|\(read only\)) )+"
)
_PARAMETERS = re.compile(r"\s*,\s*(?=(?:in|out|inout|const)\b)")
_ARRAY = re.compile(r"(\d+)-element array of (.*)")
_VECTOR = re.compile(r"(\d)-component vector of (\w+)")
_MATRIX = re.compile(r"(\d)X(\d) matrix of (\w+)")
_PREFIXES = {
    **{"float": "", "int": "i", "uint": "u", "bool": "b", "double": "d"},
    **{"int64_t": "i64", "uint64_t": "u64", "float16_t": "f16"},
    **{"int16_t": "i16", "uint16_t": "u16", "int8_t": "i8", "uint8_t": "u8"},
}


def table(version: str, stage: str, folder: Path, *, extended: bool = False) -> dict[str, set[str]]:
    """Signatures (``vec4(sampler2D, vec2)``) by name; with or without those of extensions."""
    found: dict[str, set[str]] = {}
    for entry in filter(None, map(_ENTRY.match, _dump(version, stage, folder))):
        name, result, params, extensions = entry.groups()
        if extended or extensions is None:
            kinds = [_kind(part) for part in _PARAMETERS.split(params) if part.strip()]
            found.setdefault(name, set()).add(f"{_kind(result)}({', '.join(kinds)})")
    return found


def _dump(version: str, stage: str, folder: Path) -> list[str]:
    assert TOOL is not None
    file = folder / f"table.{stage[:4]}"
    file.write_text(f"#version {version}\nvoid main() {{ }}\n")
    done = subprocess.run(
        [TOOL, "--dump-builtin-symbols", str(file)], capture_output=True, text=True, check=True
    )
    return done.stdout.splitlines()


def _kind(text: str) -> str:
    """``const in lowp 2-component vector of float p`` -> ``vec2``."""
    text = _QUALIFIERS.sub("", text.strip() + " ").strip()
    if array := _ARRAY.match(text):
        return f"{_kind(array[2])}[{array[1]}]"
    if vector := _VECTOR.match(text):
        return f"{_PREFIXES.get(vector[2], vector[2])}vec{vector[1]}"
    if matrix := _MATRIX.match(text):
        size = matrix[1] if matrix[1] == matrix[2] else f"{matrix[1]}x{matrix[2]}"
        return f"{_PREFIXES.get(matrix[3], matrix[3])}mat{size}"
    return text.split()[0]


_VARIABLE = re.compile(r"(gl_\w+):  (?!temp )([^<(]*)( <[\w, ]*>)?$")


def variables(version: str, stage: str, folder: Path) -> set[str]:
    """Names of built-in variables and constants; those of extensions are left out."""
    return {
        match[1]
        for match in map(_VARIABLE.match, _dump(version, stage, folder))
        if match and match[3] is None
    }
