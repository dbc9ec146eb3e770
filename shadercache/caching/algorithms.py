"""The algorithms: one record each. Whoever has to know one of them reads it here.

Makers are functions of ``emit/``, written ``module:function``: a file of makers and a record are
all that an algorithm takes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

COLOR, CACHE, MASK, PARKED = "color", "cache", "mask", "parked"
PREVIOUS, CURRENT = "previous-cache", "current-cache"

Drawn: TypeAlias = Literal["objects", "screen", "groups"]
DepthTest: TypeAlias = Literal["less", "lequal", "always", "equal"]
DepthBuffer: TypeAlias = Literal["shared", "marks"]


@dataclass(frozen=True, slots=True)
class AlgorithmPass:
    """One pass: all objects, or a triangle over the screen, drawn by what ``maker`` builds.
    ``does`` says in a clause what for, where an engine draws it.

    ``targets`` stand at their index; those that are neither colour nor cache live for a frame.
    ``parked`` are as many as are needed. ``reads``: what earlier frames or passes have stored.
    ``on_reset``: is it drawn where nothing is to be reused? ``draws``: of the screen there is a
    triangle for all objects, or (``groups``) one for all that have the same uniforms.
    ``depth_buffer``: the one that objects share, or one of marks, which lives for a frame.
    """

    name: str
    maker: str
    targets: tuple[str, ...]
    reads: tuple[str, ...] = ()
    on_reset: bool = True
    draws: Drawn = "objects"
    depth_test: DepthTest = "less"
    depth_write: bool = True
    depth_buffer: DepthBuffer = "shared"
    does: str = ""


@dataclass(frozen=True, slots=True)
class Algorithm:
    """``name`` is what files, manifests and tables say, ``word`` what the command line takes.

    ``unfit``: the function of ``emit/`` that says why it cannot be used for a payload, if so.
    ``fraction``: its passes where payloads are computed at a fraction of the rate, if it can that.
    ``usual``: is it taken where all are asked for, or only by name?
    """

    name: str
    word: str
    passes: tuple[AlgorithmPass, ...]
    unfit: str | None = None
    fraction: tuple[AlgorithmPass, ...] = ()
    usual: bool = True

    @property
    def branches(self) -> bool:
        """Does one pass both look up and compute, so that a branch is between them?"""
        return any(record.on_reset and PREVIOUS in record.reads for record in self.passes)

    @property
    def reads_back(self) -> bool:
        """Is the payload of a frame read from the cache in that frame?"""
        # What only marks pixels reads which of them have no payload yet.
        return any(CURRENT in record.reads and COLOR in record.targets for record in self.passes)

    @property
    def resets_at_once(self) -> bool:
        """Is a frame after a reset one pass that looks nothing up?"""
        drawn = [record for record in self.passes if record.on_reset]
        return len(drawn) == 1 and not self.branches

    def at_fraction(self) -> Algorithm | None:
        """The same with payloads at a fraction of the rate, if it can that."""
        return replace(self, passes=self.fraction) if self.fraction else None

    def words_of(self, name: str) -> str:
        """What the pass of a name does; of one that is not known its name."""
        records = (*self.passes, *self.fraction)
        return next((record.does for record in records if record.name == name), name)

    def file_of(self, record: AlgorithmPass) -> str:
        """The name of a pass's files, without their endings."""
        return self.name if len(self.passes) == 1 else f"{self.name}.{record.name}"


_FIND_OR_DISCARD = AlgorithmPass(
    "reuse",
    "three_passes:reuse",
    (CACHE,),
    (PREVIOUS,),
    on_reset=False,
    does="hits copy the cached value, misses are discarded: depth stays open",
)
_PAYLOAD_ALONE = AlgorithmPass(
    "payload",
    "three_passes:payload_only",
    (CACHE,),
    does="the value alone, where depth is still open",
)
_FROM_THIS_FRAME = "the colour, from the values of this frame"

