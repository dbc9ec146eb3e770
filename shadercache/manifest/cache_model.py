"""What a manifest says of the values that are cached, and of the textures that keep them."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import UNSET, Meta, UnsetType

from shadercache.manifest import kinds

# Three channels are missing: such formats need not be render targets (OpenGL 4.6 section 8.5.1).
TextureFormat: TypeAlias = Literal[
    "r16f", "rg16f", "rgba16f", "r32f", "rg32f", "rgba32f", "r32ui", "rg32ui", "rgba32ui"
]

Texel: TypeAlias = Annotated[
    tuple[float, float, float, float], Meta(description="what an empty texel holds")
]

Extras: TypeAlias = Annotated[
    dict[str, kinds.Channel] | UnsetType,
    Meta(
        description="what is kept beside the payload, and in which channel: the object's id, its "
        "age"
    ),
]


class CacheChannels(kinds.ManifestPart, frozen=True, kw_only=True):
    """What lies in which channel of the cache."""

    payload: Literal["x", "xy", "xyz"]
    depth: Literal["w"]
    extras: Extras = UNSET


class SecondChannels(kinds.ManifestPart, frozen=True, kw_only=True):
    """What lies in which channel of the second texture."""

    payload: Literal["x", "xy", "xyz", "xyzw"] | UnsetType = UNSET
    extras: Extras = UNSET


class SecondEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """Where a payload is too wide for one texture: a second pair of textures, made, swapped,
    sampled and cleared with the first."""

    format: TextureFormat
    clear: Texel
    channels: SecondChannels


class CacheEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """The textures that keep what is cached."""

    format: Annotated[
        Literal["rgba16f", "rgba32f", "rgba32ui"],
        Meta(description="of a texel; integers are written and read as they are"),
    ]
    buffers: Annotated[
        Literal[2],
        Meta(description="textures of the size that targets.cache tells of; they swap each frame"),
    ]
    clear: Annotated[
        Texel, Meta(description="what an empty texel holds; its depth matches nothing")
    ]
    filter: Literal["linear", "nearest"]
    wrap: Literal["clamp-to-edge"]
    channels: CacheChannels
    depth_encoding: Literal[
        "1/w",
        "16/w",
        "z/w",
        "w",
        "floatBitsToUint(16/w)",
        "floatBitsToUint(z/w)",
        "floatBitsToUint(w)",
    ]
    options: Annotated[
        dict[str, str],
        Meta(description="what was chosen of how payloads are looked up, stored and refreshed"),
    ]
    second: SecondEntry | UnsetType = UNSET


class TargetEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """What passes draw into."""

    format: Annotated[TextureFormat | None, Meta(description="of a texel; null: the engine's own")]
    divisor: Annotated[
        Literal[1, 2, 4],
        Meta(
            description="width and height are those of the colour target divided by this, rounded "
            "up; so is a viewport's extent, and its place is rounded down"
        ),
    ] = 1


class PlacesEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """Where its scalars lie, in the order of a constructor's arguments: first those in the cache,
    then those in its second texture."""

    # Scalars lie side by side, so none but runs of channels occur.
    cache: Literal["x", "xy", "xyz", "y", "yz", "z"] | UnsetType = UNSET
    second: Literal["x", "xy", "xyz", "xyzw", "y", "yz", "yzw", "z", "zw", "w"] | UnsetType = UNSET


class SpanEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """Where it stands; lines and columns start at 1, the end is exclusive."""

    line: kinds.Line
    column: kinds.Line
    end_line: kinds.Line
    end_column: kinds.Line


class NodeEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """A value that is cached."""

    id: kinds.Words
    path: Annotated[kinds.Words, Meta(description="call path, outermost function first")]
    text: Annotated[kinds.Words, Meta(description="the expression as it was written")]
    type: kinds.GlslType
    span: SpanEntry
    channels: Annotated[PlacesEntry, Meta(extra_json_schema={"minProperties": 1})]
    conditional: Annotated[
        bool,
        Meta(
            description="are there fragments that get a colour without it? A texel that lacks any "
            "of the values is no use in the next frame"
        ),
    ]
    approximate: Annotated[
        bool,
        Meta(
            description="does it depend on where or how large a surface is seen? Reuse is exact "
            "at rest, and an approximation in motion"
        ),
    ] = False
