"""Interface blocks (GLSL 3.30 section 4.3.7)."""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.ast.nodes import BlockDecl, Qualifiers
from shadercache.lang.types import Type, struct_type
from shadercache.sema.check_context import ERROR, Context
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.qualifiers import STORAGE
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker

_BUILTIN_BLOCK = "gl_PerVertex"
_IO_EXTENSIONS = ("GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
# First desktop and ES versions of the blocks of each storage, and the extensions that have them.
_SINCE: Mapping[str, tuple[int, int, *tuple[str, ...]]] = {
    "uniform": (140, 300, "GL_ARB_uniform_buffer_object"),
    "buffer": (430, 310, "GL_ARB_shader_storage_buffer_object"),
    "in": (150, 320, *_IO_EXTENSIONS),
    "out": (150, 320, *_IO_EXTENSIONS),
}
_STAGE_HAS_NONE = (("vertex", "in"), ("fragment", "out"))


class BlockChecker:
    """Declares interface blocks: their members, or their instance names."""

    def __init__(self, context: Context, types: TypeResolver, variables: VariableChecker) -> None:
        self._context = context
        self._resolver = types
        self._variables = variables

    def declare(self, block: BlockDecl) -> None:
        """Members of a block without instance name are global names; otherwise they are fields
        of the instance."""
        storage = self._variables.storage(block.qualifiers)
        self._check_storage(block, storage)
        if block.name == _BUILTIN_BLOCK:
            self._check_redeclared(block)
        fields = self._resolver.fields(block.fields, f"block {block.name}")
        self._variables.layouts.block(block, storage, fields)
        self._check_members(block, storage, fields)
        self._check_sizes(block, storage, fields)
        self._claim_name(block, storage)
        if block.instance is None:
            self._declare_members(block, storage, fields)
            return
        kind = struct_type(block.name, fields)
        kind = self._resolver.with_dims(kind, block.dims, block)
        writable = _writable(storage, block.qualifiers)
        symbol = Symbol(
            block.instance, kind, "block", block.qualifiers, block, True, writable, block
        )
        self._variables.enter(symbol, block)

    def _check_members(self, block: BlockDecl, storage: Kind, fields: dict[str, Type]) -> None:
        context = self._context
        for decl in block.fields:
            for node in decl.declarators:
                kind = fields[node.name]
                if kind is not ERROR and context.only_handles(kind):
                    message = f"the member '{node.name}' of a block cannot be {kind}"
                    context.error("SC221", message, node)
            other = [word for word in decl.qualifiers.words if word in STORAGE and word != storage]
            if other:
                message = f"'{other[0]}' does not apply to a member of a '{storage}' block"
                context.error("SC221", message, decl)
            problem = context.words_problem(decl.qualifiers.words)
            if problem is not None:
                context.error("SC221", problem, decl)
            if decl.type.struct is not None:
                message = "a struct cannot be defined inside of a block"
                context.error("SC221", message, decl.type)

    def _check_sizes(self, block: BlockDecl, storage: Kind, fields: dict[str, Type]) -> None:
        """GLSL ES has arrays without a size only at the end of a buffer (ES 3.10 section 4.1.9)."""
        nodes = [node for decl in block.fields for node in decl.declarators]
        for node in nodes[:-1] if storage == "buffer" else nodes:
            kind = fields[node.name]
            if self._context.es and kind is not ERROR and kind.is_unsized:
                self._context.error("SC215", f"'{node.name}' has no size", node)

    def _check_redeclared(self, block: BlockDecl) -> None:
        """``out gl_PerVertex { vec4 gl_Position; };`` (4.10 section 7.1): only what is there."""
        context = self._context
        extensions = ("GL_ARB_separate_shader_objects", *_IO_EXTENSIONS)
        if not context.at_least(410, 320) and context.extensions.isdisjoint(extensions):
            context.error("SC221", "this version of GLSL has gl_PerVertex as it is", block)
            return
        for decl in block.fields:
            for node in decl.declarators:
                if context.builtin_variable(node.name) is None:
                    message = f"gl_PerVertex has no member '{node.name}'"
                    context.error("SC202", message, node)

    def _check_storage(self, block: BlockDecl, storage: Kind) -> None:
        context = self._context
        if storage not in _SINCE:
            message = f"the block '{block.name}' is not uniform, buffer, in or out"
            context.error("SC221", message, block)
        elif not self._is_known(storage):
            message = f"this version of GLSL has no '{storage}' blocks"
            context.error("SC221", message, block.qualifiers)
        elif (context.stage, storage) in _STAGE_HAS_NONE:
            message = f"a {context.stage} shader has no '{storage}' blocks"
            context.error("SC221", message, block.qualifiers)

    def _is_known(self, storage: Kind) -> bool:
        desktop, es, *extensions = _SINCE[storage]
        context = self._context
        if context.at_least(desktop, es):
            return True
        extended = storage != "buffer" or context.at_least(150, 310)
        return extended and not context.extensions.isdisjoint(extensions)

    def _claim_name(self, block: BlockDecl, storage: Kind) -> None:
        """The name of a block is a global name, and one block of each storage may have it."""
        context = self._context
        if block.name != _BUILTIN_BLOCK:
            context.check_name(block.name, block)
        stored = context.blocks.setdefault(block.name, set())
        if storage in stored or context.scopes.here(block.name) is not None:
            context.error("SC202", f"'{block.name}' is already declared in this scope", block)
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
                    writable=_writable(storage, block.qualifiers, decl.qualifiers),
                    block=block,
                )
                self._variables.enter(symbol, node)


def _writable(storage: Kind, *qualifiers: Qualifiers) -> bool:
    """Can it be written? (``readonly`` stands on the block or on the member.)"""
    if storage == "buffer":
        return not any(item.has("readonly") for item in qualifiers)
    return storage == "out"
