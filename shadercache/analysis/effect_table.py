"""The effects of every piece of a module.

The analysis works by name, so it needs a module in which every identifier means one thing
(:mod:`shadercache.transform.unique_names`); it needs no table of types and can therefore be run
again after any rewrite.

A call counts with everything that the called function, and what that calls, does to global
variables; its locals and parameters stay its own.
"""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.analysis.effects import (
    NO_EFFECTS,
    Does,
    Effects,
    FunctionSummary,
    Linked,
    local_names,
    root_variable,
    union,
)
from shadercache.analysis.liveness import live_at_entry, overwritten_in
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import children, postorder, walk
from shadercache.lang.builtins import Signature, overloads


class EffectTable:
    """Effects of every piece of one module; computed on demand and kept.

    Shape: one :class:`Effects` per node of the tree, keyed by identity. What it finds out about
    whole functions goes to ``memo``. ``marks`` are further inputs that expressions read.
    """

    def __init__(
        self, module: n.Module, memo: Memo | None = None, marks: Mapping[n.Node, str] | None = None
    ) -> None:
        self.functions = {d.name: d for d in module.decls if isinstance(d, n.FunctionDef)}
        self._memo = Memo() if memo is None else memo
        self._marks = marks or {}
        self._table: dict[n.Node, Effects] = {}
        self._by_name: dict[str, Linked] = {}

    def of(self, node: n.Node) -> Effects:
        """The effects of evaluating an expression or executing a statement."""
        found = self._table.get(node)
        if found is None:
            for item in postorder(node, self._table):
                effects = self._own(item)
                if item in self._marks:
                    effects = effects | Effects(frozenset((self._marks[item],)))
                self._table[item] = effects
            found = self._table[node]
        return found

    def summary(self, name: str) -> Effects:
        """What a call of the user's function ``name`` does outside of the function."""
        return self.linked(name).head.effects

    def linked(self, name: str) -> Linked:
        """The user's function ``name`` with what it has to know of those it calls."""
        found = self._by_name.get(name)
        if found is None:
            function = self.functions[name]
            heads = tuple(
                self.linked(callee).head if callee in self.functions else None
                for callee in self._called(function)
            )
            table: dict[object, Linked] = self._memo.table("linked functions")
            found = table.get((function, heads))
            if found is None:
                found = table[function, heads] = self._link(function)
            self._by_name[name] = found
        return found

    def _link(self, function: n.FunctionDef) -> Linked:
        inside = self.of(function.body)
        own = local_names(function)
        does = inside.does & ~(Does.RETURN | Does.JUMP)
        effects = Effects(inside.reads - own, inside.writes - own, does)
        params = tuple((item.writes_back, item.type, item.dims) for item in function.proto.params)
        head = FunctionSummary(
            effects,
            live_at_entry(function, self) - own,
            overwritten_in(function, self) - own,
            params,
        )
        heads: dict[object, FunctionSummary] = self._memo.table("heads of functions")
        key = (
            effects.reads,
            effects.writes,
            head.live_at_entry,
            head.overwritten,
            does.value,
            params,
        )
        return Linked(function, own | inside.writes, heads.setdefault(key, head))

    def callees(self, name: str) -> list[str]:
        """The user's functions that the user's function ``name`` calls."""
        return [item for item in self._called(self.functions[name]) if item in self.functions]

    def _called(self, function: n.FunctionDef) -> tuple[str, ...]:
        """The names of all functions that a function calls, built-in ones too."""
        table: dict[n.FunctionDef, tuple[str, ...]] = self._memo.table("callees")
        found = table.get(function)
        if found is None:
            calls = (item.name for item in walk(function.body) if isinstance(item, n.Call))
            found = table[function] = tuple(dict.fromkeys(calls))
        return found

    def _own(self, node: n.Node) -> Effects:
        """Combine the (known) effects of the children with what the node itself does."""
        match node:
            case n.Name():
                return Effects(reads=frozenset((node.name,)))
            case n.Assign():
                return self._assign(node)
            case n.Unary(op="++" | "--") | n.Postfix():
                inside = self._table[node.operand]
                return inside | _written(node.operand)
            case n.Call():
                return self._call(node)
            case n.Declarator():
                inside = union(self._table[child] for child in children(node))
                written = frozenset((node.name,)) if node.init is not None else frozenset()
                return inside | Effects(writes=written)
            case n.Return():
                inside = NO_EFFECTS if node.value is None else self._table[node.value]
                return inside | Effects(does=Does.RETURN)
            case n.Jump():
                return Effects(does=Does.DISCARD if node.word == "discard" else Does.JUMP)
            case _:
                return union(self._table[child] for child in children(node))

    def _assign(self, node: n.Assign) -> Effects:
        inside = self._table[node.target] | self._table[node.value]
        if node.op == "=" and isinstance(node.target, n.Name):
            # The old value is not read.
            inside = self._table[node.value]
        return inside | _written(node.target)

    def _call(self, node: n.Call) -> Effects:
        total = union(self._table[arg] for arg in node.args)
        if node.name in self.functions:
            total = total | self.summary(node.name)
        else:
            total = total | Effects(does=_builtin_does(node))
        for arg, out in zip(node.args, out_arguments(node, self), strict=True):
            if out:
                total = total | _written(arg)
        return total


def direct_writes(node: n.Node, table: EffectTable) -> frozenset[str]:
    """What a node writes itself: not its operands, but the functions that it calls."""
    targets: tuple[n.Expr, ...] = ()
    found: frozenset[str] = frozenset()
    match node:
        case n.Assign(target=target):
            targets = (target,)
        case n.Unary(op="++" | "--", operand=target) | n.Postfix(operand=target):
            targets = (target,)
        case n.Call(args=args):
            outs = out_arguments(node, table)
            targets = tuple(arg for arg, out in zip(args, outs, strict=True) if out)
            if node.name in table.functions:
                found = table.summary(node.name).writes
    return found.union(root for item in targets if (root := root_variable(item)))


def out_arguments(call: n.Call, table: EffectTable) -> tuple[bool, ...]:
    """For each argument of a call: may the called function write to it?"""
    function = table.functions.get(call.name)
    if function is not None:
        return tuple(param.writes_back for param in function.proto.params)
    signatures = _signatures(call)
    return tuple(
        any(item.params[i].direction != "in" for item in signatures) for i in range(len(call.args))
    )


def _signatures(call: n.Call) -> list[Signature]:
    return [item for item in overloads(call.name) if len(item.params) == len(call.args)]


def needs_derivative(call: n.Call, table: EffectTable) -> bool:
    """Is it a built-in that takes a derivative, openly or for a level of detail?"""
    return call.name not in table.functions and bool(_builtin_does(call))


def _builtin_does(call: n.Call) -> Does:
    does = Does.NOTHING
    for item in _signatures(call):
        if item.derivative:
            does |= Does.DERIVATIVE
        if item.implicit_lod:
            does |= Does.IMPLICIT_LOD
    return does


def _written(target: n.Expr) -> Effects:
    root = root_variable(target)
    return Effects(writes=frozenset((root,))) if root else NO_EFFECTS
