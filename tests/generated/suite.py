"""Many generated shaders under the laws: seeds, coverage, and the smallest shader that fails."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import partial
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from shadercache.analysis.candidates import Candidate
from shadercache.ast.large import allow_deep_trees
from shadercache.gpu.context import Gpu

from .dialects import DIALECTS, Dialect
from .trial import Chooser, Report, try_shader
from .writer import Shader, Writer, shaders

OUTPUT = Path(__file__).resolve().parent.parent.parent / "out" / "generated"
REGRESSIONS = Path(__file__).with_name("regressions")
Nodes = Sequence[Candidate]
Trial = Callable[[Gpu, str, Dialect, Chooser], Report]

REPEATED = 3
"""Shaders that are made for one that is new, at most."""

NODES = 3
"""Nodes of a shader that are checked."""

_PICKS = st.tuples(*[st.integers(0, 0xFFFF)] * NODES)


@dataclass
class Coverage:
    """How often everything occurred, over many shaders."""

    shaders: Counter[str] = field(default_factory=Counter)
    constructs: Counter[str] = field(default_factory=Counter)
    codes: Counter[str] = field(default_factory=Counter)
    algorithms: Counter[str] = field(default_factory=Counter)
    nodes: int = 0
    not_finite: int = 0
    turned_down: int = 0
    """Shaders that the driver does not take as they are, so that nothing was drawn."""
    plain: int = 0
    """Variants in plain mode that were drawn."""
    plain_changed: int = 0
    """Those in which any pixel differs from the original by any bit."""

    def add(self, shader: Shader, report: Report) -> None:
        """Count one shader in."""
        self.shaders[shader.dialect.name] += 1
        self.constructs += shader.tags
        self.codes += report.codes
        self.algorithms += report.algorithms
        self.nodes += report.nodes
        self.not_finite += not report.finite
        self.turned_down += report.turned_down
        self.plain += len(report.plain)
        self.plain_changed += sum(share > 0.0 for share in report.plain)

    def merge(self, other: Coverage) -> None:
        """Count in what another run has seen."""
        for mine, theirs in (
            (self.shaders, other.shaders),
            (self.constructs, other.constructs),
            (self.codes, other.codes),
            (self.algorithms, other.algorithms),
        ):
            mine.update(theirs)
        self.nodes += other.nodes
        self.not_finite += other.not_finite
        self.turned_down += other.turned_down
        self.plain += other.plain
        self.plain_changed += other.plain_changed

    def to_json(self) -> dict[str, Any]:
        """The counts as plain data, the most frequent first."""
        return {
            item.name: dict(value.most_common()) if isinstance(value, Counter) else value
            for item in fields(self)
            for value in [getattr(self, item.name)]
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Coverage:
        """The counts that ``to_json`` wrote."""
        counted = {name: Counter(v) if isinstance(v, dict) else v for name, v in data.items()}
        return cls(**counted)

    def table(self) -> str:
        """The counts as text, the most frequent first."""
        lines = [f"{self.shaders.total()} shaders, {self.nodes} nodes checked"]
        lines.append(f"{self.not_finite} shaders with values that are not finite")
        lines.append(f"{self.turned_down} shaders that the driver turns down as they are")
        lines.append(f"plain mode changes bits of {self.plain_changed} of {self.plain} variants")
        for title in ("shaders", "constructs", "codes", "algorithms"):
            lines.append(f"{title}:")
            counts: Counter[str] = getattr(self, title)
            lines += [f"  {count:7}  {name}" for name, count in counts.most_common()]
        return "\n".join(lines)


@dataclass
class _Told:
    """What a run has seen. Hypothesis repeats shaders that it has made, with other nodes: half of
    what it makes is known already, and is passed over until it looks for a smaller one."""

    texts: set[str] = field(default_factory=set)
    broken: bool = False


class BrokenError(AssertionError):
    """A generated shader for which something does not hold."""


def check_shaders(
    gpu: Gpu,
    dialect: str,
    count: int,
    number: int,
    coverage: Coverage,
    trial: Trial = try_shader,
    shrink: bool = True,
) -> None:
    """Try so many different shaders, the same ones for the same seed ``number``.

    Raises :class:`BrokenError` for a shader that breaks anything, written to ``out/generated``;
    the smallest one if ``shrink``.
    """
    told = _Told()

    @seed(number)
    @settings(
        max_examples=REPEATED * count,
        deadline=None,
        database=None,
        phases=(Phase.generate, *([Phase.shrink] if shrink else [])),
        suppress_health_check=list(HealthCheck),
        report_multiple_bugs=False,
        print_blob=False,
    )
    @given(st.data())
    def every_shader(data: st.DataObject) -> None:
        shader = data.draw(shaders(dialect))
        picks = iter(data.draw(_PICKS))  # drawn in any case: what is drawn must not hang on state
        if not told.broken and (shader.text in told.texts or len(told.texts) >= count):
            return
        told.texts.add(shader.text)
        drawn = partial(pick_nodes, pick=lambda below: next(picks) % below)
        report = trial(gpu, shader.text, shader.dialect, drawn)
        coverage.add(shader, report)
        if report.problems:
            told.broken = True
            raise BrokenError(_kept(shader, report, number))

    allow_deep_trees()  # or hypothesis warns that the limit changes under it
    every_shader()


def pick_nodes(legal: Nodes, near: Nodes, pick: Callable[[int], int]) -> list[Candidate]:
    """Some of the nodes: where there is one, one that might pay, one inside of a function, and one
    that may come to what fragments share (``near``)."""
    left, found = list(legal), list[Candidate]()
    for wanted in (near.__contains__, _pays, _is_called):
        some = [node for node in left if wanted(node)]
        if some:
            found.append(some[pick(len(some))])
            left.remove(found[-1])
    while left and len(found) < NODES:
        found.append(left.pop(pick(len(left))))
    return found


def _pays(node: Candidate) -> bool:
    return node.offered


def _is_called(node: Candidate) -> bool:
    return node.instance is not None and bool(node.instance.path)


def quick_shader(dialect: str, number: int) -> Shader:
    """The shader of a seed, without the means to make it smaller."""
    choice = random.Random(f"{dialect} {number}")
    return Writer(choice.randrange, DIALECTS[dialect]).shader()


def _kept(shader: Shader, report: Report, number: int) -> str:
    """Write a failing shader to a file; hypothesis ends with the smallest. What to tell of it."""
    OUTPUT.mkdir(parents=True, exist_ok=True)
    file = OUTPUT / f"{shader.dialect.name}-{number}.frag"
    file.write_text(shader.text, encoding="utf-8")
    problems = "\n".join(report.problems)
    return (
        f"{problems}\n\n{shader.text}\n"
        f"SHADERCACHE_SEED={number} repeats this; the shader is {file}.\n"
        f"Once repaired it belongs into {REGRESSIONS}."
    )
