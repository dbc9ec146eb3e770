"""What draws an object of a scene: finished programs, and how they are run."""

from __future__ import annotations

from dataclasses import dataclass, replace

from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import Configuration
from shadercache.render.bundle import Bundle


@dataclass(frozen=True, eq=False)
class LinkedObject:
    """The programs of one object, and the configuration it is drawn by; None: its original."""

    bundle: Bundle
    configuration: Configuration | None = None

    def by(self, algorithm: str) -> LinkedObject:
        """The same by an algorithm, or by the last in the table that the object has instead.

        Without any it is drawn by its original.
        """
        have = self.bundle.algorithms if self.bundle.has_variants else ()
        fit = [algorithm, *reversed(NAMES)]
        chosen = next((name for name in fit if name in have), None)
        if self.configuration is None or chosen is None:
            return LinkedObject(self.bundle)
        return LinkedObject(self.bundle, replace(self.configuration, algorithm=chosen))
