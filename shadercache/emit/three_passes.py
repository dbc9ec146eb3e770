"""The makers of three passes: payloads are carried over, then computed, then shaded with."""

from __future__ import annotations

from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder


def reuse(builder: PassBuilder) -> Shader:
    """Carry payloads over; misses are discarded, and what the shader discards."""
    early = builder.build("reuse", [builder.cut("use")] if builder.whole else [], builder.stores)
    # Behind the discard of misses its derivatives would be undefined.
    if not builder.takes_derivatives(early.module):
        return early
    return builder.build("reuse_late", [builder.cut("use")], builder.stores)


def payload_only(builder: PassBuilder) -> Shader:
    """Compute payloads."""
    if builder.whole:
        return builder.build("miss", [builder.cut("keep")], builder.stores)
    return builder.build("payload", [builder.cut("goal")], builder.stores)


def shade(builder: PassBuilder) -> Shader:
    """The colour from the payload."""
    return builder.build("shade", [builder.cut("use")], builder.program.colors)


def unfit(builder: PassBuilder) -> str | None:
    """Why the nodes cannot be cached in three passes, if so."""
    if builder.carries:
        return (
            "with filter=carried the first of three passes would have to store what is shown "
            "beside what is kept"
        )
    if not builder.decides_loops:
        return None
    return (
        "the value decides how long a loop runs, and in the last of three passes fragments "
        "along edges read the payloads of others, with which it might never end"
    )
