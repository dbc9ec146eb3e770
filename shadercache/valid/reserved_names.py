"""Names that a shader may not give (GLSL 4.60 section 3.7): SC202, SC203, SC292."""

from __future__ import annotations

from shadercache.ast.nodes import BlockDecl, Declarator, FunctionProto, Node, Param, StructDef
from shadercache.sema.blocks import BUILTIN_BLOCK
from shadercache.sema.facts import Symbol
from shadercache.valid.subject import Subject


def check_names(subject: Subject) -> None:
    """The names of everything that the shader declares."""
    for proto in subject.nodes(FunctionProto):
        _check(proto.name, proto, subject)
    for struct in subject.nodes(StructDef):
        _check(struct.name, struct, subject)
        _check_members(struct, subject)
    for block in subject.nodes(BlockDecl):
        if block.name != BUILTIN_BLOCK:
            _check(block.name, block, subject)
            _check_members(block, subject)
    for node, symbol in subject.tables.declared.items():
        if isinstance(node, Param):
            _check(symbol.name, node, subject)
        elif not symbol.name.startswith("gl_"):  # valid.redeclared has those
            _check_variable(symbol, node, subject)


def _check(name: str, node: Node, subject: Subject) -> None:
    """Names with ``gl_`` are reserved, those with ``__`` doubtful."""
    if name.startswith("gl_"):
        subject.problems.error("SC203", "names with 'gl_' are reserved", node)
    elif "__" in name and subject.language.es_version == 100:
        subject.problems.error("SC203", f"'{name}': names with '__' are reserved", node)
    elif "__" in name:
        subject.problems.warn("SC292", f"'{name}': names with '__' are reserved", node)


def _check_members(owner: StructDef | BlockDecl, subject: Subject) -> None:
    for decl in owner.fields:
        for node in decl.declarators:
            if node.name.startswith("gl_"):
                _check(node.name, node, subject)


def _check_variable(symbol: Symbol, node: Declarator | BlockDecl, subject: Subject) -> None:
    language = subject.language
    if "__" in symbol.name:
        _check(symbol.name, node, subject)
    elif (
        symbol.is_global and language.es_version >= 300 and language.builtin_functions(symbol.name)
    ):
        subject.problems.error("SC202", f"'{symbol.name}' is a built-in function", node)
