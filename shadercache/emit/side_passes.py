"""The makers of passes beside those of an algorithm, for who measures, counts and checks."""

from __future__ import annotations

from shadercache.analysis.candidates import Candidate
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.emit.three_passes import shade
from shadercache.transform.reachable import names_in
from shadercache.transform.specialise import Clones


def payload_alone(builder: PassBuilder) -> Shader:
    """The payloads in place of the colour, for their cost (P of P/T)."""
    return builder.build("payload_alone", [_payloads(builder)], [builder.own("value")])


def hit_mask(builder: PassBuilder) -> Shader:
    """What the look-up says, for the eyes and for the hit rate."""
    clones = [builder.cut("keep")] if builder.whole else []
    return builder.build("hit_mask", clones, [builder.own("outcome")])


def needed(builder: PassBuilder) -> Shader:
    """Which pixels have payloads: other programs store them, and hits are a share of those."""
    return builder.build("needed", [_payloads(builder)], [builder.own("outcome")])


def found(builder: PassBuilder) -> Shader:
    """The first of two passes without its look-up: every pixel is a hit."""
    return builder.build("found", [_reusing(builder)], builder.colors_and_stores)


def found_unstored(builder: PassBuilder) -> Shader:
    """The same, storing nothing for the next frame."""
    return builder.build("found", [_reusing(builder)], builder.program.colors)


def _reusing(builder: PassBuilder) -> Clones:
    return builder.cut("need" if builder.whole else "use")


def _payloads(builder: PassBuilder) -> Clones:
    return builder.cut("keep" if builder.whole else "goal")


def unneeded(builder: PassBuilder) -> tuple[Candidate, ...]:
    """The nodes that the colour does not need where the others are reused."""
    named = names_in(builder.made(shade).module)
    pairs = zip(builder.nodes, builder.payloads, strict=True)
    return tuple(node for node, payload in pairs if payload not in named)
