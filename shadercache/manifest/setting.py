"""What a manifest is told of the shaders beside their programs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from shadercache.analysis.mapping import MappingKind
from shadercache.emit.dependencies import Dependency
from shadercache.emit.reflection import Input


@dataclass(frozen=True, slots=True)
class Setting:
    """Where payloads are found, what is drawn, and what an engine gives.

    ``inputs`` are those of the user's shaders; ``depends_on`` those of the payload; ``unchanged``:
    while which inputs do not change is reuse exact? (``None``: not said.) ``renamed`` leads from
    the user's names to the variants'.
    """

    mapping: MappingKind
    full_screen: bool
    inputs: Sequence[Input]
    depends_on: Sequence[Dependency]
    unchanged: Sequence[str] | None
    renamed: Mapping[str, str]
