"""What can be chosen about a rewrite."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Literal, TypeAlias, get_args, get_type_hints

from shadercache.diagnostics import usage_error

Mode: TypeAlias = Literal["plain", "proof"]
CacheFormat: TypeAlias = Literal["rgba16f", "rgba32f"]

FetchForm: TypeAlias = Literal["whole", "level"]
"""What one pass does ahead of its branch of a payload's texture fetch with implicit level of
detail: all of it, or its level of detail."""

MappingKind: TypeAlias = Literal["surface", "screen", "user"]
"""Where a fragment finds what the previous frame stored: where its point of the surface was then,
at its own pixel, or where a function of the user's says (docs/TRANSFORMATIONS.md)."""

PREVIOUS_CLIP, CURRENT_CLIP = "scPreviousClip", "scCurrentClip"
"""The user's functions that ``user`` calls; without the second the pixel's own place is taken."""

RefreshSchedule: TypeAlias = Literal["stratified", "random", "tiled", "surface", "none"]
"""Which pixels are recomputed on purpose in a frame, each once in a period: blocks, of which each
group of neighbours has one due in every frame; blocks by a hash; as many tiles as the period has
frames, one after another; triangles by a hash of their number; none (docs/NUMERICS.md)."""

FilterKind: TypeAlias = Literal["bilateral", "bilinear", "nearest", "lanczos2", "mitchell"]
"""How payloads are resampled between texels."""

DepthKind: TypeAlias = Literal["inverse-w", "ndc", "linear"]
"""What is kept of the depth, of the clip-space position: 1/w (times 16), z/w or w."""

ToleranceKind: TypeAlias = Literal["relative", "akeley-su", "fixed"]
"""What a cached depth may be off: a share of the depth, what the format's resolution and
interpolation leave uncertain, or the same everywhere."""

GuardKind: TypeAlias = Literal["miss", "clamp", "off"]
"""What becomes of payloads that are not finite or do not fit: they are stored as any other, are
never reused, or are brought into the format's range."""

ALGORITHMS = (1, 2, 3)

DEFAULT_EPSILON = 1e-3
"""Accepted relative difference of 1/w: twice what half floats round it by (docs/NUMERICS.md)."""


DEFAULT_MAGNIFICATION = 1.5
"""How many times larger a surface may become from one frame to the next and be reused, where that
is asked."""


@dataclass(frozen=True, slots=True)
class CacheOptions:
    """How a variant looks up, stores and refreshes payloads: one field for each slot (DESIGN §3).

    Each becomes a macro of the ``.glsl`` files (``emit/runtime.py``), so what is not chosen leaves
    no text.

    Refresh: ``refresh`` says which pixels are recomputed on purpose; with ``age`` the payload's age
    is kept beside it, and what is older than the period is recomputed as well.

    Hit test: ``depth`` is what is kept of it, ``tolerance`` what it may be off; with ``ids`` the
    number of the object is kept as well, and each object reuses only its own; with ``mask`` a
    uniform makes a draw miss, or keeps others from reusing it.

    Resampling: ``filter``; ``fallback``: is the nearest texel tried where a filter fails?
    ``magnification``: does a surface miss that has become much larger?

    With ``viewport`` what is drawn into may be a part of the target, and another in each frame.

    Storage: ``guard`` against values that are not finite or do not fit.
    """

    refresh: RefreshSchedule = "stratified"
    age: bool = False
    filter: FilterKind = "bilateral"
    fallback: bool = False
    magnification: bool = False
    depth: DepthKind = "inverse-w"
    tolerance: ToleranceKind = "relative"
    ids: bool = False
    mask: bool = False
    guard: GuardKind = "miss"
    viewport: bool = False


DEFAULT_CACHE = CacheOptions()


@dataclass(frozen=True, slots=True)
class Options:
    """Options of a rewrite.

    ``mode``: ``plain`` is what is shipped, ``proof`` forbids the driver to rearrange arithmetic.
    ``cache_format``: the texture format of the cache. ``epsilon``: the hit test's accepted
    difference of depths, relative to the depth. ``fetches``: what one pass does ahead of its branch
    of a payload's texture fetches; ``level`` needs GLSL 4.00 and isotropic filtering. ``cache``:
    how payloads are looked up, stored and refreshed.
    """

    mode: Mode = "plain"
    cache_format: CacheFormat = "rgba16f"
    epsilon: float = DEFAULT_EPSILON
    fetches: FetchForm = "whole"
    cache: CacheOptions = DEFAULT_CACHE


def marks_depths(options: CacheOptions) -> bool:
    """Does the sign of a cached depth tell that the payload comes from a part of a filter?

    Such a payload lies up to a pixel beside its place. What is made of it is marked as well, and
    never again of a part of a filter: so no payload slides along an edge from frame to frame.
    """
    return options.filter == "bilateral" or (options.fallback and options.filter != "nearest")


def cache_choices() -> dict[str, tuple[str, ...]]:
    """What can be chosen of each of :class:`CacheOptions`, the default first."""
    hints = get_type_hints(CacheOptions)
    found: dict[str, tuple[str, ...]] = {}
    for field in fields(CacheOptions):
        words = get_args(hints[field.name]) or ("off", "on")
        chosen = _word(getattr(DEFAULT_CACHE, field.name))
        found[field.name] = (chosen, *(word for word in words if word != chosen))
    return found


def read_cache_options(settings: Sequence[str]) -> CacheOptions:
    """Options from ``key=value`` texts, several in one apart by commas; ``ids`` is ``ids=on``.

    Raises:
        UsageError: SC028, a key or a value that is not known.
    """
    known = cache_choices()
    chosen: dict[str, Any] = {}
    for setting in (part.strip() for text in settings for part in text.split(",")):
        key, equals, word = setting.partition("=")
        key, word = key.strip().replace("-", "_"), word.strip() if equals else "on"
        if key not in known:
            hint = f"one of {', '.join(known)}"
            raise usage_error("SC028", f"the cache has no option {key!r}", hint)
        if word not in known[key]:
            hint = f"one of {', '.join(known[key])}"
            raise usage_error("SC028", f"the cache's {key} cannot be {word!r}", hint)
        chosen[key] = word == "on" if "on" in known[key] else word
    return replace(DEFAULT_CACHE, **chosen)


def written_cache_options(options: CacheOptions) -> dict[str, str]:
    """The options as they are written in a manifest: what :func:`read_cache_options` reads."""
    return {field.name: _word(getattr(options, field.name)) for field in fields(options)}


def _word(value: str | bool) -> str:
    return value if isinstance(value, str) else ("on" if value else "off")
