"""The programs of each object of a scene, which whoever links the scene hands to the renderer."""

from __future__ import annotations

from typing import Protocol

from shadercache.render.bundle import Bundle
from shadercache.scene.description import SceneObject

NEAREST = ("3-pass", "2-pass", "1-pass")
"""What an object is drawn with that has not the algorithm that is asked for, the first it has."""


class ObjectBundles(Protocol):
    """Knows the programs of objects that have shaders of their own."""

    def named(self, item: SceneObject) -> SceneObject:
        """The object with its inputs under the names that its programs have for them."""

    def bundle(self, item: SceneObject, like: Bundle) -> Bundle:
        """The object's programs, by the options of ``like``, which are the scene's own."""


class SharedPrograms:
    """Of scenes in which no object has shaders of its own."""

    def named(self, item: SceneObject) -> SceneObject:
        """The object as it is. Raises :class:`ValueError` for one with shaders of its own."""
        if item.own_shader:
            raise ValueError(f"{item.name} has shaders of its own, and nothing compiles them")
        return item

    def bundle(self, item: SceneObject, like: Bundle) -> Bundle:
        """The scene's."""
        return like


def algorithm_of(bundle: Bundle, wanted: str) -> str | None:
    """The variant that draws an object: the wanted one, or what it has. None: its original."""
    have = bundle.algorithms if "variants" in bundle.manifest else ()
    if wanted in have:
        return wanted
    return next((name for name in NEAREST if name in have), None)
