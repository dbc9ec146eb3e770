"""What the engine gives, as the manifest lists it: blocks apart from uniforms, twins with them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from shadercache.emit.block_members import InputMember
from shadercache.emit.program_set import ProgramSet
from shadercache.emit.reflection import Input, with_twins


def described_inputs(inputs: Sequence[Input], programs: ProgramSet) -> list[dict[str, Any]]:
    """An entry for every input that a program of the set declares, the added ones apart."""
    passes = [item for variant in programs.variants.values() for item in variant]
    passes += [item for item in (programs.original, programs.debug, programs.payload) if item]
    declared = {name for item in passes for name in (*item.uniforms, *item.attributes)}
    return [
        _described(item) for item in with_twins(inputs, programs.previous) if item.name in declared
    ]


def _described(item: Input) -> dict[str, Any]:
    found: dict[str, Any] = {"kind": item.kind, "name": item.name, "stages": list(item.stages)}
    if item.type is not None:
        found["type"] = item.type
    if item.kind.endswith("block"):
        found |= _block(item)
    if item.kind in ("attribute", "uniform"):
        found["location"] = item.location
    else:
        found["binding"] = item.binding
    if item.members:
        found["members"] = [_member(member) for member in item.members]
    if item.previous_of is not None:
        found["previous_of"] = item.previous_of
    return found


def _block(item: Input) -> dict[str, Any]:
    assert item.layout is not None
    found: dict[str, Any] = {"instance": item.instance, "dims": list(item.dims)}
    found |= {"packing": item.layout.packing, "matrices": item.layout.matrices}
    if item.previous_of is not None:
        # Of a packed block a program may leave out what it does not read.
        found["takes_the_last_buffer"] = item.layout.packing != "packed"
    return found


def _member(member: InputMember) -> dict[str, Any]:
    found: dict[str, Any] = {"name": member.name, "type": member.type}
    if member.layout:
        found["layout"] = member.layout
    if member.members:
        found["members"] = [_member(inner) for inner in member.members]
    return found
