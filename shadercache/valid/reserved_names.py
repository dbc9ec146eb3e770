"""Names that a shader may not give (GLSL 4.60 section 3.7): SC202, SC203, SC292."""

from __future__ import annotations

from shadercache.ast.nodes import BlockDecl, Declarator, FunctionProto, Node, Param, StructDef
from shadercache.sema.blocks import BUILTIN_BLOCK
from shadercache.sema.facts import Symbol
from shadercache.valid.suspect import Suspect


def check_names(suspect: Suspect) -> None:
    """The names of everything that the shader declares."""
    for proto in suspect.nodes(FunctionProto):
        _check(proto.name, proto, suspect)
    for struct in suspect.nodes(StructDef):
        _check(struct.name, struct, suspect)
        _check_members(struct, suspect)
    for block in suspect.nodes(BlockDecl):
        if block.name != BUILTIN_BLOCK:
            _check(block.name, block, suspect)
            _check_members(block, suspect)
    for node, symbol in suspect.tables.declared.items():
        if isinstance(node, Param):
            _check(symbol.name, node, suspect)
        elif not symbol.name.startswith("gl_"):  # valid.redeclared has those
            _check_variable(symbol, node, suspect)


def _check(name: str, node: Node, suspect: Suspect) -> None:
    """Names with ``gl_`` are reserved, those with ``__`` doubtful."""
    if name.startswith("gl_"):
        suspect.problems.error("SC203", "names with 'gl_' are reserved", node)
    elif "__" in name and suspect.language.es_version == 100:
        suspect.problems.error("SC203", f"'{name}': names with '__' are reserved", node)
    elif "__" in name:
        suspect.problems.warn("SC292", f"'{name}': names with '__' are reserved", node)


def _check_members(owner: StructDef | BlockDecl, suspect: Suspect) -> None:
    for decl in owner.fields:
        for node in decl.declarators:
            if node.name.startswith("gl_"):
                _check(node.name, node, suspect)


def _check_variable(symbol: Symbol, node: Declarator | BlockDecl, suspect: Suspect) -> None:
    language = suspect.language
    if "__" in symbol.name:
        _check(symbol.name, node, suspect)
    elif (
        symbol.is_global and language.es_version >= 300 and language.builtin_functions(symbol.name)
    ):
        suspect.problems.error("SC202", f"'{symbol.name}' is a built-in function", node)
