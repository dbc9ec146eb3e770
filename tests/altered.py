"""Records of a scene with some fields changed, wherever they stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

T = TypeVar("T")


def altered(record: T, **changes: Any) -> T:
    """``altered(scene, motion=slow, fov_degrees=30.0)``: its own fields, and those of the records
    inside it, the first that is so named."""
    own = {item.name for item in fields(record)}
    here = {name: changes.pop(name) for name in own & changes.keys()}
    for item in fields(record):
        inner = getattr(record, item.name)
        if changes and is_dataclass(inner):
            names = set(_names(inner)) & changes.keys()
            if names:
                here[item.name] = altered(inner, **{name: changes.pop(name) for name in names})
    assert not changes, f"no such fields: {sorted(changes)}"
    return replace(record, **here)


def _names(record: Any) -> Iterator[str]:
    for item in fields(record):
        yield item.name
        if is_dataclass(getattr(record, item.name)):
            yield from _names(getattr(record, item.name))
