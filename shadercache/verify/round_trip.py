"""Law 1: the printed shader renders the bits of the user's own text."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.analysed import written
from shadercache.compiler import emit_original
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.source import Source
from shadercache.transform.versions.leave_discarded import leave_discarded
from shadercache.verify.laws import apart, between
from shadercache.verify.references import MOVING, References
from shadercache.verify.verdict import Difference, Image, worst_of

_NONE = Difference()


@dataclass(frozen=True, slots=True)
class RoundTrip:
    """How far the printed shader is from the user's own text.

    ``by_rule``: what it changes of the picture that the version to which the shader is raised lets
    a ``discard`` end loops. It is no part of ``found``.
    """

    found: Difference
    by_rule: Difference = _NONE

    @property
    def exact(self) -> bool:
        """Does the law hold?"""
        return self.found.exact

    def __str__(self) -> str:
        return str(self.found)


def round_trip(references: References) -> RoundTrip | None:
    """Compare the printed shader with the user's own text.

    ``None`` where there is nothing to compare with: the text does not stand alone, or it was
    raised and reads the state of the fixed-function pipeline, or the driver does not take its
    version.
    """
    text = written(references.analysis)
    if text is None:
        return None
    try:
        own = _drawn(references, text)
    except InputError:
        return None
    found = apart(references, "plain", own)
    stepwise = None if found.exact else _in_two_steps(references, text, own)
    return RoundTrip(found) if stepwise is None else RoundTrip(stepwise, found)


def _in_two_steps(references: References, text: str, own: list[Image]) -> Difference | None:
    """How far a text is from its print, where raising it lets a ``discard`` end loops.

    Loops with that exit are not unrolled, so that a driver calculates other values itself; and
    levels of detail in them, which are undefined behind a ``discard``, are others
    (:mod:`transform.versions.leave_discarded`). No bound on rounding would fit: what is rounded
    decides conditions. But the exit can be written out in the older version as well. So two steps
    are compared, each to the bit: the text with its print in the same version, and that print with
    the exits with what was raised. ``None`` for other texts, and where the driver does not take
    what is printed.
    """
    module = parse(Source(references.analysis.fragment.name, text))
    leaving = leave_discarded(module, references.analysis.program.prefix)
    # A rewrite that finds nothing to change returns the very tree.
    if leaving is module:
        return None
    try:
        printed, left = (_drawn(references, print_module(item)) for item in (module, leaving))
    except InputError:
        return None
    return worst_of((between(own, printed, references.covered), apart(references, "plain", left)))


def _drawn(references: References, text: str) -> list[Image]:
    """The images of the printed original with another fragment shader in it."""
    analysis = references.analysis
    files = {"original.vert": analysis.vertex_source.text, "original.frag": text}
    bundle = Bundle(emit_original(analysis, "plain").manifest, files)
    with OriginalRunner(references.world, *references.linker.originals(bundle=bundle)) as runner:
        return [runner.image(frame) for frame in MOVING]
