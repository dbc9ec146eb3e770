"""INTEGRATION.md: how this very variant is put into an engine, step by step."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.resources import files
from string import Template

from shadercache.report.hand_over.expected import Expected
from shadercache.report.hand_over.handed_shaders import HandedShader, manifest_of
from shadercache.report.hand_over.integration.integration_checks import check_lines, relied_lines
from shadercache.report.hand_over.integration.integration_frame import frame_lines
from shadercache.report.hand_over.integration.integration_resets import reset_lines
from shadercache.report.hand_over.integration.integration_targets import target_lines
from shadercache.report.hand_over.integration.integration_what import what_lines
from shadercache.scene.description import Scene


def integration_text(
    shaders: Sequence[HandedShader], scene: Scene, expected: Expected | None, example: str
) -> str:
    """The text; ``example`` says in a sentence what there is of that."""
    cached = [shader for shader in shaders if shader.variant]
    names = (manifest_of(shader).source.fragment.name for shader in cached)
    sections: dict[str, Iterable[str]] = {
        "what": what_lines(shaders, expected),
        "targets": target_lines(cached),
        "frame": frame_lines(shaders),
        "reset": reset_lines(cached),
        "relies": relied_lines(cached, scene),
        "check": check_lines(cached),
    }
    template = files(__package__).joinpath("INTEGRATION.md.txt").read_text(encoding="utf-8")
    return Template(template).substitute(
        {name: "\n".join(lines) for name, lines in sections.items()},
        title=" and ".join(names),
        generator=manifest_of(cached[0]).generator,
        example=example,
    )
