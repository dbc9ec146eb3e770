"""Offsets of the members of blocks (GLSL 4.60 section 4.4.5): SC223."""

from __future__ import annotations

from shadercache.ast.nodes import BlockDecl
from shadercache.lang.block_layout import alignment
from shadercache.lang.types import Type
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect

_ALIGNED = ("std140", "std430")


def check_member_offsets(
    block: BlockDecl,
    packing: str,
    shared_align: int | None,
    members: list[dict[str, int]],
    suspect: Suspect,
) -> None:
    """Offsets and alignments stand in ``std140`` and ``std430`` blocks, and grow."""
    problems, fields = suspect.problems, suspect.fields(block)
    given = [values for values in members if "offset" in values or "align" in values]
    if (given or shared_align) and packing not in _ALIGNED:
        message = "'offset' and 'align' are for blocks with the layout std140 or std430"
        problems.error("SC223", message, block)
        return
    end = 0
    for decl, values in zip(block.fields, members, strict=True):
        for node in decl.declarators:
            kind = fields[node.name]
            if kind is ERROR or kind.components is None:
                return
            unit, size = alignment(kind, packing)
            align = values.get("align", shared_align or 0)
            if align & (align - 1):
                problems.error("SC223", f"an alignment is a power of 2, not {align}", decl)
            if "offset" in values:
                problem = _offset_problem(values["offset"], unit, end, node.name, kind)
                if problem is not None:
                    problems.error("SC223", problem, node)
                end = max(end, values["offset"])
            step = max(unit, align)
            end = -(-end // step) * step + size


def _offset_problem(offset: int, unit: int, end: int, name: str, kind: Type) -> str | None:
    if offset % unit:
        return f"the offset of {kind} is a multiple of {unit}, not {offset}"
    if offset < end:
        return f"'{name}' at the offset {offset} lies in members before it"
    return None
