"""The built-in block ``gl_PerVertex`` without an instance name, which no driver takes.

So that the rest knows the position by one name::

    out gl_PerVertex { vec4 gl_Position; } self;        out gl_PerVertex { vec4 gl_Position; };
    void main() { self.gl_Position = ...; }        =>   void main() { gl_Position = ...; }
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.sema.facts import Facts
from shadercache.transform.trees import replace_nodes

BUILTIN_BLOCK = "gl_PerVertex"


def plain_builtin_block(module: n.Module, facts: Facts) -> n.Module:
    """The module with the members of the built-in block as variables (the same if they are)."""

    def plain(original: n.Node, node: n.Node) -> n.Node:
        match original:
            case n.Member(object=n.Name() as owner, name=name, span=span):
                block = facts.symbols[owner].node
                if isinstance(block, n.BlockDecl) and block.name == BUILTIN_BLOCK:
                    return n.Name(span, name)
            case n.BlockDecl(name=name, instance=str()) if name == BUILTIN_BLOCK:
                return replace(original, instance=None, dims=())
        return node

    return replace_nodes(module, plain)
