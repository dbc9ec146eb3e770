"""Caching the colour itself: the node is the value that the shader writes in the end."""

from __future__ import annotations

from bench.peers.scene_programs import color_assignment
from shadercache.caching.configuration import Assignment, Configuration
from shadercache.linking.linker import Linker
from shadercache.measure.subjects import VariantSubject


def final_color(linker: Linker, label: str, configuration: Configuration) -> VariantSubject:
    """The colour of every object that the scene wants cached, by a configuration without nodes.

    An object that cannot be drawn by its algorithm is drawn by another one.

    Raises as ``color_node`` and ``Linker.link``.
    """
    assignment: Assignment = color_assignment(linker, configuration)
    chosen = next(one for _, one in assignment.objects if one is not None)
    return VariantSubject(label, chosen, linker.link(assignment), assignment)
