"""Where a fragment finds what the previous frame stored."""

from __future__ import annotations

from typing import Literal, TypeAlias

MappingKind: TypeAlias = Literal["surface", "screen", "user"]
"""Where its point of the surface was then, at its own pixel, or where a function of the user's says
(docs/TRANSFORMATIONS.md)."""

PREVIOUS_CLIP, CURRENT_CLIP = "scPreviousClip", "scCurrentClip"
"""The user's functions that ``user`` calls; without the second the pixel's own place is taken."""
