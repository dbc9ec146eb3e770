"""Instances of an object: how many are drawn, and the attributes that each has of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from shadercache.diagnostics import input_error
from shadercache.scene.streams import Stream
from shadercache.scene.toml_reader import Table


@dataclass(frozen=True, eq=False)
class Instances:
    """Several of an object are drawn at once; ``streams`` by the names of attributes, ``count``
    where the scene says it."""

    streams: Mapping[str, Stream] = field(default_factory=dict)
    count: int | None = None

    @property
    def number(self) -> int:
        """How many are drawn. Raises :class:`InputError` SC541 as a stream, or where two of them
        have numbers for another number of instances."""
        counts = {name: stream.shape[0] for name, stream in self.streams.items()}
        if self.count is not None:
            counts["count"] = self.count
        if len(set(counts.values())) > 1:
            told = ", ".join(f"{name} {number}" for name, number in counts.items())
            message = f"all attributes have numbers for as many instances, but there are {told}"
            raise input_error("SC541", message)
        return next(iter(counts.values()), 1)

    def renamed(self, renamed: Mapping[str, str]) -> Instances:
        """The same, with every stream also under its new name."""
        new = {renamed[name]: it for name, it in self.streams.items() if name in renamed}
        return replace(self, streams={**self.streams, **new})


ALONE = Instances()
"""One object, with nothing of its own."""


def read_instances(table: Table) -> Instances:
    """``[instances]``: a ``count``, and for each attribute the table and array it comes from."""
    streams: dict[str, Stream] = {}
    count = table.whole("count", None, least=1) if table.has("count") else None
    for name, value in table.items():
        if isinstance(value, dict):
            entry = table.table(name)
            streams[name] = Stream(
                entry.file("table"), entry.text("array"), entry.number("rate", 1.0)
            )
        else:
            known = name == "count"
            table.require(known, name, f"{table.full(name)} must have a table and an array")
    return Instances(streams, count)
