"""The generic types of ``builtins.txt``: one line of the file stands for many overloads.

Before: ``genType max(genType, float)``. After: ``float max(float, float)``, ``vec2 max(vec2,
float)``, ``vec3 max(vec3, float)``, ``vec4 max(vec4, float)``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_GENERIC = re.compile(
    r"gen(?:[IU](?:64|16|8)|F16|[IUBD])?Type|(?:f16|d)?mat(?:CR|RC)"
    r"|(?:[iu](?:64|16|8)|f16|[iubd])?vec[NCR]"
)
_KINDS = re.compile(r"\bg(?=vec4|sampler|image|Image|texture|subpass)")
_PLACED_IMAGE = re.compile(r"([iu]?)Image\b")
_SCALARS = {
    **{"": "float", "i": "int", "u": "uint", "b": "bool", "d": "double"},
    **{"i64": "int64_t", "u64": "uint64_t", "f16": "float16_t"},
    **{"i16": "int16_t", "u16": "uint16_t", "i8": "int8_t", "u8": "uint8_t"},
}
_GEN_NAMES = {f"gen{prefix.upper()}Type": prefix for prefix in _SCALARS}
_SIZES = ("2", "3", "4")

_HALF = ("genF16Type", "float16_t")
_SIZED = {
    "genFDType": (("genType", "float"), ("genDType", "double"), _HALF),
    "genFHType": (("genType", "float"), _HALF),
    "genISType": (("genI8Type", "int8_t"), ("genI16Type", "int16_t")),
    "genUSType": (("genU8Type", "uint8_t"), ("genU16Type", "uint16_t")),
}
"""Generic types that stand for several others, with the scalar of each."""
_SCALAR_OF = {
    "genFDType": "floatD",
    "genFHType": "floatH",
    "genISType": "intS",
    "genUSType": "uintS",
}

# What follows an image of each shape in the functions of images (section 8.12 of 4.60).
_IMAGE_PLACES = {
    "1D": "int",
    "2D": "ivec2",
    "3D": "ivec3",
    "Cube": "ivec3",
    "2DRect": "ivec2",
    "1DArray": "ivec2",
    "2DArray": "ivec3",
    "CubeArray": "ivec3",
    "Buffer": "int",
    "2DMS": "ivec2, int",
    "2DMSArray": "ivec3, int",
}


def expanded(text: str) -> Iterator[tuple[tuple[str, ...], bool]]:
    """All overloads that ``result, parameter, parameter`` stands for.

    Each has its types, and whether it has a ``bias``, which only fragment shaders know.
    """
    for single in _of_each_size(text):
        for sized in _sized_all(single):
            for kind in _kinds(sized):
                for placed in _placed(kind):
                    yield from _optional(placed)


def _of_each_size(text: str) -> Iterator[str]:
    """Replace floats and integers of several sizes by those of each."""
    for generic, sizes in _SIZED.items():
        if generic in text:
            for kind, scalar in sizes:
                yield text.replace(generic, kind).replace(_SCALAR_OF[generic], scalar)
            return
    yield text


def _sized_all(text: str) -> Iterator[str]:
    """Replace the generic types by every size."""
    if "Type" in text:
        sizes: tuple[str, ...] = ("1", *_SIZES)
    elif "matCR" in text:
        sizes = tuple(columns + rows for columns in _SIZES for rows in _SIZES)
    elif "vecN" in text:
        sizes = _SIZES
    else:
        yield text
        return
    generic = set(_GENERIC.findall(text))
    for size in sizes:
        sized = text
        for word in generic:
            # `vecN` is a part of `ivecN` too, but comes out right there: the prefix stays.
            sized = sized.replace(word, _sized(word, size))
        yield sized


def _sized(generic: str, size: str) -> str:
    """``genIType``, 1 -> ``int``; ``bvecN``, 3 -> ``bvec3``; ``matRC``, 23 -> ``mat3x2``."""
    prefix = _GEN_NAMES.get(generic)
    if prefix is not None:
        return _SCALARS[prefix] if size == "1" else f"{prefix}vec{size}"
    if generic.endswith("CR"):
        return f"{generic[:-2]}{size[0]}x{size[1]}"
    if generic.endswith("RC"):
        return f"{generic[:-2]}{size[1]}x{size[0]}"
    return generic[:-1] + (size[1] if generic.endswith("R") else size[0])


def _kinds(text: str) -> Iterator[str]:
    """Replace a leading ``g`` by nothing, ``i`` and ``u``."""
    for prefix in ("", "i", "u") if _KINDS.search(text) else ("",):
        yield _KINDS.sub(prefix, text)


def _placed(text: str) -> Iterator[str]:
    if not _PLACED_IMAGE.search(text):
        yield text
        return
    for shape, place in _IMAGE_PLACES.items():
        yield _PLACED_IMAGE.sub(rf"\g<1>image{shape}, {place}", text)


def _optional(text: str) -> Iterator[tuple[tuple[str, ...], bool]]:
    """Expand a last ``bias?`` or ``comp?``."""
    *kept, last = text.split(", ")
    bias = last == "bias?"
    if last.endswith("?"):
        yield tuple(kept), False
        last = "float" if bias else "const int"
    yield (*kept, last), bias
