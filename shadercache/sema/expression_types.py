"""Types and names of expressions.

Expressions are walked with an explicit stack, operands before operators, so that a chain of a
hundred thousand additions needs no recursion. An operand of the type ``ERROR`` was complained about
already; what uses it gets the same type, silently.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from operator import attrgetter
from typing import Any

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Expr, Node
from shadercache.ast.walk import CHILDREN
from shadercache.lang.types import BOOL, INT, INT64, UINT64, Type, array_of
from shadercache.sema.calls import CallChecker
from shadercache.sema.constants import FOLDED
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.fold import literal
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.operators import (
    EQUALITY,
    INDICES,
    INTEGER_ONLY,
    binary_type,
    construct_problem,
    is_combination,
    is_handle,
    member_type,
    unary_type,
)
from shadercache.sema.problems import ERROR
from shadercache.sema.typespecs import resolve

_OPERANDS: Mapping[type, Callable[[Any], tuple[Node, ...]]] = {
    **CHILDREN,
    # Its type is no operand: `resolve` looks at that, array sizes included.
    n.Construct: attrgetter("args"),
}

# What else is made of a part with a mistake is a mistake, of which nothing more is told.
_JUDGE_MISTAKES = frozenset((n.Call, n.Construct, n.Assign, n.Conditional, n.Comma))


class ExpressionChecker:
    """Fills the tables of types, symbols, calls and constants for one expression at a time."""

    def __init__(self, context: InferenceContext) -> None:
        self._context = context
        self._language, self._problems = context.language, context.problems
        self._types, self._symbols = context.tables.types, context.tables.symbols
        # Scopes change this dictionary and never replace it.
        self._visible = context.scopes.visible
        self._builtins: dict[str, Symbol | None] = {}
        self._leaves: Mapping[type, Callable[[Any], Type]] = {
            n.Name: self._name,
            n.Literal: self._literal,
        }
        self._rules: Mapping[type, Callable[..., Type]] = {
            n.Binary: self._binary,
            n.Call: CallChecker(context).check,
            n.Construct: self._construct,
            n.Member: self._member,
            n.Assign: self._assign,
            n.Index: self._index,
            n.Unary: self._unary,
            n.Postfix: self._unary,
            n.Conditional: self._conditional,
            n.Comma: lambda node, left, right: right,
            n.Length: self._length,
        }

    def check(self, root: Expr) -> Type:
        """Type of ``root``, after its parts and it have been entered into the tables."""
        order: list[tuple[Expr, Sequence[Any]]] = []
        stack: list[Any] = [root]
        types, constants, leaves = self._types, self._context.constants, self._leaves
        while stack:
            node = stack.pop()
            leaf = leaves.get(type(node))
            if leaf is not None:
                types[node] = leaf(node)
            else:
                operands = _OPERANDS[type(node)](node)
                order.append((node, operands))
                stack += operands
        # Parents came before their operands and left before right: backwards, operands come first.
        type_of, rules = types.__getitem__, self._rules
        for node, operands in reversed(order):
            kinds = tuple(map(type_of, operands))
            sort = type(node)
            if ERROR in kinds and sort not in _JUDGE_MISTAKES:
                types[node] = ERROR
                continue
            types[node] = kind = rules[sort](node, *kinds)
            if sort in FOLDED and kind is not ERROR and constants.expressions.issuperset(operands):
                constants.fold(node, operands)
        return types[root]

    # --- leaves -----------------------------------------------------------------------------------

    def _literal(self, node: n.Literal) -> Type:
        kind, value = literal(node.text)
        if value is None:
            return self._problems.error("SC227", "the integer needs more bits than it has", node)
        if kind in (INT64, UINT64) and not self._language.has_type(kind):
            message = "integers of 64 bits need GL_ARB_gpu_shader_int64"
            return self._problems.error("SC227", message, node)
        constants = self._context.constants
        constants.expressions.add(node)
        constants.values[node] = value
        return kind

    def _name(self, node: n.Name) -> Type:
        entry = self._visible.get(node.name)
        if entry is None:
            # Built-in variables stand outside of all scopes: what the shader declares hides them.
            entry = self._builtin(node.name)
        if type(entry) is Symbol:
            self._symbols[node] = entry
            if entry.kind == "const":
                self._context.constants.use(node, entry)
            return entry.type
        if entry is not None or self._language.builtin_functions(node.name):
            what = "a type" if type(entry) is Type else "a function"
            return self._problems.error("SC204", f"'{node.name}' is {what}, not a variable", node)
        known = self._context.known_variables
        return self._problems.undeclared("variable", node.name, node, known)

    def _builtin(self, name: str) -> Symbol | None:
        """The built-in variable of that name; one symbol for all its uses."""
        if name not in self._builtins:
            builtin = self._language.builtin_variable(name)
            symbol = None
            if builtin is not None:
                kind: Kind = "const" if builtin.storage == "const" else "builtin"
                symbol = Symbol(name, builtin.type, kind, writable=builtin.storage == "out")
                if kind == "const":
                    self._context.constants.declare_builtin(symbol, builtin)
            self._builtins[name] = symbol
        return self._builtins[name]

    # --- operators --------------------------------------------------------------------------------

    def _unary(self, node: n.Unary | n.Postfix, operand: Type) -> Type:
        kind = unary_type(node.op, operand)
        if kind is None or self._is_missing(node.op):
            return self._no_operator(node, operand)
        return kind

    def _binary(self, node: n.Binary, left: Type, right: Type) -> Type:
        kind = None
        if not self._is_missing(node.op, left):
            kind = binary_type(node.op, left, right, self._language.conversions)
        return kind or self._no_operator(node, left, right)

    def _is_missing(self, op: str, left: Type = BOOL) -> bool:
        """Does this version lack the operator?"""
        if op in INTEGER_ONLY:
            return not self._language.has_integer_operators
        compares = op in EQUALITY and left.holds_array
        return compares and not self._language.arrays_are_values

    def _no_operator(self, node: n.Unary | n.Postfix | n.Binary, *operands: Type) -> Type:
        kinds = " and ".join(map(str, operands))
        hint = "this version of GLSL does not have it" if self._is_missing(node.op) else None
        message = f"'{node.op}' does not apply to {kinds}"
        return self._problems.error("SC205", message, node, hint)

    def _conditional(self, node: n.Conditional, *kinds: Type) -> Type:
        condition, then, other = kinds
        if condition is not BOOL and condition is not ERROR:
            message = f"the condition of '?:' is {condition}, not bool"
            return self._problems.error("SC212", message, node.condition)
        if ERROR in kinds:
            return ERROR
        kind = self._language.conversions.common(then, other)
        if kind is None or self._language.only_handles(kind):
            message = f"'?:' cannot choose between {then} and {other}"
            return self._problems.error("SC205", message, node)
        return kind

    def _assign(self, node: n.Assign, target: Type, value: Type) -> Type:
        # An assignment has the type of its target, whatever is wrong with the value.
        if target is ERROR or value is ERROR:
            return target
        language = self._language
        result: Type | None = value
        message = f"cannot assign {value} to {target}"
        if node.op != "=":
            message = f"'{node.op}' does not apply to {target} and {value}"
            operator = node.op[:-1]
            missing = self._is_missing(operator)
            result = None if missing else binary_type(operator, target, value, language.conversions)
        elif language.only_handles(target) or (
            target.holds_array and not language.arrays_are_values
        ):
            result = None
        if result is None or not language.conversions.converts(result, target):
            self._problems.error("SC210", message, node)
        return target

    # --- parts ------------------------------------------------------------------------------------

    def _member(self, node: n.Member, whole: Type) -> Type:
        # ARB_shading_language_420pack brings the swizzles of scalars, and `length()` below.
        kind = member_type(whole, node.name, self._language.qualifier_version)
        if kind is not None:
            return kind
        message = f"{whole} has no field '{node.name}'"
        if whole.struct is not None and not whole.dims:
            return self._problems.no_field(message, node, whole.struct.fields)
        if whole.is_vector:
            message = f"'{node.name}' is no swizzle of {whole}"
        return self._problems.error("SC213", message, node)

    def _index(self, node: n.Index, whole: Type, at: Type) -> Type:
        if not (whole.dims or whole.rows > 1):
            return self._problems.error("SC214", f"{whole} cannot be indexed", node)
        if not (at.is_scalar and at.base in INDICES):
            return self._problems.error("SC214", f"the index is {at}, not int or uint", node.index)
        return whole.element

    def _length(self, node: n.Length, whole: Type) -> Type:
        size = whole.dims[0] if whole.dims else None
        if whole.rows > 1 and not whole.dims and self._language.qualifier_version >= 420:
            size = whole.cols if whole.is_matrix else whole.rows
        if whole.dims and size is None and is_runtime_array(node.object, self._symbols):
            return INT
        if size is None or not self._language.arrays_are_values:
            return self._problems.error("SC213", f"{whole} has no length()", node)
        # The length of an array is constant, whatever is in it (section 4.3.3).
        self._context.constants.set(node, size)
        return INT

    def _construct(self, node: n.Construct, *args: Type) -> Type:
        language = self._language
        kind = resolve(self._context, node.type)
        if kind is ERROR or ERROR in args:
            return ERROR
        if kind.dims and args and language.arrays_are_values:
            kind = _sized(kind, args)
        problem = None
        if kind.dims and not language.arrays_are_values:
            problem = "this version of GLSL has no constructors of arrays"
        elif kind.is_matrix and args and args[0].is_matrix and not language.at_least(120, 0):
            problem = "GLSL 1.10 makes no matrix from a matrix"
        elif kind.struct is not None and language.only_handles(kind):
            problem = f"{kind} holds samplers or images: only a uniform can be one"
        elif not (
            (language.bindless and is_handle(kind, args))
            or (language.vulkan and is_combination(kind, args))
        ):
            problem = construct_problem(kind, args, language.conversions)
        if problem is not None:
            return self._problems.error("SC219", problem, node)
        return kind


def is_runtime_array(array: Expr, symbols: Mapping[n.Name, Symbol]) -> bool:
    """Is it the last member of a buffer block, whose length is known at run time only?"""
    whole = array
    while isinstance(whole, n.Member | n.Index):
        whole = whole.object
    symbol = symbols.get(whole) if isinstance(whole, n.Name) else None
    block = None if symbol is None else symbol.block
    if block is None or not block.qualifiers.has("buffer"):
        return False
    last = block.fields[-1].declarators[-1]
    return isinstance(array, n.Name | n.Member) and array.name == last.name


def _sized(kind: Type, args: Sequence[Type]) -> Type:
    """The type of an array constructor, with the sizes that its arguments give."""
    element, size = kind.element, kind.dims[0]
    if element.is_unsized and len(set(args)) == 1 and len(args[0].dims) == len(element.dims):
        element = args[0]
    return array_of(element, len(args) if size is None else size)
