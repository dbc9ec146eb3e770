"""One pass as the harness draws it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from shadercache.caching.algorithms import Drawn
from shadercache.gpu.color_targets import ColorTarget
from shadercache.manifest.interface import InputEntry
from shadercache.render.depth_spec import DepthSpec
from shadercache.source import Source


@dataclass(frozen=True, eq=False)
class PassSpec:
    """One draw of all objects, or of one triangle over the screen for all of them, or for those of
    a group.

    Targets stand at their index; ``colors`` are those of the user's outputs. ``looks``: does
    it look up what the last frame stored? ``parked``: the formats of what is parked. ``inputs``:
    what it declares of the user's, and the twins. ``divisor``: how many times smaller than the
    picture the targets are, in each direction.
    """

    name: str
    vertex: Source
    fragment: Source
    targets: tuple[str, ...] = ("color",)
    colors: tuple[ColorTarget, ...] = ()
    depth: DepthSpec = field(default_factory=DepthSpec)
    on_reset: bool = False
    looks: bool = False
    draws: Drawn = "objects"
    parked: Mapping[str, str] = field(default_factory=dict)
    inputs: tuple[InputEntry, ...] = ()
    divisor: int = 1

    @property
    def locations(self) -> dict[str, int]:
        """Where the user's outputs stand; the text of the original need not say it."""
        # Of an array the first target counts.
        placed = reversed(list(enumerate(self.colors)))
        return {color.output: at for at, color in placed}


class NeededPass(NamedTuple):
    """Tells which pixels have payloads (1), do without (2), or have some that a guard keeps from
    being reused (3). ``by_some``: may there be pixels without?"""

    spec: PassSpec
    by_some: bool
