"""FIG11: error against time of every value over the period, and its clusters (T14).

Figure 11 of Scherzer et al. 2010 on the dragon, with three passes. The clusters are named by a rule
that looks at P/T, the error and the overlap, and at no time; where they lie is then measured.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from bench.papers.claims import Verdict
from bench.papers.drawing import ORIGINAL, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.models import Fit, fit_error
from bench.papers.rules import ALMOST_EVERY, FEWEST_NODES, GENERALLY, HIGH, LITTLE, OVERLAP
from bench.papers.scene_nodes import NodeFacts, distinct_nodes
from bench.papers.turns import Turns, Variant, as_in_the_papers, take_turns
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.subjects import subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene

ALGORITHM, PERIODS = "3-pass", (2, 4, 12, 32)
IN_TURNS = 6
"""Nodes that are drawn in the same turns."""

FRAMES = 40
"""The last eight are compared: by then each pixel has been refreshed."""

VISIBLE = 0.002
"""An error below this at the longest period is none: half a step of eight bits."""

FAR = 0.5
"""An error is large from this share of the error of caching the final colour on."""

FITS = 0.10
"""What a model may leave over, as a share of the largest error."""

LIT = frozenset({"u_eye", "u_light"})
"""What values read that depend on the view or the light."""

MEANING = {
    "A": "near",
    "B": "cheap and far",
    "C": "dear and far",
    "D": "much computed in both passes",
}
COLORS = {"A": "#26849a", "B": "#b8860b", "C": "#d6573c", "D": "#6a58a8"}


@dataclass(frozen=True, slots=True)
class ErrorBatch:
    """Nodes that were drawn in the same turns; series are labelled ``node id, n period``."""

    nodes: tuple[NodeFacts, ...]
    turns: Turns


@dataclass(frozen=True, slots=True)
class Figure11:
    """What is stored."""

    periods: tuple[int, ...]
    batches: tuple[ErrorBatch, ...]


@dataclass(frozen=True, slots=True)
class Path:
    """A node's curve: share of the original's time and RMSE at each period."""

    facts: NodeFacts
    shares: tuple[float, ...]
    errors: tuple[float, ...]
    fit: Fit

    @property
    def worst(self) -> float:
        """The error at the longest period."""
        return self.errors[-1]


def label(facts: NodeFacts, period: int) -> str:
    """Of a series."""
    return f"{facts.id}, n {period}"


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure11:
    """Measure every node at all periods in the same turns."""
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    linker = Linker(scene, analysis)
    chosen = options.some(distinct_nodes(scene, analysis), quick=3)
    how = MeasureOptions(options.frames(FRAMES))
    batches = []
    with RenderScene(gpu, linker.scene, (options.size, options.size)) as world:
        for start in range(0, len(chosen), IN_TURNS):
            tell(start, len(chosen))
            nodes = tuple(chosen[start : start + IN_TURNS])
            subjects = [one for facts in nodes for one in _subjects(linker, facts)]
            batches.append(ErrorBatch(nodes, take_turns(world, linker, subjects, how)))
    return Figure11(PERIODS, tuple(batches))


def _subjects(linker: Linker, facts: NodeFacts) -> Iterator[Variant]:
    for period in PERIODS:
        chosen = as_in_the_papers([facts.id], ALGORITHM).with_refresh(period)
        for subject in subjects_of(linker, facts.id, [chosen]):
            yield Variant(label(facts, period), subject)


def paths(data: Figure11) -> list[Path]:
    """All curves; values that three passes do not fit have none."""
    return [
        _path(facts, batch.turns, data.periods)
        for batch in data.batches
        for facts in batch.nodes
        if batch.turns.has(label(facts, data.periods[0]))
    ]


def _path(facts: NodeFacts, turns: Turns, periods: Sequence[int]) -> Path:
    labels = [label(facts, period) for period in periods]
    errors = tuple(turns.of(name).rmse for name in labels)
    return Path(facts, tuple(map(turns.share, labels)), errors, fit_error(periods, errors))


def clusters(curves: Sequence[Path]) -> dict[str, list[Path]]:
    """A to D, named without a look at the times.

    D: both passes compute much. Of the others those are far whose error is a good part of that of
    caching the final colour, which is the value of the greatest P/T. C is far and of a high P/T,
    B far and of a low one, A is what is near.
    """
    final = max(curves, key=lambda path: path.facts.ratio).worst
    found: dict[str, list[Path]] = {name: [] for name in MEANING}
    for path in curves:
        if path.facts.overlap >= OVERLAP:
            found["D"].append(path)
        elif path.worst >= FAR * final:
            found["C" if path.facts.ratio >= HIGH else "B"].append(path)
        else:
            found["A"].append(path)
    return found


def judge(data: Figure11) -> list[Verdict]:
    """T14, both parts."""
    curves = paths(data)
    model, where = _model(curves), _positions(clusters(curves))
    if len(curves) < FEWEST_NODES:
        few = f"only {len(curves)} nodes were drawn; "
        model, where = (Verdict(one.claim, None, few + one.numbers) for one in (model, where))
    return [model, where]


def _model(curves: Sequence[Path]) -> Verdict:
    """T14a: for almost every visible error the model leaves little, and it generally saturates
    within the periods that were drawn (lambda times them is 1 or more)."""
    seen = [path for path in curves if path.worst >= VISIBLE]
    if not seen:
        return Verdict("T14a", None, f"no error of {VISIBLE} or more")
    fitting = sum(path.fit.residual <= FITS * max(path.errors) for path in seen)
    rates = [path.fit.rate or 0.0 for path in seen]
    saturating = sum(rate * (PERIODS[-1] - 1) >= 1.0 for rate in rates)
    holds = fitting >= ALMOST_EVERY * len(seen) and saturating >= GENERALLY * len(seen)
    left = np.median([path.fit.residual / max(path.errors) for path in seen])
    words = (
        f"of {len(seen)} values with an error of {VISIBLE} or more the model fits {fitting} to "
        f"within {FITS:.0%} of the largest error (median {left:.1%}), and {saturating} "
        f"saturate up to n = {PERIODS[-1]}; median lambda {np.median(rates):.3f}"
    )
    return Verdict("T14a", holds, words)


def _positions(found: Mapping[str, Sequence[Path]]) -> Verdict:
    """T14b: all four are there; C is the fastest and A faster than B, B gains little, D is slower
    than A and C, B and C are farther than A. Of medians over the nodes at the longest period."""
    members = ", ".join(f"{name} {len(curves)}" for name, curves in found.items())
    if not all(found.values()):
        return Verdict("T14b", False, f"a cluster is empty: {members}")
    speed = {
        name: float(np.median([1.0 / path.shares[-1] for path in curves]))
        for name, curves in found.items()
    }
    error = {
        name: float(np.median([path.worst for path in curves])) for name, curves in found.items()
    }
    statements = {
        "C the fastest": speed["C"] == max(speed.values()),
        "A faster than B": speed["A"] > speed["B"],
        "B gains little": speed["B"] <= 1.0 + LITTLE,
        "D slower than A and C": speed["D"] < min(speed["A"], speed["C"]),
        "A nearer than B and C": error["A"] < min(error["B"], error["C"]),
    }
    wrong = [words for words, right in statements.items() if not right]
    lit = {name: sum(not LIT.isdisjoint(p.facts.inputs) for p in found[name]) for name in found}
    each = ", ".join(
        f"{name} ({len(found[name])} nodes, {lit[name]} read view or light) {speed[name]:.2f}x at "
        f"RMSE {error[name]:.4f}"
        for name in found
    )
    return Verdict(
        "T14b", not wrong, f"{each}; {'not so: ' + ', '.join(wrong) if wrong else 'all as said'}"
    )


def table(data: Figure11) -> str:
    """A row for each curve, by cluster."""
    header = (
        *("cluster", "node", "P/T static", "twice"),
        *(f"n {period}" for period in data.periods),
        *(f"RMSE n {period}" for period in data.periods),
        *("alpha", "lambda", "expression"),
    )
    rows = [
        (
            *(name, path.facts.id, f"{path.facts.ratio:.3f}", f"{path.facts.overlap:.0%}"),
            *(f"{1.0 / share:.2f}x" for share in path.shares),
            *(f"{error:.4f}" for error in path.errors),
            *(f"{path.fit.scale:.4f}", f"{path.fit.rate:.3f}", path.facts.text[:40]),
        )
        for name, curves in clusters(paths(data)).items()
        for path in curves
    ]
    return format_table(header, rows)


def draw(data: Figure11) -> dict[str, bytes]:
    """Error against time, a curve for each value from the shortest period to the longest."""
    figure, (axes,) = panels(1, 1, (9.0, 6.5))
    original = 1e3 * float(np.median([np.median(b.turns.original) for b in data.batches]))
    for name, curves in clusters(paths(data)).items():
        for number, path in enumerate(curves):
            words = f"{name}: {MEANING[name]} ({len(curves)})" if number == 0 else None
            times = [original * share for share in path.shares]
            axes.plot(times, path.errors, color=COLORS[name], lw=1, alpha=0.7, label=words)
            axes.plot(times[-1], path.worst, color=COLORS[name], marker="o", ms=3.5)
        if curves:
            x = original * np.median([path.shares[-1] for path in curves])
            y = np.median([path.worst for path in curves])
            circle = {"boxstyle": "circle", "fc": "white", "ec": COLORS[name]}
            look: dict[str, Any] = {"fontsize": 13, "weight": "bold", "bbox": circle}
            axes.annotate(
                name, (x, y), (14, 0), textcoords="offset points", color=COLORS[name], **look
            )
    axes.axvline(original, color=ORIGINAL, lw=1.2, ls="--", label=f"original, {original:.1f} ms")
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("time of a frame (ms), three passes")
    axes.set_ylabel("RMSE over covered pixels (display-encoded, 0-1)")
    drawn = ", ".join(map(str, data.periods))
    axes.set_title(f"dragon: every value at n = {drawn} (dot)", loc="left", fontsize=11)
    axes.legend(frameon=False, fontsize=9)
    return {"figure11": png(figure)}


EXPERIMENT = Experiment(
    "FIG11", "Error against time of every value", Figure11, gather, judge, table, draw
)
