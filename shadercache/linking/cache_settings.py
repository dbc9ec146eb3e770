"""The settings of a cache in a scene."""

from __future__ import annotations

from collections.abc import Sequence

from shadercache.caching.configuration import Configuration
from shadercache.caching.layout import MOST_IN_HALF
from shadercache.caching.settings import with_settings
from shadercache.scene.description import Scene


def configured(
    scene: Scene, configuration: Configuration, settings: Sequence[str] | None
) -> Configuration:
    """A configuration with the settings of ``--cache``. Raises :class:`UsageError` SC028.

    Objects and instances that share a cache are told apart by their numbers, unless ``ids=off`` is
    said.
    """
    drawn = (part.inputs.instances.number for part in scene.parts if part.caching.on)
    # Half floats tell no more of them apart.
    several = ["ids=on"] if 1 < sum(drawn) <= MOST_IN_HALF else []
    # The user's settings come last, for the last one holds.
    return with_settings(configuration, [*several, *(settings or ())])
