"""Which nodes can be cached together: a set of payloads with one look-up and one refresh rule."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from shadercache.analysis.call_paths import Instance, Use
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.cost import FETCH
from shadercache.analysis.costs.shared_work import SharedWorkTable
from shadercache.analysis.effects import Does
from shadercache.analysis.refusals import FIRST_TEXEL, SECOND_TEXEL
from shadercache.analysis.value_numbering import ValueGroup
from shadercache.diagnostics import Diagnostic, InputError, Severity, shortened
from shadercache.source import Source

CHANNELS = FIRST_TEXEL + SECOND_TEXEL


def check_set(
    nodes: Sequence[Candidate], groups: Mapping[Candidate, ValueGroup], source: Source
) -> None:
    """Raise :class:`InputError` where nodes, each of which may be cached, cannot be so together.

    SC415: two of them are one, or have the same value; SC416: they need too many channels.
    """
    for one, other in combinations(nodes, 2):
        if one is other:
            message = f"'{one.text}' ({one.id}) is in the set twice"
            raise InputError(Diagnostic("SC415", message, source, one.expr.span))
        if groups[one] is groups[other]:
            message = f"'{other.text}' ({other.id}) has the same value as '{one.text}' ({one.id})"
            hint = "leave one of them out"
            raise InputError(Diagnostic("SC415", message, source, other.expr.span, hint))
    wide = [node.type.components_or_one for node in nodes]
    if sum(wide) > CHANNELS:
        needed = " + ".join(map(str, wide))
        message = f"the set needs {needed} = {sum(wide)} channels; two cache texels have {CHANNELS}"
        raise InputError(Diagnostic("SC416", message, source, nodes[-1].expr.span))


def check_needed(unneeded: Sequence[Candidate], source: Source) -> None:
    """Raise :class:`InputError` SC417 for nodes of a set that feed only others of it, if any."""
    hint = "leave it out of the set"
    message = "is not needed where the rest of the set is reused"
    problems = [
        Diagnostic("SC417", f"'{node.text}' ({node.id}) {message}", source, node.expr.span, hint)
        for node in unneeded
    ]
    if problems:
        raise InputError(problems)


def notes_on(nodes: Sequence[Candidate], source: Source) -> tuple[Diagnostic, ...]:
    """What a set costs where not every fragment has all its values: SC418."""
    if len(nodes) == 1:
        return ()
    message = (
        "is not computed in every fragment; where it is not, the others of the set are computed "
        "anew in every frame"
    )
    return tuple(
        Diagnostic(
            "SC418", f"'{node.text}' {message}", source, node.expr.span, severity=Severity.NOTE
        )
        for node in nodes
        if is_skipped(node)
    )


def companion(
    nodes: Sequence[Candidate], groups: Mapping[Candidate, ValueGroup], overlaps: SharedWorkTable
) -> Candidate | None:
    """What to cache along with ``nodes`` so that both passes compute the least twice.

    ``None`` where nothing that fits beside them saves more than the fetch that it may cost.
    """
    free = CHANNELS - sum(node.type.components_or_one for node in nodes)
    taken = {groups[node] for node in nodes}
    now = overlaps.parts(nodes).overlap
    choices: list[tuple[float, int, float, int]] = []
    firsts = [group.first for group in dict.fromkeys(groups.values()) if group not in taken]
    for number, node in enumerate(firsts):
        width = node.type.components_or_one if node.offered else CHANNELS + 1
        # What travels along is a part of what is shared, and more than a fetch of it. Where one
        # value is missing in a texel, the next frame finds none of the set there (SC418).
        if width > free or not FETCH < node.cost <= now + FETCH or is_skipped(node):
            continue
        parts = overlaps.parts((*nodes, node))
        if parts.overlap < now - FETCH:
            # Among equals the narrowest, then what leaves the least to shade, then the first.
            choices.append((parts.overlap, width, parts.remainder, number))
    return firsts[min(choices)[-1]] if choices else None


def note_on_overlap(
    nodes: Sequence[Candidate], other: Candidate, overlaps: SharedWorkTable, source: Source
) -> Diagnostic:
    """SC423: what both passes compute, and what caching another value along leaves of it."""
    now, then = overlaps.parts(nodes), overlaps.parts((*nodes, other))
    whole = now.whole or 1.0
    message = (
        f"payload and shading both compute {now.overlap / whole:.0%} of the shader; with "
        f"'{shortened(other.text, 60)}' ({other.id}) in the cache too they share "
        f"{then.overlap / whole:.0%}"
    )
    return Diagnostic("SC423", message, source, other.expr.span, "--carry does so", Severity.NOTE)


def is_skipped(node: Candidate) -> bool:
    """Are there fragments that get a colour without the value, past a branch or a return?"""
    at: Instance | None = node.instance
    place = node.place
    while at is not None and place is not None:
        # Discards in front do not count: what they end gets no colour.
        before = at.places.reaching.steps[: place.step.index]
        if place.use is Use.BRANCH or any(step.effects.does & Does.RETURN for step in before):
            return True
        place, at = at.place, at.parent
    return False
