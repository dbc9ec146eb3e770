"""Types as written: names, struct definitions, array sizes."""

from __future__ import annotations

from shadercache.ast.nodes import Dims, Expr, Node, Qualifiers, StructDef, TypeSpec, VarDecl
from shadercache.lang.builtins import struct
from shadercache.lang.types import INT, UINT, VOID, Type, array_of, builtin_type, struct_type
from shadercache.sema.check_context import ERROR, Context
from shadercache.sema.default_precisions import Precisions
from shadercache.sema.expression_types import ExpressionChecker

_FIELD_WORDS = frozenset(("highp", "mediump", "lowp"))


class TypeResolver:
    """Turns :class:`TypeSpec` into :class:`Type`, declaring the structs it defines."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self.expressions = ExpressionChecker(context, self.resolve)
        self.precisions = Precisions(context)

    def declared(self, qualifiers: Qualifiers, spec: TypeSpec) -> Type:
        """The type of something declared with these qualifiers, which have to give it all that
        the version wants."""
        kind = self.resolve(spec)
        self.precisions.require(kind, qualifiers, spec)
        if spec.dims and kind is not ERROR and not self._context.arrays_are_values:
            message = f"the size of an array stands behind its name: {kind.element} x[...]"
            return self._context.error("SC221", message, spec)
        return kind

    def resolve(self, spec: TypeSpec) -> Type:
        """The type a specifier stands for; ``ERROR`` after a diagnostic."""
        if spec.struct is not None:
            kind = self.define(spec.struct)
        else:
            found = builtin_type(spec.name) or self._context.scopes.visible.get(spec.name)
            if found is None and spec.name.startswith("gl_"):
                found = struct(spec.name)
            if not isinstance(found, Type):
                return self._unknown(spec, found is not None)
            kind = found
        return self.with_dims(kind, spec.dims, spec) if spec.dims else kind

    def _unknown(self, spec: TypeSpec, variable: bool) -> Type:
        if variable:
            return self._context.error("SC204", f"'{spec.name}' is not a type here", spec)
        return self._context.undeclared("type", spec.name, spec, self._context.scopes.names)

    def with_dims(self, element: Type, dims: Dims, node: Node) -> Type:
        """``element`` with array sizes around it; ``node`` is blamed for what is wrong."""
        if not dims or element is ERROR:
            for size in dims:
                if size is not None:
                    self.expressions.check(size)
            return element
        if element is VOID:
            return self._context.error("SC204", "an array of void", node)
        kind = element
        for size in reversed(dims):
            number = None if size is None else self._size(size)
            if number == 0:
                return ERROR
            kind = array_of(kind, number)
        if len(kind.dims) > 1 and self._context.version < (310 if self._context.es else 430):
            return self._context.error("SC225", "arrays of arrays need GLSL 4.30", node)
        return kind

    def _size(self, size: Expr) -> int:
        """A constant positive integer; 0 after a diagnostic."""
        context, constants = self._context, self.expressions.constants
        kind = self.expressions.check(size)
        if kind is ERROR:
            return 0
        value = constants.values.get(size)
        if kind not in (INT, UINT) or size not in constants.expressions:
            context.error("SC215", "an array size is a constant integer", size)
        elif not isinstance(value, int):
            context.error("SC215", "the value of this array size cannot be computed", size)
        elif value <= 0:
            context.error("SC215", f"an array size is positive, not {value}", size)
        else:
            return value
        return 0

    def define(self, struct: StructDef) -> Type:
        """Declare the struct in the current scope (section 4.1.8)."""
        fields = self.fields(struct.fields, f"struct {struct.name}".rstrip())
        for decl in struct.fields:
            self._check_field(decl)
        kind = struct_type(struct.name, fields)
        if kind.struct is not None:
            self._context.structs[kind.struct] = struct
        if not struct.name:
            return kind
        if self._context.scopes.here(struct.name) is not None:
            message = f"'{struct.name}' is declared twice in the same scope"
            return self._context.error("SC202", message, struct)
        self._context.check_name(struct.name, struct)
        self._context.check_block_name(struct.name, struct)
        self._context.scopes.declare(struct.name, kind)
        return kind

    def _check_field(self, decl: VarDecl) -> None:
        """Fields of a struct have no qualifiers but precision, and define no struct."""
        extra = [word for word in decl.qualifiers.words if word not in _FIELD_WORDS]
        if extra:
            message = f"'{extra[0]}' does not apply to a field"
            self._context.error("SC221", message, decl.qualifiers)
        if decl.qualifiers.layout and not self._context.bindless:
            self._context.error("SC223", "a field of a struct has no layout", decl.qualifiers)
        if decl.type.struct is not None:
            message = "a struct cannot be defined inside of a struct"
            self._context.error("SC221", message, decl.type)

    def fields(self, decls: tuple[VarDecl, ...], owner: str) -> dict[str, Type]:
        """Names and types of the members of a struct or block."""
        fields: dict[str, Type] = {}
        for decl in decls:
            base = self.declared(decl.qualifiers, decl.type)
            if base is VOID:
                base = self._context.error("SC204", "a member cannot be void", decl.type)
            for declarator in decl.declarators:
                if declarator.name in fields:
                    message = f"{owner} has two members '{declarator.name}'"
                    self._context.error("SC202", message, declarator)
                if declarator.name.startswith("gl_") and not owner.endswith(" gl_PerVertex"):
                    self._context.check_name(declarator.name, declarator)
                fields[declarator.name] = self.with_dims(base, declarator.dims, declarator)
        return fields
