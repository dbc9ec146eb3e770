"""What each object of the example has for itself: its number, its group, a period of its own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from shadercache.manifest.pass_model import Role
from shadercache.report.hand_over.example.example_data import ExampleData, ExampleObject
from shadercache.report.hand_over.example.example_values import collapsed
from shadercache.report.hand_over.handed_shaders import HandedShader
from shadercache.scene.object_inputs import root_of


def has_own_periods(shaders: Iterable[HandedShader]) -> bool:
    """Do cached objects differ in their periods or blocks?"""
    chosen = [
        item.configuration.refresh
        for shader in shaders
        for item in shader.cached
        if item.configuration is not None
    ]
    return len({(refresh.period, refresh.block) for refresh in chosen}) > 1


def _groups(shader: HandedShader, data: ExampleData) -> list[int]:
    """The number of each object's group: objects are of one where all is equal that passes over
    the screen read of them. Those of all shaders are told apart."""
    first = max((number for groups in data.groups.values() for number in groups), default=0) + 1
    known: dict[tuple[object, ...], int] = {}
    return [
        known.setdefault(_key(shader, data, row, item), first + len(known))
        for row, item in enumerate(data.objects[shader])
    ]


def add_own_values(shader: HandedShader, data: ExampleData) -> None:
    """A table of each added uniform that is the same in all frames; ``data`` has the others."""
    data.groups[shader] = _groups(shader, data)
    refreshes = [item.configuration for item in shader.objects]
    own: Mapping[Role, list[int]] = {
        "object": [item.number for item in shader.objects],
        "mask": [item.part.caching.mask for item in shader.objects],
        "group": data.groups[shader],
        "period": [one.refresh.period if one else 1 for one in refreshes],
        "block": [one.refresh.block if one else 2 for one in refreshes],
    }
    for uniform in shader.added:
        numbers = own.get(uniform.role, [uniform.default])
        if uniform.role in own or uniform.default is not None:
            kind = np.int32 if uniform.type == "int" else np.float32
            table = collapsed(np.array(numbers, kind)[:, None, None])
            data.arrays[f"values/{shader.folder}{uniform.name}"] = table


def _key(
    shader: HandedShader, data: ExampleData, row: int, item: ExampleObject
) -> tuple[object, ...]:
    """What passes over the screen read of an object."""
    read = {name for one in shader.passes if one.draws == "groups" for name in one.uniforms}
    start = f"values/{shader.folder}"
    tables = (
        table[row % len(table)].tobytes()
        for key, table in data.arrays.items()
        if key.startswith(start) and root_of(key.removeprefix(start)) in read
    )
    cached = item.given.configuration is not None
    return (cached, *tables, *(item.textures.get(name) for name in sorted(read)))
