"""Manifests to JSON text and back, and the JSON Schema of them."""

from __future__ import annotations

import re
from typing import Any

import msgspec

from shadercache.diagnostics import InputError, input_error
from shadercache.manifest.model import SCHEMA_VERSION, AnyManifest, Manifest
from shadercache.manifest.rules import problems

_LONGEST = 200
"""Characters of what is wrong: a file may hold a word of megabytes."""
# msgspec ends a sentence with its place, " - at `$.inputs[0]`". It quotes keys of the file, which
# may hold line ends.
_PLACE = re.compile(r"(?P<what>.*) - at (?P<key>`key` in )?`\$\.?(?P<path>.*)`", re.DOTALL)


def encode(manifest: AnyManifest) -> str:
    """The text of ``manifest.json``."""
    return msgspec.json.format(msgspec.json.encode(manifest), indent=2).decode() + "\n"


def decode(data: Any, name: str) -> Manifest:
    """What a JSON file holds, as a manifest; ``name`` is the file's.

    Raises:
        InputError: SC021 with the path to what is wrong; also where it is of another version.
    """
    # Asked first, since of another version any other complaint would mislead.
    if not isinstance(data, dict) or data.get("schema_version") != SCHEMA_VERSION:
        raise unusable(f"{name} is not of schema_version {SCHEMA_VERSION}")
    try:
        manifest = msgspec.convert(data, Manifest)
    except msgspec.ValidationError as error:
        raise unusable(_told(str(error))) from None
    for path, what in problems(manifest):
        raise unusable(f"{path}: {what}")
    return manifest


def schema() -> dict[str, Any]:
    """The JSON Schema of manifests."""
    head = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "shadercache manifest",
    }
    return {**head, **_on_one_line(msgspec.json.schema(Manifest))}


def unusable(reason: str) -> InputError:
    """SC021."""
    return input_error("SC021", f"the manifest cannot be used: {reason}")


def _told(words: str) -> str:
    """What msgspec says, the path in front."""
    match = _PLACE.fullmatch(words)
    what = (match["what"] if match else words).replace("`", "'")
    if len(what) > _LONGEST:
        what = what[:_LONGEST] + " ..."
    what = what[:1].lower() + what[1:]
    if match is None:
        return what
    path = match["path"]
    return f"a key of {path}: {what}" if match["key"] else f"{path}: {what}"


def _on_one_line(value: Any) -> Any:
    """Descriptions that were docstrings, without their line ends."""
    if isinstance(value, dict):
        return {key: _on_one_line(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_on_one_line(inner) for inner in value]
    return " ".join(value.split("\n")) if isinstance(value, str) else value
