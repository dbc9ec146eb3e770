"""What an engine sets the added uniforms to."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import UNSET

from shadercache.caching.algorithms import PARKED
from shadercache.manifest.pass_model import AddedUniform, Role

_WORDS: Mapping[Role, str] = {
    "previous-cache": "`cache`, as the last frame left it",
    "current-cache": "`cache`, as this frame has written it so far",
    "previous-cache-2": "`cache-2`, as the last frame left it",
    "current-cache-2": "`cache-2`, as this frame has written it so far",
    "clock": "the number of the frame modulo the period, reduced on the CPU",
    "period": "{0}, the period in frames",
    "block": "{0}, the edge of squares that are refreshed together, in pixels",
    "epsilon": "{0}, what a cached depth may be off",
    "reset": "1 in the draws of a reset, else 0",
    "mask": "for each draw 0; 1: it reuses nothing; 2: nor is what it stores reused",
    "viewport": "left, bottom, width, height of the viewport in the pass's targets, in pixels",
    "previous-viewport": "the same of the last frame",
    "scale": "x, y: width and height of the cache's viewport over the picture's; "
    "z, w: the corner of the cache's less x, y times the corner of the picture's",
    "unit": "2 near far / (far - near) of your projection",
    "magnification": "{0}, how many times larger a surface may have become",
    "change": "{0}, how much a refresh may change a value before the period shortens",
    "resolution": "{0}, how much of itself a depth is rounded by",
    "limit": "{0}, the largest value that is reused",
    "least": "{0}, the smallest above zero that the format holds",
    "group": "for each draw a number from 1, the same in all its passes; draws by one shader may "
    "share one if what `fix-up` declares is the same for them",
}
_OBJECT = "for each draw the object's number from 1, the same in every frame"
_FIRST = (
    "for each draw the number of its first instance from 1, the same in every frame; instances "
    "have the next ones, so leave room for all"
)


def value_words(uniform: AddedUniform, on_reset: bool = False) -> str:
    """What it is set to, as a clause; ``on_reset``: is it set in the draws of a reset?"""
    if uniform.role.startswith(PARKED):
        return f"`{uniform.role}`"
    if uniform.role == "object":
        return _FIRST if uniform.name.endswith("first_object") else _OBJECT
    number = f"{uniform.default:.7g}" if uniform.default is not None else "your choice"
    words = _WORDS[uniform.role].format(number)
    if on_reset and uniform.on_reset is not UNSET and uniform.role != "reset":
        words += f"; {uniform.on_reset:g} in the draws of a reset"
    return words
