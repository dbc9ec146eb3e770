"""Rows of a store as the page's script reads them.

Times are shares of the original's time in the same turns, so that rows of one machine can stand in
one picture although they were measured at different hours.
"""

from __future__ import annotations

import math
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Configuration
from shadercache.measure.metrics.perceived import Perceived
from shadercache.paths import data_path
from shadercache.report.parts.page_words import settings_in_words
from shadercache.sweep.row import PayloadEntry, Row, SceneEntry, TrialResult

BINS = 24
"""Steps of the histograms of frame times."""


def page_row(row: Row, node: int | None) -> dict[str, Any]:
    """One row; ``node`` is the place of its payload in the page's list of nodes."""
    found: dict[str, Any] = {"key": row.key, "kind": row.kind, "label": row.label, "node": node}
    if row.configuration is not None:
        chosen = Configuration.from_json(row.configuration)
        found |= {
            "algorithm": chosen.algorithm,
            "period": chosen.refresh.period,
            "block": chosen.refresh.block,
            "settings": ", ".join(settings_in_words(chosen)),
        }
    if row.failure is not None:
        failure = row.failure
        return found | {
            "failure": {"kind": failure.kind, "code": failure.code, "message": failure.message}
        }
    assert row.result is not None
    return found | _result(row.result) | {"written": row.written.date}


def page_node(payload: PayloadEntry) -> dict[str, Any]:
    """What is said of a payload once for all of its rows."""
    return {
        "label": payload.label,
        "ids": list(payload.ids),
        "path": payload.path,
        "text": payload.text,
        "type": payload.type,
        "places": [list(place) for place in payload.places],
        "staticRatio": _rounded(payload.static_ratio),
        "equal": payload.equal,
    }


def scene_in_words(scene: SceneEntry) -> str:
    """What the command line calls a scene: its name where it is one of the corpus, or its path."""
    own = data_path("corpus", scene.name, "scene.toml")
    return scene.name if Path(scene.path) == own else scene.path


def repeat_command(row: Row, store: str) -> str:
    """The command line that measures a row again; that of a peer is one of the source tree."""
    width, height = row.scene.size
    if row.configuration is None:
        words = ["python", "-m", "bench.peers", scene_in_words(row.scene), "--size", str(width)]
        return shlex.join([*words, "--frames", str(row.scene.frames), "--store", store])
    chosen = Configuration.from_json(row.configuration)
    refresh = chosen.refresh
    words = ["shadercache", "sweep", scene_in_words(row.scene), *row.scene.options]
    words += ["-o", store, "--nodes", row.label]
    words += ["--passes", algorithm(chosen.algorithm).word]
    words += ["--period", str(refresh.period), "--block", str(refresh.block)]
    words += ["--format", chosen.storage.format]
    words += ["--rate", chosen.payload_rate] if chosen.divisor > 1 else []
    own = ("format=", "rate=")
    settings = [word for word in settings_in_words(chosen) if not word.startswith(own)]
    words += ["--cache", ",".join(settings)] if settings else []
    words += ["--size", f"{width}x{height}", "--frames", str(row.scene.frames)]
    if row.result is not None:
        words += ["--perceptual"] if row.result.image.perceived is not None else []
        words += ["--profile"] if row.result.times.profile else []
    # Forced: the store has this row, and a sweep leaves what it has alone.
    return shlex.join([*words, "--force"])


def _result(result: TrialResult) -> dict[str, Any]:
    times, image = result.times, result.image
    original = float(np.median(times.samples.original))
    ratio = times.ratio
    found: dict[str, Any] = {
        "speedup": [_rounded(value) for value in (ratio.median, ratio.low, ratio.high)],
        # The interval of a share is that of the ratio, upside down.
        "time": [_rounded(1.0 / value) for value in (ratio.median, ratio.high, ratio.low)],
        "ms": _rounded(float(np.median(times.samples.subject)) * 1e3),
        "originalMs": _rounded(original * 1e3),
        "tail": _rounded(times.tail),
        "reset": _rounded(times.reset),
        "ratio": _rounded(times.p_over_t),
        "floor": None if times.floor is None else _rounded(times.floor / original),
        "efficiency": _rounded(times.efficiency),
        "profile": [
            [part.name, *map(_rounded, (part.share.median, part.share.low, part.share.high))]
            for part in times.profile
        ],
        "histogram": histogram(times.samples.subject, times.samples.original),
        "errors": {
            "rmse": _rounded(image.rmse),
            "p99": _rounded(image.p99),
            "max": _rounded(image.maximum),
            "psnr": _rounded(image.psnr),
        }
        | _perceived(image.perceived),
    }
    if result.reuse is not None:
        found |= {
            "hits": _rounded(result.reuse.hit_rate),
            "bytes": _rounded(result.reuse.bytes_per_pixel),
            "burst": _rounded(result.reuse.burst),
            "outcomes": {
                name: _rounded(share) for name, share in result.reuse.outcomes.items() if share
            },
        }
    return found


def _perceived(measures: Perceived | None) -> dict[str, Any]:
    """The measures that not every store has."""
    names = ("ssim", "flip", "flicker", "pattern")
    ages = measures.by_age if measures is not None else ()
    return {
        **{name: _rounded(getattr(measures, name, None)) for name in names},
        "byAge": [
            [one.youngest, one.oldest, _rounded(one.share), _rounded(one.rmse)] for one in ages
        ],
    }


def histogram(subject: Sequence[float], original: Sequence[float]) -> dict[str, Any]:
    """How often frames took how long: counts of both in the same steps, from ``start`` to ``end``.

    In ms. The slowest fiftieth may lie beyond the end and is counted there.
    """
    both = np.array([*subject, *original]) * 1e3
    start, end = float(both.min()), float(np.quantile(both, 0.98))
    if end <= start:
        end = start * 1.01 + 1e-6
    edges = np.linspace(start, end, BINS + 1)
    # NumPy drops what lies beyond the last edge; the last step includes that edge.
    counts = [
        np.histogram(np.minimum(np.array(samples) * 1e3, end), edges)[0].tolist()
        for samples in (subject, original)
    ]
    return {"start": _rounded(start), "end": _rounded(end), "counts": counts}


def _rounded(value: float | None) -> float | None:
    """Four significant digits: more are noise, and the page is read by many rows at once."""
    if value is None or not math.isfinite(value):
        return None
    return float(f"{value:.4g}")
