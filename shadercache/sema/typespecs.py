"""Types as written: names, struct definitions, array sizes."""

from __future__ import annotations

from shadercache.ast.nodes import Dims, Expr, Node, Qualifiers, StructDef, TypeSpec, VarDecl
from shadercache.lang.builtins import struct
from shadercache.lang.types import INT, UINT, VOID, Type, array_of, builtin_type, struct_type
from shadercache.sema.expression_types import ExpressionChecker
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR


class TypeResolver:
    """Turns :class:`TypeSpec` into :class:`Type`, declaring the structs it defines."""

    def __init__(self, context: InferenceContext) -> None:
        self._context = context
        self.expressions = ExpressionChecker(context, self.resolve)

    def declared(self, spec: TypeSpec) -> Type:
        """The type of something that is declared with this specifier."""
        kind = self.resolve(spec)
        if spec.dims and kind is not ERROR and not self._context.language.arrays_are_values:
            message = f"the size of an array stands behind its name: {kind.element} x[...]"
            return self._context.problems.error("SC221", message, spec)
        return kind

    def layout(self, qualifiers: Qualifiers) -> None:
        """The types of the values in a ``layout(...)``."""
        for item in qualifiers.layout or ():
            if item.value is not None:
                self.expressions.check(item.value)

    def resolve(self, spec: TypeSpec) -> Type:
        """The type a specifier stands for; ``ERROR`` after a diagnostic."""
        kind = self._named(spec)
        if spec.dims:
            kind = self.with_dims(kind, spec.dims, spec)
        self._context.tables.specs[spec] = kind
        return kind

    def _named(self, spec: TypeSpec) -> Type:
        if spec.struct is not None:
            return self.define(spec.struct)
        found = builtin_type(spec.name) or self._context.scopes.visible.get(spec.name)
        if found is None and spec.name.startswith("gl_"):
            found = struct(spec.name)
        return found if isinstance(found, Type) else self._unknown(spec, found is not None)

    def _unknown(self, spec: TypeSpec, variable: bool) -> Type:
        if variable:
            return self._context.problems.error("SC204", f"'{spec.name}' is not a type here", spec)
        known = self._context.scopes.names
        return self._context.problems.undeclared("type", spec.name, spec, known)

    def with_dims(self, element: Type, dims: Dims, node: Node) -> Type:
        """``element`` with array sizes around it; ``node`` is blamed for what is wrong."""
        if not dims or element is ERROR:
            for size in dims:
                if size is not None:
                    self.expressions.check(size)
            return element
        if element is VOID:
            return self._context.problems.error("SC204", "an array of void", node)
        kind = element
        for size in reversed(dims):
            number = None if size is None else self._size(size)
            if number == 0:
                return ERROR
            kind = array_of(kind, number)
        if len(kind.dims) > 1 and not self._context.language.at_least(430, 310):
            return self._context.problems.error("SC225", "arrays of arrays need GLSL 4.30", node)
        return kind

    def _size(self, size: Expr) -> int:
        """A constant positive integer; 0 after a diagnostic."""
        problems, constants = self._context.problems, self.expressions.constants
        kind = self.expressions.check(size)
        if kind is ERROR:
            return 0
        value = constants.values.get(size)
        if kind not in (INT, UINT) or size not in constants.expressions:
            problems.error("SC215", "an array size is a constant integer", size)
        elif not isinstance(value, int):
            problems.error("SC215", "the value of this array size cannot be computed", size)
        elif value <= 0:
            problems.error("SC215", f"an array size is positive, not {value}", size)
        else:
            return value
        return 0

    def define(self, struct: StructDef) -> Type:
        """Declare the struct in the current scope (section 4.1.8)."""
        fields = self.fields(struct.fields, f"struct {struct.name}".rstrip())
        kind = struct_type(struct.name, fields)
        if kind.struct is not None:
            self._context.tables.structs[kind.struct] = struct
        if not struct.name:
            return kind
        if self._context.scopes.here(struct.name) is not None:
            message = f"'{struct.name}' is declared twice in the same scope"
            return self._context.problems.error("SC202", message, struct)
        self._context.check_block_name(struct.name, struct)
        self._context.scopes.declare(struct.name, kind)
        return kind

    def fields(self, decls: tuple[VarDecl, ...], owner: str) -> dict[str, Type]:
        """Names and types of the members of a struct or block."""
        fields: dict[str, Type] = {}
        for decl in decls:
            base = self.declared(decl.type)
            if base is VOID:
                base = self._context.problems.error("SC204", "a member cannot be void", decl.type)
            for declarator in decl.declarators:
                if declarator.name in fields:
                    message = f"{owner} has two members '{declarator.name}'"
                    self._context.problems.error("SC202", message, declarator)
                fields[declarator.name] = self.with_dims(base, declarator.dims, declarator)
        return fields
