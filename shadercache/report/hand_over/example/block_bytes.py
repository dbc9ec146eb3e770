"""The bytes of a uniform block that is laid out by std140, from the values of its members."""

from __future__ import annotations

import numpy as np
from msgspec import UNSET
from numpy.typing import NDArray

from shadercache.gpu.uniform_blocks import block_uniforms
from shadercache.manifest.interface import UniformBlockInput
from shadercache.scene.camera import Values


class _Words:
    """Words in memory."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.words = np.zeros(-(-size // 4), np.uint32)

    def write(self, words: list[int], data: bytes) -> None:
        """Set some of them."""
        self.words[words] = np.frombuffer(data, np.uint32)


def block_bytes(block: UniformBlockInput, values: Values, giver: str) -> NDArray[np.uint8]:
    """The bytes of a block; ``giver`` is who has the values, for messages.

    Raises:
        InputError: SC524 for another layout, SC523 for a value of a wrong size.
    """
    held = _Words(0 if block.size is UNSET else block.size)
    for member in block_uniforms(giver, [block], {block.name: held}):
        member.write(member.encode(values[member.name], giver))
    return held.words.view(np.uint8)
