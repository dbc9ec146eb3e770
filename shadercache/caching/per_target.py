"""What differs with the layout of the payloads: the types of texels, and how many there are.

The files are written for one texture. ``sc_TEXELS`` is the type of what there is of each texture:
where there are two, a declaration or an assignment of such a variable is there twice, and so is a
parameter with its argument::

    sc_TEXELS a = texelFetch(sc_cache, near, 0);

    uvec4 a = texelFetch(sc_cache, near, 0);
    uvec4 a_2 = texelFetch(sc_cache_2, near, 0);

Other words: ``sc_TEXEL`` is one of them, ``sc_CHANNEL`` a scalar of it, ``sc_SUMS`` are floats for
each texture, and ``sc_SAMPLERS`` the textures. ``sc_ANY_FLOATS(condition)`` asks of all textures
with floats, ``if (sc_IF_INTEGERS(condition))`` of one after another that has integers or booleans;
``sc_MERGED`` and ``sc_ONLY_FLOATS`` come to less where all channels are floats, or none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.caching.fill import Filler, returned
from shadercache.caching.layout import Layout
from shadercache.source import NOWHERE
from shadercache.transform.rename import rename

N = TypeVar("N", bound=n.Node)
D = TypeVar("D", bound=n.Decl)

_EACH = ("TEXELS", "SAMPLERS", "SUMS")
_TYPES = {
    **{"TEXEL": "vec4", "TEXELS": "vec4", "CHANNEL": "float"},
    **{"SAMPLERS": "sampler2D", "SUMS": "vec4"},
}
_TYPES_OF_BITS = _TYPES | {
    **{"TEXEL": "uvec4", "TEXELS": "uvec4", "CHANNEL": "uint", "SAMPLERS": "usampler2D"},
}


class PerTarget:
    """Makes declarations that are filled in what they are for the textures of a layout.

    ``decls`` are all that they name.
    """

    def __init__(
        self, decls: Sequence[n.Decl], layout: Layout, filler: Filler, prefix: str
    ) -> None:
        self.layout, self.prefix = layout, prefix
        words = _TYPES_OF_BITS if layout.bits else _TYPES
        self.types = {prefix + word: kind for word, kind in words.items()}
        self._each = frozenset(prefix + word for word in _EACH)
        self._shared = {
            # Of these the second is written out already (payload_text.py).
            *(prefix + word for word in ("discrete", "pack", "PACKED")),
            *(d.declarators[0].name for d in decls if isinstance(d, n.VarDecl) and self.is_each(d)),
        }
        self.places = {
            decl.name: [at for at, param in enumerate(decl.proto.params) if self.is_each(param)]
            for decl in decls
            if isinstance(decl, n.FunctionDef)
        }
        """Of each function the parameters that are there for each texture."""
        self._typer = _Typer(self, filler)

    def __call__(self, decl: D) -> list[D]:
        # Doubled first: the words for types tell what there is of each texture.
        return [self._typer.rewrite(one) for one in _Doubler(self, decl).doubled(decl)]

    def is_each(self, decl: n.VarDecl | n.Param) -> bool:
        return decl.type.name in self._each

    def names(self, decl: n.Decl) -> set[str]:
        """The variables in a declaration that are there for each texture."""
        names = set(self._shared)
        for node in walk(decl):
            if isinstance(node, n.VarDecl) and self.is_each(node):
                names.update(declarator.name for declarator in node.declarators)
            elif isinstance(node, n.Param) and self.is_each(node):
                names.add(node.name or "")
        return names


class _Doubler(Rewriter):
    """Has twice what is there of each of two textures."""

    def __init__(self, target: PerTarget, decl: n.Decl) -> None:
        self._target = target
        self._two = target.layout.second
        self._names = target.names(decl)
        self._second = {name: f"{name}_2" for name in self._names}
        self._floats, self._integers = target.prefix + "ANY_FLOATS", target.prefix + "IF_INTEGERS"

    def doubled(self, decl: D) -> list[D]:
        decl = self.rewrite(decl)
        again = isinstance(decl, n.VarDecl) and self._target.is_each(decl) and self._two
        return self._both(decl) if again else [decl]

    def _both(self, node: N) -> list[N]:
        return [node, rename(node, self._second)]

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if self._two:
            match node:
                case n.DeclStmt(decl=n.VarDecl() as decl) if self._target.is_each(decl):
                    return self._both(node)
                case n.ExprStmt(expr=n.Assign(target=n.Name(name=name))) if name in self._names:
                    return self._both(node)
        match node:
            case n.If(condition=n.Call(name=name, args=(condition,))) if name == self._integers:
                both = self._both(replace(node, condition=condition))
                return [one for at, one in enumerate(both) if self._target.layout.has_integers(at)]
        return node

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        if isinstance(node, n.FunctionProto) and self._two:
            places = self._target.places.get(node.name, [])
            return replace(node, params=self._beside(node.params, places))
        return node

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if isinstance(node, n.Call):
            if node.name == self._floats:
                return self._any(node.args[0])
            if self._two and (places := self._target.places.get(node.name)):
                return replace(node, args=self._beside(node.args, places))
        return node

    def _beside(self, nodes: Sequence[N], places: Sequence[int]) -> tuple[N, ...]:
        beside = (self._both(node) if at in places else [node] for at, node in enumerate(nodes))
        return tuple(node for both in beside for node in both)

    def _any(self, condition: n.Expr) -> n.Expr:
        """A condition asked of each texture that holds floats: is it true of any?"""
        first, second = self._both(condition)
        more = self._target.layout.has_floats(1)
        return n.Binary(NOWHERE, "||", first, second) if more else first


class _Typer(Rewriter):
    """Puts types in, and what the late words come to for one of the textures."""

    def __init__(self, target: PerTarget, filler: Filler) -> None:
        self._target, self._filler = target, filler
        self._marks = {
            f"{target.prefix}discrete{'_2' * texel}": target.layout.integers(texel)
            for texel in range(2)
        }

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        if isinstance(node, n.TypeSpec) and node.name in self._target.types:
            return replace(node, name=self._target.types[node.name])
        return node

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if isinstance(node, n.Call) and (word := self._filler.word(node.name)):
            mask = node.args[-1] if node.args else None
            marks = self._marks[mask.name] if isinstance(mask, n.Name) else ()
            # A mask of no bits, or of all, chooses nothing: the text says only what is left.
            if marks and not any(marks):
                return node.args[0]
            if marks and all(marks) and word == "MERGED":
                return node.args[1]
            (function,) = self._filler.functions(word)
            return self.rewrite(returned(function, node.args))
        return node
