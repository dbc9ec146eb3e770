"""Which expressions are constant expressions (GLSL 3.30 section 4.3.3), and their values."""

from __future__ import annotations

from shadercache.ast.nodes import (
    Binary,
    Conditional,
    Construct,
    Expr,
    Index,
    InitList,
    Member,
    Unary,
)
from shadercache.lang.builtins import BuiltinVariable, Signature
from shadercache.lang.types import Type
from shadercache.sema import fold
from shadercache.sema.conversions import Conversions
from shadercache.sema.facts import Scalar, Symbol
from shadercache.sema.fold import Value
from shadercache.sema.fold_calls import fold_call

SWIZZLES = ("xyzw", "rgba", "stpq")


class Constants:
    """Constant expressions and constant variables found so far.

    ``driver`` holds those whose value a driver may change (``gl_MaxDrawBuffers``): they may size
    an array, but nothing else is concluded from them.
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
        value = self.values.get(init)
        if value is not None and symbol.type.base is not None and not symbol.type.is_array:
            value = fold.converted(value, symbol.type.base)
        self._symbols[symbol] = value
        if init in self._driver:
            self._driver.add(symbol)

    def declare_builtin(self, symbol: Symbol, builtin: BuiltinVariable) -> None:
        """``symbol`` is a built-in constant; its value is the least that drivers have."""
        self._symbols[symbol] = builtin.value
        self._driver.add(symbol)

    def use(self, expr: Expr, symbol: Symbol) -> None:
        """``expr`` names a constant variable."""
        if symbol not in self._symbols:
            return
        value = self._symbols[symbol]
        self.expressions.add(expr)
        if value is not None:
            self.values[expr] = value
        if symbol in self._driver:
            self._driver.add(expr)

    def set(self, expr: Expr, value: Value | None, *parts: Expr) -> None:
        """``expr`` is constant; ``None`` for a value that is not known."""
        self.expressions.add(expr)
        if value is not None:
            self.values[expr] = value
            if self._driver and not self._driver.isdisjoint(parts):
                self._driver.add(expr)

    def all_known(self, parts: tuple[Expr, ...]) -> list[Value] | None:
        """The values of ``parts`` if all of them have one."""
        values = [self.values[part] for part in parts if part in self.values]
        return values if len(values) == len(parts) else None

    def unary(self, node: Unary) -> None:
        """An operator on a constant."""
        value = self.values.get(node.operand)
        folded = None if value is None else fold.fold_unary(node.op, value, self._types[node])
        self.set(node, folded, node.operand)

    def binary(self, node: Binary) -> None:
        """An operator on two constants."""
        one, two = self.values.get(node.left), self.values.get(node.right)
        left, right = self._types[node.left].base, self._types[node.right].base
        folded = None
        if one is not None and two is not None:
            base = self._conversions.common_base(left, right) if left and right else None
            operands = (self._types[node.left], self._types[node.right])
            folded = fold.fold_binary(node.op, (one, two), operands, base, self._types[node])
        self.set(node, folded, node.left, node.right)

    def conditional(self, node: Conditional) -> None:
        """``?:`` of three constants."""
        condition = self.values.get(node.condition)
        chosen = node.then if condition else node.other
        value = None if condition is None else self.values.get(chosen)
        kind = self._types[node]
        if value is not None and kind.base and not kind.is_array:
            value = fold.converted(value, kind.base)
        self.set(node, value, node.condition, node.then, node.other)

    def construct(self, node: Construct | InitList) -> None:
        """A constructor, or a list in braces, of constants."""
        parts = node.args if isinstance(node, Construct) else node.items
        kind, values = self._types[node], self.all_known(parts)
        self.set(node, fold.fold_construct(kind, values) if values else None, *parts)

    def call(self, node: Expr, signature: Signature, args: tuple[Expr, ...]) -> None:
        """A built-in function; constant if its arguments are."""
        if not self.expressions.issuperset(args):
            return
        values = self.all_known(args)
        folded = None
        if values:
            params = [param.type for param in signature.params]
            folded = fold_call(signature.name, values, params, signature.result)
        self.set(node, folded, *args)

    def member(self, node: Member) -> None:
        """A field or a swizzle of a constant."""
        value, whole = self.values.get(node.object), self._types[node.object]
        folded: Value | None = None
        if whole.struct is not None and isinstance(value, tuple):
            folded = value[list(whole.struct.fields).index(node.name)]
        elif value is not None:
            letters = next((s for s in SWIZZLES if node.name[0] in s), "")
            parts = value if isinstance(value, tuple) else (value,)
            picked = tuple(parts[letters.index(char)] for char in node.name)
            folded = picked[0] if len(picked) == 1 else picked
        self.set(node, folded, node.object)

    def index(self, node: Index) -> None:
        """A constant index of a constant."""
        value, at = self.values.get(node.object), self.values.get(node.index)
        folded = None
        if isinstance(value, tuple) and isinstance(at, int) and 0 <= at < len(value):
            folded = value[at]
        self.set(node, folded, node.object, node.index)
