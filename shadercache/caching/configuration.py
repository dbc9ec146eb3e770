"""One value names one configuration: what is cached, by which algorithm, and how.

Equal values are equal configurations. Written down they are JSON, and :attr:`Configuration.key`
names them in short.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, field, fields, is_dataclass, replace
from hashlib import sha256
from typing import Any, Literal, TypeAlias, get_args, get_origin, get_type_hints

from shadercache.caching.algorithms import DEFAULT, NAMES, USUAL
from shadercache.diagnostics import input_error
from shadercache.transform.hoist_fetches import FetchForm

Mode: TypeAlias = Literal["plain", "proof"]
CacheFormat: TypeAlias = Literal["rgba16f", "rgba32f"]

RefreshSchedule: TypeAlias = Literal["stratified", "random", "tiled", "surface", "none"]
"""Which pixels are recomputed on purpose in a frame, each once in a period: blocks, of which each
group of neighbours has one due in every frame; blocks by a hash; as many tiles as the period has
frames, one after another; triangles by a hash of their number; none (docs/why/refresh.md)."""

FilterKind: TypeAlias = Literal[
    "bilateral", "bilinear", "nearest", "lanczos2", "mitchell", "carried"
]
"""How payloads are resampled between texels; ``carried``: what is stored never is, and each texel
keeps a raw sample and where that truly lies."""

DepthKind: TypeAlias = Literal["inverse-w", "ndc", "linear"]
"""What is kept of the depth, of the clip-space position: 1/w (times 16), z/w or w."""

ToleranceKind: TypeAlias = Literal["relative", "akeley-su", "fixed"]
"""What a cached depth may be off: a share of the depth, what the format's resolution and
interpolation leave uncertain, or the same everywhere."""

GuardKind: TypeAlias = Literal["miss", "clamp", "off"]
"""What becomes of payloads that are not finite or do not fit: they are stored as any other, are
never reused, or are brought into the format's range."""

Combine: TypeAlias = Literal["reuse"]
"""What a hit makes of the cached value and a new sample."""

PayloadRate: TypeAlias = Literal["full", "half", "quarter"]
"""Of how many pixels payloads are computed: of each, or of as many as a picture of half or a
quarter of the size has; the others take them from those (docs/why/rate.md)."""

DIVISORS: dict[PayloadRate, int] = {"full": 1, "half": 2, "quarter": 4}
"""How many pixels a texel of the cache covers in each direction."""

DEFAULT_EPSILON = 1e-3
"""Accepted relative difference of 1/w: twice what half floats round it by (docs/why/reuse.md)."""

DEFAULT_MAGNIFICATION = 1.5
"""How many times larger a surface may become from one frame to the next and be reused, where that
is asked."""


@dataclass(frozen=True, slots=True)
class Refresh:
    """What is recomputed on purpose: by which schedule, how often (``period``, in frames; 1 is all
    of it, always), in squares of which edge (``block``, in pixels, even).

    With ``age`` the payload's age is kept beside it, and what is older than the period is
    recomputed as well. With ``adaptive`` above 0 the period is the longest one: it is halved where
    a refresh changes a payload by more than that, and doubled again where it does not (Scherzer et
    al. 2010, 3.2.4).
    """

    schedule: RefreshSchedule = "stratified"
    period: int = 32
    block: int = 4
    age: bool = False
    adaptive: float = 0.0

    @property
    def judged(self) -> bool:
        """Does what a look-up finds decide whether it is refreshed?"""
        return self.age or self.adaptive > 0.0

    @property
    def renews(self) -> bool:
        """Is everything recomputed in every frame, so that no look-up finds anything?"""
        return self.period == 1 and (self.schedule != "none" or self.age)


@dataclass(frozen=True, slots=True)
class Filter:
    """How payloads are resampled; ``fallback``: is the nearest texel tried where that fails?"""

    kind: FilterKind = "bilateral"
    fallback: bool = False

    @property
    def marks_depths(self) -> bool:
        """Does the sign of a cached depth tell that the payload comes from a part of a filter?"""
        # Such a payload lies up to a pixel beside its place. What is made of it is marked as well,
        # and never again of a part: so no payload slides along an edge from frame to frame.
        alone = self.kind in ("nearest", "carried")
        return self.kind == "bilateral" or (self.fallback and not alone)

    @property
    def carries(self) -> bool:
        """Does a texel keep a raw sample with its place, apart from what is shown?"""
        return self.kind == "carried"


@dataclass(frozen=True, slots=True)
class HitTest:
    """When a texel holds what is looked for: what its depth may be off, and by how much of it.

    With ``ids`` the number of the object is kept as well, and each object reuses only its own; with
    ``mask`` a uniform makes a draw miss, or keeps others from reusing it. ``magnification``: does a
    surface miss that has become much larger? With ``viewport`` what is drawn into may be a part of
    the target, and another in each frame.
    """

    tolerance: ToleranceKind = "relative"
    epsilon: float = DEFAULT_EPSILON
    ids: bool = False
    mask: bool = False
    magnification: bool = False
    viewport: bool = False


@dataclass(frozen=True, slots=True)
class Storage:
    """The format of texels, what they keep of the depth, and the guard against values that are not
    finite or do not fit."""

    format: CacheFormat = "rgba16f"
    depth: DepthKind = "inverse-w"
    guard: GuardKind = "miss"


