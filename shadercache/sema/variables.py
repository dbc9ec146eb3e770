"""Declarations of variables and interface blocks (GLSL 3.30 sections 4.3, 4.3.7, 7.1)."""

from __future__ import annotations

from shadercache.ast.nodes import (
    BlockDecl,
    Declarator,
    Expr,
    QualifierDecl,
    Qualifiers,
    VarDecl,
)
from shadercache.lang import builtins
from shadercache.lang.types import BOOL, INT, VOID, Type, struct_type
from shadercache.sema.context import ERROR, Context
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.scopes import FunctionSet
from shadercache.sema.typespecs import TypeResolver

_STORAGE: dict[str, Kind] = {"const": "const", "uniform": "uniform", "in": "in", "out": "out"}
_WRITABLE = ("local", "global", "out")


class VariableChecker:
    """Declares variables, each after its initialiser is checked (the initialiser of ``x`` still
    sees the ``x`` outside, section 4.2.2)."""

    def __init__(self, context: Context, types: TypeResolver) -> None:
        self._context = context
        self._resolver = types
        self._check = types.expressions.check
        self._constants = types.expressions.constants

    def declare(self, decl: VarDecl) -> None:
        """A declaration of variables, global or local."""
        base = self._resolver.resolve(decl.type)
        self.check_layout(decl.qualifiers)
        kind = self._storage(decl.qualifiers)
        if base is VOID:
            base = self._context.error("SC204", "a variable cannot be void", decl.type)
        for declarator in decl.declarators:
            self._declare_one(decl, declarator, base, kind)

    def _storage(self, qualifiers: Qualifiers) -> Kind:
        """How a variable with these qualifiers is stored; complains where that is impossible."""
        context = self._context
        if qualifiers.has("varying", "attribute"):
            reads = context.stage == "fragment" or qualifiers.has("attribute")
            return "in" if reads else "out"
        words = [word for word in qualifiers.words if word in _STORAGE]
        if len(words) > 1:
            message = f"'{' '.join(words)}' contradict each other"
            context.error("SC221", message, qualifiers)
        local = context.scopes.depth > 0
        if local and words and words[0] != "const":
            message = f"'{words[0]}' stands only on global variables and parameters"
            context.error("SC221", message, qualifiers)
        if words:
            return _STORAGE[words[0]]
        return "local" if local else "global"

    def _declare_one(self, decl: VarDecl, declarator: Declarator, base: Type, kind: Kind) -> None:
        declared = self._resolver.with_dims(base, declarator.dims, declarator)
        given = None if declarator.init is None else self._check(declarator.init)
        if given is not None and given is not ERROR and declared is not ERROR:
            declared = self._initialised(declarator, declared, given, kind)
        if declared is not ERROR:
            self._check_storage(decl, declarator, declared, kind)
        symbol = Symbol(
            declarator.name,
            declared,
            kind,
            decl.qualifiers,
            declarator,
            self._context.scopes.depth == 0,
            kind in _WRITABLE,
        )
        if declarator.name.startswith("gl_"):
            self._redeclare_builtin(symbol, declarator)
        else:
            self._context.check_name(declarator.name, declarator)
            self._enter(symbol, declarator)
        if kind == "const":
            self._check_constant(symbol, declarator, given)

    def _initialised(self, node: Declarator, declared: Type, given: Type, kind: Kind) -> Type:
        """The type of a variable with an initialiser: sized by it where it has no size."""
        if kind in ("in", "out"):
            message = f"'{node.name}' is an '{kind}' variable: it has no initialiser"
            return self._context.error("SC221", message, node)
        sized = declared
        if declared.is_unsized and given.dims and declared.element is given.element:
            sized = given
        if given is VOID or not self._context.conversions.converts(given, sized):
            message = f"cannot initialise '{node.name}' of type {declared} with {given}"
            return self._context.error("SC210", message, node.init or node)
        return sized

    def _check_constant(self, symbol: Symbol, node: Declarator, given: Type | None) -> None:
        if node.init is None:
            self._context.error("SC222", f"the constant '{node.name}' has no value", node)
        elif node.init in self._constants.expressions:
            if symbol.type is not ERROR:
                self._constants.declare(symbol, node.init)
        elif given is not ERROR and (
            symbol.is_global or self._context.es or self._context.version < 420
        ):
            message = f"the value of the constant '{node.name}' is not a constant expression"
            self._context.error("SC222", message, node.init)

    def _check_storage(self, decl: VarDecl, node: Declarator, kind: Type, storage: Kind) -> None:
        """What types each kind of variable may have (sections 4.1.7, 4.3.4 to 4.3.6)."""
        problem = None
        if kind.holds_opaque and storage != "uniform":
            problem = f"'{node.name}' of type {kind} must be a uniform or a parameter"
        elif storage in ("in", "out"):
            problem = self._interface_problem(decl.qualifiers, node.name, kind, storage)
        if problem is not None:
            self._context.error("SC221", problem, node)

    def _interface_problem(
        self, qualifiers: Qualifiers, name: str, kind: Type, storage: Kind
    ) -> str | None:
        element = kind.struct is None and kind.base
        outer = (self._context.stage == "vertex") == (storage == "in")
        if element == "bool":
            return f"'{name}' of type {kind} cannot be '{storage}'"
        if outer and kind.struct is not None:
            return f"'{name}' is a struct: it cannot be '{storage}' here"
        if outer and storage == "out" and kind.cols > 1:
            return f"'{name}' is a matrix: it cannot be an output of a fragment shader"
        reads = storage == "in" and self._context.stage == "fragment"
        smooth = reads and not qualifiers.has("flat") and not name.startswith("gl_")
        if smooth and element in ("int", "uint", "double"):
            return f"'{name}' of type {kind} needs the qualifier 'flat'"
        return None

    def _enter(self, symbol: Symbol, node: Declarator | BlockDecl) -> None:
        """Declare, unless the scope has the name; an unsized array may be given its size."""
        scopes = self._context.scopes
        before = scopes.here(symbol.name)
        if before is not None and not _gives_size(before, symbol):
            what = "a function" if isinstance(before, FunctionSet) else "declared"
            message = f"'{symbol.name}' is already {what} in this scope"
            self._context.error("SC202", message, node)
        scopes.declare(symbol.name, symbol)
        self._context.declared[node] = symbol

    def _redeclare_builtin(self, symbol: Symbol, node: Declarator) -> None:
        """``in vec4 gl_FragCoord;`` with other qualifiers or an array size (section 7.1)."""
        context = self._context
        known = builtins.variable(
            symbol.name, context.stage, context.version, context.module.profile
        )
        kind = symbol.type
        if known is None or known.storage == "const" or context.scopes.depth:
            context.error("SC203", "names with 'gl_' are reserved", node)
        elif kind is not ERROR and _innermost(kind) != _innermost(known.type):
            message = f"'{symbol.name}' is redeclared as {kind}; it is {known.type}"
            context.error("SC202", message, node)
        own = Symbol(
            symbol.name,
            kind,
            "builtin",
            symbol.qualifiers,
            node,
            writable=known is not None and known.storage == "out",
            block=symbol.block,
        )
        self._enter(own, node)

    # --- blocks -----------------------------------------------------------------------------------

    def declare_block(self, block: BlockDecl) -> None:
        """An interface block: its members are global names, or fields of its instance name."""
        context = self._context
        self.check_layout(block.qualifiers)
        storage = self._storage(block.qualifiers)
        if storage not in ("uniform", "in", "out"):
            context.error("SC221", f"the block '{block.name}' is not uniform, in or out", block)
        fields = self._resolver.fields(block.fields, f"block {block.name}")
        for decl in block.fields:
            self.check_layout(decl.qualifiers)
        for name, kind in fields.items():
            if kind is not ERROR and kind.holds_opaque:
                message = f"the member '{name}' of a block cannot be {kind}"
                context.error("SC221", message, block)
        if (context.stage, storage) in (("vertex", "in"), ("fragment", "out")):
            message = f"a {context.stage} shader has no '{storage}' blocks"
            context.error("SC221", message, block.qualifiers)
        if block.instance is None:
            self._declare_members(block, storage, fields)
            return
        kind = struct_type(block.name, fields)
        kind = self._resolver.with_dims(kind, block.dims, block)
        symbol = Symbol(
            block.instance, kind, "block", block.qualifiers, block, writable=storage == "out"
        )
        context.check_name(block.instance, block)
        self._enter(symbol, block)

    def _declare_members(self, block: BlockDecl, storage: Kind, fields: dict[str, Type]) -> None:
        for decl in block.fields:
            for node in decl.declarators:
                symbol = Symbol(
                    node.name,
                    fields[node.name],
                    storage,
                    decl.qualifiers,
                    node,
                    writable=storage == "out",
                    block=block,
                )
                if node.name.startswith("gl_"):
                    self._redeclare_builtin(symbol, node)
                else:
                    self._context.check_name(node.name, node)
                    self._enter(symbol, node)

    # --- the rest ---------------------------------------------------------------------------------

    def declare_condition(self, decl: VarDecl) -> None:
        """A variable declared as the condition of a loop: one ``bool`` with a value."""
        self.declare(decl)
        for node in decl.declarators:
            symbol = self._context.declared.get(node)
            if symbol is not None and symbol.type not in (BOOL, ERROR):
                message = f"the condition is {symbol.type}, not bool"
                self._context.error("SC212", message, node)
            if node.init is None:
                self._context.error("SC212", "the condition has no value", node)

    def qualify(self, decl: QualifierDecl) -> None:
        """``invariant gl_Position;``: the names must be variables."""
        context = self._context
        self.check_layout(decl.qualifiers)
        for name in decl.names:
            entry = context.scopes.visible.get(name)
            profile = context.module.profile
            known = builtins.variable(name, context.stage, context.version, profile)
            if known is None and not isinstance(entry, Symbol):
                context.undeclared("variable", name, decl, context.known_variables)

    def check_layout(self, qualifiers: Qualifiers) -> None:
        """Values in ``layout(...)`` are constant integers, not negative."""
        for item in qualifiers.layout or ():
            if item.value is not None:
                self._check_layout_value(item.name, item.value)

    def _check_layout_value(self, name: str, value: Expr) -> None:
        kind = self._check(value)
        number = self._constants.values.get(value)
        if kind is not ERROR and (kind is not INT or not isinstance(number, int) or number < 0):
            message = f"the layout value of '{name}' is a constant integer, not negative"
            self._context.error("SC223", message, value)


def _gives_size(before: object, symbol: Symbol) -> bool:
    """Is this the second declaration of a global array that had no size (section 4.1.9)?"""
    return (
        isinstance(before, Symbol)
        and before.type.is_unsized
        and symbol.is_global
        and bool(symbol.type.dims)
        and before.type.element is symbol.type.element
    )


def _innermost(kind: Type) -> str:
    return kind.name if not kind.dims else f"{kind.name}[]"
