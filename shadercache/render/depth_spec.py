"""What a pass does with depth, as moderngl has it."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.gpu.fractions import WhichDepth
from shadercache.manifest.pass_model import DepthEntry

_TESTS = {"less": "<", "lequal": "<=", "always": "1", "equal": "=="}


@dataclass(frozen=True, slots=True)
class DepthSpec:
    """The depth function as moderngl has it, and the buffer: that which objects share, another one
    for targets of another size, or that of marks."""

    test: str = "<"
    write: bool = True
    buffer: WhichDepth = "shared"


def depth_spec(entry: DepthEntry, apart: bool) -> DepthSpec:
    """Of what a manifest says; ``apart``: are the targets of another size than the picture?"""
    return DepthSpec(_TESTS[entry.test], entry.write, "apart" if apart else entry.buffer)
