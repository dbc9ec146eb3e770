"""The makers of passes behind a payload pass at a fraction of the rate: pixels take their payloads
from the texels around them, and those that cannot are drawn by the whole shader."""

from __future__ import annotations

from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder, exact_original
from shadercache.emit.two_passes import discards_late


def shade(builder: PassBuilder) -> Shader:
    """The colour from payloads of texels around the pixel; what none fits is discarded."""
    clones, outputs = [builder.cut("use")], builder.program.colors
    early = builder.build("neighbours", clones, outputs)
    if not discards_late(builder, early):
        return early
    return builder.build("neighbours_late", clones, outputs)


def rest(builder: PassBuilder) -> Shader:
    """The unchanged shader, for the pixels that are still open."""
    return exact_original(builder.program)
