"""The built-in block ``gl_PerVertex`` without an instance name, which no driver takes.

So that the rest knows the position by one name::

    out gl_PerVertex { vec4 gl_Position; } self;        out gl_PerVertex { vec4 gl_Position; };
    void main() { self.gl_Position = ...; }        =>   void main() { gl_Position = ...; }
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.sema.facts import Facts

BUILTIN_BLOCK = "gl_PerVertex"


def plain_builtin_block(module: n.Module, facts: Facts) -> n.Module:
    """The module with the members of the built-in block as variables (the same if they are)."""
    return _Plain(facts).rewrite(module)


class _Plain(Rewriter):
    def __init__(self, facts: Facts) -> None:
        self._facts = facts

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if isinstance(original, n.Member) and isinstance(original.object, n.Name):
            block = self._facts.symbols[original.object].node
            if isinstance(block, n.BlockDecl) and block.name == BUILTIN_BLOCK:
                return n.Name(original.span, original.name)
        return node

    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl:
        if isinstance(node, n.BlockDecl) and node.name == BUILTIN_BLOCK and node.instance:
            return replace(node, instance=None, dims=())
        return node
