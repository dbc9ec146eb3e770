"""What is drawn: for each object of a scene a configuration, or its original."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

from shadercache.caching.configuration import Configuration


@dataclass(frozen=True, slots=True)
class Assignment:
    """``objects``: the name of each, in the scene's order, and its configuration; None: its
    original draws it."""

    objects: tuple[tuple[str, Configuration | None], ...]

    def with_originals(self, names: Collection[str]) -> Assignment:
        """The same, but some objects are drawn by their originals."""
        return Assignment(
            tuple((name, None if name in names else chosen) for name, chosen in self.objects)
        )

    def to_json(self) -> list[dict[str, Any]]:
        """Plain data: each configuration with the objects that have it, null for originals."""
        groups: dict[Configuration | None, list[str]] = {}
        for name, chosen in self.objects:
            groups.setdefault(chosen, []).append(name)
        return [
            {"objects": names, "configuration": None if chosen is None else chosen.to_json()}
            for chosen, names in groups.items()
        ]
