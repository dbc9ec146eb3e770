"""Manifests as an engine sees them, and the reflection of shaders that no manifest tells of."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import shadercache
from shadercache.emit.program_set import Pass, ProgramSet
from shadercache.emit.reflection import inputs_of
from shadercache.manifest.codec import encode
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import AnyManifest
from shadercache.manifest.shader_inputs import described_inputs
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.valid.read import read

SCHEMA = Path(shadercache.__file__).with_name("manifest.schema.json")


def plain(manifest: AnyManifest) -> dict[str, Any]:
    """What an engine reads from ``manifest.json``."""
    found: dict[str, Any] = json.loads(encode(manifest))
    return found


def reflected(vertex: Source, fragment: Source) -> tuple[InputEntry, ...]:
    """What two shaders are given, as a manifest would tell it."""
    stages: tuple[tuple[Source, Stage], ...] = ((vertex, "vertex"), (fragment, "fragment"))
    inputs = inputs_of([(*read(source, stage), stage) for source, stage in stages])
    names = tuple(item.name for item in inputs)
    return described_inputs(inputs, ProgramSet(original=Pass("", "", (), uniforms=names)))
