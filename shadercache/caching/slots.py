"""What can be chosen in each slot, and the files of ``glsl/`` that it means.

Where a slot's value is one file, the file has its name; the tables say what else a value means. All
files of a slot have the same functions with the same parameters (docs/TRANSFORMATIONS.md).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import DEFAULT_EPSILON, Configuration
from shadercache.caching.layout import ID, MOST_OF_HALF, OFFSETS, Layout, empty_depth
from shadercache.caching.outcomes import (
    INTERPOLATION,
    LEAST_AREA,
    LEAST_WEIGHT,
    NEARBY,
    REACHES,
    SPREAD,
    STEEPEST,
)

FIRST_MARK, MARKS = 0.75, 8192.0
"""Depths that mark misses, in clip space: the first, and how many steps there are to one. Their
window depths are exact in floats, and in 24 bits none lies near half a step, where what draws and
what a shader writes may be rounded apart."""

MOST_GROUPS = 2047
"""Below the farthest depth; half floats are exact up to there."""

NUMBERS = {
    "SPREAD": str(SPREAD),
    "EPSILON": str(DEFAULT_EPSILON),
    "INTERPOLATION": str(INTERPOLATION),
    "LEAST_WEIGHT": str(LEAST_WEIGHT),
    "NEARBY": str(NEARBY),
    "STEEPEST": str(STEEPEST),
    "LEAST_AREA": str(LEAST_AREA),
    **{name: str(reach) for name, reach in REACHES.items()},
    "MOST_OF_HALF": str(MOST_OF_HALF),
    "FIRST_MARK": str(FIRST_MARK),
    "MARKS": str(MARKS),
}
"""What words in capitals mean that stand for numbers."""

LocateKind: TypeAlias = MappingKind | Literal["user, current"]
"""How a pass finds its texel; the last: the user says where the pixel itself is as well."""

LOCATE: dict[LocateKind, tuple[str, ...]] = {
    "surface": ("locate/surface", "locate/by_motion"),
    "screen": ("locate/screen",),
    "user": ("locate/user_pixel", "locate/by_motion"),
    "user, current": ("locate/user", "locate/by_motion"),
}


@dataclass(frozen=True, slots=True)
class Resampling:
    """The files of a filter: how texels are fetched and tested, what is made of a ``part`` of them
    where they do not agree, and what is made of more of them where they do."""

    fetch: str = "fetch/four"
    test: str = "test/together"
    part: tuple[str, ...] = ()
    more: tuple[str, ...] = ()


RESAMPLE = {
    "bilateral": Resampling(test="test/apart", part=("resample/bilateral", "resample/chosen")),
    "bilinear": Resampling(),
    "nearest": Resampling("fetch/nearest", "test/nearest"),
    "lanczos2": Resampling(more=("resample/lanczos2", "resample/cubic")),
    "mitchell": Resampling(more=("resample/mitchell", "resample/cubic")),
    "carried": Resampling("fetch/around", "test/carried", more=("resample/carried",)),
}

_PIXEL = Resampling("fetch/pixel", "test/pixel")
_FALLBACK = ("resample/fallback",)
_TUCKED = {(): "nothing", OFFSETS: "offsets", (*OFFSETS, ID): "offsets_and_id"}


DEFAULT = Configuration()


@dataclass(frozen=True, slots=True)
class Choice:
    """All that decides the text of the runtime: the payloads' layout and the slots.

    ``whole``: not every fragment has the payloads. ``instanced``: a draw is of several instances.
    """

    layout: Layout
    prefix: str
    whole: bool = False
    located: LocateKind = "surface"
    configuration: Configuration = DEFAULT
    instanced: bool = False

    @property
    def _resampling(self) -> Resampling:
        """The filter, and what it comes to for the payloads at hand."""
        # No integer lies between two others, and the nearest alone may belong to something else.
        chosen = RESAMPLE[self.configuration.filter.kind]
        if self.layout.bits:
            return RESAMPLE["bilinear"] if chosen.fetch == "fetch/nearest" else chosen
        if self.configuration.filter.fallback and chosen.test == "test/together":
            return replace(chosen, test="test/apart", part=_FALLBACK)
        return chosen

    @property
    def _marks(self) -> bool:
        """Are depths marked where a filter makes do with a part of its texels?"""
        return bool(self._resampling.part)

    @property
    def files(self) -> tuple[str, ...]:
        """The files that all passes have."""
        chosen = self.configuration
        turns = chosen.refresh.schedule != "none"
        return (
            "globals",
            "object/instanced" if self.instanced else "object/alone",
            "wide",
            "texel/bits" if self.layout.bits else "texel/floats",
            *(("due/by_turn", f"due/{chosen.refresh.schedule}") if turns else ()),
            *LOCATE[self.located],
            "frame/viewport" if chosen.hit_test.viewport else "frame/whole",
            f"depth/{chosen.storage.depth}",
            f"tolerance/{chosen.hit_test.tolerance}",
            *self._look_up(),
            *self._storage(),
            f"combine/{chosen.combine}",
            *self._rate(),
            "payload/sometimes" if self.whole else "payload/always",
        )

    def _look_up(self) -> tuple[str, ...]:
        chosen, screen = self.configuration, self.located == "screen"
        how = _PIXEL if screen else self._resampling
        tests = {
            # With ages a young payload skips its turn, and only the filter tells how old it is.
            # So do the halvings of its period.
            "test/turn": chosen.refresh.schedule != "none" and not chosen.refresh.judged,
            "test/opt_out": chosen.hit_test.mask,
            # The pixel of a screen is its own texel: it is inside, and as large as it was.
            "test/inside": not screen,
            "test/magnification": chosen.hit_test.magnification and not screen,
            how.test: True,
        }
        between = ("resample/integers",) if self.layout.bits and how.fetch == "fetch/four" else ()
        found = "found/marked" if how.part else "found/unmarked"
        if chosen.refresh.judged and chosen.filter.carries:
            found = "found/raw"
        elif chosen.refresh.judged and how.part:
            found = "found/marked_and_judged"
        return (
            "look_up",
            how.fetch,
            *(name for name, wanted in tests.items() if wanted),
            *(*how.part, *between, *how.more),
            "ids/kept" if chosen.hit_test.ids else "ids/none",
            "mark/moved" if self._marks else "mark/none",
            found,
        )

    def _rate(self) -> tuple[str, ...]:
        if self.configuration.payload_rate == "full":
            return ("rate/full",)
        nearest = self.configuration.filter.kind == "nearest" and not self.layout.bits
        # A filter may have brought the last already.
        chosen = () if "resample/chosen" in self._look_up() else ("resample/chosen",)
        return ("rate/fraction", "rate/nearest" if nearest else "rate/blended", *chosen)

    def _storage(self) -> tuple[str, ...]:
        chosen = self.configuration
        refresh = chosen.refresh
        age: tuple[str, ...] = ("age/none",)
        if refresh.age:
            age = "age/kept", "age/alone" if refresh.schedule == "none" else "age/in_turn"
        elif refresh.adaptive:
            age = ("age/adaptive",)
        return (
            "store/texels",
            "carry/raw" if chosen.filter.carries else "carry/none",
            f"tuck/{_TUCKED[self.layout.tucked]}",
            f"store/{chosen.storage.guard}",
            "opt_out/asked" if chosen.hit_test.mask else "opt_out/never",
            *age,
        )

    def marking(self, looks: bool) -> str:
        """The file on whether a pass marks the depths it stores; ``looks``: does it look up?"""
        marks = self._marks and looks and self.located != "screen"
        return "store/marked" if marks else "store/unmarked"

    @property
    def depths(self) -> tuple[str, str, str]:
        """Depths that match nothing: of an empty texel, of one that must not be reused, and of one
        that this frame is yet to compute."""
        if self.layout.bits:
            ndc = self.configuration.storage.depth == "ndc"
            # Bits of floats: 2.0 or 0.0 for an empty texel, and -2^127, whose sign is a mark.
            return ("0x40000000u" if ndc else "0u"), "0xFF000000u", "0xFE000000u"
        # Nothing that is drawn is as near: as 16/w that is the largest half float, as w the
        # smallest that is not rounded. The sign is a mark, so that it is never taken alone.
        linear = self.configuration.storage.depth == "linear"
        small = self._marks and linear
        poison = "-0.00006103515625" if small else f"-{MOST_OF_HALF}"
        # Objects whose filters differ may share a cache, and what is open in it is marked for all.
        missed = "-0.0001220703125" if linear else "-49152.0"
        return str(empty_depth(self.layout, self.configuration)), poison, missed
