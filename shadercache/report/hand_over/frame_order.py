"""Which passes of which shader come when: all objects finish a pass before the next begins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from shadercache.manifest.pass_model import PassEntry
from shadercache.report.hand_over.handed_shaders import HandedObject, HandedShader


@dataclass(frozen=True, eq=False)
class PassStep:
    """A pass of a shader, of all of these objects. ``cached``: is it one of a variant?"""

    shader: HandedShader
    entry: PassEntry
    objects: tuple[HandedObject, ...]
    cached: bool = True

    @property
    def over_screen(self) -> bool:
        """Is it a triangle over the screen in place of objects?"""
        return self.entry.draws != "objects"

    @property
    def program(self) -> str:
        """The path of its two files, without their endings."""
        return self.shader.folder + self.entry.fragment.removesuffix(".frag")


def steps_of(shaders: Sequence[HandedShader]) -> list[PassStep]:
    """Every step of a frame, in order: first what is not cached, so that nothing it hides is
    stored."""
    steps = [
        PassStep(shader, shader.manifest.original, shader.plain, cached=False)
        for shader in shaders
        if shader.plain
    ]
    for behind in (False, True):
        parts = [_part(shader.passes, behind) for shader in shaders]
        for number in range(max(map(len, parts))):
            for shader, part in zip(shaders, parts, strict=True):
                if number < len(part):
                    _add(steps, PassStep(shader, part[number], shader.cached))
    return steps


def _part(passes: Sequence[PassEntry], behind: bool) -> Sequence[PassEntry]:
    """The passes up to the last one of objects, or those behind it."""
    end = max((at for at, one in enumerate(passes, 1) if one.draws == "objects"), default=0)
    return passes[end:] if behind else passes[:end]


def _add(steps: list[PassStep], step: PassStep) -> None:
    # What only marks pixels reads nothing but the cache: it is drawn once for all shaders.
    marks = not step.entry.targets and any(one.entry.name == step.entry.name for one in steps)
    if not marks:
        steps.append(step)
