"""Which expressions are constant expressions (GLSL 3.30 section 4.3.3), and their values."""

from __future__ import annotations

from collections.abc import Sequence

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Expr
from shadercache.lang.builtins import BuiltinVariable, Signature
from shadercache.lang.types import Type
from shadercache.lang.words import STEP_OPS
from shadercache.sema import fold
from shadercache.sema.conversions import Conversions
from shadercache.sema.facts import Scalar, Symbol
from shadercache.sema.fold import Value
from shadercache.sema.fold_calls import fold_call
from shadercache.sema.operators import SWIZZLES

FOLDED = frozenset((n.Unary, n.Binary, n.Conditional, n.Construct, n.InitList, n.Member, n.Index))
"""What is a constant expression where all of its parts are."""


class Constants:
    """Constant expressions and constant variables found so far.

    ``_driver`` holds those whose value a driver may change (``gl_MaxDrawBuffers``), or an engine
    (``layout(constant_id = 3) const``): they may size an array, but nothing else is concluded from
    them.
    """

    def __init__(self, types: dict[Expr, Type], conversions: Conversions) -> None:
        self.expressions: set[Expr] = set()
        self.values: dict[Expr, Value] = {}
        self._types = types
        self._conversions = conversions
        self._symbols: dict[Symbol, Value | None] = {}
        self._driver: set[Expr | Symbol] = set()

    def scalars(self) -> dict[Expr, Scalar]:
        """The scalar values that hold on every driver."""
        driver = self._driver
        return {
            expr: value
            for expr, value in self.values.items()
            if not isinstance(value, tuple) and expr not in driver
        }

    def declare(self, symbol: Symbol, init: Expr) -> None:
        """``symbol`` is a constant with the constant initialiser ``init``."""
        self._symbols[symbol] = _as_type(self.values.get(init), symbol.type)
        # An engine gives what is specialised another value.
        if init in self._driver or _is_specialised(symbol):
            self._driver.add(symbol)

    def declare_builtin(self, symbol: Symbol, builtin: BuiltinVariable) -> None:
        """``symbol`` is a built-in constant; its value is the least that drivers have."""
        self._symbols[symbol] = builtin.value
        self._driver.add(symbol)

    def use(self, expr: Expr, symbol: Symbol) -> None:
        """``expr`` names a constant variable."""
        # From 4.20 on the value of a local constant need be no constant expression.
        if symbol in self._symbols:
            self.set(expr, self._symbols[symbol], symbol)

    def set(self, expr: Expr, value: Value | None, *parts: Expr | Symbol) -> None:
        """``expr`` is constant; ``None`` for a value that is not known."""
        self.expressions.add(expr)
        if value is not None:
            self.values[expr] = value
        # What is computed from a driver's value is the driver's as well.
        if self._driver and not self._driver.isdisjoint(parts):
            self._driver.add(expr)

    def call(self, node: n.Call, signature: Signature) -> None:
        """A built-in function; constant if its arguments are."""
        if not self.expressions.issuperset(node.args):
            return
        values = [self.values[arg] for arg in node.args if arg in self.values]
        folded = None
        if values and len(values) == len(node.args):
            params = [param.type for param in signature.params]
            folded = fold_call(signature.name, values, params, signature.result)
        self.set(node, folded, *node.args)

    def fold(self, node: Expr, parts: Sequence[Expr]) -> None:
        """An expression, typed and without mistakes, all parts of which are constant."""
        # `++` changes its operand, so it is in no constant expression.
        steps = isinstance(node, n.Unary) and node.op in STEP_OPS
        if not steps:
            known = [self.values[part] for part in parts if part in self.values]
            if isinstance(node, n.Conditional):
                value = self._chosen(node)
            else:
                value = self._value(node, known) if len(known) == len(parts) else None
            self.set(node, value, *parts)

    def _value(self, node: Expr, values: list[Value]) -> Value | None:
        """The value of an operation on known values."""
        kind = self._types[node]
        match node:
            case n.Unary():
                return fold.fold_unary(node.op, values[0], kind)
            case n.Binary():
                operands = (self._types[node.left], self._types[node.right])
                left, right = (operand.base for operand in operands)
                base = self._conversions.common_base(left, right) if left and right else None
                return fold.fold_binary(node.op, (values[0], values[1]), operands, base, kind)
            case n.Member():
                return _member(self._types[node.object], node.name, values[0])
            case n.Index():
                whole, at = values
                if isinstance(whole, tuple) and isinstance(at, int) and 0 <= at < len(whole):
                    return whole[at]
                return None
        return fold.fold_construct(kind, values)

    def _chosen(self, node: n.Conditional) -> Value | None:
        condition = self.values.get(node.condition)
        if condition is None:
            return None
        # The other part may be undefined, as in `N > 0 ? 1 / N : 0`.
        chosen = node.then if condition else node.other
        return _as_type(self.values.get(chosen), self._types[node])


def _is_specialised(symbol: Symbol) -> bool:
    return any(item.name == "constant_id" for item in symbol.qualifiers.layout or ())


def _as_type(value: Value | None, kind: Type) -> Value | None:
    """A value that is implicitly converted."""
    if value is None or kind.base is None or kind.is_array:
        return value
    return fold.converted(value, kind.base)


def _member(whole: Type, name: str, value: Value) -> Value:
    """A field or a swizzle of a constant."""
    if whole.struct is not None and isinstance(value, tuple):
        return value[list(whole.struct.fields).index(name)]
    letters = next(letters for letters in SWIZZLES if name[0] in letters)
    components = value if isinstance(value, tuple) else (value,)
    picked = tuple(components[letters.index(letter)] for letter in name)
    return picked[0] if len(picked) == 1 else picked
