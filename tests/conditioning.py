"""What plain mode may change of a picture: what the conditioning of the cached value allows.

A driver rearranges arithmetic across the cut (``(v * 3.0) * 5.0`` is one product or two), so that a
payload, and what is computed from it, is some roundings off; how many, and where, each driver
decides for itself. How far that moves the picture is up to the shader. So it is measured, on the
same driver: the payload is made larger and smaller by a few roundings, and the terms of each
varying by one; the picture may change by as much as these change it, by as much as the same
liberties change the original, and by the roundings of a colour.

Varyings, because Mesa 25.0 gives for ``v_normal * 3.0``, where a program needs no more of the
varying, what interpolating the product would give. What is interpolated is the sum of terms that
cancel, far larger than itself where triangles are small, so other roundings show. (The one ulp is a
choice: docs/why/rewriting.md.)
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from shadercache.analysis.candidates import Candidate
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.front.parse import parse
from shadercache.lang.types import builtin_type
from shadercache.render.bundle import Bundle
from shadercache.source import Source
from shadercache.verify.laws import refreshed
from shadercache.verify.verdict import Difference, Verdict, difference
from shadercache.verify.verifier import Verifier

COLOUR = 1e-5
"""84 ulps of a colour of the order of 1; what comes behind the payload is rearranged as well."""

ROUNDINGS = 8
"""By which a payload is moved, in ulps. A product that is folded and a sum that is added in another
order are off by one to three."""

ULP = 2.0**-23

NEAR = Path(__file__).with_suffix(".glsl")

PROGRAM = "2-pass.miss.frag"
"""The whole shader, with the payload stored where it stands."""

_PAYLOAD = re.compile(r"^(\s*)(sc_payload(?:_\d+)?) = .*;$", re.MULTILINE)


def all_too_far(
    verifier: Verifier, chosen: Sequence[Sequence[Candidate]], verdicts: Sequence[Verdict]
) -> dict[str, dict[str, str]]:
    """Of the nodes that were judged, those that change too much in plain mode, by their texts."""
    pairs = zip(chosen, verdicts, strict=True)
    found = {item.text: too_far(verifier, nodes, item.plain) for nodes, item in pairs}
    return {text: far for text, far in found.items() if far}


def too_far(
    verifier: Verifier, nodes: Sequence[Candidate], plain: dict[str, Difference]
) -> dict[str, str]:
    """The algorithms that change more of the picture in plain mode than may be, and how much."""
    worst = max((found.maximum for found in plain.values()), default=0.0)
    if worst <= COLOUR:
        return {}
    bound = COLOUR + _rearranged(verifier) + _moved(verifier, nodes)
    return {
        name: f"{found.maximum:.1e} of {bound:.1e}"
        for name, found in plain.items()
        if found.maximum > bound
    }


def _rearranged(verifier: Verifier) -> float:
    """What the driver's liberties change of the original: its plain mode against proof mode.

    Among them is 16 bits for ``mediump`` (llvmpipe 25.0), which proof mode makes ``highp``."""
    frames = zip(*(verifier.references.images[mode] for mode in ("plain", "proof")), strict=True)
    found = [
        difference(plain, proof, covered).maximum
        for covered, (plain, proof) in zip(verifier.references.covered, frames, strict=True)
    ]
    return max(found)


def _moved(verifier: Verifier, nodes: Sequence[Candidate]) -> float:
    bundle = verifier.rewritten(nodes, "plain")
    text = bundle.files[PROGRAM]
    found = 0.0
    for sign in (-1, 1):
        files = bundle.files | {PROGRAM: scaled(text, sign * ROUNDINGS)}
        changed = refreshed(verifier.references, Bundle(bundle.manifest, files), "2-pass", "plain")
        found = max(found, changed.maximum)
    return found


def scaled(text: str, ulps: float) -> str:
    """The program with every number of its payloads moved by so many ulps, and its varyings by
    as many in proportion, one for :data:`ROUNDINGS`."""
    module = parse(Source(PROGRAM, text))
    structs = {item.name: item for item in walk(module) if isinstance(item, n.StructDef)}
    variables = [decl for decl in module.decls if isinstance(decl, n.VarDecl)]
    kinds = {item.name: (decl.type, item.dims) for decl in variables for item in decl.declarators}
    size = ulps * ULP

    def statement(found: re.Match[str]) -> str:
        parts = _parts(found[2], *kinds[found[2]], structs)
        return found[0] + "".join(f" {part} *= {1.0 + size!r};" for part in parts)

    near = f"#define SC_ULPS {size / ROUNDINGS!r}\n{NEAR.read_text(encoding='utf-8')}"
    for decl in variables:
        if decl.qualifiers.has("in") and not decl.type.dims and _is_vector(decl.type):
            names = [item.name for item in decl.declarators if not item.dims]
            near += "".join(f"#define {name} sc_near({name})\n" for name in names)
    head, first, rest = _PAYLOAD.sub(statement, text).partition(_first_function(module, text))
    return f"{head}{near}{first}{rest}"


def _is_vector(kind: n.TypeSpec) -> bool:
    found = builtin_type(kind.name)
    return found is not None and found.is_float and not found.is_matrix


def _first_function(module: n.Module, text: str) -> str:
    """The text of the line in which the first function begins."""
    kinds = n.FunctionDef | n.FunctionProto
    start = next(decl.span.start for decl in module.decls if isinstance(decl, kinds))
    return text[start:].partition("\n")[0]


def _parts(
    place: str, kind: n.TypeSpec, dims: n.Dims, structs: dict[str, n.StructDef]
) -> list[str]:
    """The places of the floating-point scalars, vectors and matrices in a variable."""
    every = (*kind.dims, *dims)
    if every:
        size = every[0]
        assert isinstance(size, n.Literal)
        element = n.TypeSpec(kind.span, kind.name)
        items = (f"{place}[{at}]" for at in range(int(size.text)))
        return [part for item in items for part in _parts(item, element, every[1:], structs)]
    if kind.name in structs:
        fields = [
            (field.type, item) for field in structs[kind.name].fields for item in field.declarators
        ]
        return [
            part
            for spec, item in fields
            for part in _parts(f"{place}.{item.name}", spec, item.dims, structs)
        ]
    found = builtin_type(kind.name)
    return [place] if found is not None and found.base == "float" else []
