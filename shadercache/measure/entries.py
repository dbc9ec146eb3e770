"""From nodes to what is measured: their programs, and the scene they run in."""

from __future__ import annotations

from collections.abc import Sequence

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, rewrite
from shadercache.measure.measurement import Entry
from shadercache.options import ALGORITHMS, Options
from shadercache.render.bundle import Bundle


def make_entry(
    analysis: Analysis,
    label: str,
    node: Candidate | Sequence[Candidate],
    options: Options,
    algorithms: Sequence[int] = ALGORITHMS,
    *,
    unprofitable: bool = False,
) -> Entry:
    """A node, or several cached together, ready to be measured.

    All variants are made, since the parts of P/T and of the floor are measured on them; only those
    of ``algorithms`` that the node has are run. Raises as :func:`shadercache.compiler.rewrite`.
    """
    emission = rewrite(analysis, node, options, unprofitable=unprofitable)
    bundle = Bundle(emission.manifest, emission.files)
    wanted = {f"{number}-pass" for number in algorithms}
    return Entry(label, bundle, tuple(name for name in bundle.algorithms if name in wanted))
