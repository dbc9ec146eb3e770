"""The manifest as a typed model: what is decoded, what is encoded, what the JSON Schema says.

Docstrings and descriptions are those of the published schema. Rules between fields, which types
cannot say, stand in :mod:`manifest.rules`.
"""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import UNSET, Meta, UnsetType

from shadercache.manifest.cache_model import CacheEntry, NodeEntry, TargetEntry
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.kinds import (
    UNIQUE,
    Identifier,
    ManifestPart,
    Sentences,
    StageName,
    TargetName,
    Words,
)
from shadercache.manifest.pass_model import (
    AddedUniform,
    DebugEntry,
    DepthFunctionName,
    DepthFunctions,
    NeededEntry,
    ObjectsEntry,
    PassEntry,
    RefusedEntry,
    StateEntry,
    TriangleEntry,
    VariantEntry,
)

SCHEMA_VERSION: Literal[2] = 2

ModeName: TypeAlias = Annotated[
    Literal["plain", "proof"],
    Meta(description="plain is what is shipped; proof forbids the driver to rearrange arithmetic"),
]


class SourceEntry(ManifestPart, frozen=True, kw_only=True):
    """A shader that was rewritten."""

    name: Words
    sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]


class SourcesEntry(ManifestPart, frozen=True, kw_only=True):
    """The shaders that were rewritten."""

    fragment: SourceEntry
    vertex: SourceEntry


class ColorEntry(ManifestPart, frozen=True, kw_only=True):
    """The one colour output."""

    output: Identifier
    location: Literal[0]


class DependencyEntry(ManifestPart, frozen=True, kw_only=True):
    """Something that the cached values depend on."""

    kind: Literal[
        "attribute",
        "uniform",
        "sampler",
        "image",
        "atomic counter",
        "uniform block",
        "storage block",
        "built-in",
    ]
    name: Identifier
    stages: Annotated[
        tuple[StageName, ...],
        Meta(
            description="the stages that read it for the values",
            min_length=1,
            extra_json_schema=UNIQUE,
        ),
    ]
    members: Annotated[
        tuple[Identifier, ...], Meta(description="of a block: these alone", min_length=1)
    ] = ()


class MappingEntry(ManifestPart, frozen=True, kw_only=True):
    """Where a fragment finds what the previous frame stored."""

    kind: Annotated[
        Literal["surface", "screen", "user"],
        Meta(
            description="surface: where its point of the surface was then; screen: at its own "
            "pixel; user: where scPreviousClip() says"
        ),
    ]
    exact_while_unchanged: Annotated[
        tuple[Identifier, ...] | UnsetType,
        Meta(
            description="with screen: the uniforms, textures and attributes that the value depends "
            "on; while none of them changes reuse is exact, and else what is reused is up to a "
            "period old"
        ),
    ] = UNSET


class Manifest(ManifestPart, frozen=True, kw_only=True):
    """Everything an engine must know to run the variants of one cached value, or of several that
    are cached together. A renderer that knows only this file and the shaders it names can run them.
    """

    schema_version: Literal[2]
    generator: Annotated[Words, Meta(description="program and version that wrote the files")]
    source: SourcesEntry
    nodes: Annotated[
        tuple[NodeEntry, ...],
        Meta(
            description="the values that are cached, all or none of them in each texel",
            min_length=1,
            max_length=7,
        ),
    ]
    mode: ModeName
    color: ColorEntry
    cache: CacheEntry
    targets: Annotated[
        dict[TargetName, TargetEntry],
        Meta(description="every target that a pass names; all are as large as the colour target"),
    ]
    uniforms: Annotated[
        tuple[AddedUniform, ...],
        Meta(
            description="every uniform that was added, the previous twins apart; none has a "
            "location or binding of its own"
        ),
    ]
    renamed: Annotated[
        dict[Words, Identifier],
        Meta(
            description="attribute, uniform or output of the user's text -> its name in the "
            "shaders beside this file, where it is another: in shaders of older versions"
        ),
    ]
    previous: Annotated[
        dict[Identifier, Identifier],
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
        ObjectsEntry | TriangleEntry,
        Meta(description="what each pass draws"),
    ]
    original: Annotated[PassEntry, Meta(description="the unchanged shader")]
    geometry: Annotated[
        PassEntry | UnsetType,
        Meta(description="the bare geometry: what no cache can save of the original"),
    ] = UNSET
    variants: Annotated[
        tuple[VariantEntry, ...],
        Meta(description="the algorithms; the passes of one are drawn in order", min_length=1),
    ]
    refused: Annotated[
        tuple[RefusedEntry, ...],
        Meta(description="algorithms that these values cannot be cached with"),
    ]
    payload: Annotated[
        PassEntry,
        Meta(
            description="draws the payload alone in place of the colour: what computing it costs; "
            "no part of any variant"
        ),
    ]
    debug: DebugEntry
    frame: Annotated[Sentences, Meta(description="what the engine does each frame, in order")]
    reset: Annotated[
        Sentences,
        Meta(description="what it does on the first frame and whenever the last one does not fit"),
    ]
    relies_on: Annotated[
        tuple[Words, ...], Meta(description="engine state that the variants take for granted")
    ]
    state: Annotated[
        tuple[StateEntry, ...],
        Meta(
            description="what the engine sets of the pipeline while passes are drawn", min_length=1
        ),
    ]
    depth_functions: Annotated[
        dict[DepthFunctionName, DepthFunctions] | UnsetType,
        Meta(
            description="an application's depth function -> what 'less' and 'lequal' of a pass are "
            "there, and what depth is cleared to; 'equal' stands for an application that draws "
            "depth first, which the variants do without; not there for a full-screen triangle, "
            "which shares its depth with nothing"
        ),
    ] = UNSET


class OriginalManifest(ManifestPart, frozen=True, kw_only=True):
    """How the unchanged shader is drawn: what the harness compares variants with."""

    schema_version: Literal[2]
    mode: ModeName
    inputs: tuple[InputEntry, ...]
    original: PassEntry


class NeededManifest(ManifestPart, frozen=True, kw_only=True):
    """How it is drawn which pixels have payloads."""

    schema_version: Literal[2]
    mode: ModeName
    inputs: tuple[InputEntry, ...]
    needed: NeededEntry


AnyManifest: TypeAlias = Manifest | OriginalManifest | NeededManifest
