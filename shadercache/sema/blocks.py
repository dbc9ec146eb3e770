"""Interface blocks (GLSL 3.30 section 4.3.7): the names that they declare."""

from __future__ import annotations

from shadercache.ast.nodes import BlockDecl
from shadercache.lang.types import Type, struct_type
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.storage import storage_of
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker

BUILTIN_BLOCK = "gl_PerVertex"
"""The block that a vertex shader may declare again."""

_WRITABLE = ("buffer", "out")


class BlockChecker:
    """Declares interface blocks: their members, or their instance names."""

    def __init__(
        self, context: InferenceContext, types: TypeResolver, variables: VariableChecker
    ) -> None:
        self._context = context
        self._resolver = types
        self._variables = variables

    def declare(self, block: BlockDecl) -> None:
        """Members of a block without instance name are global names; otherwise they are fields
        of the instance."""
        storage = storage_of(block.qualifiers, self._context.language.stage, local=False)
        fields = self._resolver.fields(block.fields, f"block {block.name}")
        self._context.tables.fields[block] = fields
        for qualifiers in (block.qualifiers, *(decl.qualifiers for decl in block.fields)):
            self._resolver.layout(qualifiers)
        self._claim_name(block, storage)
        if block.instance is None:
            self._declare_members(block, storage, fields)
            return
        kind = struct_type(block.name, fields)
        kind = self._resolver.with_dims(kind, block.dims, block)
        writable = storage in _WRITABLE
        symbol = Symbol(
            block.instance, kind, "block", block.qualifiers, block, True, writable, block
        )
        self._variables.enter(symbol, block)

    def _claim_name(self, block: BlockDecl, storage: Kind) -> None:
        """The name of a block is a global name, and one block of each storage may have it."""
        context = self._context
        stored = context.blocks.setdefault(block.name, set())
        if storage in stored or context.scopes.here(block.name) is not None:
            message = f"'{block.name}' is already declared in this scope"
            context.problems.error("SC202", message, block)
        stored.add(storage)

    def _declare_members(self, block: BlockDecl, storage: Kind, fields: dict[str, Type]) -> None:
        for decl in block.fields:
            for node in decl.declarators:
                symbol = Symbol(
                    node.name,
                    fields[node.name],
                    storage,
                    decl.qualifiers,
                    node,
                    writable=storage in _WRITABLE,
                    block=block,
                )
                self._variables.enter(symbol, node)
