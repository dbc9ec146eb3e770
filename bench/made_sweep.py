"""A result store with made-up numbers, for what reads stores: nothing is drawn or measured.

Nodes, configurations and emitted shaders are those of the dragon. Times and errors follow the
models of Scherzer et al. 2010, equations 2, 3 and 5, with some noise; pictures show a ball.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from msgspec import structs
from numpy.typing import NDArray
from PIL import Image

from shadercache import Configuration, __version__, analyse, rewrite
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.value_numbering import one_of_each
from shadercache.caching.algorithms import PROFILED
from shadercache.caching.configuration import by_every_algorithm
from shadercache.cli.io import read_pair
from shadercache.compiler import Analysis
from shadercache.measure.metrics.perceived import Perceived
from shadercache.measure.metrics.texel_age import AgeError
from shadercache.paths import data_path
from shadercache.sweep import row as kept
from shadercache.sweep.store import Store, hash_of

PERIODS = 4, 8, 16, 32
MACHINE = kept.Machine(
    "made-up (no renderer)", "0.0 made up", "made up", "a made-up processor", 2, "none"
)
PEERS = {
    "half resolution": (0.36, 0.030),
    "half resolution, by depth": (0.41, 0.021),
    "quarter resolution": (0.19, 0.043),
    "checkerboard": (0.58, 0.012),
    "final colour cached": (0.47, 0.026),
    "two octaves": (0.55, 0.048),
    "half the frame rate": (0.53, 0.034),
    "temporal upscaler": (0.44, 0.018),
}
"""Name: share of the original's time, RMSE."""

_GEOMETRY, _ORIGINAL = 0.16, 0.0341
_OUTCOMES = {"hit": 1, "refresh": 2, "outside": 3, "depth": 4, "poison": 6}
_FRAMES = 40


@dataclass(frozen=True, slots=True)
class MadeSize:
    """How much of everything: ``values`` are cached by three algorithms with four periods each;
    ``edge`` of the pictures in pixels; ``files``: are variants really emitted?"""

    values: int = 41
    peers: int = len(PEERS)
    edge: int = 512
    files: bool = True


def fill_store(path: Path, size: MadeSize, machine: kept.Machine = MACHINE) -> list[kept.Row]:
    """Write the rows of a made-up sweep into a store, which is made where there is none."""
    analysis = analyse(*read_pair(str(data_path("corpus", "dragon", "dragon.frag")), None))
    make = _Maker(size, machine, np.random.default_rng(1))
    rows = [*make.variants(analysis), *make.peers()]
    with Store(path, create=True) as store:
        store.keep(rows, make.blobs)
    return rows


