"""The parser's callbacks for types, declarations and functions."""

from __future__ import annotations

from typing import Any, NamedTuple

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    Block,
    BlockDecl,
    Declarator,
    Dims,
    Expr,
    FunctionDef,
    FunctionProto,
    InitList,
    LayoutItem,
    Param,
    PrecisionDecl,
    QualifierDecl,
    Qualifiers,
    StructDef,
    TypeSpec,
    VarDecl,
)
from shadercache.front.build_expressions import Dim, ExpressionBuilder
from shadercache.front.tokens import Token, TokenStream, TypeScopes
from shadercache.lang.words import PRECISIONS
from shadercache.source import Span


class FullType(NamedTuple):
    """Qualifiers and a type, before what is declared with them."""

    start: int
    end: int
    qualifiers: Qualifiers
    type: TypeSpec


class LayoutWords(NamedTuple):
    """``layout(...)`` among the qualifiers."""

    start: int
    end: int
    items: list[LayoutItem]


class DeclaredHead(NamedTuple):
    """What precedes the fields of a block or struct, or the parameters of a function."""

    start: int
    qualifiers: Qualifiers
    name: str
    type: TypeSpec | None = None


def _sizes(dims: list[Dim]) -> Dims:
    return tuple(dim.size for dim in dims)


def _qualifiers(parts: list[Any]) -> Qualifiers:
    """The node for a list of qualifier words and layouts."""
    words = tuple(part.text for part in parts if isinstance(part, Token))
    layouts = [part.items for part in parts if isinstance(part, LayoutWords)]
    layout = tuple(item for items in layouts for item in items) if layouts else None
    return Qualifiers(Span(parts[0].start, parts[-1].end), words, layout)


