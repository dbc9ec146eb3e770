"""The reflection in a manifest: what of the user's a program declares and an engine gives."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Annotated, Literal, TypeAlias

from msgspec import UNSET, Meta, UnsetType

from shadercache.manifest import kinds

Dimension: TypeAlias = Literal["1D", "2D", "3D", "cube", "rectangle", "buffer"]
Component: TypeAlias = Annotated[
    Literal["float", "int", "uint"],
    Meta(description="of a texel's numbers, as the shader has them"),
]
Location: TypeAlias = Annotated[
    kinds.Unsigned | None,
    Meta(description="as it is declared; null: each program has one of its own choice"),
]
Binding: TypeAlias = Annotated[
    kinds.Unsigned | None,
    Meta(description="as it is declared; null: texture or image unit 0 when left alone"),
]
DescriptorSet: TypeAlias = Annotated[
    kinds.Unsigned | UnsetType,
    Meta(description="of Vulkan GLSL: the descriptor set; left out it is 0"),
]
Twin: TypeAlias = Annotated[
    kinds.Identifier | UnsetType,
    Meta(
        description="it is the twin of the input of this name, and gets what that one had in the "
        "last frame"
    ),
]
StageNames: TypeAlias = Annotated[
    tuple[kinds.StageName, ...],
    Meta(description="the stages that declare it", min_length=1, extra_json_schema=kinds.UNIQUE),
]


class MemberEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """A member of a block or of a struct.

    In blocks of packing std140 or std430 the offsets are told: those of a block's members from its
    beginning, those of a struct's from the struct's. Of other blocks, ask the linked program by
    name.
    """

    name: kinds.Identifier
    type: kinds.GlslType
    dims: kinds.Dims = ()
    offset: Annotated[kinds.Unsigned | UnsetType, Meta(description="in bytes")] = UNSET
    stride: Annotated[
        kinds.Size | UnsetType,
        Meta(description="of an array: bytes from one element of the innermost array to the next"),
    ] = UNSET
    matrix_stride: Annotated[
        kinds.Size | UnsetType,
        Meta(description="of a matrix: bytes from one column (row_major: one row) to the next"),
    ] = UNSET
    layout: Annotated[
        kinds.Words | UnsetType, Meta(description="what is written in its layout(...)")
    ] = UNSET
    read: Annotated[
        bool, Meta(description="of a block's member: false where no program reads it")
    ] = True
    members: Annotated[tuple[MemberEntry, ...], Meta(description="of a struct", min_length=1)] = ()


class _Variable(kinds.ManifestPart, frozen=True, kw_only=True):
    """What all inputs but blocks have."""

    name: kinds.Identifier
    stages: StageNames
    type: kinds.GlslType
    dims: kinds.Dims = ()


class AttributeInput(_Variable, frozen=True, kw_only=True, tag_field="kind", tag="attribute"):
    """A vertex attribute."""

    location: Location
    previous_of: Twin = UNSET


class UniformInput(_Variable, frozen=True, kw_only=True, tag_field="kind", tag="uniform"):
    """A uniform that is no texture, outside of blocks."""

    location: Location
    default: Annotated[
        tuple[float, ...] | str | UnsetType,
        Meta(
            description="what the shaders initialise it with, so that it may be left alone: its "
            "numbers in order (a matrix by columns), or the expression where they are not known"
        ),
    ] = UNSET
    members: Annotated[
        tuple[MemberEntry, ...],
        Meta(
            description="of a struct; GL names its parts name.member, name[0].member", min_length=1
        ),
    ] = ()
    previous_of: Twin = UNSET


class _Texture(_Variable, frozen=True, kw_only=True):
    """What samplers and images have."""

    binding: Binding
    set: DescriptorSet = UNSET
    dimension: Dimension
    component: Component
    layers: Annotated[bool, Meta(description="is it an array texture?")] = False
    multisampled: bool = False
    previous_of: Twin = UNSET


class SamplerInput(_Texture, frozen=True, kw_only=True, tag_field="kind", tag="sampler"):
    """A texture that is sampled."""

    compares: Annotated[
        bool, Meta(description="is it a shadow sampler, which compares depths?")
    ] = False
    external: Annotated[bool, Meta(description="is it a samplerExternalOES?")] = False


class ImageInput(_Texture, frozen=True, kw_only=True, tag_field="kind", tag="image"):
    """An image that is read and written by texel."""


class TextureInput(_Texture, frozen=True, kw_only=True, tag_field="kind", tag="texture"):
    """A texture without a sampler, of Vulkan GLSL."""


class SamplerStateInput(
    _Variable, frozen=True, kw_only=True, tag_field="kind", tag="sampler state"
):
    """A sampler without a texture, of Vulkan GLSL."""

    binding: kinds.Unsigned | None
    set: DescriptorSet = UNSET
    compares: Annotated[bool, Meta(description="does it compare depths?")] = False


class SubpassInput(_Variable, frozen=True, kw_only=True, tag_field="kind", tag="subpass input"):
    """What an earlier subpass has left at the pixel, of Vulkan GLSL."""

    binding: kinds.Unsigned | None
    set: DescriptorSet = UNSET
    input_attachment_index: kinds.Unsigned | None


class SpecialisedInput(
    _Variable, frozen=True, kw_only=True, tag_field="kind", tag="specialisation constant"
):
    """A constant that is given where a pipeline is made, of Vulkan GLSL; alike in all passes."""

    constant_id: Annotated[kinds.Unsigned, Meta(description="as it is declared")]
    default: Annotated[str, Meta(description="its value where none is given, as an expression")]


class CounterInput(_Variable, frozen=True, kw_only=True, tag_field="kind", tag="atomic counter"):
    """An atomic counter."""

    binding: Annotated[kinds.Unsigned | None, Meta(description="as it is declared")]


class _BlockInput(kinds.ManifestPart, frozen=True, kw_only=True):
    """What blocks have."""

    name: Annotated[
        kinds.Identifier,
        Meta(
            description="the block's name, by which GL knows it (of an array of blocks: name[0], "
            "name[1], ...)"
        ),
    ]
    stages: StageNames
    instance: Annotated[
        kinds.Identifier | None,
        Meta(description="by which the shaders know it; null: they know its members"),
    ]
    dims: Annotated[
        tuple[kinds.Size, ...],
        Meta(description="sizes of an array of blocks; each element has a buffer"),
    ]
    packing: Literal["shared", "packed", "std140", "std430"]
    matrices: Literal["column_major", "row_major"]
    binding: Annotated[
        kinds.Unsigned | None,
        Meta(description="as it is declared; null: point 0 when left alone, so give it a free one"),
    ]
    set: DescriptorSet = UNSET
    size: Annotated[
        kinds.Unsigned | UnsetType,
        Meta(
            description="bytes that a buffer has to have (and more for an array without a size at "
            "its end); with std140 and std430"
        ),
    ] = UNSET
    members: Annotated[tuple[MemberEntry, ...], Meta(min_length=1)]
    previous_of: Twin = UNSET
    takes_the_last_buffer: Annotated[
        bool | UnsetType,
        Meta(
            description="of a twin: is it laid out like the other one, so that the same buffer can "
            "be bound a frame later?"
        ),
    ] = UNSET


class UniformBlockInput(
    _BlockInput, frozen=True, kw_only=True, tag_field="kind", tag="uniform block"
):
    """A uniform block."""

    push_constant: Annotated[
        bool, Meta(description="of Vulkan GLSL: is it the block of push constants?")
    ] = False


class StorageBlockInput(
    _BlockInput, frozen=True, kw_only=True, tag_field="kind", tag="storage block"
):
    """A shader storage block."""


InputEntry: TypeAlias = (
    AttributeInput
    | UniformInput
    | SamplerInput
    | ImageInput
    | TextureInput
    | SamplerStateInput
    | SubpassInput
    | SpecialisedInput
    | CounterInput
    | UniformBlockInput
    | StorageBlockInput
)


BOUND = (SamplerInput, ImageInput, TextureInput, UniformBlockInput, StorageBlockInput)
"""What has a binding, and may have a twin."""


def name_space(entry: InputEntry) -> type:
    """What the name of an input is one of: attributes, uniforms, or blocks of either kind.

    Stages share their uniforms (GLSL 4.60 section 4.3.5) and their blocks (4.3.9). An attribute of
    the one may have the name of a uniform of the other, and is another input.
    """
    apart = (AttributeInput, UniformBlockInput, StorageBlockInput)
    return type(entry) if isinstance(entry, apart) else UniformInput


def declared_of(
    inputs: Iterable[InputEntry], uniforms: Collection[str], attributes: Collection[str]
) -> tuple[InputEntry, ...]:
    """Those of the inputs that are among these attributes, or among these uniforms, textures and
    blocks."""
    return tuple(
        entry
        for entry in inputs
        if entry.name in (attributes if isinstance(entry, AttributeInput) else uniforms)
    )
