"""What holds objects of OpenGL gives them back at the end of a ``with`` block."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Self


class Resource(ABC):
    """Has ``release``, and calls it when its ``with`` block ends."""

    @abstractmethod
    def release(self) -> None:
        """Give back whatever this holds."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()