class _Maker:
    def __init__(self, size: MadeSize, machine: kept.Machine, draw: np.random.Generator) -> None:
        self._size, self._machine, self._draw = size, machine, draw
        self.blobs: dict[str, bytes] = {}
        self._ball = ball(size.edge)

    def variants(self, analysis: Analysis) -> Iterator[kept.Row]:
        for number, (node, equal) in enumerate(_values(analysis, self._size.values)):
            payload = _payload(analysis, node, equal)
            texts = self._texts(analysis, node)
            for period in PERIODS:
                plain = Configuration((node.id,)).with_refresh(period)
                if number % 3 == 0:
                    plain = replace(plain, refresh=replace(plain.refresh, age=True))
                error = 0.03 * node.ratio * (1.0 - math.exp(-0.08 * (period - 1)))
                error *= 0.6 + 0.8 * ((number * 7) % 11) / 11.0
                pictures = self._pictures(error, period, plain.refresh.age)
                for chosen in by_every_algorithm(plain):
                    time = self._time(chosen.algorithm, node.ratio, period, number)
                    outcome: kept.Failure | kept.TrialResult
                    outcome = result = self._outcome(time, error, node.ratio, period)
                    if chosen.algorithm == PROFILED:
                        parts = self._parts(time)
                        times = structs.replace(result.times, profile=parts)
                        outcome = structs.replace(result, times=times)
                    if number == 1 and chosen.algorithm == "1-pass":
                        message = "the program took more than 20 times as long as the original"
                        outcome = kept.Failure("hung", "SC606", message)
                    own = {k: v for k, v in texts.items() if k.startswith(("s", chosen.algorithm))}
                    row = self._row(payload.label, outcome, pictures)
                    yield structs.replace(
                        row, payload=payload, configuration=chosen.to_json(), texts=own
                    )

    def peers(self) -> Iterator[kept.Row]:
        for label, (time, error) in list(PEERS.items())[: self._size.peers]:
            outcome = self._outcome(time, error, None, None)
            yield self._row(label, outcome, self._pictures(error, None, False))

    def _row(
        self, label: str, outcome: kept.Failure | kept.TrialResult, pictures: dict[str, str]
    ) -> kept.Row:
        name = hash_of(f"{label} {self._draw.random()}".encode())
        edge = self._size.edge
        return kept.Row(
            key=name,
            identity=name,
            kind="peer" if label in PEERS else "variant",
            scene=kept.SceneEntry(
                "dragon", "corpus/dragon/scene.toml", (edge, edge), 24, "surface"
            ),
            payload=None,
            label=label,
            configuration=None,
            machine=self._machine,
            outcome=outcome,
            texts={},
            pictures={} if isinstance(outcome, kept.Failure) else pictures,
            written=kept.Written("2026-01-02T03:04:05+00:00", __version__),
        )

    def _time(self, algorithm: str, ratio: float, period: int, number: int) -> float:
        """The share of the original's time: the parts that are drawn, and what a pass adds."""
        # What is refreshed, and misses beside it.
        computed = 1.0 / period + 0.03
        overhead = {"1-pass": 0.04, "2-pass": 0.10, "3-pass": 0.15}[algorithm]
        if algorithm == "1-pass":
            computed = 0.85 + 0.15 * computed  # a software renderer runs both sides of a branch
        hit = (1.0 - _GEOMETRY) * (1.0 - min(1.0, ratio))
        shading = hit + computed * ratio * (1.0 - _GEOMETRY)
        if algorithm == "2-pass":
            shading += 0.12 * (1.0 - ratio)
        return _GEOMETRY + shading + overhead + 0.02 * math.sin(2.1 * number)

    def _parts(self, time: float) -> tuple[kept.PartEntry, ...]:
        """Where a frame goes: the geometry twice, and the rest as it is drawn."""
        names = ("clears", "look-up", "refresh decision", "shading", "store")
        drawn = self._draw.dirichlet(np.full(len(names), 6.0)) * (time - 2.0 * _GEOMETRY)
        shares = dict(zip(names, drawn.tolist(), strict=True))
        shares |= {"geometry, both passes": 2.0 * _GEOMETRY, "not explained": -0.01}
        return tuple(
            kept.PartEntry(name, kept.RatioEntry(share, share - 0.01, share + 0.01, share))
            for name, share in shares.items()
        )

    def _outcome(
        self, time: float, error: float, ratio: float | None, period: int | None
    ) -> kept.TrialResult:
        noise = self._draw.lognormal(0.0, 0.05, (3, _FRAMES))
        drift = np.linspace(1.0, 1.15, _FRAMES)
        shares = np.array([time, 1.0, _GEOMETRY])[:, None]
        seconds = _ORIGINAL * shares * drift * (1.0 + 0.02 * noise**8)
        subject, original, geometry = (tuple(row.tolist()) for row in seconds)
        middle = 1.0 / time
        width = float(self._draw.uniform(0.008, 0.025))
        floor = None if period is None else time * float(self._draw.uniform(0.72, 0.95))
        times = kept.Times(
            kept.RatioEntry(middle, middle * (1.0 - width), middle * (1.0 + width), middle),
            tail=float(np.quantile(subject, 0.99) / np.median(subject)),
            capped=False,
            reset=1.04 if period else None,
            p_over_t=None if ratio is None else ratio * float(self._draw.uniform(0.97, 1.03)),
            floor=None if floor is None else floor * _ORIGINAL,
            efficiency=None if floor is None else floor / time,
            samples=kept.Samples(subject, original, geometry),
        )
        psnr = None if error == 0.0 else -20.0 * math.log10(error)
        perceived = Perceived(
            frames=4,
            ssim=1.0 - 2.0 * error,
            flip=error * 1.9,
            flicker=error * 0.7,
            pattern=None if period is None else 1.0 + 0.1 * period,
            by_age=() if period is None else _by_age(error, period),
        )
        image = kept.ImageErrors(error, 3 * error, 9 * error, psnr, (error,) * 12, perceived)
        return kept.TrialResult(times, image, None if period is None else _reuse(period), 0.46)

    def _texts(self, analysis: Analysis, node: Candidate) -> dict[str, str]:
        assert analysis.vertex_source is not None
        texts = {"source.frag": analysis.fragment.text, "source.vert": analysis.vertex_source.text}
        if self._size.files:
            texts |= rewrite(analysis, by_every_algorithm(Configuration((node.id,)))).files
        return {name: self._kept(text.encode()) for name, text in texts.items()}

    def _pictures(self, error: float, period: int | None, age: bool) -> dict[str, str]:
        edge, ball = self._size.edge, self._ball
        covered = np.asarray(ball.any(axis=2))
        grain = self._draw.normal(0.0, 255.0 * error, (edge, edge, 1))
        cached = np.clip(np.rint(ball + grain * covered[..., None]), 0, 255).astype(np.uint8)
        small = Image.fromarray(cached).resize((160, 160))
        found = {
            "original": _png(ball),
            "cached": _png(cached),
            "thumbnail": _encoded(small, "WEBP"),
        }
        if period is not None:
            blocks = np.kron(self._draw.integers(0, period, (edge // 4,) * 2), np.ones((4, 4), int))
            mask = np.where(blocks == 0, 2, 1) * covered
            mask[:, : edge // 3][self._draw.random((edge, edge // 3)) < 0.02] = 4
            found["outcomes"] = _png((mask * covered).astype(np.uint8))
            found["payload"] = _png((255 - ball) * covered[..., None].astype(np.uint8))
            if age:
                found["ages"] = _png((blocks * 16).astype(np.uint16))
        return {kind: self._kept(data) for kind, data in found.items()}

    def _kept(self, data: bytes) -> str:
        name = hash_of(data)
        self.blobs[name] = data
        return name


def ball(edge: int) -> NDArray[np.uint8]:
    """A lit ball with veins, (edge, edge, 3), black around it."""
    x, y = np.meshgrid(*(np.linspace(-1.15, 1.15, edge),) * 2)
    inside = np.asarray(x**2 + y**2 < 1.0)
    z = np.sqrt(np.clip(1.0 - x**2 - y**2, 0.0, 1.0))
    light = np.clip(0.5 * x - 0.6 * y + 0.65 * z, 0.05, 1.0)
    bent = 3.0 * np.sin(4.1 * x + 1.3) * np.cos(3.7 * y) + np.sin(9.0 * z + 5.0 * y)
    vein = np.exp(-9.0 * np.sin(3.0 * x + 2.0 * y + bent) ** 2)
    stone = np.stack([0.82 - 0.55 * vein, 0.79 - 0.45 * vein, 0.72 - 0.36 * vein], axis=2)
    shown = np.sqrt(stone * light[..., None]) * inside[..., None]
    return np.rint(255.0 * shown).astype(np.uint8)


def _values(analysis: Analysis, count: int) -> Sequence[tuple[Candidate, int]]:
    """Values of all costs, evenly picked by their static share."""
    offered = one_of_each([node for node in analysis.nodes if node.offered], analysis.groups)
    ordered = sorted(offered.items(), key=lambda pair: pair[0].ratio)
    picked = np.linspace(len(ordered) // 3, len(ordered) - 1, count).astype(int)
    return [ordered[at] for at in picked]


def _payload(analysis: Analysis, node: Candidate, equal: int) -> kept.PayloadEntry:
    source, span = analysis.fragment, node.expr.span
    place = (*source.position(span.start), *source.position(span.end))
    label = "albedo" if node.text.startswith("marble(") else node.id
    named = node.id, node.path, node.text, node.type.name
    return kept.PayloadEntry(label, (named[0],), *named[1:], (place,), node.ratio, equal)


def _by_age(error: float, period: int) -> tuple[AgeError, ...]:
    """The error grows with the age; ages are put together by powers of two."""
    spans = [(2**power // 2 + 1, 2**power) for power in range(1, period.bit_length())]
    return tuple(
        AgeError(
            youngest,
            oldest,
            share=(oldest - youngest + 1) / period,
            rmse=error * math.sqrt(2.0 * oldest / period),
        )
        for youngest, oldest in spans
    )


def _reuse(period: int) -> kept.ReuseShares:
    refresh = 1.0 / period
    shares = {"hit": 0.97 - refresh, "refresh": refresh, "outside": 0.004, "depth": 0.026}
    return kept.ReuseShares(shares["hit"], 1.2 * refresh, shares, {"hit": 1e5}, _OUTCOMES)


def _png(pixels: NDArray[np.generic]) -> bytes:
    return _encoded(Image.fromarray(pixels), "PNG")


def _encoded(image: Image.Image, form: str) -> bytes:
    buffer = io.BytesIO()
    image.save(buffer, form)
    return buffer.getvalue()
