"""The manifest as a typed model: what is decoded, what is encoded, what the JSON Schema says.

Docstrings and descriptions are those of the published schema. Rules between fields, which types
cannot say, stand in :mod:`manifest.rules`.
"""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import UNSET, Meta, UnsetType

from shadercache.manifest import kinds, pass_model
from shadercache.manifest.cache_model import CacheEntry, NodeEntry, TargetEntry
from shadercache.manifest.interface import InputEntry

SCHEMA_VERSION: Literal[3] = 3

ModeName: TypeAlias = Annotated[
    Literal["plain", "proof"],
    Meta(description="plain is what is shipped; proof forbids the driver to rearrange arithmetic"),
]


class SourceEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """A shader that was rewritten."""

    name: kinds.Words
    sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]


class SourcesEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """The shaders that were rewritten."""

    fragment: SourceEntry
    vertex: SourceEntry


class OutputEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """An output of the user's shader, and the targets that it is drawn into."""

    output: kinds.Identifier
    type: kinds.GlslType
    location: Annotated[kinds.Unsigned, Meta(le=7, description="of the first target")]
    targets: Annotated[
        tuple[kinds.ColorName, ...],
        Meta(description="one, or of an array one for each element", min_length=1),
    ]


class DependencyEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """Something that the cached values depend on."""

    kind: Literal[
        "attribute",
        "uniform",
        "sampler",
        "image",
        "texture",
        "sampler state",
        "subpass input",
        "specialisation constant",
        "atomic counter",
        "uniform block",
        "storage block",
        "built-in",
    ]
    name: kinds.Identifier
    stages: Annotated[
        tuple[kinds.StageName, ...],
        Meta(
            description="the stages that read it for the values",
            min_length=1,
            extra_json_schema=kinds.UNIQUE,
        ),
    ]
    members: Annotated[
        tuple[kinds.Identifier, ...], Meta(description="of a block: these alone", min_length=1)
    ] = ()


class MappingEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """Where a fragment finds what the previous frame stored."""

    kind: Annotated[
        Literal["surface", "screen", "user"],
        Meta(
            description="surface: where its point of the surface was then; screen: at its own "
            "pixel; user: where scPreviousClip() says"
        ),
    ]
    exact_while_unchanged: Annotated[
        tuple[kinds.Identifier, ...] | UnsetType,
        Meta(
            description="with screen: the uniforms, textures and attributes that the value depends "
            "on; while none of them changes reuse is exact, and else what is reused is up to a "
            "period old"
        ),
    ] = UNSET


class Manifest(kinds.ManifestPart, frozen=True, kw_only=True):
    """Everything an engine must know to run the variants of one cached value, or of several that
    are cached together. A renderer that knows only this file and the shaders it names can run them.
    """

    schema_version: Literal[3]
    generator: Annotated[kinds.Words, Meta(description="program and version that wrote the files")]
    source: SourcesEntry
    nodes: Annotated[
        tuple[NodeEntry, ...],
        Meta(
            description="the values that are cached, all or none of them in each texel",
            min_length=1,
            # Three scalars fit beside the depth of the first texel, and four into the second.
            max_length=7,
        ),
    ]
    mode: ModeName
    outputs: Annotated[
        tuple[OutputEntry, ...],
        Meta(description="the user's, in the order of their locations", min_length=1),
    ]
    cache: CacheEntry
    targets: Annotated[
        dict[kinds.TargetName, TargetEntry],
        Meta(
            description="every target that a pass names, and its size; those of a pass are all of "
            "one size, and so is its depth buffer: there is one for each size"
        ),
    ]
    uniforms: Annotated[
        tuple[pass_model.AddedUniform, ...],
        Meta(
            description="every uniform that was added, the previous twins apart; none has a "
            "location or binding of its own"
        ),
    ]
    uniform_block: Annotated[
        pass_model.AddedBlock | UnsetType,
        Meta(description="of Vulkan GLSL: what holds the added uniforms that are no textures"),
    ] = UNSET
    renamed: Annotated[
        dict[kinds.Words, kinds.Identifier],
        Meta(
            description="attribute, uniform or output of the user's text -> its name in the "
            "shaders beside this file, where it is another: in shaders of older versions"
        ),
    ]
    previous: Annotated[
        dict[kinds.Identifier, kinds.Identifier],
        Meta(
            description="name -> its twin, which gets what the name's had in the last frame: "
            "uniforms, and of blocks the block and its instance or members (inputs tells them "
            "apart)"
        ),
    ]
    inputs: Annotated[
        tuple[InputEntry, ...],
        Meta(
            description="what the engine gives: everything of the user's that a program beside "
            "this file declares, and the twins; a pass declares those among its uniforms and "
            "attributes"
        ),
    ]
    depends_on: Annotated[
        tuple[DependencyEntry, ...],
        Meta(
            description="what the cached values depend on, through varyings too; a reused value is "
            "that of what these were when it was computed"
        ),
    ]
    mapping: MappingEntry
    draw: Annotated[
        pass_model.ObjectsEntry | pass_model.TriangleEntry, Meta(description="what each pass draws")
    ]
    original: Annotated[pass_model.DrawingPass, Meta(description="the unchanged shader")]
    geometry: Annotated[
        pass_model.DrawingPass | UnsetType,
        Meta(description="the bare geometry: what no cache can save of the original"),
    ] = UNSET
    variants: Annotated[
        tuple[pass_model.VariantEntry, ...],
        Meta(description="the algorithms; the passes of one are drawn in order", min_length=1),
    ]
    refused: Annotated[
        tuple[pass_model.RefusedEntry, ...],
        Meta(description="algorithms that these values cannot be cached with"),
    ]
    payload: Annotated[
        pass_model.DrawingPass | UnsetType,
        Meta(
            description="draws the payload alone in place of the colour: what computing it costs; "
            "no part of any variant, and left out where a variant is handed over"
        ),
    ] = UNSET
    debug: pass_model.DebugEntry
    frame: Annotated[kinds.Sentences, Meta(description="what the engine does each frame, in order")]
    reset: Annotated[
        kinds.Sentences,
        Meta(description="what it does on the first frame and whenever the last one does not fit"),
    ]
    relies_on: Annotated[
        tuple[kinds.Words, ...], Meta(description="engine state that the variants take for granted")
    ]
    state: Annotated[
        tuple[pass_model.StateEntry, ...],
        Meta(
            description="what the engine sets of the pipeline while passes are drawn", min_length=1
        ),
    ]
    depth_functions: Annotated[
        dict[pass_model.DepthFunctionName, pass_model.DepthFunctions] | UnsetType,
        Meta(
            description="an application's depth function -> what 'less' and 'lequal' of a pass are "
            "there, and what depth is cleared to; 'equal' stands for an application that draws "
            "depth first, which the variants do without; not there for a full-screen triangle, "
            "which shares its depth with nothing"
        ),
    ] = UNSET


class OriginalManifest(kinds.ManifestPart, frozen=True, kw_only=True):
    """How the unchanged shader is drawn: what the harness compares variants with."""

    schema_version: Literal[3]
    mode: ModeName
    inputs: tuple[InputEntry, ...]
    outputs: tuple[OutputEntry, ...]
    original: pass_model.PassEntry


class NeededManifest(kinds.ManifestPart, frozen=True, kw_only=True):
    """How it is drawn which pixels have payloads."""

    schema_version: Literal[3]
    mode: ModeName
    inputs: tuple[InputEntry, ...]
    needed: pass_model.NeededEntry


AnyManifest: TypeAlias = Manifest | OriginalManifest | NeededManifest
