"""The values of a shader that are worth a look: what they save, where they are, what they need."""

from __future__ import annotations

import shlex
from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING

from shadercache.analysis.mapping import PREVIOUS_CLIP
from shadercache.diagnostics import snippet

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.analysis.costs.savings import Saving
    from shadercache.compiler import Analysis

MOST = 10
"""Values that are shown."""

LEAST = 3
"""Values that are shown even where a look-up costs more than it saves."""

MAPPINGS = {
    "surface": "a value is reused on the same point of a surface",
    "screen": "a value is reused at the same pixel; exact while its uniforms and textures stay",
    "user": f"a value is reused from where {PREVIOUS_CLIP}() says",
}
_STAYS = {
    "surface": "stays the same on the surface",
    "screen": "stays the same at the pixel",
    "user": "stays the same where it is reused",
}

Changes = Mapping[str, str]
"""Which inputs change from frame to frame, and with what."""


def told_in_one_look(analysis: Analysis, changes: Changes | None, files: Sequence[str]) -> str:
    """The values that save most, and what to do next. ``files``: how a command line named them."""
    ranked = analysis.savings.ranked()
    if not ranked:
        return _nothing_offered(analysis)
    dependence = Dependence(analysis, changes)
    telling = analysis.savings.telling(ranked, dependence.causes, MOST)
    shown = [one for number, one in enumerate(telling) if one.share > 0.0 or number < LEAST]
    values = "value" if len(ranked) == 1 else "different values"
    head = (
        f"{len(shown)} of {len(ranked)} {values}, by what caching one saves of the shader at most "
        f"(static costs)\nmapping: {analysis.mapping}, {MAPPINGS[analysis.mapping]}"
    )
    told = (_value(analysis, one, dependence.told(one.node)) for one in shown)
    best = min(
        (one for one in shown if one.share > 0.0 and one.share >= 0.5 * shown[0].share),
        key=lambda one: len(dependence.causes(one.node)),
        default=shown[0],
    )
    return "\n\n".join([head, *told, f"{_counts(analysis)}; {_next(analysis, best, files)}"])


def _value(analysis: Analysis, saving: Saving, changing: str) -> str:
    node, source = saving.node, analysis.fragment
    (line, column), end = map(source.position, node.expr.span)
    place = f"{source.part(node.expr.span.start).name}:{line}:{column}"
    if end.line > line:
        place += f" to {end.line}:{end.column}"
    share = f"saves {saving.share:.0%}" if saving.share > 0.0 else "a look-up costs more than it"
    twice = f", {saving.twice:.0%} computed twice" if saving.twice >= 0.005 else ""
    path = "" if node.path == "main" else f", {node.path}"
    condition = "; not in every fragment" if node.unsure else ""
    return "\n".join(
        [
            f"{place}: {share}{twice}: {node.type} {node.id}{path}",
            *snippet(source, node.expr.span),
            f"        {changing}{condition}",
        ]
    )


class Dependence:
    """What values depend on: through varyings too, if their vertex shader is known."""

    def __init__(self, analysis: Analysis, changes: Changes | None) -> None:
        from shadercache.analysed import of_vertex_stage, value_classes
        from shadercache.analysis.candidates import varyings

        self._analysis, self._changes = analysis, changes
        self.value_class = value_classes(analysis, changes)
        self._varyings = varyings(analysis.program.module)
        # A shader has many values, and few sets of inputs.
        self._through = cache(partial(of_vertex_stage, analysis))

    def causes(self, node: Candidate) -> frozenset[str]:
        """What changes the value: of what it depends on all that is not known to stay."""
        names = node.inputs | self._through(node.inputs & self._varyings)
        return names if self._changes is None else names & self._changes.keys()

    def sentence(self, node: Candidate) -> str:
        """What changes the value, as it is shown."""
        kinds, changes = self._kinds(node), self._changes
        if changes is None:
            given = [f"{kind} {', '.join(names)}" for kind, names in kinds.items()]
            if more := self._through(node.inputs & self._varyings):
                given.append(f"in the vertex shader {', '.join(sorted(more))}")
            return f"depends on {'; '.join(given) or 'nothing'}"
        causes: dict[str, list[str]] = {cause: [] for cause in sorted(set(changes.values()))}
        for name in sorted(self.causes(node)):
            causes[changes[name]].append(name)
        told = ["where it is seen"] * node.on_screen
        told += [f"the {cause} ({', '.join(names)})" for cause, names in causes.items() if names]
        if told:
            return f"changes with {' and '.join(told)}"
        place = ", ".join(kinds.get("varyings", ()))
        return _STAYS[self._analysis.mapping] + (f" ({place})" if place else "")

    def told(self, node: Candidate) -> str:
        """The class of the value, and what changes it."""
        word = self.value_class(node)
        return f"{word}{' (exact at rest)' * node.approximate}: {self.sentence(node)}"

    def _kinds(self, node: Candidate) -> dict[str, list[str]]:
        from shadercache.analysis.input_reads import by_kind, input_kinds

        program = self._analysis.program
        kinds = by_kind(node.inputs, input_kinds(program.module, program.facts))
        # What the shader itself fixes changes nothing.
        kinds.pop("globals", None)
        return kinds


def _counts(analysis: Analysis) -> str:
    offered = [node for node in analysis.nodes if node.offered]
    values = len({analysis.groups[node] for node in offered})
    refused = len(analysis.nodes) - len(offered)
    different = "1 value" if values == 1 else f"{values} different values"
    more = "" if analysis.reading.approximate else _told_of_screen(analysis)
    return (
        f"{len(offered)} nodes of {different} are offered, {refused} are refused (--all lists them"
        f"{more})"
    )


def _told_of_screen(analysis: Analysis) -> str:
    """How many values are refused only as of the screen."""
    refusals = (node.refusal for node in analysis.nodes)
    count = sum(refusal is not None and refusal.approximable for refusal in refusals)
    return f"; {count} as values of the screen, which --approximate may offer" if count else ""


def _next(analysis: Analysis, best: Saving, files: Sequence[str]) -> str:
    """What to do with the value that changes with least of those that save much."""
    words = ["shadercache", "rewrite", *files, *analysis.reading.words]
    command = shlex.join([*words, "--node", best.node.id, "-o", "out"])
    if best.share <= 0.0:
        return f"by static costs none is worth a look-up; to measure one all the same: {command}"
    return f"next: {command}"


def _nothing_offered(analysis: Analysis) -> str:
    nodes = analysis.nodes
    reasons = Counter(node.refusal.code for node in nodes if node.refusal)
    if not reasons:
        return "There is nothing to cache: the shader computes no value."
    common = "; ".join(
        f"{count} for {code.code}: a value {code.sentence}"
        for code, count in reasons.most_common(3)
    )
    return (
        f"None of the {len(nodes)} nodes may be cached (mapping: {analysis.mapping}): {common} "
        "(--all lists them)."
    )
