"""Which nodes can be cached together: a set of payloads with one look-up and one refresh rule."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from shadercache.analysis.candidates import FIRST_TEXEL, SECOND_TEXEL, Candidate
from shadercache.analysis.effects import Does
from shadercache.analysis.groups import Group
from shadercache.analysis.instances import Instance, Use
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.source import Source

CHANNELS = FIRST_TEXEL + SECOND_TEXEL


def check_set(
    nodes: Sequence[Candidate], groups: Mapping[Candidate, Group], source: Source
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


def is_skipped(node: Candidate) -> bool:
    """Are there fragments that get a colour without the value, past a branch or a return?"""
    at: Instance | None = node.instance
    place = node.place
    while at is not None and place is not None:
        before = at.places.spine.steps[: place.step.index]
        if place.use is Use.BRANCH or any(step.effects.does & Does.RETURN for step in before):
            return True
        place, at = at.place, at.parent
    return False
