"""What the passes of each algorithm do, in a clause."""

from __future__ import annotations

from shadercache.manifest.pass_model import PassEntry

_WORDS = {
    ("1-pass", "shade"): "hits are shaded from the cache, the others compute the value",
    (
        "2-pass",
        "hit",
    ): "hits are shaded from the cache, misses discarded: their depth stays open",
    ("2-pass", "miss"): "the whole shader, where depth is still open",
    ("3-pass", "reuse"): "hits copy the cached value, misses are discarded: depth stays open",
    ("3-pass", "payload"): "the value alone, where depth is still open",
    ("3-pass", "shade"): "the colour, from the values of this frame",
    ("3-pass", "rest"): "the whole shader, for pixels that no texel of the smaller cache fits",
    ("parked", "find"): "hits are shaded from the cache, misses park what the rest needs",
    (
        "parked",
        "mark",
    ): "a depth for each pixel that misses; the next pass skips the others",
    ("parked", "fix-up"): "the whole shader for misses, from what they have parked",
}


def words_of(algorithm: str, entry: PassEntry) -> str:
    """What a pass does; of one that is not known its name."""
    return _WORDS.get((algorithm, entry.name), entry.name)
