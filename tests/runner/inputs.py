"""Gives a program what the manifest says that it wants: uniforms, textures, blocks, and twins."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import moderngl


class Given(NamedTuple):
    """What a draw has: the engine's values of this and the last frame, numbers and caches by role.

    Values stand under the names that GL has for uniforms (``light.place``, ``lights[1].place``) and
    blocks (``Camera``, ``Cameras[1]``); those of blocks are bytes.
    """

    now: Mapping[str, Any]
    last: Mapping[str, Any]
    numbers: Mapping[str, Any]
    caches: Mapping[str, moderngl.Texture]


class Inputs:
    """What a manifest lists under ``inputs`` and ``uniforms``."""

    def __init__(
        self,
        ctx: moderngl.Context,
        manifest: Mapping[str, Any],
        textures: Mapping[str, moderngl.Texture | moderngl.TextureCube],
    ) -> None:
        self.textures = textures
        self.told = {item["name"]: item for item in (*manifest["inputs"], *manifest["uniforms"])}
        self.points = _points(manifest["inputs"])
        self.buffers: dict[str, moderngl.Buffer] = {}
        self.ctx = ctx

    def give(self, program: moderngl.Program, declared: list[str], given: Given) -> None:
        """Set everything that the program has; ``declared``: the pass's ``uniforms``."""
        units = itertools.count()
        for name in program:
            member = program[name]
            if isinstance(member, moderngl.Attribute):
                continue
            root = re.split(r"[.\[]", name, maxsplit=1)[0]
            assert root in declared, f"the manifest does not tell of {name}"
            item = self.told[root]
            if item.get("kind") == "uniform block":
                for index, element in self._elements(member, item):
                    self._bind(member, index, element, _value(item, element, given))
            elif "sampler" in item["type"]:
                texture = given.caches[item["role"]] if "role" in item else self.textures[root]
                member.value = next(units)
                texture.use(member.value)
            elif "role" in item:
                member.value = given.numbers[item["role"]]
            else:
                member.value = _value(item, name, given)

    @staticmethod
    def _elements(
        block: moderngl.UniformBlock, item: Mapping[str, Any]
    ) -> Iterator[tuple[int, str]]:
        """The blocks of an array, with their numbers: moderngl knows the last of them alone."""
        names = _elements(item)
        first = block.index - len(names) + 1
        return enumerate(names, first)

    def _bind(self, block: moderngl.UniformBlock, index: int, name: str, content: bytes) -> None:
        if name not in self.buffers:
            self.buffers[name] = self.ctx.buffer(reserve=block.size)
        self.buffers[name].write(content[: block.size])
        block.ctx._set_ubo_binding(block.program_obj, index, self.points[name])
        self.buffers[name].bind_to_uniform_block(self.points[name])


def _value(item: Mapping[str, Any], name: str, given: Given) -> Any:
    """This frame's value, or for a twin the one that its original had in the last."""
    original = item.get("previous_of")
    if original is None:
        return given.now[name]
    return given.last[original + name[len(item["name"]) :]]


def _points(inputs: list[Mapping[str, Any]]) -> dict[str, int]:
    """A binding point for each block: the declared one, or one that no other has."""
    blocks = [item for item in inputs if item["kind"] == "uniform block"]
    points = {
        name: item["binding"] + at
        for item in blocks
        if item["binding"] is not None
        for at, name in enumerate(_elements(item))
    }
    free = (point for point in itertools.count() if point not in set(points.values()))
    for item in blocks:
        if item["binding"] is None:
            points |= {name: next(free) for name in _elements(item)}
    return points


def _elements(block: Mapping[str, Any]) -> list[str]:
    """The names of the elements of an array of blocks; the name of a block that is none."""
    ranges = (range(size) for size in block["dims"])
    return [
        block["name"] + "".join(f"[{at}]" for at in place) for place in itertools.product(*ranges)
    ]
