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
        self.roles = {item["name"]: item["role"] for item in manifest["uniforms"]}
        self.listed = {item["name"]: item for item in manifest["inputs"]}
        self.points = _points(list(self.listed.values()))
        self.buffers: dict[str, moderngl.Buffer] = {}
        self.ctx = ctx

    def give(self, program: moderngl.Program, declared: list[str], given: Given) -> None:
        """Set everything that the program has; ``declared``: the pass's ``uniforms``."""
        units = itertools.count()
        for name in program:
            member = program[name]
            root = re.split(r"[.\[]", name, maxsplit=1)[0]
            if isinstance(member, moderngl.Uniform | moderngl.UniformBlock):
                assert root in declared, f"the manifest does not tell of {name}"
            if isinstance(member, moderngl.UniformBlock):
                for index, element in self._elements(member, root):
                    self._bind(member, index, element, self._value(root, element, given))
            elif isinstance(member, moderngl.Uniform):
                self._set(member, root, given, units)

    def _value(self, root: str, name: str, given: Given) -> Any:
        """This frame's value, or for a twin the one that its original had in the last."""
        original = self.listed[root].get("previous_of")
        return given.now[name] if original is None else given.last[original + name[len(root) :]]

    def _set(
        self, uniform: moderngl.Uniform, root: str, given: Given, units: Iterator[int]
    ) -> None:
        role = self.roles.get(root)
        if role is not None and role not in given.caches:
            uniform.value = given.numbers[role]
        elif role is not None or root in self.textures:
            texture = given.caches[role] if role is not None else self.textures[root]
            uniform.value = next(units)
            texture.use(uniform.value)
        else:
            uniform.value = self._value(root, uniform.name, given)

    def _elements(self, block: moderngl.UniformBlock, root: str) -> Iterator[tuple[int, str]]:
        """The blocks of an array, with their numbers: moderngl knows the last of them alone."""
        names = _elements(self.listed[root])
        first = block.index - len(names) + 1
        return enumerate(names, first)

    def _bind(self, block: moderngl.UniformBlock, index: int, name: str, content: bytes) -> None:
        if name not in self.buffers:
            self.buffers[name] = self.ctx.buffer(reserve=block.size)
        self.buffers[name].write(content[: block.size])
        block.ctx._set_ubo_binding(block.program_obj, index, self.points[name])
        self.buffers[name].bind_to_uniform_block(self.points[name])


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
