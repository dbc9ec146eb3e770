"""Types and names of expressions.

Expressions are walked with an explicit stack, operands before operators, so that a chain of a
hundred thousand additions needs no recursion. An operand of the type ``ERROR`` was complained about
already; what uses it gets the same type, silently.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Any

from shadercache.ast.nodes import (
    Assign,
    Binary,
    Call,
    Comma,
    Conditional,
    Construct,
    Expr,
    Index,
    Length,
    Literal,
    Member,
    Name,
    Postfix,
    TypeSpec,
    Unary,
)
from shadercache.lang.types import BOOL, INT, INT64, UINT, UINT64, Type, array_of, vector
from shadercache.sema.calls import CallChecker
from shadercache.sema.constants import SWIZZLES, Constants
from shadercache.sema.constructors import construct_problem, is_handle
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.fold import literal
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.operators import EQUALITY, INTEGER_ONLY, binary_type, unary_type
from shadercache.sema.problems import ERROR

_OPERANDS: Mapping[type, Callable[[Any], tuple[Expr, ...]]] = {
    Binary: attrgetter("left", "right"),
    Call: attrgetter("args"),
    Construct: attrgetter("args"),
    Member: lambda node: (node.object,),
    Assign: attrgetter("target", "value"),
    Index: attrgetter("object", "index"),
    Unary: lambda node: (node.operand,),
    Postfix: lambda node: (node.operand,),
    Conditional: attrgetter("condition", "then", "other"),
    Comma: attrgetter("left", "right"),
    Length: lambda node: (node.object,),
}


class ExpressionChecker:
    """Fills the tables of types, symbols, calls and constants for one expression at a time."""

    def __init__(self, context: InferenceContext, resolve_spec: Callable[[TypeSpec], Type]) -> None:
        self._context = context
        self._language, self._problems = context.language, context.problems
        self._types = context.tables.types
        self._visible = context.scopes.visible
        self._symbols = context.tables.symbols
        self._resolve_spec = resolve_spec
        self._literals: dict[str, tuple[Type, bool | int | float | None]] = {}
        self._binary_types: dict[tuple[str, Type, Type], Type | None] = {}
        self._members: dict[tuple[Type, str], Type | None] = {}
        self._builtins: dict[str, Symbol | None] = {}
        self.constants = Constants(context.tables.types, context.language.conversions)
        self._calls = CallChecker(context, self.constants)
        self._rules: Mapping[type, Callable[[Any], Type]] = {
            Binary: self._binary,
            Call: self._calls.check,
            Construct: self._construct,
            Member: self._member,
            Assign: self._assign,
            Index: self._index,
            Unary: self._unary,
            Postfix: self._postfix,
            Conditional: self._conditional,
            Comma: self._comma,
            Length: self._length,
        }

    def check(self, root: Expr) -> Type:
        """Type of ``root``, after its parts and it have been entered into the tables."""
        order: list[Expr] = []
        stack = [root]
        types = self._types
        while stack:
            node = stack.pop()
            if type(node) is Name:
                types[node] = self._name(node)
            elif type(node) is Literal:
                types[node] = self._literal(node)
            else:
                order.append(node)
                stack.extend(_OPERANDS[type(node)](node))
        # Parents came before their operands and left before right: backwards, operands come first.
        rules = self._rules
        for node in reversed(order):
            types[node] = rules[node.__class__](node)
        return types[root]

    # --- leaves -----------------------------------------------------------------------------------

    def _literal(self, node: Literal) -> Type:
        found = self._literals.get(node.text)
        if found is None:
            found = self._literals[node.text] = literal(node.text)
        kind, value = found
        if value is None:
            return self._problems.error("SC227", "the integer needs more bits than it has", node)
        if kind in (INT64, UINT64) and not self._language.has_type(kind):
            message = "integers of 64 bits need GL_ARB_gpu_shader_int64"
            return self._problems.error("SC227", message, node)
        self.constants.expressions.add(node)
        self.constants.values[node] = value
        return kind

    def _name(self, node: Name) -> Type:
        entry = self._visible.get(node.name)
        if entry is None:
            entry = self._builtin(node.name)
        if type(entry) is Symbol:
            self._symbols[node] = entry
            if entry.kind == "const":
                self.constants.use(node, entry)
            return entry.type
        if entry is not None or self._language.builtin_functions(node.name):
            what = "a type" if type(entry) is Type else "a function"
            return self._problems.error("SC204", f"'{node.name}' is {what}, not a variable", node)
        known = self._context.known_variables
        return self._problems.undeclared("variable", node.name, node, known)

    def _builtin(self, name: str) -> Symbol | None:
        """The built-in variable of that name; one symbol for all its uses."""
        if name not in self._builtins:
            found = self._language.builtin_variable(name)
            symbol = None
            if found is not None:
                kind: Kind = "const" if found.storage == "const" else "builtin"
                symbol = Symbol(name, found.type, kind, writable=found.storage == "out")
                if found.storage == "const":
                    self.constants.declare_builtin(symbol, found)
            self._builtins[name] = symbol
        return self._builtins[name]

    # --- operators --------------------------------------------------------------------------------

    def _unary(self, node: Unary) -> Type:
        operand = self._types[node.operand]
        if operand is ERROR:
            return ERROR
        kind = unary_type(node.op, operand)
        if kind is None or self._is_missing(node.op):
            return self._no_operator(node, operand)
        if node.op not in ("++", "--") and node.operand in self.constants.expressions:
            self._types[node] = kind
            self.constants.unary(node)
        return kind

    def _postfix(self, node: Postfix) -> Type:
        operand = self._types[node.operand]
        if operand is ERROR:
            return ERROR
        kind = unary_type(node.op, operand)
        if kind is None:
            return self._no_operator(node, operand)
        return kind

    def _binary(self, node: Binary) -> Type:
        left, right = self._types[node.left], self._types[node.right]
        key = (node.op, left, right)
        if key in self._binary_types:
            kind = self._binary_types[key]
        elif left is ERROR or right is ERROR:
            kind = ERROR
        else:
            kind = None
            if not self._is_missing(node.op, left):
                kind = binary_type(node.op, left, right, self._language.conversions)
            self._binary_types[key] = kind
        if kind is None:
            return self._no_operator(node, left, right)
        constant = self.constants.expressions
        if node.left in constant and node.right in constant and kind is not ERROR:
            self._types[node] = kind
            self.constants.binary(node)
        return kind

    def _is_missing(self, op: str, left: Type = BOOL) -> bool:
        """Does this version lack the operator?"""
        if op in INTEGER_ONLY:
            return not self._language.has_integer_operators
        compares = op in EQUALITY and left.holds_array
        return compares and not self._language.arrays_are_values

    def _no_operator(self, node: Unary | Postfix | Binary, *operands: Type) -> Type:
        kinds = " and ".join(map(str, operands))
        hint = "this version of GLSL does not have it" if self._is_missing(node.op) else None
        message = f"'{node.op}' does not apply to {kinds}"
        return self._problems.error("SC205", message, node, hint)

    def _conditional(self, node: Conditional) -> Type:
        condition, then, other = (
            self._types[part] for part in (node.condition, node.then, node.other)
        )
        if condition is not BOOL and condition is not ERROR:
            message = f"the condition of '?:' is {condition}, not bool"
            return self._problems.error("SC212", message, node.condition)
        if ERROR in (condition, then, other):
            return ERROR
        kind = self._language.conversions.common(then, other)
        if kind is None or self._language.only_handles(kind):
            message = f"'?:' cannot choose between {then} and {other}"
            return self._problems.error("SC205", message, node)
        if self.constants.expressions.issuperset((node.condition, node.then, node.other)):
            self._types[node] = kind
            self.constants.conditional(node)
        return kind

    def _comma(self, node: Comma) -> Type:
        return self._types[node.right]

    def _assign(self, node: Assign) -> Type:
        target, value = self._types[node.target], self._types[node.value]
        if target is ERROR or value is ERROR:
            return target
        conversions = self._language.conversions
        result: Type | None = value
        if node.op != "=":
            missing = self._is_missing(node.op[:-1])
            result = None if missing else binary_type(node.op[:-1], target, value, conversions)
        elif (
            target.holds_array and not self._language.arrays_are_values
        ) or self._language.only_handles(target):
            result = None
        if result is None or not conversions.converts(result, target):
            message = f"cannot assign {value} to {target}"
            if node.op != "=":
                message = f"'{node.op}' does not apply to {target} and {value}"
            self._problems.error("SC210", message, node)
        return target

    # --- parts ------------------------------------------------------------------------------------

    def _member(self, node: Member) -> Type:
        whole = self._types[node.object]
        if whole is ERROR:
            return ERROR
        key = (whole, node.name)
        if key not in self._members:
            self._members[key] = member_type(whole, node.name, self._language.qualifier_version)
        kind = self._members[key]
        if kind is None:
            return self._bad_member(node, whole)
        if node.object in self.constants.expressions:
            self._types[node] = kind
            self.constants.member(node)
        return kind

    def _bad_member(self, node: Member, whole: Type) -> Type:
        if whole.struct is not None and not whole.dims:
            message = f"{whole} has no field '{node.name}'"
            return self._problems.no_field(message, node, whole.struct.fields)
        message = f"{whole} has no field '{node.name}'"
        if whole.is_vector:
            message = f"'{node.name}' is no swizzle of {whole}"
        return self._problems.error("SC213", message, node)

    def _index(self, node: Index) -> Type:
        whole, at = self._types[node.object], self._types[node.index]
        if whole is ERROR or at is ERROR:
            return ERROR
        if not (whole.dims or whole.rows > 1):
            return self._problems.error("SC214", f"{whole} cannot be indexed", node)
        if at is not INT and at is not UINT:
            return self._problems.error("SC214", f"the index is {at}, not int or uint", node.index)
        kind, constant = whole.element, self.constants.expressions
        if node.index in constant and node.object in constant:
            self._types[node] = kind
            self.constants.index(node)
        return kind

    def _length(self, node: Length) -> Type:
        whole = self._types[node.object]
        if whole is ERROR:
            return ERROR
        size = whole.dims[0] if whole.dims else None
        if whole.rows > 1 and not whole.dims and self._language.qualifier_version >= 420:
            size = whole.cols if whole.is_matrix else whole.rows
        if whole.dims and size is None and is_runtime_array(node.object, self._symbols):
            return INT
        if size is None or not self._language.arrays_are_values:
            return self._problems.error("SC213", f"{whole} has no length()", node)
        self.constants.set(node, size)
        return INT

    def _construct(self, node: Construct) -> Type:
        kind = self._resolve_spec(node.type)
        args = [self._types[arg] for arg in node.args]
        if kind is ERROR or ERROR in args:
            return ERROR
        if kind.dims and not self._language.arrays_are_values:
            message = "this version of GLSL has no constructors of arrays"
            return self._problems.error("SC219", message, node)
        if kind.dims and args:
            kind = _sized(kind, args)
        problem = None
        if kind.struct is not None and self._language.only_handles(kind):
            problem = f"{kind} holds samplers or images: only a uniform can be one"
        elif not (self._language.bindless and is_handle(kind, args)):
            problem = construct_problem(kind, args, self._language.conversions)
        if (
            kind.is_matrix
            and args[:1]
            and args[0].is_matrix
            and not self._language.at_least(120, 0)
        ):
            problem = "GLSL 1.10 makes no matrix from a matrix"
        if problem is not None:
            return self._problems.error("SC219", problem, node)
        if self.constants.expressions.issuperset(node.args):
            self._types[node] = kind
            self.constants.construct(node)
        return kind


def root(expr: Expr, symbols: Mapping[Name, Symbol]) -> Symbol | None:
    """The variable that an expression is, or is a part of."""
    while isinstance(expr, Member | Index):
        expr = expr.object
    return symbols.get(expr) if isinstance(expr, Name) else None


def is_runtime_array(array: Expr, symbols: Mapping[Name, Symbol]) -> bool:
    """Is it the last member of a buffer block, whose length is known at run time only?"""
    symbol = root(array, symbols)
    block = None if symbol is None else symbol.block
    if block is None or not block.qualifiers.has("buffer"):
        return False
    return isinstance(array, Name | Member) and array.name == block.fields[-1].declarators[-1].name


def _sized(kind: Type, args: list[Type]) -> Type:
    """The type of an array constructor, with the sizes that its arguments give."""
    element, size = kind.element, kind.dims[0]
    if element.is_unsized and len(set(args)) == 1 and len(args[0].dims) == len(element.dims):
        element = args[0]
    return array_of(element, len(args) if size is None else size)


def member_type(whole: Type, name: str, version: int) -> Type | None:
    """Type of ``.name``: a field, or a swizzle (section 5.5); scalars have one from 4.20 on."""
    if whole.dims:
        return None
    if whole.struct is not None:
        return whole.struct.fields.get(name)
    if whole.base is None or whole.cols > 1 or (whole.rows == 1 and version < 420):
        return None
    fits = any(set(name) <= set(letters[: whole.rows]) for letters in SWIZZLES)
    return vector(whole.base, len(name)) if fits and 1 <= len(name) <= 4 else None
