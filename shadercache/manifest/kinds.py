"""Words and numbers that several parts of a manifest are made of, with their rules."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

UNIQUE = {"uniqueItems": True}
"""msgspec has no such rule: :mod:`manifest.rules` holds it."""

Identifier: TypeAlias = Annotated[
    str,
    Meta(
        pattern=r"^[A-Za-z_][A-Za-z0-9_.\[\]]*$",
        description="a GLSL name, with members or elements",
    ),
]
Words: TypeAlias = Annotated[str, Meta(min_length=1)]
FileName: TypeAlias = Annotated[str, Meta(min_length=1)]
GlslType: TypeAlias = Annotated[str, Meta(min_length=1, description="its GLSL type")]
Sentences: TypeAlias = Annotated[tuple[Words, ...], Meta(min_length=1)]

Line: TypeAlias = Annotated[int, Meta(ge=1)]
Unsigned: TypeAlias = Annotated[int, Meta(ge=0)]
Size: TypeAlias = Annotated[int, Meta(ge=1)]

StageName: TypeAlias = Literal["vertex", "fragment"]
ParkedName: TypeAlias = Literal[
    "parked-1", "parked-2", "parked-3", "parked-4", "parked-5", "parked-6"
]
ColorName: TypeAlias = Literal[
    "color", "color-2", "color-3", "color-4", "color-5", "color-6", "color-7", "color-8"
]
TargetName: TypeAlias = Literal[ColorName, "cache", "cache-2", "mask", ParkedName]
ReadName: TypeAlias = Literal[
    "previous-cache", "current-cache", "previous-cache-2", "current-cache-2", ParkedName
]
Channel: TypeAlias = Literal["x", "y", "z", "w"]

Dims: TypeAlias = Annotated[
    tuple[Unsigned, ...],
    Meta(description="sizes of the array, outermost first; 0: as many as the buffer has"),
]


class ManifestPart(
    Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, omit_defaults=True
):
    """What all parts of a manifest share: they are checked whole, and absent is not null."""