class DeclarationBuilder(ExpressionBuilder):
    """Callbacks for types, declarations and functions; keeps the scopes of names."""

    def begin(self, stream: TokenStream) -> None:
        """Make ready for another file."""
        super().begin(stream)
        self._scopes = stream.scopes

    def end(self) -> None:
        """Let go of the file."""
        super().end()
        self._scopes = TypeScopes()

    # --- qualifiers and types

    def layout(self, parts: list[Any]) -> LayoutWords:
        """``layout(items)``."""
        return LayoutWords(parts[0].start, parts[3].end, parts[2])

    def layout_item(self, parts: list[Any]) -> LayoutItem:
        """``name`` or ``name = value``."""
        name = parts[0]
        if name.type != "NAME" and name.text not in ("shared", "packed"):
            span = Span(name.start, name.end)
            self._refuse("SC106", f"'{name.text}' is a keyword and cannot be a layout", span)
        value: Expr | None = parts[2] if len(parts) == 3 else None
        end = name.end if value is None else self._end(value)
        return LayoutItem(Span(name.start, end), name.text, value)

    def qualifiers(self, parts: list[Any]) -> list[Any]:
        """The first qualifier."""
        return parts

    def qualifiers_more(self, parts: list[Any]) -> list[Any]:
        """One more qualifier."""
        return self.append(parts)

    def full_type(self, parts: list[Any]) -> FullType:
        """A type with the qualifiers before it."""
        type_spec = parts[-1]
        if len(parts) == 1:
            start, end = type_spec.span
            return FullType(start, end, NO_QUALIFIERS, type_spec)
        qualifiers = _qualifiers(parts[0])
        return FullType(qualifiers.span.start, type_spec.span.end, qualifiers, type_spec)

    def type_spec(self, parts: list[Any]) -> TypeSpec:
        """The name of a type or the definition of a struct, and array sizes."""
        what = parts[0]
        dims: list[Dim] = parts[1] if len(parts) == 2 else []
        if isinstance(what, StructDef):
            start, end, name, struct = *what.span, what.name, what
        else:
            start, end, name, struct = what.start, what.end, what.text, None
        return TypeSpec(Span(start, dims[-1].end if dims else end), name, struct, _sizes(dims))

    def struct_open(self, parts: list[Token]) -> DeclaredHead:
        """``struct Name {``: from here on the name is a type."""
        name = parts[1].text if len(parts) == 3 else ""
        if name:
            self._scopes.declare_type(name)
        return DeclaredHead(parts[0].start, NO_QUALIFIERS, name)

    def struct_def(self, parts: list[Any]) -> StructDef:
        """A struct with its fields."""
        head, fields, closing = parts
        return StructDef(Span(head.start, closing.end), head.name, tuple(fields))

    def field(self, parts: list[Any]) -> VarDecl:
        """``type a, b[2];`` in a struct or block."""
        full, names, closing = parts
        return VarDecl(Span(full.start, closing.end), full.qualifiers, full.type, tuple(names))

    def field_name(self, parts: list[Any]) -> Declarator:
        """The name of a field, with array sizes; it hides nothing outside."""
        return self._declarator(parts)

    # --- variables

    def declarator(self, parts: list[Any]) -> Declarator:
        """A name, with array sizes."""
        node = self._declarator(parts)
        self._scopes.declare_variable(node.name)
        return node

    def declarator_init(self, parts: list[Any]) -> Declarator:
        """A name with an initialiser, in which the name still means what it meant before."""
        node = self._declarator(parts)
        self._scopes.declare_variable(node.name)
        return node

    def _declarator(self, parts: list[Any]) -> Declarator:
        name = parts[0]
        dims: list[Dim] = parts[1] if len(parts) in (2, 4) else []
        init: Expr | None = parts[-1] if len(parts) > 2 else None
        last = dims[-1].end if dims else name.end
        end = last if init is None else self._end(init)
        return Declarator(Span(name.start, end), name.text, _sizes(dims), init)

    def var_decl(self, parts: list[Any]) -> tuple[FullType, list[Declarator]]:
        """A type and the first name, or none."""
        return parts[0], parts[1:]

    def var_decl_more(self, parts: list[Any]) -> tuple[FullType, list[Declarator]]:
        """One more name. (``float, a;`` is valid and the same as ``float a;``.)"""
        full, names = parts[0]
        names.append(parts[2])
        return full, names

    def init_list(self, parts: list[Any]) -> InitList:
        """``{a, b}``, with or without a comma at its end."""
        opening = parts[0]
        language = self._stream.language
        if not language.at_least(420, None, "GL_ARB_shading_language_420pack"):
            message = "initialiser lists in braces need GLSL 4.20"
            hint = "write a constructor, such as float[2](1.0, 2.0)"
            self._refuse("SC110", message, Span(opening.start, opening.end), hint)
        return InitList(Span(opening.start, parts[-1].end), tuple(parts[1]))

    def var_decl_end(self, parts: list[Any]) -> VarDecl:
        """The ``;`` after a declaration of variables."""
        (full, names), closing = parts
        return VarDecl(Span(full.start, closing.end), full.qualifiers, full.type, tuple(names))

    def condition_decl(self, parts: list[Any]) -> VarDecl:
        """``type name = init`` as the condition of a loop."""
        full, name, _, init = parts
        end = self._end(init)
        declarator = Declarator(Span(name.start, end), name.text, (), init)
        self._scopes.declare_variable(name.text)
        return VarDecl(Span(full.start, end), full.qualifiers, full.type, (declarator,))

    # --- other declarations

    def no_decl(self, parts: list[Token]) -> None:
        """A ``;`` of its own between declarations says nothing."""

    def precision_decl(self, parts: list[Token]) -> PrecisionDecl:
        """``precision highp float;``."""
        first, precision, name, closing = parts
        if precision.text not in PRECISIONS:
            span = Span(precision.start, precision.end)
            self._refuse("SC103", "expected highp, mediump or lowp after 'precision'", span)
        type_spec = TypeSpec(Span(name.start, name.end), name.text)
        return PrecisionDecl(Span(first.start, closing.end), precision.text, type_spec)

    def qualifier_decl(self, parts: list[Any]) -> QualifierDecl:
        """``invariant gl_Position;``, ``layout(early_fragment_tests) in;``."""
        qualifiers = _qualifiers(parts[0])
        names = tuple(name.text for name in parts[1]) if len(parts) == 3 else ()
        if names and not qualifiers.has("invariant", "precise"):
            name = parts[1][0]
            message = f"expected a type before '{name.text}'"
            self._refuse("SC103", message, Span(name.start, name.end))
        return QualifierDecl(Span(qualifiers.span.start, parts[-1].end), qualifiers, names)

    def block_head(self, parts: list[Any]) -> DeclaredHead:
        """``uniform Name {``."""
        qualifiers = _qualifiers(parts[0])
        return DeclaredHead(qualifiers.span.start, qualifiers, parts[1].text)

    def block_decl(self, parts: list[Any]) -> BlockDecl:
        """An interface block; without an instance its fields are variables outside it too."""
        head, fields = parts[:2]
        instance = parts[3].text if len(parts) > 4 else None
        dims: list[Dim] = parts[4] if len(parts) == 6 else []
        names = [name.name for decl in fields for name in decl.declarators]
        for name in names if instance is None else [instance]:
            self._scopes.declare_variable(name)
        span = Span(head.start, parts[-1].end)
        return BlockDecl(span, head.qualifiers, head.name, tuple(fields), instance, _sizes(dims))

    # --- functions

    def param(self, parts: list[Any]) -> Param:
        """A parameter; ``name`` and array sizes may be left out."""
        full = parts[0]
        name = parts[1] if len(parts) > 1 else None
        dims: list[Dim] = parts[2] if len(parts) > 2 else []
        end = dims[-1].end if dims else name.end if name else full.end
        if name:
            self._scopes.declare_variable(name.text)
        text = name.text if name else None
        return Param(Span(full.start, end), full.qualifiers, full.type, text, _sizes(dims))

    def proto_open(self, parts: list[Any]) -> DeclaredHead:
        """``type name(``: the parameters have a scope together with the body."""
        full, name, _ = parts
        self._scopes.declare_variable(name.text)
        self._scopes.open()
        return DeclaredHead(full.start, full.qualifiers, name.text, full.type)

    def proto(self, parts: list[Any]) -> FunctionProto:
        """The head of a function."""
        head = parts[0]
        params: list[Param] = parts[1] if len(parts) == 3 else []
        if len(params) == 1 and _is_void(params[0]):
            params = []
        span = Span(head.start, parts[-1].end)
        return FunctionProto(span, head.qualifiers, head.type, head.name, tuple(params))

    def prototype(self, parts: list[Any]) -> FunctionProto:
        """The head of a function with ``;``."""
        proto, closing = parts
        self._scopes.close()
        span = Span(proto.span.start, closing.end)
        return FunctionProto(span, proto.qualifiers, proto.type, proto.name, proto.params)

    def function_def(self, parts: list[Any]) -> FunctionDef:
        """A function with its body."""
        proto: FunctionProto = parts[0]
        body: Block = parts[1]
        return FunctionDef(Span(proto.span.start, body.span.end), proto, body)


def _is_void(param: Param) -> bool:
    plain = param.name is None and not param.dims and param.qualifiers is NO_QUALIFIERS
    return plain and param.type.name == "void" and not param.type.dims
