"""What the checker finds out about a module: side tables keyed by the nodes of its tree."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass
from typing import Literal, TypeAlias

from shadercache.ast import nodes as n
from shadercache.diagnostics import Diagnostic
from shadercache.lang.builtins import Signature
from shadercache.lang.types import StructType, Type

Stage: TypeAlias = Literal["fragment", "vertex"]

Kind: TypeAlias = Literal[
    "local", "param", "global", "const", "uniform", "buffer", "in", "out", "builtin", "block"
]

Declares: TypeAlias = n.Declarator | n.Param | n.BlockDecl
"""The nodes that declare a variable."""

Callee: TypeAlias = n.FunctionDef | n.FunctionProto | Signature
"""What a call calls: a function, one that is only declared here, or a built-in overload."""

Scalar: TypeAlias = int | float | bool


@dataclass(frozen=True, slots=True, eq=False)
class Symbol:
    """One variable: every use of it in the source leads to the same object.

    ``kind`` is how it is stored: a ``const`` may be local or global (``is_global``); a ``block``
    is the instance name of an interface block. A member of a block without instance name is a
    ``uniform``, ``buffer``, ``in`` or ``out`` with ``block`` set. ``node`` is the declaration,
    ``None`` for a built-in variable. ``writable`` says whether it may be assigned to.
    """

    name: str
    type: Type
    kind: Kind
    qualifiers: n.Qualifiers = n.NO_QUALIFIERS
    node: Declares | None = None
    is_global: bool = True
    writable: bool = False
    block: n.BlockDecl | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Facts:
    """Names, types and constants of one module.

    ``types`` holds every expression; ``symbols`` every variable use; ``declared`` every declared
    variable; ``calls`` what each call resolves to. ``constants`` holds the scalar constant
    expressions whose value is known on every driver (floats rounded to 32 bits). ``called`` lists
    the calls in the body of each function in the order of evaluation; ``structs`` where a struct is
    defined. ``functions`` are the definitions in source order; ``prototypes`` leads from each
    prototype to the definition of its function, where the module has one.
    """

    types: Mapping[n.Expr, Type]
    symbols: Mapping[n.Name, Symbol]
    declared: Mapping[Declares, Symbol]
    calls: Mapping[n.Call, Callee]
    constants: Mapping[n.Expr, Scalar]
    constant_expressions: Set[n.Expr]
    functions: tuple[n.FunctionDef, ...]
    called: Mapping[n.FunctionDef, tuple[n.Call, ...]]
    prototypes: Mapping[n.FunctionProto, n.FunctionDef]
    structs: Mapping[StructType, n.StructDef]
    warnings: tuple[Diagnostic, ...] = ()

    def is_constant(self, expr: n.Expr) -> bool:
        """Is it a constant expression (GLSL 3.30 section 4.3.3), of whatever type?"""
        return expr in self.constant_expressions
