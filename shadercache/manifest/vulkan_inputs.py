"""What inputs and their twins are in Vulkan GLSL: sets, bindings, locations."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import UNSET, structs

from shadercache.analysis.stages import StageSide, next_location, spare_locations
from shadercache.emit.vulkan import FIRST_TWIN, VulkanPlaces
from shadercache.manifest.interface import (
    BOUND,
    AttributeInput,
    InputEntry,
    StorageBlockInput,
    UniformBlockInput,
)


def places_of(
    fragment: StageSide,
    vertex: StageSide | None,
    inputs: Iterable[InputEntry],
    twins: dict[str, str],
    instanced: bool,
) -> VulkanPlaces:
    """What two stages leave free. ``twins``: attributes that have one, and its name."""
    varying, locations = next_location(fragment, "in"), dict[str, int]()
    if vertex is not None:
        varying = max(varying, next_location(vertex, "out"))
        spare = spare_locations(vertex, "in", twins)
        locations = {twins[name]: number for name, number in spare.items()}
    return VulkanPlaces(_free_set(inputs), varying, instanced, locations)


def _free_set(inputs: Iterable[InputEntry]) -> int:
    """The first descriptor set that no input is in."""
    numbers = (getattr(entry, "set", None) for entry in inputs)
    taken = {0 if number is UNSET else number for number in numbers}
    return next(number for number in range(len(taken) + 1) if number not in taken)


def twin_bindings_in_vulkan(inputs: Iterable[InputEntry]) -> dict[str, int]:
    """The bindings of twins, in the set that is free, by the name of what has one. An array has one
    binding."""
    bound = [one.name for one in inputs if isinstance(one, BOUND) and "vertex" in one.stages]
    return {name: FIRST_TWIN + number for number, name in enumerate(bound)}


def twin_in_vulkan(twin: InputEntry, places: VulkanPlaces) -> InputEntry:
    """A twin at its place; that of push constants is a buffer."""
    if isinstance(twin, AttributeInput):
        return structs.replace(twin, location=places.locations[twin.name])
    if isinstance(twin, UniformBlockInput) and twin.push_constant:
        about = {name: getattr(twin, name) for name in twin.__struct_fields__}
        del about["push_constant"]
        twin = StorageBlockInput(**about)
    return structs.replace(twin, set=places.set) if isinstance(twin, BOUND) else twin
