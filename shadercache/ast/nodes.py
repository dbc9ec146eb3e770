"""The syntax tree of GLSL.

Nodes are frozen, compared by identity (so that side tables can be dictionaries keyed by node), and
carry the span of the source text they came from. Nothing is ever annotated in place: what an
analysis finds out stands in its own table. Parentheses are not in the tree; the printer sets them
by precedence.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from shadercache.source import NOWHERE, Span


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """Anything that stands in a source text."""

    span: Span


# --- expressions --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Name(Node):
    """A variable."""

    name: str


@dataclass(frozen=True, slots=True, eq=False)
class Literal(Node):
    """A number or ``true``/``false``, in the spelling of the source (``1.``, ``.5``, ``0x1Fu``)."""

    text: str


@dataclass(frozen=True, slots=True, eq=False)
class Unary(Node):
    """A prefix operator: ``+ - ! ~ ++ --``."""

    op: str
    operand: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Postfix(Node):
    """A postfix operator: ``++ --``."""

    op: str
    operand: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Binary(Node):
    """``left op right``; neither assignment nor comma."""

    op: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Conditional(Node):
    """``condition ? then : other``."""

    condition: Expr
    then: Expr
    other: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Assign(Node):
    """``target op value`` with ``op`` one of ``= += -= *= /= %= <<= >>= &= ^= |=``."""

    op: str
    target: Expr
    value: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Comma(Node):
    """``left, right`` as an operator."""

    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Call(Node):
    """A call of a function by name: the user's or a built-in."""

    name: str
    args: tuple[Expr, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Construct(Node):
    """A constructor: of a built-in type, of a struct, or of an array of either."""

    type: TypeSpec
    args: tuple[Expr, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Member(Node):
    """``object.name``: a field of a struct or block, or a swizzle."""

    object: Expr
    name: str


@dataclass(frozen=True, slots=True, eq=False)
class Index(Node):
    """``object[index]``."""

    object: Expr
    index: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Length(Node):
    """``object.length()``."""

    object: Expr


@dataclass(frozen=True, slots=True, eq=False)
class InitList(Node):
    """``{a, {b, c}}``, which only an initialiser may be or hold (GLSL 4.20, section 4.1.11)."""

    items: tuple[Expr, ...]


Expr: TypeAlias = (
    Name
    | Literal
    | Unary
    | Postfix
    | Binary
    | Conditional
    | Assign
    | Comma
    | Call
    | Construct
    | Member
    | Index
    | Length
    | InitList
)


# --- types and declarations -----------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class LayoutItem(Node):
    """One entry of ``layout(...)``: ``name`` or ``name = value``."""

    name: str
    value: Expr | None


@dataclass(frozen=True, slots=True, eq=False)
class Qualifiers(Node):
    """The qualifiers before a type. ``words`` are in source order, layout apart.

    ``layout`` is ``None`` where the source has no ``layout(...)``.
    """

    words: tuple[str, ...] = ()
    layout: tuple[LayoutItem, ...] | None = None

    def has(self, *words: str) -> bool:
        """Is any of these words among the qualifiers?"""
        return any(word in self.words for word in words)


NO_QUALIFIERS = Qualifiers(NOWHERE)

Dims: TypeAlias = tuple["Expr | None", ...]
"""Array sizes, outermost first as GLSL prints them; ``None`` is an unsized ``[]``."""


@dataclass(frozen=True, slots=True, eq=False)
class TypeSpec(Node):
    """A type as written: a name (``""`` for an anonymous struct) and array sizes."""

    name: str
    struct: StructDef | None = None
    dims: Dims = ()


@dataclass(frozen=True, slots=True, eq=False)
class StructDef(Node):
    """``struct name { fields }``."""

    name: str
    fields: tuple[VarDecl, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Declarator(Node):
    """One declared name, its array sizes and its initialiser."""

    name: str
    dims: Dims = ()
    init: Expr | None = None


@dataclass(frozen=True, slots=True, eq=False)
class VarDecl(Node):
    """``qualifiers type a, b = 1;`` (no declarators: ``struct S {...};``). Precision words are
    among the qualifiers."""

    qualifiers: Qualifiers
    type: TypeSpec
    declarators: tuple[Declarator, ...]


@dataclass(frozen=True, slots=True, eq=False)
class BlockDecl(Node):
    """An interface block: ``uniform Name { fields } instance[dims];``."""

    qualifiers: Qualifiers
    name: str
    fields: tuple[VarDecl, ...]
    instance: str | None = None
    dims: Dims = ()


@dataclass(frozen=True, slots=True, eq=False)
class PrecisionDecl(Node):
    """``precision mediump float;``."""

    precision: str
    type: TypeSpec


@dataclass(frozen=True, slots=True, eq=False)
class QualifierDecl(Node):
    """Qualifiers without a type: ``invariant gl_Position;``, ``layout(...) in;``."""

    qualifiers: Qualifiers
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Param(Node):
    """A parameter; ``name`` is ``None`` where the source gives none."""

    qualifiers: Qualifiers
    type: TypeSpec
    name: str | None = None
    dims: Dims = ()

    @property
    def writes_back(self) -> bool:
        """Is it ``out`` or ``inout``?"""
        return self.qualifiers.has("out", "inout")


@dataclass(frozen=True, slots=True, eq=False)
class FunctionProto(Node):
    """The head of a function; alone, with ``;``, it is a prototype. ``f(void)`` has no params."""

    qualifiers: Qualifiers
    type: TypeSpec
    name: str
    params: tuple[Param, ...]


@dataclass(frozen=True, slots=True, eq=False)
class FunctionDef(Node):
    """A function with its body."""

    proto: FunctionProto
    body: Block

    @property
    def name(self) -> str:
        """The function's name."""
        return self.proto.name


# --- statements -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Block(Node):
    """``{ ... }``."""

    body: tuple[Stmt, ...]


@dataclass(frozen=True, slots=True, eq=False)
class ExprStmt(Node):
    """An expression as a statement; the empty statement has none."""

    expr: Expr | None


@dataclass(frozen=True, slots=True, eq=False)
class DeclStmt(Node):
    """A declaration as a statement."""

    decl: VarDecl | PrecisionDecl | QualifierDecl | FunctionProto


@dataclass(frozen=True, slots=True, eq=False)
class If(Node):
    """``if (condition) then else other``."""

    condition: Expr
    then: Stmt
    other: Stmt | None


@dataclass(frozen=True, slots=True, eq=False)
class Switch(Node):
    """``switch (selector) { ... }`` with :class:`Case` labels among the statements."""

    selector: Expr
    body: tuple[Stmt, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Case(Node):
    """``case value:``, or ``default:`` where value is ``None``."""

    value: Expr | None


@dataclass(frozen=True, slots=True, eq=False)
class For(Node):
    """``for (init; condition; step) body``; a condition may declare a variable."""

    init: ExprStmt | DeclStmt
    condition: Expr | VarDecl | None
    step: Expr | None
    body: Stmt


@dataclass(frozen=True, slots=True, eq=False)
class While(Node):
    """``while (condition) body``."""

    condition: Expr | VarDecl
    body: Stmt


@dataclass(frozen=True, slots=True, eq=False)
class DoWhile(Node):
    """``do body while (condition);``."""

    body: Stmt
    condition: Expr


@dataclass(frozen=True, slots=True, eq=False)
class Return(Node):
    """``return value;``."""

    value: Expr | None


@dataclass(frozen=True, slots=True, eq=False)
class Jump(Node):
    """``break``, ``continue``, ``discard`` or ``demote``."""

    word: str


Stmt: TypeAlias = (
    Block | ExprStmt | DeclStmt | If | Switch | Case | For | While | DoWhile | Return | Jump
)


# --- the whole ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Directive(Node):
    """A directive that is kept for the driver: ``#extension ...``, ``#pragma ...`` (its text)."""

    text: str


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment, and where it belongs: no node, for it may stand anywhere.

    ``anchor`` is the offset at which the declaration or statement begins that the comment stands
    before, or (``behind``) at which the one ends that it stands behind. Nodes keep their spans
    when a tree is rewritten, so a comment goes or stays with what it is about.
    """

    span: Span
    text: str
    anchor: int
    behind: bool = False


Decl: TypeAlias = VarDecl | BlockDecl | PrecisionDecl | QualifierDecl | FunctionProto | FunctionDef


@dataclass(frozen=True, slots=True, eq=False)
class Module(Node):
    """A translation unit: ``#version version profile``, the kept directives, the declarations.

    Comments that stand before all else have the start of the module for their anchor.
    """

    version: int
    profile: str | None
    directives: tuple[Directive, ...]
    decls: tuple[Decl, ...]
    comments: tuple[Comment, ...] = ()
