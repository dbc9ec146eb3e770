"""The uniforms that the compiler adds, the twins of the user's apart: a record each."""

from __future__ import annotations

from typing import Any

from msgspec import UNSET, structs

from shadercache.caching.configuration import DEFAULT_MAGNIFICATION, Configuration
from shadercache.caching.layout import MOST_IN_HALF, Layout, precision_of
from shadercache.caching.slots import MOST_GROUPS
from shadercache.manifest.pass_model import AddedUniform

_ROLES = {
    **{"cache": "previous-cache", "cache_2": "previous-cache-2"},
    **{"payloads": "current-cache", "payloads_2": "current-cache-2"},
}
"""Of names that are not their roles."""

_OF_SECOND = ("cache_2", "payloads_2")

# No depth is off by less than nothing: a pass that looks up all the same finds nothing.
_ON_RESET = {"epsilon": -1, "reset": 1}

_OF_FORMAT = "; depends on cache.format"


def _uniform(
    declared: str,
    meaning: str,
    unit: str | None = None,
    values: str | None = None,
    default: float | None = None,
) -> AddedUniform:
    kind, name = declared.split()
    role: Any = _ROLES.get(name, name.replace("_", "-"))
    return AddedUniform(
        name=name,
        type=kind,  # type: ignore[arg-type]
        role=role,
        meaning=meaning,
        unit=unit,
        range=values,
        default=default,
        on_reset=_ON_RESET.get(name, UNSET),
    )


_UNIFORMS = (
    _uniform("sampler2D cache", "what the last frame stored"),
    _uniform("sampler2D payloads", "what this frame has stored so far"),
    _uniform("sampler2D cache_2", "the rest of what the last frame stored"),
    _uniform("sampler2D payloads_2", "the rest of what this frame has stored"),
    _uniform("int clock", "number of the frame modulo the period", "frames", "[0, period)", 0),
    _uniform(
        "int period",
        "frames between two refreshes of a pixel; 1 refreshes everything in every frame. "
        "Variants that run beside each other may have different ones",
        "frames",
        # Schedules multiply the period by 16 bits of a hash, which has to fit into 32 bits.
        "[1, 65536)",
        32,
    ),
    _uniform(
        "int block",
        "edge of the squares of pixels that are refreshed together",
        "pixels",
        # Even, so that whole quads of 2 x 2 pixels take the same path.
        ">= 2, even",
        4,
    ),
    _uniform(
        "float epsilon",
        "accepted difference between the cached and the expected depth",
        "relative to 1/w",
        "> 0; below it nothing is found",
    ),
    _uniform("ivec4 viewport", "left, bottom, width and height of the viewport", "pixels"),
    _uniform("ivec4 previous_viewport", "the same of the last frame", "pixels"),
    _uniform(
        "vec4 scale",
        "leads from pixels to texels of a smaller cache: times .xy, plus .zw. The .xy are the "
        "extent of the cache's viewport over that of the picture's, the .zw the corner of the "
        "cache's less (.xy times the corner of the picture's)",
        "pixels",
    ),
    _uniform(
        "int object",
        "number of the object that is drawn; each draw sets it, to the same in every frame",
        default=0,
    ),
    _uniform(
        "int mask",
        "set by each draw. 1: it reuses nothing in this frame; 2: nor is what it stores reused",
        values="[0, 2]",
        default=0,
    ),
    _uniform(
        "int reset",
        "1 in a frame that follows a reset, else 0: payloads then start with different ages",
        values="0 or 1",
        default=0,
    ),
    _uniform(
        "float unit",
        "what 1/w is in depths from -1 to 1: 2 near far / (far - near) in a perspective",
        "w",
        "> 0",
    ),
    _uniform(
        "float magnification",
        "how many times larger a surface may have become and still be reused",
        values=">= 1",
        default=DEFAULT_MAGNIFICATION,
    ),
    _uniform(
        "float change",
        "how much a refresh may change a payload and leave the period as it is there: the largest "
        "difference of a number in it",
        values="> 0",
    ),
    _uniform("float resolution", f"how much of itself a depth is rounded by{_OF_FORMAT}"),
    _uniform("float limit", f"the largest payload that is reused{_OF_FORMAT}"),
    _uniform("float least", f"the smallest above zero that it surely holds{_OF_FORMAT}"),
    _uniform(
        "int group",
        "number of a draw, the same in all of its passes. No two draws of a frame have the same, "
        "unless all uniforms and textures that passes with draws 'groups' declare are the same for "
        "them, this one apart: then such passes are drawn once for all of these draws",
        values=f"[1, {MOST_GROUPS}]",
        default=1,
    ),
    *(_uniform(f"usampler2D parked_{at}", "what misses have parked") for at in range(1, 7)),
)
"""In the order of manifests. What depends on the configuration is filled in below."""


_FIRST_OBJECT = (
    "number of the first instance that is drawn, the others have the next; each draw sets it, to "
    "the same in every frame, so that no two instances have the same number"
)


def added_uniforms(
    prefix: str, layout: Layout, configuration: Configuration, instanced: bool
) -> list[AddedUniform]:
    """The uniforms that programs of a configuration may have; ``prefix`` begins their names.
    ``instanced``: does the number of an object go to the first of its instances?"""
    held = precision_of(layout.formats(configuration.storage.format)[0])
    exact, oldest = f"[0, {MOST_IN_HALF}]", f"[1, {MOST_IN_HALF // 2}]"
    if layout.bits:
        exact = f"[0, {2**31})"
    elif not layout.tucked:
        # What lies in the lowest bits of a channel leaves little more than half a float above it.
        exact, oldest = f"{exact}, with rgba32f [0, {2**24}]", f"{oldest}, with rgba32f [1, 65536)"
    chosen: dict[str, dict[str, Any]] = {
        "epsilon": {"default": configuration.hit_test.epsilon},
        "change": {"default": configuration.refresh.adaptive or None},
        "object": {"range": exact},
        "resolution": {"default": held.resolution},
        "limit": {"default": held.limit},
        "least": {"default": held.least},
    }
    if configuration.refresh.age and not layout.bits:
        # Ages are means of several texels, and above 1,024 half floats hold no fractions.
        chosen["period"] = {"range": oldest}
    if instanced:
        chosen["object"] |= {"name": f"{prefix}first_object", "meaning": _FIRST_OBJECT}
    uniforms: list[AddedUniform] = []
    for uniform in _UNIFORMS:
        about = {"name": prefix + uniform.name} | chosen.get(uniform.name, {})
        if uniform.type == "sampler2D" and layout.bits:
            about["type"] = "usampler2D"
        if layout.second or uniform.name not in _OF_SECOND:
            uniforms.append(structs.replace(uniform, **about))
    return uniforms
