"""Locations: which are taken, and by what (GLSL 4.60 section 4.4.1 to 4.4.3)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import prod
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.lang.types import StructType, Type
from shadercache.sema.problems import ERROR
from shadercache.sema.storage import PER_VERTEX, of_one_vertex
from shadercache.valid.suspect import Finding, Suspect

# First version of a location: (stage, storage) -> version; what is missing needs 4.10.
_LOCATION_SINCE = {("vertex", "in"): 330, ("fragment", "out"): 330}
_LOCATING = "GL_ARB_explicit_attrib_location"
_ENHANCED = "GL_ARB_enhanced_layouts"
_BLOCK_LOCATIONS = (_ENHANCED, "GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
_MAX_LOCATIONS = 4096  # No implementation has more; those of larger arrays are not looked at.
_SORTS = {"int": "integers", "uint": "unsigned integers"}

Values: TypeAlias = Mapping[str, int]
"""What the words of a layout say."""


class Locations:
    """Places variables and members of blocks at locations; no two of them share one."""

    def __init__(self, suspect: Suspect, findings: list[Finding]) -> None:
        self._suspect, self._language = suspect, suspect.language
        self._findings = findings
        self._taken: dict[tuple[str, int, int, int], str] = {}
        self._sorts: dict[tuple[int, int], str] = {}

    def _error(self, message: str, node: n.Node) -> None:
        self._findings.append(Finding("SC223", message, node))

    def place(self, node: n.Declarator, kind: Type, storage: str, values: Values) -> None:
        """A variable stands at the location that its layout gives."""
        for word in ("component", "index"):
            if word in values and "location" not in values:
                self._error(f"'{word}' needs a 'location' beside it", node)
        if "location" not in values:
            return
        since = self._since(storage)
        if self._language.interface_version < since:
            version = f"GLSL ES {since}" if self._language.es else f"GLSL {since / 100:.2f}"
            what = "a uniform" if storage == "uniform" else f"this '{storage}' variable"
            self._error(f"a location of {what} needs {version}", node)
        # On the desktop attributes may share a location: a program reads one of them.
        elif kind is not ERROR and (
            self._language.es or (self._language.stage, storage) != ("vertex", "in")
        ):
            self._take(node, kind, storage, values)

    def place_block(
        self, block: n.BlockDecl, storage: str, first: int | None, members: Sequence[Values]
    ) -> None:
        """Members stand one behind the other, unless they say otherwise."""
        at, language = first, self._language
        extended = not language.extensions.isdisjoint(_BLOCK_LOCATIONS)
        if at is not None and not extended and not language.at_least(440, 320):
            self._error("this version of GLSL has no locations of blocks", block)
        if storage not in ("in", "out"):
            return
        located = ["location" in values for values in members]
        if any(located) and not all(located) and first is None:
            message = "either all members of a block have a location or none, unless the block has"
            self._error(message, block)
        array = bool(block.dims) and not block.qualifiers.has(*PER_VERTEX)
        for decl, values in zip(block.fields, members, strict=True):
            if "location" in values and array:
                self._error("a member of an array of blocks has no location of its own", block)
            at = values.get("location", at)
            for node in decl.declarators:
                kind = self._suspect.tables.fields[block][node.name]
                kind = of_one_vertex(kind, decl.qualifiers)
                if at is not None and kind is not ERROR and not array:
                    self._take(node, kind, storage, {**values, "location": at})
                    at += kind.slots

    def _since(self, storage: str) -> int:
        known = _LOCATION_SINCE.get((self._language.stage, storage))
        extensions = self._language.extensions
        if _ENHANCED in extensions or (known and _LOCATING in extensions):
            return 0
        if self._language.es:
            return 300 if known else 310
        return 430 if storage == "uniform" else known or 410

    def _take(self, node: n.Declarator, kind: Type, storage: str, values: Values) -> None:
        problem = _component_problem(kind, values)
        if problem is None:
            used = _uniforms(kind, values) if storage == "uniform" else _used(kind, values)
            problem = self._clash(node.name, storage, values.get("index", 0), used)
        if problem is None and (self._language.stage, storage) == ("fragment", "out"):
            problem = self._other_sort(node.name, kind, values)
        if problem is not None:
            self._error(problem, node)

    def _clash(
        self, name: str, storage: str, index: int, used: Iterable[tuple[int, int]]
    ) -> str | None:
        for location, component in used:
            # The second source of blending (`index = 1`) may have the location of the first.
            other = self._taken.setdefault((storage, location, component, index), name)
            if other != name:
                return f"'{name}' and '{other}' share the location {location}"
        return None

    def _other_sort(self, name: str, kind: Type, values: Values) -> str | None:
        """Outputs that share a location have components of one sort."""
        sort = _SORTS.get(kind.base or "", "floats")
        index, first = values.get("index", 0), values["location"]
        for location in range(first, first + min(kind.slots, _MAX_LOCATIONS)):
            other = self._sorts.setdefault((location, index), sort)
            if other != sort:
                return f"'{name}' holds {sort}, what else is at location {location} {other}"
        return None


def _component_problem(kind: Type, values: Values) -> str | None:
    if "component" not in values:
        return None
    start = values["component"]
    wide = kind.base == "double"
    # A double takes two components, and starts at an even one (section 4.4.1).
    if wide and (start % 2 or kind.rows > 2):
        return f"{kind} starts at component 0 or 2, and has no more than two there"
    if start + kind.rows * (2 if wide else 1) > 4:
        return f"{kind} does not fit behind component {start}"
    return None


def _used(kind: Type, values: Values) -> Iterator[tuple[int, int]]:
    """Locations and components that a variable takes."""
    for step in range(min(kind.slots, _MAX_LOCATIONS)):
        # The second half of dvec3 and dvec4 stands in a location of its own.
        second = step % 2 == 1 and kind.base == "double" and kind.rows > 2
        components = range(2 * (kind.rows - 2)) if second else _components(kind, values)
        yield from ((values["location"] + step, component) for component in components)


def _uniforms(kind: Type, values: Values) -> Iterator[tuple[int, int]]:
    first = values["location"]
    count = min(_uniform_slots(kind), _MAX_LOCATIONS)
    # Locations of uniforms name variables, and have no components.
    return ((location, 0) for location in range(first, first + count))


def _components(kind: Type, values: Values) -> range:
    """Which components of its (first) location a variable takes."""
    # Only scalars and vectors leave components to others.
    if kind.base is None or kind.cols > 1:
        return range(4)
    width = kind.rows * (2 if kind.base == "double" else 1)
    start = values.get("component", 0)
    return range(start, start + min(width, 4))


def _uniform_slots(kind: Type, known: dict[StructType, int] | None = None) -> int:
    """A uniform takes one for each element and member (section 4.4.3)."""
    one, known = 1, {} if known is None else known
    if kind.struct is not None:
        # Each struct once: nested ones would take exponential time.
        if kind.struct not in known:
            fields = kind.struct.fields.values()
            known[kind.struct] = sum(_uniform_slots(field, known) for field in fields)
        one = known[kind.struct]
    return one * prod(size or 1 for size in kind.dims)
