"""The parser's callbacks for types, declarations and functions."""

from __future__ import annotations

from itertools import chain
from typing import Any, NamedTuple

from shadercache.ast import nodes as n
from shadercache.ast.nodes import NO_QUALIFIERS, Expr, Qualifiers, TypeSpec
from shadercache.front.tokens import Token
from shadercache.front.tree_state import TreeState
from shadercache.lang.words import PRECISIONS
from shadercache.source import Span


class Dim(NamedTuple):
    """``[size]`` or ``[]``, with the place where it ends."""

    size: Expr | None
    end: int


class FullType(NamedTuple):
    """Qualifiers and a type, before what is declared with them."""

    span: Span
    qualifiers: Qualifiers
    type: TypeSpec


class LayoutWords(NamedTuple):
    """``layout(...)`` among the qualifiers."""

    start: int
    end: int
    items: list[n.LayoutItem]


class DeclaredHead(NamedTuple):
    """What precedes the fields of a block or struct, or the parameters of a function."""

    start: int
    qualifiers: Qualifiers
    name: str
    type: TypeSpec | None = None


class TypeRules:
    """One method for each rule of types and qualifiers, of the rule's name."""

    def __init__(self, state: TreeState) -> None:
        self._state = state

    def layout(self, parts: list[Any]) -> LayoutWords:
        return LayoutWords(parts[0].start, parts[3].end, parts[2])

    def layout_item(self, parts: list[Any]) -> n.LayoutItem:
        name, _, value = parts
        # These two are words of layouts and also keywords or reserved words of some versions.
        if name.type != "NAME" and name.text not in ("shared", "packed"):
            message = f"'{name.text}' is a keyword and cannot be a layout"
            self._state.refuse("SC106", message, name.span)
        end = name.end if value is None else self._state.end_of(value)
        return n.LayoutItem(Span(name.start, end), name.text, value)

    def full_type(self, parts: list[Any]) -> FullType:
        words, type_spec = parts
        if words is None:
            return FullType(type_spec.span, NO_QUALIFIERS, type_spec)
        qualifiers = _qualifiers(words)
        return FullType(Span(words[0].start, type_spec.span.end), qualifiers, type_spec)

    def type_spec(self, parts: list[Any]) -> TypeSpec:
        named, dims = parts
        struct = named if isinstance(named, n.StructDef) else None
        name = named.text if struct is None else struct.name
        span = named.span
        if dims:
            span = Span(span.start, dims[-1].end)
        return TypeSpec(span, name, struct, _sizes(dims))

    def struct_open(self, parts: list[Any]) -> DeclaredHead:
        """``struct Name {``: from here on the name is a type."""
        word, token, _ = parts
        name = token.text if token else ""
        if name:
            self._state.scopes.declare_type(name)
        return DeclaredHead(word.start, NO_QUALIFIERS, name)

    def struct_def(self, parts: list[Any]) -> n.StructDef:
        head, members, closing = parts
        return n.StructDef(Span(head.start, closing.end), head.name, tuple(members))

    def dim(self, parts: list[Any]) -> Dim:
        _, size, closing = parts
        return Dim(size, closing.end)


