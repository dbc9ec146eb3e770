"""Every expression of every shader of the corpus has the type that glslang gives it.

Each expression ``e`` of type T is wrapped in a call that only compiles for exactly T (see
:mod:`sema.glslang`), and glslang judges the whole.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from shadercache.ast.nodes import (
    Assign,
    Call,
    Case,
    Declarator,
    Expr,
    FunctionDef,
    Index,
    LayoutItem,
    Length,
    Member,
    Module,
    Name,
    Node,
    Postfix,
    TypeSpec,
    Unary,
    VarDecl,
)
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.lang.builtins import Signature
from shadercache.sema.facts import Facts, Stage
from shadercache.source import NOWHERE, Source
from shadercache.valid.validate import validate
from tests.glslang import PROBED, PROBES, bad_lines, needs_glslang

ROOT = Path(__file__).resolve().parents[2]
SHADERS = sorted(p for end in ("frag", "vert") for p in (ROOT / "corpus").glob(f"*/*.{end}"))


class Probe(Rewriter):
    """Wraps every expression that is a value in a probe for its type."""

    def __init__(self, facts: Facts, kept: set[Node]) -> None:
        self.facts, self.kept, self.count = facts, kept, 0

    def expression(self, node: Expr, original: Expr) -> Expr:
        kind = str(self.facts.types[original])
        if original in self.kept or kind not in PROBED:
            return node
        self.count += 1
        return Call(NOWHERE, f"sc_{kind}", (Call(NOWHERE, "sc_id", (node,)),))


def kept(module: Module, facts: Facts) -> set[Node]:
    """What no call may be put around: l-values and constant expressions."""
    found: set[Node] = set()
    for decl in module.decls:
        if not isinstance(decl, FunctionDef):
            found.update(walk(decl))
    for node in walk(module):
        match node:
            case Assign():
                found.update(path(node.target))
            case Unary(op="++" | "--") | Postfix():
                found.update(path(node.operand))
            case VarDecl() if node.qualifiers.has("const"):
                found.update(walk(node))
            case TypeSpec() | Case() | LayoutItem():
                found.update(walk(node))
            case Declarator():
                found.update(*(walk(size) for size in node.dims if size is not None))
            case Length():
                found.update(path(node.object))
            case Index() if facts.types[node.object].holds_opaque:
                found.update(walk(node.index))
            case Call():
                found.update(*(path(arg) for arg in written(node, facts)))
    return found


def path(target: Expr) -> Iterator[Node]:
    """An l-value and the l-values it is part of; not its indices."""
    yield target
    while not isinstance(target, Name):
        if not isinstance(target, Member | Index):
            return
        target = target.object
        yield target


def written(call: Call, facts: Facts) -> list[Expr]:
    """Arguments that the function writes or that must stay constant."""
    callee = facts.calls[call]
    if isinstance(callee, Signature):
        flags = [param.direction != "in" or param.constant for param in callee.params]
    else:
        proto = callee.proto if isinstance(callee, FunctionDef) else callee
        flags = [param.writes_back for param in proto.params]
    return [arg for arg, flag in zip(call.args, flags, strict=True) if flag]


@needs_glslang
@pytest.mark.parametrize("file", SHADERS, ids=lambda file: f"{file.parent.name}/{file.name}")
def test_types_of_all_expressions(file: Path, tmp_path: Path) -> None:
    stage: Stage = "vertex" if file.suffix == ".vert" else "fragment"
    source = Source(file.name, file.read_text())
    module = parse(source)
    facts = validate(module, source, stage)
    probe = Probe(facts, kept(module, facts))
    text = print_module(probe.rewrite(module))
    version, _, rest = text.partition("\n")
    probed = tmp_path / file.name
    probed.write_text(f"{version}\n{PROBES}{rest}")
    assert not bad_lines(probed)
    assert probe.count > 5