# The first three are those of Sitthi-amorn et al. 2008.
ALGORITHMS = (
    Algorithm(
        "1-pass",
        "1",
        (
            AlgorithmPass(
                "shade",
                "one_pass:shade_or_reuse",
                (COLOR, CACHE),
                (PREVIOUS,),
                does="hits are shaded from the cache, the others compute the value",
            ),
        ),
        unfit="one_pass:unfit",
    ),
    Algorithm(
        "2-pass",
        "2",
        (
            # Hits write their depth, so the second pass fails the early depth test there: nothing
            # else keeps it from shading all pixels again.
            AlgorithmPass(
                "hit",
                "two_passes:hit",
                (COLOR, CACHE),
                (PREVIOUS,),
                on_reset=False,
                does="hits are shaded from the cache, misses discarded: their depth stays open",
            ),
            AlgorithmPass(
                "miss",
                "two_passes:miss",
                (COLOR, CACHE),
                does="the whole shader, where depth is still open",
            ),
        ),
    ),
    Algorithm(
        "3-pass",
        "3",
        (
            _FIND_OR_DISCARD,
            _PAYLOAD_ALONE,
            # The visible surface has been drawn twice already: equal depth is the winner.
            AlgorithmPass(
                "shade",
                "three_passes:shade",
                (COLOR,),
                (CURRENT,),
                depth_test="lequal",
                does=_FROM_THIS_FRAME,
            ),
        ),
        unfit="three_passes:unfit",
        # The first two draw into a cache that is smaller than the picture, with a depth of its own.
        fraction=(
            _FIND_OR_DISCARD,
            _PAYLOAD_ALONE,
            AlgorithmPass(
                "shade",
                "upsampling:shade",
                (COLOR,),
                (CURRENT,),
                does=_FROM_THIS_FRAME,
            ),
            AlgorithmPass(
                "rest",
                "upsampling:rest",
                (COLOR,),
                does="the whole shader, for pixels that no texel of the smaller cache fits",
            ),
        ),
    ),
    Algorithm(
        "parked",
        "parked",
        (
            AlgorithmPass(
                "find",
                "parked:find",
                (COLOR, CACHE, PARKED),
                (PREVIOUS,),
                does="hits are shaded from the cache, misses park what the rest needs",
            ),
            # A depth for each pixel that waits, so that what comes next fails the early depth test
            # at all others. It is another buffer: that of the objects must stay as it is.
            AlgorithmPass(
                "mark",
                "parked:mark",
                (),
                (CURRENT,),
                draws="screen",
                depth_test="always",
                depth_buffer="marks",
                does="a depth for each pixel that misses; the next pass skips the others",
            ),
            AlgorithmPass(
                "fix-up",
                "parked:fix_up",
                (COLOR, CACHE),
                (PARKED,),
                draws="groups",
                depth_test="equal",
                depth_write=False,
                depth_buffer="marks",
                does="the whole shader for misses, from what they have parked",
            ),
        ),
        unfit="parked:unfit",
        usual=False,
    ),
)
"""In the order of their passes; where one of the usual ones has to be chosen without reason, the
last that fits."""

DEFAULT = "2-pass"
"""What a configuration takes where nothing is said."""

NAMES = tuple(record.name for record in ALGORITHMS)
USUAL = tuple(record.name for record in ALGORITHMS if record.usual)
"""Those that are meant by all."""

PROMISING = ("2-pass", "parked", "3-pass", "1-pass")
"""In the order in which they are tried where one is chosen: what pays more often comes first."""

FRACTIONAL = next(record.name for record in ALGORITHMS if record.fraction)
"""What computes payloads at a fraction of the rate."""

PROFILED, FIRST = "2-pass", "hit"
"""The algorithm of which a profile is taken, and its pass that looks up."""

LeftOut: TypeAlias = Literal["look-up", "look-up and store"]
"""What the first pass may do without, to measure what that costs."""

_FOUND = {"look-up": ("found", (COLOR, CACHE)), "look-up and store": ("found_unstored", (COLOR,))}


def without(left_out: LeftOut) -> Algorithm:
    """Two passes that leave something out. What they draw is not the picture: it is timed."""
    whole = _BY_NAME[PROFILED]
    maker, targets = _FOUND[left_out]
    first = replace(whole.passes[0], maker=f"side_passes:{maker}", targets=targets, reads=())
    return replace(whole, passes=(first, *whole.passes[1:]))


def algorithm(name: str) -> Algorithm:
    """The record of an algorithm. Raises :class:`KeyError` for a name that is not in the table."""
    return _BY_NAME[name]


_BY_NAME = {record.name: record for record in ALGORITHMS}
