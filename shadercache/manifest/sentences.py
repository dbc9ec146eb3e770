"""What an engine does each frame, and on a reset, in sentences."""

from __future__ import annotations

FRAME = (
    "Swap the two caches: what was written in the last frame is the previous cache now.",
    "Clear the depth buffer to 1, the colour target to the background, and the cache that is "
    "written in this frame to cache.clear.",
    "Set the uniforms. A name among the values of 'previous' gets what its key had in the last "
    "frame (of a jittered projection: with the jitter of this frame, which is no motion); the "
    "clock is the frame number modulo the period, reduced on the CPU.",
    "Draw the passes of the variant in order. All objects finish a pass before the next begins; "
    "those that are not cached come first, with no cache attached, so that nothing they hide is "
    "stored. Bind targets[i] at colour attachment i; do not blend.",
)

FRAME_OF_TWO = (
    "What is said of a cache holds for its second texture (cache.second) as well; both are cleared "
    "to values of their own."
)

RESET = (
    "On the first frame, and whenever the last frame does not show the same scene (camera cut, "
    "resize, new projection, reloaded shader, lost context): clear both caches to cache.clear. "
    "After a resize or a lost context make them anew first, as large as the target.",
    "Draw only the passes with on_reset true: what was stored is not looked up, and the image is "
    "the original's.",
    "One and three passes may then be drawn as the one of two passes with on_reset true: image and "
    "cache are the same, no branch is in the way, and the geometry is drawn once.",
    "An object that the last frame did not show, or that jumps, is drawn so by itself; the caches "
    "stay as they are.",
    "A cut that is not told is drawn rightly up to what passes the hit test by chance, and costs "
    "look-ups that find nothing.",
)


def frame_sentences(two_textures: bool) -> list[str]:
    """What it does each frame, in order; ``two_textures``: is a payload too wide for one?"""
    return [*FRAME, *[FRAME_OF_TWO] * two_textures]


def reset_sentences() -> list[str]:
    """What it does on the first frame and whenever the last one does not fit."""
    return list(RESET)
