"""In which precision GLSL ES computes each expression (3.00 section 4.5.2).

A value that is cached goes through a variable of ours: were that one more precise than the
expression whose place it takes, all that is computed from it would be so too, and the image would
change on every driver that computes ``mediump`` in 16 bits.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import cast

from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children, postorder
from shadercache.lang.builtins import Signature
from shadercache.lang.types import builtin_type
from shadercache.lang.words import PRECISIONS
from shadercache.sema.facts import Facts, Stage

_RANKS = {"lowp": 1, "mediump": 2, "highp": 3}
_LOW_SAMPLERS = ("sampler2D", "samplerCube")
_MIDDLING = ("gl_PointCoord", "gl_PointSize")
# Their results are declared highp, whatever precision their arguments have.
_EXACT_CALLS = (
    *("textureSize", "floatBitsToInt", "floatBitsToUint", "intBitsToFloat", "uintBitsToFloat"),
    *("packHalf2x16", "packSnorm2x16", "packUnorm2x16"),
)
_COMPARISONS = ("==", "!=", "<", ">", "<=", ">=", "&&", "||", "^^")

Defaults = dict[str, str]


class PrecisionTable:
    """The precision of every expression of a module of GLSL ES; none for other modules."""

    def __init__(self, module: n.Module, facts: Facts, stage: Stage = "fragment") -> None:
        self._facts = facts
        self._declared: dict[n.Node, str | None] = {}
        self._known: dict[n.Node, str | None] = {}
        if module.profile != "es":
            return
        first = "mediump" if stage == "fragment" else "highp"
        defaults = {"int": first, **dict.fromkeys(_LOW_SAMPLERS, "lowp")}
        # Floats have no default in a fragment shader: it must declare one (3.00 section 4.5.4).
        if stage == "vertex":
            defaults["float"] = first
        for decl in module.decls:
            self._enter(decl, defaults)

    def of(self, expr: n.Expr) -> str | None:
        """``highp``, ``mediump`` or ``lowp``; ``None`` where there is none: booleans, what is made
        of constants alone, and everything that is not GLSL ES."""
        if not self._declared:
            return None
        if expr not in self._known:
            # Operands first: a chain of operators is as deep as it is long.
            for part in postorder(expr, self._known):
                if isinstance(part, EXPRESSIONS):
                    self._known[part] = self._own(cast("n.Expr", part))
        return self._known[expr]

    def _own(self, expr: n.Expr) -> str | None:
        """The precision of an expression, of whose operands it is known."""
        match expr:
            case n.Name(name=name):
                declaration = self._facts.symbols[expr].node
                if declaration is not None:
                    return self._declared.get(declaration)
                return "mediump" if name in _MIDDLING else "highp"
            case n.Member(object=owner, name=name):
                return self._field(owner, name) or self.of(owner)
            case n.Binary(op="<<" | ">>", left=left):
                return self.of(left)
            case n.Binary(op=op) if op in _COMPARISONS:
                return None
            case n.Conditional(then=one, other=other) | n.Binary(left=one, right=other):
                return self._highest((one, other))
            case n.Assign(target=part) | n.Comma(right=part) | n.Index(object=part):
                return self.of(part)
            case n.Unary(operand=part) | n.Postfix(operand=part):
                return self.of(part)
            case n.Call():
                return self._call(expr)
            case n.Construct(args=args):
                return self._highest(args)
            case n.Length():
                return "highp"
        return None

    def _highest(self, parts: Iterable[n.Expr]) -> str | None:
        words = [word for part in parts if (word := self.of(part))]
        return max(words, key=_RANKS.__getitem__, default=None)

    def _field(self, owner: n.Expr, name: str) -> str | None:
        kind = self._facts.types[owner]
        definition = self._facts.structs.get(kind.struct) if kind.struct is not None else None
        block = self._facts.symbols[owner].block if isinstance(owner, n.Name) else None
        fields = definition.fields if definition else block.fields if block else ()
        items = (field for decl in fields for field in decl.declarators)
        return next((self._declared.get(field) for field in items if field.name == name), None)

    def _call(self, call: n.Call) -> str | None:
        callee = self._facts.calls[call]
        if isinstance(callee, Signature):
            if callee.name in _EXACT_CALLS:
                return "highp"
            # A fetch is as precise as its sampler, however precise the coordinates are.
            return self.of(call.args[0]) if callee.texture else self._highest(call.args)
        proto = callee.proto if isinstance(callee, n.FunctionDef) else callee
        return self._declared.get(proto)

    def _enter(self, node: n.Node, defaults: Defaults) -> None:
        """Note what is declared in a part of the module; ``precision`` holds to its scope's end."""
        match node:
            case n.PrecisionDecl():
                defaults[node.type.name] = node.precision
            case n.FunctionDef() | n.Block() | n.For() | n.While() | n.Switch():
                defaults = dict(defaults)
            case n.VarDecl():
                word = _precision(node.qualifiers, node.type, defaults)
                self._declared.update(dict.fromkeys(node.declarators, word))
            case n.Param() | n.FunctionProto():
                self._declared[node] = _precision(node.qualifiers, node.type, defaults)
        for child in children(node):
            if not isinstance(child, n.Expr):
                self._enter(child, defaults)


def _precision(qualifiers: n.Qualifiers, spec: n.TypeSpec, defaults: Defaults) -> str | None:
    for word in qualifiers.words:
        if word in PRECISIONS:
            return word
    kind = builtin_type(spec.name)
    if kind is None:
        return None
    # precision mediump int; is about unsigned integers, too (3.00 section 4.5.4).
    sort = {"float": "float", "int": "int", "uint": "int"}.get(kind.base or "", kind.name)
    return defaults.get(sort)
