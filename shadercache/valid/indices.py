"""What an index may be (GLSL 4.60 section 5.7): SC214."""

from __future__ import annotations

from shadercache.ast.nodes import Index, Name
from shadercache.lang.builtins import MOST_ELEMENTS
from shadercache.lang.types import Type, array_of
from shadercache.sema.expression_types import is_runtime_array
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect


def check_indices(suspect: Suspect) -> None:
    """A constant index lies inside; some arrays have constant indices only."""
    for node in suspect.nodes(Index):
        if suspect.type_of(node) is ERROR:
            continue
        whole = suspect.type_of(node.object)
        _check_range(node, whole, suspect)
        if not suspect.is_constant(node.index):
            _check_dynamic(node, whole, suspect)


def _check_range(node: Index, whole: Type, suspect: Suspect) -> None:
    at = suspect.value(node.index)
    if isinstance(node.object, Name) and node.object.name in MOST_ELEMENTS:
        whole = array_of(whole.element, whole.dims[0] or MOST_ELEMENTS[node.object.name])
    size = whole.dims[0] if whole.dims else (whole.cols if whole.cols > 1 else whole.rows)
    if isinstance(at, int) and (at < 0 or (size is not None and at >= size)):
        suspect.problems.error("SC214", f"index {at} is outside of {whole}", node.index)


def _check_dynamic(node: Index, whole: Type, suspect: Suspect) -> None:
    """What only a constant may index: unsized arrays, and before 4.00 arrays of samplers."""
    problems, language = suspect.problems, suspect.language
    if whole.is_unsized and whole.dims[0] is None:
        if is_runtime_array(node.object, suspect.tables.symbols):
            return
        message = f"{whole} has no size yet: only a constant may index it"
        problems.error("SC214", message, node.index)
    elif whole.holds_opaque and not language.indexes_samplers:
        message = "before GLSL 4.00 only a constant may index an array of samplers"
        problems.error("SC214", message, node.index)
    elif whole.struct is not None and whole.dims and not language.at_least(0, 320):
        name = node.object
        symbol = suspect.tables.symbols.get(name) if isinstance(name, Name) else None
        if symbol is not None and symbol.kind == "block":
            message = "before GLSL ES 3.20 only a constant may index an array of blocks"
            problems.error("SC214", message, node.index)
