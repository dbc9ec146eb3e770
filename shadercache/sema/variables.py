"""Declarations of variables (GLSL 3.30 sections 4.1.7, 4.3 and 7)."""

from __future__ import annotations

from shadercache.ast.nodes import (
    BlockDecl,
    Declarator,
    PrecisionDecl,
    QualifierDecl,
    Qualifiers,
    VarDecl,
)
from shadercache.lang import builtins
from shadercache.lang.types import BOOL, VOID, Type
from shadercache.sema.check_context import ERROR, NEVER, Context
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.initialisers import InitialiserChecker
from shadercache.sema.layout_words import IMAGE_FORMATS
from shadercache.sema.layouts import LayoutChecker
from shadercache.sema.qualifiers import MEMORY, global_problem
from shadercache.sema.redeclared import redeclared
from shadercache.sema.scopes import FunctionSet
from shadercache.sema.typespecs import TypeResolver

_STORAGE: dict[str, Kind] = {
    **{"const": "const", "uniform": "uniform", "in": "in", "out": "out", "buffer": "buffer"}
}
_WRITABLE = ("local", "global", "out")
_LOCAL_WORDS = frozenset(("const", "precise", "highp", "mediump", "lowp"))


# Formats that GLSL ES reads and writes (ES 3.10 section 4.9).
_BOTH_WAYS = frozenset(("r32f", "r32i", "r32ui"))
_ANY_INITIALISER = "GL_EXT_shader_non_constant_global_initializers"


