"""What the result store keeps of a trial: one configuration, or a peer, against the original.

A row is written once and never changed; as JSON it is what exports hold.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeAlias

import msgspec

from shadercache.measure.metrics.perceived import Perceived

SubjectKind: TypeAlias = Literal["variant", "peer"]

FailureKind: TypeAlias = Literal["refused", "rejected", "hung", "crashed"]
"""The compiler refuses it, the driver does not take it, it took too long, or the driver died."""


class Machine(msgspec.Struct, frozen=True):
    """Where a trial ran. Times of two machines are never compared."""

    renderer: str
    driver: str
    clock: str
    processor: str
    cores: int
    system: str

    @property
    def name(self) -> str:
        """In short, for tables and headings."""
        return f"{self.renderer.partition('(')[0].strip()}, {self.cores} cores"


class SceneEntry(msgspec.Struct, frozen=True):
    """What was drawn: the scene by name and path, picture size in pixels, fixed frames.

    ``options``: how its shaders are read, as the command line says it.
    """

    name: str
    path: str
    size: tuple[int, int]
    frames: int
    mapping: str
    options: tuple[str, ...] = ()


class PayloadEntry(msgspec.Struct, frozen=True):
    """What was cached. ``places`` are [line, column, end line, end column] in the source, counted
    from 1, the end exclusive; ``static_ratio`` is P/T by static cost; ``equal`` as in bench."""

    label: str
    ids: tuple[str, ...]
    path: str
    text: str
    type: str
    places: tuple[tuple[int, int, int, int], ...]
    static_ratio: float
    equal: int = 1


class Failure(msgspec.Struct, frozen=True, tag="failure"):
    """Why there is no result: a diagnostic's code and message."""

    kind: FailureKind
    code: str
    message: str


class RatioEntry(msgspec.Struct, frozen=True):
    """Original time over the subject's: median of the pairs, 95 % interval, ratio of the sums."""

    median: float
    low: float
    high: float
    total: float


class Samples(msgspec.Struct, frozen=True):
    """Seconds of every timed frame, those of the reset frame left out."""

    subject: tuple[float, ...]
    original: tuple[float, ...]
    geometry: tuple[float, ...]


class PartEntry(msgspec.Struct, frozen=True):
    """A part of a frame, as ``measure.frame_profile`` has it: its time over the original's."""

    name: str
    share: RatioEntry


class Times(msgspec.Struct, frozen=True):
    """What follows from the clock: it differs from run to run.

    ``tail`` is p99 over median of the subject, ``capped`` says that the time ended before the ratio
    was known as well as was asked, ``p_over_t`` P/T as timed, ``reset`` the frame
    behind a reset over the original's, ``floor`` in seconds, ``efficiency`` floor over time.
    ``profile``: where its frames go, if that was asked for; last what no part explains.
    """

    ratio: RatioEntry
    tail: float
    capped: bool
    reset: float | None
    p_over_t: float | None
    floor: float | None
    efficiency: float | None
    samples: Samples
    profile: tuple[PartEntry, ...] = ()


class ImageErrors(msgspec.Struct, frozen=True):
    """How far the images are from the original's: equal in every run on one machine.

    All as ``measure.image_error`` says; ``psnr`` is None for equal images. ``perceived`` where that
    was asked for.
    """

    rmse: float
    p99: float
    maximum: float
    psnr: float | None
    frame_rmse: tuple[float, ...]
    perceived: Perceived | None = None


class ReuseShares(msgspec.Struct, frozen=True):
    """What became of the covered visible pixels: shares by outcome, fragments by pass.

    ``values``: outcome -> its number in the picture ``outcomes``. ``bytes_per_pixel``: what its
    textures take; rows of version 0.1.0 do not know it.
    """

    hit_rate: float
    burst: float
    outcomes: dict[str, float]
    work: dict[str, float]
    values: dict[str, int]
    bytes_per_pixel: float | None = None


class TrialResult(msgspec.Struct, frozen=True, tag="result"):
    """What a trial measured. A peer has no ``reuse``."""

    times: Times
    image: ImageErrors
    reuse: ReuseShares | None
    covered: float


class Written(msgspec.Struct, frozen=True):
    """When a row was written (UTC), and by which version."""

    date: str
    version: str


class Row(msgspec.Struct, frozen=True):
    """A finished trial.

    ``key`` names all that determines it, the machine and the content of every file included;
    ``identity`` names what was asked for (scene, label, configuration, size, frames) on that
    machine: two rows of one identity and two keys were measured on different sources. ``texts``
    are shaders by name (``source.frag`` is the user's), ``pictures`` PNG files by kind
    (``original``, ``cached``, ``outcomes``, ``ages``, ``payload``, ``thumbnail``): both by the hash
    under which the store has them.
    """

    key: str
    identity: str
    kind: SubjectKind
    scene: SceneEntry
    payload: PayloadEntry | None
    label: str
    configuration: dict[str, Any] | None
    machine: Machine
    outcome: Failure | TrialResult
    texts: dict[str, str]
    pictures: dict[str, str]
    written: Written

    @property
    def result(self) -> TrialResult | None:
        """The result, where there is one."""
        return None if isinstance(self.outcome, Failure) else self.outcome

    @property
    def failure(self) -> Failure | None:
        """The failure, where it is one."""
        return self.outcome if isinstance(self.outcome, Failure) else None

    @property
    def words(self) -> Mapping[str, str]:
        """What ``--where`` asks about: see :func:`words`."""
        return words(self.scene.name, self.label, self.configuration)


def words(scene: str, label: str, configuration: Mapping[str, Any] | None) -> dict[str, str]:
    """A trial's choices as words, by the names that ``--where`` has for them."""
    chosen = {"scene": scene, "node": label}
    if configuration is not None:
        refresh, storage = configuration["refresh"], configuration["storage"]
        chosen |= {
            "algorithm": configuration["algorithm"],
            "passes": configuration["algorithm"].partition("-")[0],
            "period": str(refresh["period"]),
            "block": str(refresh["block"]),
            "format": storage["format"],
            "refresh": refresh["schedule"],
            "filter": configuration["filter"]["kind"],
            "depth": storage["depth"],
            "rate": configuration.get("payload_rate", "full"),
        }
    return chosen
