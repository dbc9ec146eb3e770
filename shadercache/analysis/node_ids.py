"""The ids of nodes.

``noise.4-1f0c22ab`` is the expression with the number 4 in ``noise``. Behind the dash stands a
digest of the functions on the call path as they are written, and of which calls it takes, so that
edits elsewhere leave an id alone. Of nodes that share so short a digest each has a longer one
behind it. Where edits elsewhere have left it alone with the short one, it is known by both.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from hashlib import blake2b

from shadercache.analysis.call_paths import Instance, Place

SHORT = 4
"""Bytes of the digest in every id. Where 10,000 paths lead to a function, two of them share one in
every hundredth shader."""

LONG = 12
"""Bytes of that behind it: no two nodes share both."""


class NodeIds:
    """Makes the ids of one shader's nodes.

    ``printed``: the text of each function and initialised global, by its name.
    """

    def __init__(self, instances: tuple[Instance, ...], printed: Mapping[str, str]) -> None:
        self._instances, self._printed = instances, printed
        self._short = self._paths(SHORT)

    def short(self, instance: Instance, place: Place) -> str:
        """The id of an expression on a call path, if no other node has it."""
        mark = "u" if instance.unrolled else ""
        stem = f"{instance.places.function.name}.{place.ordinal}{mark}"
        return f"{stem}-{_digest(SHORT, self._short[instance], str(place.ordinal))}"

    def long(self, instance: Instance, place: Place) -> str:
        """The id that no other node has."""
        rest = _digest(LONG, self._long[instance], str(place.ordinal))
        return self.short(instance, place) + rest

    def of_initialiser(self, name: str, number: int) -> str:
        """The id of an expression in the initialiser of a global: there is one path to it."""
        return f"{name}.{number}-{_digest(SHORT, self._printed[name], str(number))}"

    @cached_property
    def _long(self) -> dict[Instance, str]:
        return self._paths(LONG)

    def _paths(self, size: int) -> dict[Instance, str]:
        """A digest of every call path: the functions on it as written, and which calls it takes."""
        digests: dict[Instance, str] = {}
        for instance in self._instances:
            # With its loops taken apart the same text has other expressions under the same numbers.
            own = self._printed[instance.places.function.name] + (
                " unrolled" if instance.places.unrolled else ""
            )
            above: tuple[str, ...] = ()
            if instance.parent is not None and instance.place is not None:
                above = (digests[instance.parent], str(instance.place.ordinal))
            digests[instance] = _digest(size, *above, own)
        return digests


def _digest(size: int, *parts: str) -> str:
    return blake2b("\0".join(parts).encode(), digest_size=size).hexdigest()