class VariableChecker:
    """Declares variables, each after its initialiser is checked (the initialiser of ``x`` still
    sees the ``x`` outside, section 4.2.2)."""

    def __init__(self, context: Context, types: TypeResolver) -> None:
        self._context = context
        self._resolver = types
        self._initialisers = InitialiserChecker(context, types.expressions)
        self._constants = types.expressions.constants
        self.layouts = LayoutChecker(context, types.expressions)

    def declare(self, decl: VarDecl) -> None:
        """A declaration of variables, global or local."""
        base = self._resolver.declared(decl.qualifiers, decl.type)
        kind = self.storage(decl.qualifiers)
        if base is VOID:
            base = self._context.error("SC204", "a variable cannot be void", decl.type)
        for declarator in decl.declarators:
            symbol = self._declare_one(decl, declarator, base, kind)
            if decl.qualifiers.layout or base.name == "atomic_uint":
                self.layouts.variable(declarator, symbol.name, symbol.type, decl.qualifiers, kind)

        if decl.qualifiers.layout and not decl.declarators:
            self.layouts.nameless(decl.qualifiers, base, kind)

    def storage(self, qualifiers: Qualifiers) -> Kind:
        """How a variable with these qualifiers is stored; complains where that is impossible."""
        words, local = qualifiers.words, self._context.scopes.depth > 0
        if not words:
            return "local" if local else "global"
        storage = self._stored(qualifiers)
        problem = self._context.words_problem(words)
        problem = problem or self._version_problem(words)
        misplaced = [word for word in words if word not in _LOCAL_WORDS]
        if self._context.bindless:
            misplaced = [word for word in misplaced if word not in MEMORY]
        if local and misplaced:
            problem = f"'{misplaced[0]}' stands only on global variables and parameters"
        elif not local and problem is None:
            problem = global_problem(words, self._context.stage, storage, self._invariable())
        if problem is not None:
            self._context.error("SC221", problem, qualifiers)
        return storage

    def _version_problem(self, words: tuple[str, ...]) -> str | None:
        """What a version or a profile does not have."""
        context = self._context
        gone = not context.es and context.version >= 420 and context.profile != "compatibility"
        for word in words:
            if word in ("attribute", "varying") and gone:
                return f"'{word}' is gone from the core profile since GLSL 4.20"
            if word in ("in", "out") and not context.at_least(130, 300):
                return f"'{word}' stands on parameters only before GLSL 1.30 and GLSL ES 3.00"
        return "'shared' is for compute shaders" if "shared" in words else None

    def _stored(self, qualifiers: Qualifiers) -> Kind:
        context, words = self._context, qualifiers.words
        for word in words:
            if word in _STORAGE:
                return _STORAGE[word]
        if "attribute" in words:
            if context.stage == "fragment":
                context.error("SC221", "a fragment shader has no attributes", qualifiers)
            return "in"
        if "varying" in words:
            return "in" if context.stage == "fragment" else "out"
        return "local" if context.scopes.depth > 0 else "global"

    def _declare_one(self, decl: VarDecl, declarator: Declarator, base: Type, kind: Kind) -> Symbol:
        declared = self._resolver.with_dims(base, declarator.dims, declarator)
        init = declarator.init
        given = None if init is None else self._initialisers.check(init, declared)
        if given is not None and given is not ERROR and declared is not ERROR:
            declared = self._initialised(declarator, declared, given, kind)
        if declared is not ERROR:
            self._check_storage(decl, declarator, declared, kind)
            if self._context.es and declared.is_unsized:
                self._context.error("SC215", f"'{declarator.name}' has no size", declarator)
        symbol = Symbol(
            declarator.name,
            declared,
            kind,
            decl.qualifiers,
            declarator,
            self._context.scopes.depth == 0,
            kind in _WRITABLE,
        )
        self.enter(symbol, declarator)
        # ES wants constant initialisers of all global variables (ES 3.00 section 4.3).
        if kind in ("const", "uniform") or (kind == "global" and self._context.es):
            self._check_constant(symbol, declarator, given)
        return symbol

    def _initialised(self, node: Declarator, declared: Type, given: Type, kind: Kind) -> Type:
        """The type of a variable with an initialiser: sized by it where it has no size."""
        if kind == "uniform" and not self._context.at_least(120, NEVER):
            message = "this version of GLSL has no uniforms with a value"
            return self._context.error("SC221", message, node)
        if declared.holds_array and not self._context.arrays_are_values:
            message = "this version of GLSL has no arrays with a value"
            return self._context.error("SC210", message, node)
        if kind in ("in", "out"):
            message = f"'{node.name}' is an '{kind}' variable: it has no initialiser"
            return self._context.error("SC221", message, node)
        sized = declared
        if declared.is_unsized and _fills(given, declared):
            sized = given
        if given is VOID or not self._context.conversions.converts(given, sized):
            message = f"cannot initialise '{node.name}' of type {declared} with {given}"
            return self._context.error("SC210", message, node.init or node)
        return sized

    def _check_constant(self, symbol: Symbol, node: Declarator, given: Type | None) -> None:
        """A constant needs a constant value; a uniform may have one (sections 4.3.3, 4.3.5)."""
        context = self._context
        if node.init is None:
            if symbol.kind == "const":
                context.error("SC222", f"the constant '{node.name}' has no value", node)
        elif node.init in self._constants.expressions:
            if symbol.kind == "const" and symbol.type is not ERROR:
                self._constants.declare(symbol, node.init)
        elif given is not ERROR and (symbol.is_global or context.qualifier_version < 420):
            if symbol.kind == "global" and _ANY_INITIALISER in context.extensions:
                return
            message = f"the value of '{node.name}' is not a constant expression"
            context.error("SC222", message, node.init)

    def _check_storage(self, decl: VarDecl, node: Declarator, kind: Type, storage: Kind) -> None:
        """What types each kind of variable may have (sections 4.1.7, 4.3.4 to 4.3.6)."""
        problem = None
        if storage == "buffer":
            problem = f"'{node.name}' is not in a block: buffers have blocks only"
        elif kind.holds_opaque and storage != "uniform" and not self._context.bindless:
            problem = f"'{node.name}' of type {kind} must be a uniform or a parameter"
        elif "image" in kind.name and kind.struct is None and storage == "uniform":
            problem = self._image_problem(decl.qualifiers, node.name, kind)
        elif decl.qualifiers.has(*MEMORY) and not self._context.bindless:
            problem = f"'{node.name}' of type {kind} is no image: it has no memory qualifiers"
        elif storage in ("in", "out"):
            problem = self._interface_problem(decl.qualifiers, node.name, kind, storage)
        if problem is not None:
            self._context.error("SC221", problem, node)

    def _image_problem(self, qualifiers: Qualifiers, name: str, kind: Type) -> str | None:
        """An image that is read needs a format, one of its sort (4.20 section 4.4.6)."""
        words = [item.name.lower() for item in qualifiers.layout or ()]
        formats = [word for word in words if word in IMAGE_FORMATS]
        for word in formats:
            sort = "uimage" if word.endswith("ui") else "iimage" if word.endswith("i") else "image"
            if not kind.name.startswith(sort):
                return f"'{word}' is no format of {kind}"
        one_way = qualifiers.has("readonly", "writeonly")
        if self._context.es and not one_way and not _BOTH_WAYS.issuperset(formats):
            return f"'{name}' with the format '{formats[0]}' is 'readonly' or 'writeonly'"
        if formats or qualifiers.has("writeonly") or self._context.bindless:
            return None
        if "GL_EXT_shader_image_load_formatted" in self._context.extensions:
            return None
        return f"'{name}' needs a format, such as layout(rgba8), or 'writeonly'"

    def _interface_problem(
        self, qualifiers: Qualifiers, name: str, kind: Type, storage: Kind
    ) -> str | None:
        context = self._context
        outer = (context.stage == "vertex") == (storage == "in")
        wide = not kind.bases.isdisjoint(("double", "int64_t", "uint64_t")) and not context.bindless
        if outer and storage == "out" and wide:
            return f"'{name}' of type {kind} cannot be an output of a fragment shader"
        if outer and storage == "in" and wide and not self._has_wide_attributes():
            return f"'{name}' of type {kind}: attributes of 64 bits need GLSL 4.10"
        if not outer and kind.struct is not None and not context.at_least(150, 300):
            return f"'{name}' is a struct: it cannot be '{storage}' before GLSL 1.50"
        if context.version == 100 and not kind.bases.isdisjoint(("int", "bool")):
            return f"'{name}' of type {kind}: '{storage}' variables hold floats only here"
        if "bool" in kind.bases:
            return f"'{name}' of type {kind} cannot be '{storage}'"
        if outer and storage == "in" and kind.dims and not context.at_least(150, NEVER):
            return f"'{name}' is an array: it cannot be an attribute in this version"
        if outer and kind.struct is not None:
            return f"'{name}' is a struct: it cannot be '{storage}' here"
        if outer and storage == "out" and kind.cols > 1:
            return f"'{name}' is a matrix: it cannot be an output of a fragment shader"
        reads = storage == "in" and self._context.stage == "fragment"
        passed = reads or (not outer and storage == "out" and context.es_version == 300)
        smooth = passed and not qualifiers.has("flat") and not name.startswith("gl_")
        if smooth and not kind.bases.isdisjoint(("int", "uint", "double")):
            return f"'{name}' of type {kind} needs the qualifier 'flat'"
        return None

    def _is_new_es(self) -> bool:
        return self._context.es and self._context.version >= 300

    def _has_wide_attributes(self) -> bool:
        context = self._context
        return context.at_least(410, NEVER) or "GL_ARB_vertex_attrib_64bit" in context.extensions

    # --- entering names ---------------------------------------------------------------------------

    def enter(self, symbol: Symbol, node: Declarator | BlockDecl) -> None:
        """Declare a variable, unless the scope has the name; an unsized array may be given its
        size, and a built-in variable other qualifiers."""
        scopes = self._context.scopes
        if symbol.name.startswith("gl_"):
            symbol = redeclared(symbol, node, self._context)
        elif "__" in symbol.name:
            self._context.check_name(symbol.name, node)
        elif (
            scopes.depth == 0 and self._is_new_es() and self._context.builtin_functions(symbol.name)
        ):
            message = f"'{symbol.name}' is a built-in function"
            self._context.error("SC202", message, node)
        before = scopes.here(symbol.name)
        if before is not None and not _may_follow(before, symbol):
            what = "a function" if isinstance(before, FunctionSet) else "declared"
            message = f"'{symbol.name}' is already {what} in this scope"
            self._context.error("SC202", message, node)
        self._context.check_block_name(symbol.name, node)
        scopes.declare(symbol.name, symbol)
        self._context.declared[node] = symbol

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
        """``invariant gl_Position;``: the names must be variables, for ``invariant`` outputs (or
        inputs of a fragment shader, section 4.6.1)."""
        context = self._context
        if not decl.names:
            self._default(decl)
        invariant = decl.qualifiers.has("invariant")
        if invariant and context.scopes.depth:
            context.error("SC221", "'invariant' stands only at global scope", decl)
        for name in decl.names:
            entry = context.scopes.visible.get(name)
            known = context.builtin_variable(name)
            if isinstance(entry, Symbol):
                known = known or builtins.BuiltinVariable(name, entry.type, entry.kind)
            if known is None:
                context.undeclared("variable", name, decl, context.known_variables)
            elif invariant and known.storage not in self._invariable():
                message = f"'{name}' is no output: it cannot be invariant"
                context.error("SC221", message, decl)
            elif context.is_used(name):
                message = f"'{name}' was used before: its qualifiers stay as they are"
                context.error("SC221", message, decl)

    def _default(self, decl: QualifierDecl) -> None:
        """``layout(std140) uniform;``: what follows has this layout."""
        storage = self._stored(decl.qualifiers)
        words = decl.qualifiers.words
        problem = self._context.words_problem(words) or self._version_problem(words)
        if self._context.scopes.depth:
            problem = "defaults stand only at global scope"
        elif storage not in ("in", "out", "uniform", "buffer"):
            problem = "only 'in', 'out', 'uniform' and 'buffer' stand on their own"
        if problem is not None:
            self._context.error("SC221", problem, decl)
        self.layouts.default(decl.qualifiers, storage)

    def check_precision(self, decl: PrecisionDecl) -> None:
        """``precision mediump float;`` (section 4.5.3)."""
        self._resolver.precisions.declare(decl, self._resolver.resolve(decl.type))

    def _invariable(self) -> tuple[str, ...]:
        inputs = self._context.stage == "fragment" and not self._context.at_least(420, 300)
        return ("out", "in") if inputs else ("out",)


def _may_follow(before: object, symbol: Symbol) -> bool:
    """May the same scope declare this again? A built-in variable; an array without a size, to give
    it one (section 4.1.9)."""
    if not isinstance(before, Symbol):
        return False
    if symbol.kind == "builtin":
        return True
    return (
        before.type.is_unsized
        and bool(symbol.type.dims)
        and before.type.element is symbol.type.element
    )


def _fills(given: Type, declared: Type) -> bool:
    """Is ``given`` the array ``declared`` with all its sizes?"""
    while declared.dims and len(given.dims) == len(declared.dims):
        if declared.dims[0] not in (None, given.dims[0]):
            return False
        given, declared = given.element, declared.element
    return given is declared
