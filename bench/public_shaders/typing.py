"""Do we type as glslang does? Its tree tells the type of every assignment and of every global.

Compared are, for each valid shader, the types of all assignments (and of the initialisers that are
not folded away), as often as each occurs, and the declared types of inputs, outputs and uniforms by
name. What glslang leaves out of its tree, such as a branch that is never taken, proves nothing.
"""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import partial
from multiprocessing import Pool
from pathlib import Path

from bench.public_shaders.judge import TOOL
from bench.public_shaders.shaders import Shader
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.ast.walk import walk
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.source import Source
from shadercache.valid.read import read

_ASSIGNMENT = re.compile(r"^\d+:\S+\s+[\w ]+ second child (?:to|into) first child \((.*)\)$")
_GLOBAL = re.compile(r"^\d+:\S+\s+'(\w+)' \((.*)\)$")
_LINKED = re.compile(r"^\d+:\?\s+Linker Objects$")
_ARRAY = re.compile(r"(?:unsized )?(\d+)-element array of |unsized array of ")
_SIZE = re.compile(r"\[\d*\]")
_VECTOR = re.compile(r"\b(\d)-component vector of (\w+)")
_MATRIX = re.compile(r"\b(\d)X(\d) matrix of (\w+)")
_PREFIX = {
    **{"float": "", "int": "i", "uint": "u", "bool": "b", "double": "d"},
    **{"int64_t": "i64", "uint64_t": "u64"},
}
_STORED = ("in", "out", "uniform", "varying", "attribute")


def compare_types(shaders: Sequence[Shader], folder: Path, processes: int) -> list[str]:
    """For each valid shader, whose file lies in ``folder``, what differs; nothing if all agree."""
    with Pool(processes, allow_deep_trees) as pool:
        return pool.map(partial(_compare, folder=folder), shaders, chunksize=8)


def _compare(shader: Shader, folder: Path) -> str:
    command = [TOOL, "-i", "-d", shader.file]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    lines = done.stdout.decode(errors="replace").splitlines()
    try:
        module, facts = read(Source(shader.file, shader.text), shader.stage)
    except Exception as error:
        return f"not read: {type(error).__name__}"
    differences = (*_global_differences(lines, module, facts), *_assignments(lines, module, facts))
    return "; ".join(differences)


def _assignments(lines: Sequence[str], module: n.Module, facts: Facts) -> Iterator[str]:
    """The types that glslang assigns to more often than we do."""
    theirs = Counter(shape_of(found[1]) for line in lines if (found := _ASSIGNMENT.match(line)))
    ours = Counter(map(shape, _assigned(module, facts)))
    missing = theirs - ours
    if missing:
        yield f"assigned {dict(missing)} where we have {dict(ours - theirs)}"


def _assigned(module: n.Module, facts: Facts) -> Iterator[Type]:
    for node in walk(module):
        if isinstance(node, n.Assign):
            yield facts.types[node.target]
        elif isinstance(node, n.Declarator) and node.init is not None:
            yield facts.declared[node].type
        elif isinstance(node, n.Call):
            # What an out argument is given is assigned, and the result is kept meanwhile, where the
            # parameter has another type (section 6.1.1).
            callee = facts.calls[node]
            if isinstance(callee, n.FunctionDef):
                callee = callee.proto
            if isinstance(callee, n.FunctionProto):
                pairs = zip(callee.params, node.args, strict=True)
                yield from (facts.types[arg] for param, arg in pairs if param.writes_back)
                yield facts.types[node]


def _global_differences(lines: Sequence[str], module: n.Module, facts: Facts) -> Iterator[str]:
    begin = next((at for at, line in enumerate(lines) if _LINKED.match(line)), len(lines))
    theirs = {found[1]: found[2] for line in lines[begin:] if (found := _GLOBAL.match(line))}
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has(*_STORED):
            for declarator in decl.declarators:
                if declarator.name.startswith("gl_"):
                    continue  # Told with the name of the built-in.
                text = theirs.get(declarator.name)
                ours = shape(facts.declared[declarator].type)
                if text is not None and not _agree(shape_of(text), ours):
                    yield f"'{declarator.name}' is {shape_of(text)}, with us {ours}"


def _agree(theirs: str, ours: str) -> bool:
    """The judge gives an array without a size the one that its uses need."""
    if "[]" in ours:
        theirs, ours = (_SIZE.sub("[]", text) for text in (theirs, ours))
    return theirs == ours


def shape(kind: Type) -> str:
    """A type as :func:`shape_of` names it: structs and sizes that are not known have no name."""
    name = "struct" if kind.struct is not None else kind.name
    return name + "".join("[]" if size is None else f"[{size}]" for size in kind.dims)


def shape_of(text: str) -> str:
    """The name of a type in glslang's words: ``temp highp 3-component vector of float``."""
    sizes = ""
    is_struct = re.search(r"\b(?:structure|block)\{", text)
    head = text[: is_struct.start()] if is_struct else text
    for found in _ARRAY.finditer(head):
        sizes += f"[{found[1] or ''}]"
    if is_struct:
        return f"struct{sizes}"
    if vector := _VECTOR.search(text):
        return f"{_PREFIX.get(vector[2], vector[2])}vec{vector[1]}{sizes}"
    if matrix := _MATRIX.search(text):
        columns, rows, base = matrix.groups()
        size = columns if columns == rows else f"{columns}x{rows}"
        return f"{_PREFIX.get(base, base)}mat{size}{sizes}"
    return text.rsplit(" ", 1)[-1] + sizes
