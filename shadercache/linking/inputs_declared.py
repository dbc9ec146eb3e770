"""The uniforms and attributes that shaders declare."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import product

from shadercache.ast import nodes as n
from shadercache.compiler import Analysis
from shadercache.lang.types import Type
from shadercache.manifest.block_members import block_fields
from shadercache.sema.facts import Facts
from shadercache.transform.versions.raise_version import Raised


def inputs_declared(
    stages: Iterable[Raised], word: str, old: Mapping[str, str], initialised: bool = False
) -> Iterator[tuple[str, Type]]:
    """Name and type of each uniform or attribute, by its old name too.

    Those with an initialiser are there only if they are asked for.
    """
    for stage in stages:
        for decl in stage.module.decls:
            if isinstance(decl, n.BlockDecl) and decl.qualifiers.has(word):
                for prefix in _prefixes(decl, stage.facts):
                    for name, kind in block_fields(decl, stage.facts).items():
                        yield prefix + name, kind
            if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has(word):
                continue
            for declarator in decl.declarators:
                kind = stage.facts.declared[declarator].type
                if declarator.init is None or initialised:
                    yield from _parts(declarator.name, kind)
                    # Law 1 draws the user's own text as well, which has the old name.
                    if declarator.name in old:
                        yield from _parts(old[declarator.name], kind)


def _prefixes(decl: n.BlockDecl, facts: Facts) -> Iterator[str]:
    """What stands before the members of a block; of an array of blocks before those of each."""
    if decl.instance is None:
        yield ""
        return
    sizes = [range(size or 1) for size in facts.declared[decl].type.dims]
    for place in product(*sizes):
        yield f"{decl.instance}{''.join(f'[{at}]' for at in place)}."


def _parts(name: str, kind: Type) -> Iterator[tuple[str, Type]]:
    """An input; in place of one that holds samplers its parts: ``lamp.map``, ``maps[1]``."""
    if not kind.holds_opaque or kind.is_opaque:
        yield name, kind
    elif kind.is_array:
        for at in range(kind.dims[0] or 1):
            yield from _parts(f"{name}[{at}]", kind.element)
    elif kind.struct is not None:
        for field, inner in kind.struct.fields.items():
            yield from _parts(f"{name}.{field}", inner)


def uniform_sizes(analysis: Analysis) -> dict[str, int | None]:
    """How many numbers each uniform takes, by the names that GL has for them.

    None where that is not known: of an array without a size.
    """
    old = {new: name for name, new in analysis.renamed.items()}
    return {
        part: size
        for name, kind in inputs_declared(analysis.raised, "uniform", old, initialised=True)
        for part, size in _sizes(name, kind)
    }


def _sizes(name: str, kind: Type) -> Iterator[tuple[str, int | None]]:
    """A uniform for each member of a struct; an innermost array of numbers is one."""
    if kind.is_array and (kind.struct is not None or len(kind.dims) > 1):
        for at in range(kind.dims[0] or 1):
            yield from _sizes(f"{name}[{at}]", kind.element)
    elif kind.struct is not None:
        for field, inner in kind.struct.fields.items():
            yield from _sizes(f"{name}.{field}", inner)
    elif not kind.holds_opaque:
        yield name, kind.components
