"""What verifying says of a node: which laws hold, and how far pictures are off."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.result_files import plain

Image = NDArray[np.float32]
Mask = NDArray[np.bool_]

PERIOD = 4
"""Refresh period of the runs that reuse: short, so that few frames show every phase."""

MAX_TIES = 1e-4
"""Share of pixels with depth ties above which a scene is reported (law 4)."""

LAWS = {"always": "law 2", "resting": "law 3", "agreeing": "law 4"}
"""What is drawn for each law."""


@dataclass(frozen=True, slots=True)
class Difference:
    """How far an image is from the reference, in display units, over covered pixels.

    The largest, the 99.9th percentile, and the share of changed pixels.
    """

    maximum: float = 0.0
    p999: float = 0.0
    changed: float = 0.0

    @property
    def exact(self) -> bool:
        """The same bits everywhere (an image that is not finite never is)."""
        return self.changed == 0.0

    def __str__(self) -> str:
        if not np.isfinite(self.maximum):
            return f"{self.changed:.2%} of the pixels differ, some of which are not finite"
        return f"{self.changed:.2%} of the pixels differ, by up to {self.maximum:.2g}"


def difference(image: Image, reference: Image, covered: Mask) -> Difference:
    """Compare colours bit by bit where ``covered``; NaN equals NaN of the same bits only."""
    one, other = image[covered], reference[covered]
    # Bits, since NaN is not equal to itself, and -0 is equal to 0.
    changed = (one.view(np.uint32) != other.view(np.uint32)).any(axis=-1)
    if not changed.any():
        return Difference()
    share = float(changed.mean())
    if not (np.isfinite(one).all() and np.isfinite(other).all()):
        return Difference(np.inf, np.inf, share)
    apart = np.abs(one.astype(np.float64) - other).max(axis=-1)
    return Difference(float(apart.max()), float(np.percentile(apart, 99.9)), share)


def worst_of(differences: Iterable[Difference]) -> Difference:
    """The largest of each figure."""
    every = list(differences)
    return Difference(
        max((one.maximum for one in every), default=0.0),
        max((one.p999 for one in every), default=0.0),
        max((one.changed for one in every), default=0.0),
    )


def rmse(images: Iterable[Image], others: Iterable[Image], judged: Iterable[Mask]) -> float:
    """The root of the mean square by which images of two runs differ, in pixels that count."""
    pairs = zip(images, others, judged, strict=False)
    apart = [(image.astype(np.float64) - other)[counts] for image, other, counts in pairs]
    return float(np.sqrt(np.mean(np.square(np.concatenate(apart)))))


@dataclass(slots=True)
class Verdict:
    """The laws for one node, or for several cached together.

    ``node``, ``path`` and ``text`` are of all nodes, joined as :meth:`Bundle.node` does it.
    ``laws``: what each of :data:`LAWS` found, by algorithm. ``faults``: what is wrong with what is
    reused, in a sentence, by law and algorithm (``law 3 (2-pass)``). ``ages``: the greatest age in
    frames that a payload reached at a period of :data:`PERIOD`, where the cache keeps ages.
    ``plain``: what plain mode changes. ``refused``: the algorithms that the compiler does not offer
    for the node, and why. ``failure``: why a variant could not be drawn at all. ``cause``: what of
    the payload is not finite, and where. ``moving``: of a value of the screen, the RMSE of its
    reuse in motion, which no law bounds, by algorithm.
    """

    node: str
    path: str
    text: str
    profitable: bool
    cause: str = ""
    laws: dict[str, dict[str, Difference]] = field(
        default_factory=lambda: {key: {} for key in LAWS}
    )
    plain: dict[str, Difference] = field(default_factory=dict)
    ages: dict[str, float] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)
    failure: str = ""
    faults: dict[str, str] = field(default_factory=dict)
    moving: dict[str, float] | None = None

    @property
    def approximate(self) -> bool:
        """Is it a value of the screen, exact at rest alone?"""
        return self.moving is not None

    @property
    def algorithms(self) -> set[str]:
        """Those whose variants were judged."""
        return set(self.laws["always"])

    @property
    def broken(self) -> list[str]:
        """The laws that do not hold, as ``law 2 (1-pass)``; with a failure, that none does."""
        return list(self._reasons())

    @property
    def reasons(self) -> list[str]:
        """A sentence for each broken law: what was expected, and what was found."""
        return [f"{law}: {'; '.join(words)}" for law, words in self._reasons().items()]

    @property
    def inexact(self) -> dict[str, Difference]:
        """The laws whose pictures differ, as ``law 2 (1-pass)``, and how far."""
        return {
            f"{LAWS[key]} ({name})": apart
            for key, by_algorithm in self.laws.items()
            for name, apart in by_algorithm.items()
            if not apart.exact
        }

    def to_json(self) -> dict[str, Any]:
        """JSON values, with the list of broken laws. Differences without end are null."""
        data: dict[str, Any] = plain(self)
        data.update(data.pop("laws"), broken=self.broken, reasons=self.reasons)
        data["approximate"] = self.approximate
        return data

    def _reasons(self) -> dict[str, list[str]]:
        """Broken law -> what is wrong."""
        reasons = {"cannot be drawn": [self.failure]} if self.failure else {}
        inexact = self.inexact
        for key, by_algorithm in self.laws.items():
            for law in (f"{LAWS[key]} ({name})" for name in by_algorithm):
                words = [str(inexact[law])] if law in inexact else []
                words += [self.faults[law]] if law in self.faults else []
                if words:
                    reasons[law] = words
        for name, age in self.ages.items():
            # So written an age that is NaN breaks the law.
            if not age <= PERIOD:
                reasons[f"law 7 ({name})"] = [f"a payload is {age:g} frames old, {PERIOD} expected"]
        return reasons