class DeclarationRules:
    """One method for each rule of declarations, of the rule's name."""

    def __init__(self, state: TreeState) -> None:
        self._state = state

    def declarator(self, parts: list[Any]) -> n.Declarator:
        """A name; in its own initialiser it still means what it meant before."""
        name, dims, _, init = parts
        # The rule is complete behind the initialiser, which was read with the name's older meaning.
        self._state.scopes.declare_variable(name.text)
        end = dims[-1].end if dims else name.end
        if init is not None:
            end = self._state.end_of(init)
        return n.Declarator(Span(name.start, end), name.text, _sizes(dims), init)

    def field_name(self, parts: list[Any]) -> n.Declarator:
        """The name of a field hides nothing outside."""
        name, dims = parts
        end = dims[-1].end if dims else name.end
        return n.Declarator(Span(name.start, end), name.text, _sizes(dims))

    def init_list(self, parts: list[Any]) -> n.InitList:
        opening, items, _, closing = parts
        language = self._state.stream.language
        if not language.at_least(420, None, "GL_ARB_shading_language_420pack"):
            message = "initialiser lists in braces need GLSL 4.20"
            hint = "write a constructor, such as float[2](1.0, 2.0)"
            self._state.refuse("SC110", message, opening.span, hint)
        return n.InitList(Span(opening.start, closing.end), tuple(items))

    def var_decl_end(self, parts: list[Any]) -> n.VarDecl:
        (full, *names), closing = parts
        span = Span(full.span.start, closing.end)
        return n.VarDecl(span, full.qualifiers, full.type, tuple(names))

    def condition_decl(self, parts: list[Any]) -> n.VarDecl:
        """``type name = init`` as the condition of a loop."""
        full, name, equals, init = parts
        declarator = self.declarator([name, None, equals, init])
        span = Span(full.span.start, declarator.span.end)
        return n.VarDecl(span, full.qualifiers, full.type, (declarator,))

    def precision_decl(self, parts: list[Token]) -> n.PrecisionDecl:
        first, precision, name, closing = parts
        if precision.text not in PRECISIONS:
            message = "expected highp, mediump or lowp after 'precision'"
            self._state.refuse("SC103", message, precision.span)
        type_spec = TypeSpec(name.span, name.text)
        return n.PrecisionDecl(Span(first.start, closing.end), precision.text, type_spec)

    def qualifier_decl(self, parts: list[Any]) -> n.QualifierDecl:
        """``invariant gl_Position;``, ``layout(early_fragment_tests) in;``."""
        words, names, closing = parts
        qualifiers = _qualifiers(words)
        if names and not qualifiers.has("invariant", "precise"):
            message = f"expected a type before '{names[0].text}'"
            self._state.refuse("SC103", message, names[0].span)
        span = Span(words[0].start, closing.end)
        return n.QualifierDecl(span, qualifiers, tuple(name.text for name in names or ()))

    def block_head(self, parts: list[Any]) -> DeclaredHead:
        words, name, _ = parts
        return DeclaredHead(words[0].start, _qualifiers(words), name.text)

    def block_decl(self, parts: list[Any]) -> n.BlockDecl:
        """An interface block; without an instance its fields are variables outside it too."""
        head, members, _, instance, dims, closing = parts
        names = [name.name for decl in members for name in decl.declarators]
        for name in [instance.text] if instance else names:
            self._state.scopes.declare_variable(name)
        return n.BlockDecl(
            Span(head.start, closing.end),
            head.qualifiers,
            head.name,
            tuple(members),
            instance and instance.text,
            _sizes(dims),
        )

    def param(self, parts: list[Any]) -> n.Param:
        full, name, dims = parts
        end = dims[-1].end if dims else name.end if name else full.span.end
        if name:
            self._state.scopes.declare_variable(name.text)
        span = Span(full.span.start, end)
        return n.Param(span, full.qualifiers, full.type, name and name.text, _sizes(dims))

    def proto_open(self, parts: list[Any]) -> DeclaredHead:
        """``type name(``: the parameters have a scope together with the body."""
        full, name, _ = parts
        # Before the scope is opened: the name of the function may hide a struct outside of it.
        self._state.scopes.declare_variable(name.text)
        self._state.scopes.open()
        return DeclaredHead(full.span.start, full.qualifiers, name.text, full.type)

    def proto(self, parts: list[Any]) -> n.FunctionProto:
        head, params, closing = parts
        if params is None or (len(params) == 1 and _is_void(params[0])):
            params = ()
        span = Span(head.start, closing.end)
        return n.FunctionProto(span, head.qualifiers, head.type, head.name, tuple(params))

    def prototype(self, parts: list[Any]) -> n.FunctionProto:
        proto, closing = parts
        self._state.scopes.close()
        span = Span(proto.span.start, closing.end)
        return n.FunctionProto(span, proto.qualifiers, proto.type, proto.name, proto.params)


def _sizes(dims: list[Dim] | None) -> n.Dims:
    return tuple([dim.size for dim in dims]) if dims else ()


def _qualifiers(parts: list[Any]) -> Qualifiers:
    """The node for a list of qualifier words and layouts."""
    words = tuple([part.text for part in parts if isinstance(part, Token)])
    layouts = [part.items for part in parts if isinstance(part, LayoutWords)]
    layout = tuple(chain(*layouts)) if layouts else None
    return Qualifiers(Span(parts[0].start, parts[-1].end), words, layout)


def _is_void(param: n.Param) -> bool:
    plain = param.name is None and not param.dims and param.qualifiers is NO_QUALIFIERS
    return plain and param.type.name == "void" and not param.type.dims
