"""Do we type as glslang does? Its tree names the type of every assignment and of every global.

The types of all assignments are compared as often as each occurs, initialisers that are not folded
away among them, and the declared types of inputs, outputs and uniforms by name. What glslang leaves
out of its tree, such as a branch that is never taken, proves nothing.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts

_ASSIGNMENT = re.compile(r"^\d+:\S+\s+[\w ]+ second child (?:to|into) first child \((.*)\)$")
_GLOBAL = re.compile(r"^\d+:\S+\s+'(\w+)' \((.*)\)$")
_ARRAY = re.compile(r"(?:unsized )?(\d+)-element array of |unsized array of ")
_SIZE = re.compile(r"\[\d*\]")
_PARTS = re.compile(r"\b(?:(\d)-component vector|(\d)X(\d) matrix) of (\w+)")
_PREFIX = {
    **{"float": "", "int": "i", "uint": "u", "bool": "b", "double": "d"},
    **{"int64_t": "i64", "uint64_t": "u64"},
}
_STORED = ("in", "out", "uniform", "varying", "attribute")


def type_differences(tree: Sequence[str], module: n.Module, facts: Facts) -> str:
    """Where glslang's tree of a shader has other types than we; nothing if all agree."""
    return "; ".join((*_globals(tree, module, facts), *_assignments(tree, module, facts)))


def _assignments(tree: Sequence[str], module: n.Module, facts: Facts) -> Iterator[str]:
    """The types that glslang assigns to more often than we do."""
    theirs = Counter(shape_of(match[1]) for line in tree if (match := _ASSIGNMENT.match(line)))
    ours = Counter(map(shape, _assigned(module, facts)))
    if missing := theirs - ours:
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
            proto = callee.proto if isinstance(callee, n.FunctionDef) else callee
            if isinstance(proto, n.FunctionProto):
                pairs = zip(proto.params, node.args, strict=True)
                yield from (facts.types[arg] for param, arg in pairs if param.writes_back)
                yield facts.types[node]


def _globals(tree: Sequence[str], module: n.Module, facts: Facts) -> Iterator[str]:
    # Globals stand last, behind what is local and of the same name.
    theirs = {match[1]: match[2] for line in tree if (match := _GLOBAL.match(line))}
    variables = [decl for decl in module.decls if isinstance(decl, n.VarDecl)]
    stored = [decl for decl in variables if decl.qualifiers.has(*_STORED)]
    for declarator in (declarator for decl in stored for declarator in decl.declarators):
        name, ours = declarator.name, shape(facts.declared[declarator].type)
        # The tree lists a built-in that is declared again under its block.
        if name in theirs and not name.startswith("gl_"):
            other = shape_of(theirs[name])
            # It gives an array without a size the one that its uses need.
            if ours != (_SIZE.sub("[]", other) if "[]" in ours else other):
                yield f"'{name}' is {other}, with us {ours}"


def shape(kind: Type) -> str:
    """A type as :func:`shape_of` names it: structs and sizes that are not known have no name."""
    name = "struct" if kind.struct is not None else kind.name
    return name + "".join("[]" if size is None else f"[{size}]" for size in kind.dims)


def shape_of(text: str) -> str:
    """The name of a type in glslang's words: ``temp highp 3-component vector of float``."""
    head, is_struct, _ = re.split(r"(\b(?:structure|block)\{|$)", text, maxsplit=1)
    sizes = "".join(f"[{size[1] or ''}]" for size in _ARRAY.finditer(head))
    if is_struct:
        return f"struct{sizes}"
    if parts := _PARTS.search(text):
        length, columns, rows, base = parts.groups()
        size = columns if columns == rows else f"{columns}x{rows}"
        return f"{_PREFIX.get(base, base)}{f'vec{length}' if length else f'mat{size}'}{sizes}"
    return text.rsplit(" ", 1)[-1] + sizes
