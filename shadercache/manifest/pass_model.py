"""What a manifest says of passes: their files, targets and state, and what was added for them."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import UNSET, Meta, UnsetType

from shadercache.caching.algorithms import NAMES, DepthTest, Drawn
from shadercache.manifest import kinds

Role: TypeAlias = Literal[
    "previous-cache",
    "current-cache",
    "previous-cache-2",
    "current-cache-2",
    "clock",
    "period",
    "block",
    "epsilon",
    "object",
    "viewport",
    "previous-viewport",
    "scale",
    "reset",
    "mask",
    "unit",
    "magnification",
    "change",
    "resolution",
    "limit",
    "least",
    "group",
    kinds.ParkedName,
]

Outcomes: TypeAlias = Annotated[
    dict[
        Literal[
            "hit", "refresh", "outside", "depth", "id", "poison", "magnified", "opted-out", "old"
        ],
        # Masks are read back as bytes.
        Annotated[int, Meta(ge=1, le=255)],
    ],
    Meta(
        description="what is written for each outcome; 0 means that nothing was drawn",
        extra_json_schema={"required": ["hit", "refresh", "outside", "depth"]},
    ),
]


class AddedUniform(kinds.ManifestPart, frozen=True, kw_only=True):
    """A uniform that was added; but in Vulkan GLSL it has no location or binding of its own."""

    name: kinds.Identifier
    type: Literal["ivec4", "vec4", "sampler2D", "usampler2D", "int", "float"]
    role: Role
    meaning: kinds.Words
    unit: str | None
    range: str | None
    default: int | float | None
    on_reset: Annotated[
        int | float | UnsetType, Meta(description="its value in the draws of a reset")
    ] = UNSET
    binding: Annotated[
        kinds.Unsigned | UnsetType,
        Meta(description="of a texture in Vulkan GLSL: its binding in the set of the block"),
    ] = UNSET
    offset: Annotated[
        kinds.Unsigned | UnsetType,
        Meta(description="in Vulkan GLSL, of what is no texture: in bytes, in the block"),
    ] = UNSET


class AddedBlock(kinds.ManifestPart, frozen=True, kw_only=True):
    """The uniform block of what was added, in Vulkan GLSL. It is the same in all passes, with the
    members at fixed offsets (std140); what 'uniforms' does not list is not read."""

    name: kinds.Identifier
    set: kinds.Unsigned
    binding: kinds.Unsigned
    size: Annotated[kinds.Size, Meta(description="in bytes")]


class ObjectsEntry(
    kinds.ManifestPart, frozen=True, kw_only=True, tag_field="geometry", tag="objects"
):
    """The engine's own objects."""


class TriangleEntry(
    kinds.ManifestPart, frozen=True, kw_only=True, tag_field="geometry", tag="full-screen triangle"
):
    """One triangle over the whole target, of three vertices without attributes or index."""

    mode: Literal["triangles"]
    vertices: Literal[3]


class DepthEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """What a pass does with the depth buffer."""

    test: Annotated[
        DepthTest,
        Meta(description="depth function; depth is cleared to 1 once per frame, not per pass"),
    ]
    write: bool
    buffer: Annotated[
        Literal["shared", "marks"],
        Meta(
            description="shared: the one that all objects are drawn into; marks: another one, as "
            "large as the target, that is never cleared and lives for a frame, with 'test' as it "
            "is whatever depth_functions says, and no polygon offset"
        ),
    ] = "shared"


class PassEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """One draw of all objects, or of the screen.

    What it declares is told by name; each name has one entry in 'inputs' or 'uniforms'.
    """

    name: Annotated[
        kinds.Words, Meta(description="what the pass is called in messages and results")
    ]
    vertex: Annotated[
        kinds.FileName, Meta(description="file of the vertex shader, beside the manifest")
    ]
    fragment: Annotated[
        kinds.FileName, Meta(description="file of the fragment shader, beside the manifest")
    ]
    targets: Annotated[
        tuple[kinds.TargetName, ...],
        Meta(
            description="entry i is bound at colour attachment i: the colour target, the cache "
            "that is written in this frame (cache-2: its second texture), what is parked for a "
            "later pass (never cleared), or the debug mask (one float channel)",
            extra_json_schema=kinds.UNIQUE,
        ),
    ]
    depth: DepthEntry
    reads: Annotated[
        tuple[kinds.ReadName, ...],
        Meta(
            description="what the pass samples: the cache of the last frame, the one written in "
            "this frame, or what an earlier pass has parked",
            extra_json_schema=kinds.UNIQUE,
        ),
    ]
    uniforms: Annotated[
        tuple[kinds.Identifier, ...],
        Meta(
            description="every uniform that the program declares, the user's and the added ones, "
            "and every block",
            extra_json_schema=kinds.UNIQUE,
        ),
    ]
    attributes: Annotated[
        tuple[kinds.Identifier, ...],
        Meta(
            description="every vertex attribute that the program declares",
            extra_json_schema=kinds.UNIQUE,
        ),
    ]
    on_reset: Annotated[bool, Meta(description="whether the pass is drawn on a reset frame")]
    draws: Annotated[
        Drawn,
        Meta(
            description="screen: one triangle over the whole target, of three vertices without "
            "attributes or index, once for all objects of this manifest (without targets: of all "
            "manifests that share the cache); groups: the same once for each group of objects (the "
            "uniform of that role)"
        ),
    ] = "objects"


class DebugEntry(PassEntry, frozen=True, kw_only=True):
    """Draws the outcome of the hit test; instead of a variant, with the same previous cache and
    clock."""

    targets: tuple[Literal["mask"]]
    values: Outcomes
    format: Annotated[Literal["r32f"], Meta(description="of the mask")]
    clear: Annotated[Literal[0], Meta(description="what the mask is cleared to: nothing was drawn")]
    depth_buffer: Annotated[
        Literal["own"],
        Meta(
            description="own: another one than the passes', or the same if it is cleared before "
            "and after; it is cleared like theirs"
        ),
    ]
    when: kinds.Words


class NeededEntry(PassEntry, frozen=True, kw_only=True):
    """Draws which pixels have payloads; no part of a manifest that is written.

    ``by_some``: are there pixels that may do without?
    """

    by_some: bool


_MARKING = {"required": ["buffer"], "properties": {"buffer": {"const": "marks"}}}
_IDLE = {"targets": {"maxItems": 0}, "depth": {"not": _MARKING}}

DrawingPass: TypeAlias = Annotated[
    PassEntry, Meta(extra_json_schema={"not": {"properties": _IDLE}})
]
"""One that draws into something."""


class VariantEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """An algorithm; its passes are drawn in order."""

    algorithm: Annotated[kinds.Words, Meta(examples=list(NAMES))]
    passes: Annotated[
        tuple[DrawingPass, ...],
        Meta(
            min_length=1,
            extra_json_schema={
                "contains": {"required": ["on_reset"], "properties": {"on_reset": {"const": True}}},
            },
        ),
    ]


class RefusedEntry(kinds.ManifestPart, frozen=True, kw_only=True):
    """An algorithm that the values cannot be cached with."""

    algorithm: kinds.Words
    reason: kinds.Words


class StateEntry(kinds.ManifestPart, frozen=True):
    """Something an engine sets of the pipeline, and what it must be."""

    state: kinds.Words
    must: Annotated[
        Literal["off", "on", "equal", "fill"],
        Meta(
            description="equal: the same in every pass of a frame, in the debug program, and where "
            "the shader is drawn without a cache"
        ),
    ]
    why: kinds.Words


DepthFunctionName: TypeAlias = Literal["less", "lequal", "greater", "gequal", "equal"]


class DepthFunctions(kinds.ManifestPart, frozen=True, kw_only=True):
    """What the depth functions of passes are in an application with another one."""

    less: Literal["less", "greater"]
    lequal: Literal["lequal", "gequal"]
    clear: Literal[0, 1]
