"""What a value depends on, as an engine knows it: through the varyings, back to what it sets."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from shadercache.emit.reflection import Input
from shadercache.sema.facts import Stage

BUILTIN = "built-in"


@dataclass(frozen=True, slots=True)
class Dependency:
    """An input that a value depends on.

    ``members`` of a block are those alone, where they can be told apart; ``stages`` are those that
    read it for the value.
    """

    kind: str
    name: str
    stages: tuple[Stage, ...]
    members: tuple[str, ...] = ()


def dependencies(
    read: Mapping[Stage, Iterable[str]], inputs: Iterable[Input]
) -> tuple[Dependency, ...]:
    """The dependencies, in the order of ``inputs``; built-in inputs come last.

    ``read``: the names of variables, of members and instances of blocks that each stage reads.
    """
    names = {stage: set(found) for stage, found in read.items()}
    found: list[Dependency] = []
    for item in inputs:
        known = _names(item)
        stages = tuple(stage for stage in item.stages if known & names.get(stage, set()))
        if stages:
            parts = set().union(*(names[stage] for stage in stages))
            members = [] if item.instance else [m.name for m in item.members if m.name in parts]
            is_block = item.kind.endswith("block")
            found.append(
                Dependency(item.kind, item.name, stages, tuple(members) if is_block else ())
            )
    return (*found, *_builtins(names))


def _names(item: Input) -> set[str]:
    """The names by which a shader knows an input."""
    if item.instance is not None:
        return {item.instance}
    if item.kind.endswith("block"):
        return {member.name for member in item.members}
    return {item.name}


def _builtins(names: Mapping[Stage, set[str]]) -> Iterable[Dependency]:
    for stage, found in names.items():
        for name in sorted(found):
            if name.startswith("gl_"):
                yield Dependency(BUILTIN, name, (stage,))
