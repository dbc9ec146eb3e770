"""The ``.glsl`` files of this package and of the passes, as trees: each is parsed once.

Their expressions stand nowhere, so nothing takes them for the user's. Statements and declarations
have negative places, to which comments are anchored; no two files share one.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import count
from pathlib import Path

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.front.parse import parse
from shadercache.source import NOWHERE, Source, Span
from shadercache.transform.names import PREFIX

FOLDER = Path(__file__).with_name("glsl")

TYPE_WORDS = ("TEXEL", "TEXELS", "SAMPLERS", "SUMS", "CHANNEL")
"""Types that the layout of the payloads decides (:mod:`shadercache.caching.per_target`)."""

# Payloads may be of these.
_SMALL_TYPES = "#extension GL_EXT_shader_explicit_arithmetic_types : enable"

# Up to an empty line: a comment right above a declaration belongs to that.
_HEAD = re.compile(r"\A(?://.*\n)+(?=\n)")
_LONGEST = 1_000_000  # Places of one file lie before those of the next.
_numbers = count(1)


@dataclass(frozen=True, slots=True)
class Template:
    """The declarations of a file, and its comments."""

    decls: tuple[n.Decl, ...]
    comments: tuple[n.Comment, ...]


@cache
def read_template(path: Path, prefix: str) -> Template:
    """A file with the given name prefix, without what it says of itself at its head."""
    text = _HEAD.sub("", path.read_text(encoding="utf-8"))
    return parse_template(text.replace(PREFIX, prefix), prefix)


def parse_template(text: str, prefix: str, structs: Sequence[str] = ()) -> Template:
    """A text that may use the user's structs of these names."""
    # The parser has to know that these are types; what is in them is declared elsewhere.
    types = (*(prefix + word for word in TYPE_WORDS), *structs)
    unknown = (f"struct {name} {{ float unknown; }};" for name in types)
    whole = "\n".join(["#version 330", _SMALL_TYPES, *unknown, text])
    module = parse(Source("template.glsl", whole))
    placed = _Placed(-next(_numbers) * _LONGEST)
    decls = placed.rewrite(replace(module, directives=())).decls[len(types) :]
    return Template(decls, tuple(placed.comment(comment) for comment in module.comments))


class _Placed(Rewriter):
    """Moves the places of statements and declarations, and takes away all others."""

    def __init__(self, base: int) -> None:
        self._base = base

    def comment(self, comment: n.Comment) -> n.Comment:
        return replace(comment, span=self._moved(comment.span), anchor=self._base + comment.anchor)

    def _moved(self, span: Span) -> Span:
        return Span(self._base + span.start, self._base + span.end)

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        return replace(node, span=NOWHERE)

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        return replace(node, span=self._moved(node.span))

    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl:
        return replace(node, span=self._moved(node.span))

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        return node if node is n.NO_QUALIFIERS else replace(node, span=NOWHERE)