@dataclass(frozen=True, slots=True)
class Configuration:
    """What is cached (``nodes``, by id), by which algorithm, and a choice in each slot.

    ``mode``: ``plain`` is what is shipped, ``proof`` forbids the driver to rearrange arithmetic.
    ``fetches``: what is done ahead of a branch of the payload's texture fetches; ``level`` needs
    GLSL 4.00 and isotropic filtering.
    """

    nodes: tuple[str, ...] = ()
    algorithm: str = DEFAULT
    refresh: Refresh = field(default_factory=Refresh)
    filter: Filter = field(default_factory=Filter)
    hit_test: HitTest = field(default_factory=HitTest)
    storage: Storage = field(default_factory=Storage)
    combine: Combine = "reuse"
    payload_rate: PayloadRate = "full"
    fetches: FetchForm = "whole"
    mode: Mode = "plain"

    @property
    def key(self) -> str:
        """A short name for the value: that of its canonical text."""
        return sha256(self.canonical.encode()).hexdigest()[:12]

    @property
    def program_key(self) -> str:
        """The same of what changes emitted text: configurations that share it share programs."""
        return self.compiled.key

    @property
    def compiled(self) -> Configuration:
        """The configuration with what is a uniform or a texture's format at its default."""
        plain = self.with_refresh(Refresh().period, Refresh().block)
        adaptive = 1.0 if self.refresh.adaptive else 0.0
        # Only carried samples are packed by the format (caching/layout.py).
        kept = self.storage.format if self.filter.carries else Storage().format
        return replace(
            plain,
            refresh=replace(plain.refresh, adaptive=adaptive),
            hit_test=replace(self.hit_test, epsilon=DEFAULT_EPSILON),
            storage=replace(self.storage, format=kept),
        )

    @property
    def look_up(self) -> Configuration:
        """The configuration with all at its default that no text of the runtime depends on."""
        return replace(self.compiled, nodes=(), algorithm=DEFAULT, fetches="whole", mode="plain")

    @property
    def divisor(self) -> int:
        """How many pixels a texel of the cache covers in each direction."""
        return DIVISORS[self.payload_rate]

    @property
    def canonical(self) -> str:
        """Its JSON in one way of writing it."""
        return json.dumps(self.to_json(), sort_keys=True, separators=(",", ":"))

    def to_json(self) -> dict[str, Any]:
        """Plain data that :meth:`from_json` reads."""
        return asdict(self) | {"nodes": list(self.nodes)}

    @classmethod
    def from_json(cls, data: Any) -> Configuration:
        """The configuration that was written down.

        Raises:
            InputError: SC029, a field or value that is not known, at its path.
        """
        configuration: Configuration = _read(cls, data, "configuration")
        if configuration.algorithm not in NAMES:
            raise _unknown("configuration.algorithm", configuration.algorithm)
        return configuration

    def with_refresh(self, period: int | None = None, block: int | None = None) -> Configuration:
        """The same with another period or block."""
        now = self.refresh
        period, block = period or now.period, block or now.block
        return replace(self, refresh=replace(now, period=period, block=block))


@dataclass(frozen=True, slots=True)
class Assignment:
    """What is drawn: the name of each object, in the scene's order, and its configuration.

    None: its original draws it.
    """

    objects: tuple[tuple[str, Configuration | None], ...]

    def with_originals(self, names: Collection[str]) -> Assignment:
        """The same, but some objects are drawn by their originals."""
        return Assignment(
            tuple((name, None if name in names else chosen) for name, chosen in self.objects)
        )

    def to_json(self) -> list[dict[str, Any]]:
        """Plain data: each configuration with the objects that have it, null for originals."""
        groups: dict[Configuration | None, list[str]] = {}
        for name, chosen in self.objects:
            groups.setdefault(chosen, []).append(name)
        return [
            {"objects": names, "configuration": None if chosen is None else chosen.to_json()}
            for chosen, names in groups.items()
        ]


def by_every_algorithm(configuration: Configuration) -> tuple[Configuration, ...]:
    """The same by each of the usual algorithms, and by its own."""
    names = dict.fromkeys((*USUAL, configuration.algorithm))
    return tuple(replace(configuration, algorithm=name) for name in names)


def _read(kind: Any, data: Any, path: str) -> Any:
    """A value of a type from plain data."""
    if isinstance(kind, type) and is_dataclass(kind):
        if not isinstance(data, Mapping):
            raise _unknown(path, data)
        hints = get_type_hints(kind)
        for name in data:
            if name not in hints:
                raise _unknown(f"{path}.{name}", data[name])
        known = [one.name for one in fields(kind) if one.name in data]
        return kind(**{name: _read(hints[name], data[name], f"{path}.{name}") for name in known})
    if get_origin(kind) is tuple and isinstance(data, list | tuple):
        return tuple(_read(str, one, f"{path}[{at}]") for at, one in enumerate(data))
    if get_origin(kind) is Literal and data in get_args(kind):
        return data
    # JSON may write 1 for 1.0. By the very type, since `True` is an `int` to `isinstance`.
    if kind is float and type(data) in (int, float):
        return float(data)
    if isinstance(kind, type) and type(data) is kind:
        return data
    raise _unknown(path, data)


def _unknown(path: str, value: Any) -> Exception:
    return input_error("SC029", f"{path} cannot be {value!r}")
