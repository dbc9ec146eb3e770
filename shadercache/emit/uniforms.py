"""The uniforms that the compiler adds, the twins of the user's apart, as the manifest has them."""

from __future__ import annotations

from typing import Any

from shadercache.caching.configuration import DEFAULT_MAGNIFICATION, Configuration
from shadercache.caching.layout import MOST_IN_HALF, Layout, precision_of


def added_uniforms(
    prefix: str, layout: Layout, configuration: Configuration
) -> list[dict[str, Any]]:
    """One entry for each: name, type, role, meaning, unit, range, default, its value on a reset.

    ``prefix`` begins the names.
    """

    def entry(
        name: str, kind: str, role: str, meaning: str, unit: str | None = None, **more: Any
    ) -> dict[str, Any]:
        base: dict[str, Any] = {
            "name": prefix + name,
            "type": kind,
            "role": role,
            "meaning": meaning,
        }
        base |= {"unit": unit, "range": more.get("range"), "default": more.get("default")}
        return base | ({"on_reset": more["on_reset"]} if "on_reset" in more else {})

    sampler = "usampler2D" if layout.bits else "sampler2D"
    most = f"[0, {2**31})" if layout.bits else f"[0, {MOST_IN_HALF}], with rgba32f [0, {2**24}]"
    held = precision_of(layout.formats(configuration.storage.format)[0])
    second = [
        entry("cache_2", sampler, "previous-cache-2", "the rest of what the last frame stored"),
        entry("payloads_2", sampler, "current-cache-2", "the rest of what this frame has stored"),
    ]
    return [
        entry("cache", sampler, "previous-cache", "what the last frame stored"),
        entry("payloads", sampler, "current-cache", "what this frame has stored so far"),
        *(second if layout.second else ()),
        entry(
            "clock",
            "int",
            "clock",
            "number of the frame modulo the period",
            "frames",
            range="[0, period)",
            default=0,
        ),
        entry(
            "period",
            "int",
            "period",
            "frames between two refreshes of a pixel; 1 refreshes everything in every frame. "
            "Variants that run beside each other may have different ones",
            "frames",
            range=_periods(layout, configuration),
            default=32,
        ),
        entry(
            "block",
            "int",
            "block",
            "edge of the squares of pixels that are refreshed together",
            "pixels",
            range=">= 2, even",
            default=4,
        ),
        entry(
            "epsilon",
            "float",
            "epsilon",
            "accepted difference between the cached and the expected depth",
            "relative to 1/w",
            range="> 0; below it nothing is found",
            default=configuration.hit_test.epsilon,
            on_reset=-1,
        ),
        entry(
            "viewport",
            "ivec4",
            "viewport",
            "left, bottom, width and height of the viewport",
            "pixels",
        ),
        entry(
            "previous_viewport",
            "ivec4",
            "previous-viewport",
            "the same of the last frame",
            "pixels",
        ),
        entry(
            "object",
            "int",
            "object",
            "number of the object that is drawn; each draw sets it, to the same in every frame",
            range=most,
            default=0,
        ),
        entry(
            "mask",
            "int",
            "mask",
            "set by each draw. 1: it reuses nothing in this frame; 2: nor is what it stores reused",
            range="[0, 2]",
            default=0,
        ),
        entry(
            "reset",
            "int",
            "reset",
            "1 in a frame that follows a reset, else 0: payloads then start with different ages",
            range="0 or 1",
            default=0,
            on_reset=1,
        ),
        entry(
            "unit",
            "float",
            "unit",
            "what 1/w is in depths from -1 to 1: 2 near far / (far - near) in a perspective",
            "w",
            range="> 0",
        ),
        entry(
            "magnification",
            "float",
            "magnification",
            "how many times larger a surface may have become and still be reused",
            range=">= 1",
            default=DEFAULT_MAGNIFICATION,
        ),
        *(
            entry(role, "float", role, f"{meaning}; depends on cache.format", default=value)
            for role, meaning, value in (
                ("resolution", "how much of itself a depth is rounded by", held.resolution),
                ("limit", "the largest payload that is reused", held.limit),
                ("least", "the smallest above zero that it surely holds", held.least),
            )
        ),
    ]


def _periods(layout: Layout, configuration: Configuration) -> str:
    """The range of the period; half floats count no further than this without rounding."""
    rough = configuration.refresh.age and not layout.bits
    return f"[1, {MOST_IN_HALF // 2}], with rgba32f [1, 65536)" if rough else "[1, 65536)"
