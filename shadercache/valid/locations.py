"""Locations: which are taken, and by what (GLSL 4.60 section 4.4.1 to 4.4.3)."""

from __future__ import annotations

from collections.abc import Mapping
from math import prod

from shadercache.ast.nodes import BlockDecl, Node
from shadercache.lang.types import StructType, Type
from shadercache.sema.problems import ERROR
from shadercache.sema.storage import PER_VERTEX, of_one_vertex
from shadercache.valid.suspect import Suspect

# First version of a location: (stage, storage) -> version; what is missing needs 4.10.
_LOCATION_SINCE = {("vertex", "in"): 330, ("fragment", "out"): 330}
_LOCATING = "GL_ARB_explicit_attrib_location"
_BLOCK_LOCATIONS = frozenset(
    ("GL_ARB_enhanced_layouts", "GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
)
_INTERFACE_SINCE = 410
_UNIFORM_SINCE = 430
_ES_SINCE = {"uniform": 310, "interface": 310}
_MAX_LOCATIONS = 4096  # No implementation has more; those of larger arrays are not looked at.
_SORTS = {"int": "integers", "uint": "unsigned integers"}


class Locations:
    """Places variables and members of blocks at locations; no two of them share one."""

    def __init__(self, suspect: Suspect) -> None:
        self._suspect = suspect
        self._language, self._problems = suspect.language, suspect.problems
        self._taken: dict[tuple[str, int, int, int], str] = {}
        self._sorts: dict[tuple[int, int], str] = {}

    def place(
        self, node: Node, name: str, kind: Type, storage: str, values: Mapping[str, int]
    ) -> None:
        """``name`` of type ``kind`` stands at the location that its layout gives."""
        for word in ("component", "index"):
            if word in values and "location" not in values:
                self._problems.error("SC223", f"'{word}' needs a 'location' beside it", node)
        if "location" not in values:
            return
        since = self._since(storage)
        if self._language.interface_version < since:
            version = f"GLSL ES {since}" if self._language.es else f"GLSL {since / 100:.2f}"
            what = "a uniform" if storage == "uniform" else f"this '{storage}' variable"
            self._problems.error("SC223", f"a location of {what} needs {version}", node)
        elif kind is not ERROR and self._exclusive(storage):
            self._take(node, name, kind, storage, values)

    def place_block(
        self, block: BlockDecl, storage: str, first: int | None, members: list[dict[str, int]]
    ) -> None:
        """Members stand one behind the other, unless they say otherwise."""
        problems, at = self._problems, first
        if at is not None and not self._takes_block_locations():
            problems.error("SC223", "this version of GLSL has no locations of blocks", block)
        located = ["location" in values for values in members]
        array = bool(block.dims) and not block.qualifiers.has(*PER_VERTEX)
        if storage not in ("in", "out"):
            return
        if any(located) and not all(located) and first is None:
            message = "either all members of a block have a location or none, unless the block has"
            problems.error("SC223", message, block)
        for decl, values in zip(block.fields, members, strict=True):
            if "location" in values and array:
                message = "a member of an array of blocks has no location of its own"
                problems.error("SC223", message, block)
            at = values.get("location", at)
            for node in decl.declarators:
                kind = of_one_vertex(self._suspect.fields(block)[node.name], decl.qualifiers)
                if at is not None and kind is not ERROR and not array:
                    self._take(node, node.name, kind, storage, {**values, "location": at})
                    at += kind.slots

    def _takes_block_locations(self) -> bool:
        enhanced = not self._language.extensions.isdisjoint(_BLOCK_LOCATIONS)
        return enhanced or self._language.at_least(440, 320)

    def _since(self, storage: str) -> int:
        known = _LOCATION_SINCE.get((self._language.stage, storage))
        extensions = self._language.extensions
        if "GL_ARB_enhanced_layouts" in extensions or (known and _LOCATING in extensions):
            return 0
        if storage == "uniform":
            return _ES_SINCE["uniform"] if self._language.es else _UNIFORM_SINCE
        if self._language.es:
            return 300 if known else _ES_SINCE["interface"]
        return known or _INTERFACE_SINCE

    def _exclusive(self, storage: str) -> bool:
        """Do locations belong to one variable? Attributes may share one on the desktop."""
        return self._language.es or (self._language.stage, storage) != ("vertex", "in")

    def _take(
        self, node: Node, name: str, kind: Type, storage: str, values: Mapping[str, int]
    ) -> None:
        problem = _component_problem(kind, values)
        if problem is None:
            used = _used(kind, values) if storage != "uniform" else _uniforms(kind, values)
            problem = self._clash(name, storage, values.get("index", 0), used)
        if problem is None and (self._language.stage, storage) == ("fragment", "out"):
            problem = self._other_sort(name, kind, values)
        if problem is not None:
            self._problems.error("SC223", problem, node)

    def _clash(
        self, name: str, storage: str, index: int, used: list[tuple[int, int]]
    ) -> str | None:
        for location, component in used:
            other = self._taken.setdefault((storage, location, component, index), name)
            if other != name:
                return f"'{name}' and '{other}' share the location {location}"
        return None

    def _other_sort(self, name: str, kind: Type, values: Mapping[str, int]) -> str | None:
        """Outputs that share a location have components of one sort."""
        sort = _SORTS.get(kind.base or "", "floats")
        index, first = values.get("index", 0), values["location"]
        for location in range(first, first + min(kind.slots, _MAX_LOCATIONS)):
            other = self._sorts.setdefault((location, index), sort)
            if other != sort:
                return f"'{name}' holds {sort}, what else is at location {location} {other}"
        return None


def _component_problem(kind: Type, values: Mapping[str, int]) -> str | None:
    if "component" not in values:
        return None
    start = values["component"]
    wide = kind.base == "double"
    if wide and (start % 2 or kind.rows > 2):
        return f"{kind} starts at component 0 or 2, and has no more than two there"
    if start + kind.rows * (2 if wide else 1) > 4:
        return f"{kind} does not fit behind component {start}"
    return None


def _used(kind: Type, values: Mapping[str, int]) -> list[tuple[int, int]]:
    """Locations and components that a variable takes."""
    used: list[tuple[int, int]] = []
    for step in range(min(kind.slots, _MAX_LOCATIONS)):
        # The second half of dvec3 and dvec4 stands in a location of its own.
        second = step % 2 == 1 and kind.base == "double" and kind.rows > 2
        components = range(2 * (kind.rows - 2)) if second else _components(kind, values)
        used += [(values["location"] + step, component) for component in components]
    return used


def _uniforms(kind: Type, values: Mapping[str, int]) -> list[tuple[int, int]]:
    first = values["location"]
    count = min(_uniform_slots(kind), _MAX_LOCATIONS)
    return [(location, 0) for location in range(first, first + count)]


def _components(kind: Type, values: Mapping[str, int]) -> range:
    """Which components of its (first) location a variable takes."""
    if kind.base is None or kind.cols > 1:
        return range(4)
    width = kind.rows * (2 if kind.base == "double" else 1)
    start = values.get("component", 0)
    return range(start, start + min(width, 4))


def _uniform_slots(kind: Type, known: dict[StructType, int] | None = None) -> int:
    """A uniform takes one for each element and member (section 4.4.3)."""
    one, known = 1, {} if known is None else known
    if kind.struct is not None:
        if kind.struct not in known:
            fields = kind.struct.fields.values()
            known[kind.struct] = sum(_uniform_slots(field, known) for field in fields)
        one = known[kind.struct]
    return one * prod(size or 1 for size in kind.dims)
