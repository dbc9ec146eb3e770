"""Manifests as an engine sees them, and the reflection of shaders that no manifest tells of."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import shadercache
from shadercache.manifest.codec import encode
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import AnyManifest
from shadercache.manifest.reflection import inputs_of
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
    return inputs_of([(*read(source, stage), stage) for source, stage in stages])
