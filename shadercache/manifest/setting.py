"""What a manifest is told of the shaders beside their programs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from shadercache.analysis.mapping import MappingKind
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import DependencyEntry
from shadercache.source import Source


@dataclass(frozen=True, slots=True)
class Setting:
    """The shaders' sources, where payloads are found, what is drawn, and what an engine gives.

    ``inputs`` are those of the user's shaders; ``depends_on`` those of the payload; ``unchanged``:
    while which inputs do not change is reuse exact? (``None``: not said.) ``renamed`` leads from
    the user's names to the variants'.
    """

    fragment: Source
    vertex: Source
    mapping: MappingKind
    full_screen: bool
    inputs: tuple[InputEntry, ...]
    depends_on: tuple[DependencyEntry, ...]
    unchanged: tuple[str, ...] | None
    renamed: Mapping[str, str]
