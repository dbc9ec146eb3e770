"""The effects of every piece of a module.

The analysis works by name, so it needs a module in which every identifier means one thing
(:mod:`shadercache.transform.unique_names`); it needs no table of types and can therefore be run
again after any rewrite.

A call counts with everything that the called function, and what that calls, does to global
variables; its locals and parameters stay its own.

The effects of a function say what it may read or write, in whatever order. In its summary the order
counts, too::

    void shade() {               // reads u_light and v_a; o_color is overwritten before
        o_color = vec4(v_a, 1.0);
        o_color.rgb *= u_light;
    }
"""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.analysis.dataflow import Backward, Loop
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
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import children, postorder, walk
from shadercache.lang.builtins import Signature, overloads

_NO_NAMES: frozenset[str] = frozenset()


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
        self._reads: dict[n.Node, frozenset[str]] = {}
        self._by_name: dict[str, Linked] = {}

    def of(self, node: n.Node) -> Effects:
        """The effects of evaluating an expression or executing a statement."""
        known = self._table.get(node)
        if known is not None:
            return known
        for part in postorder(node, self._table):
            effects = self._own(part)
            if part in self._marks:
                effects = effects | Effects(self._marked(part))
            self._table[part] = effects
        return self._table[node]

    def reads(self, node: n.Node) -> frozenset[str]:
        """What evaluating an expression or a statement reads, before it is overwritten by a call.

        The order counts only in called functions.
        """
        if node not in self._reads:
            for part in postorder(node, self._reads):
                self._reads[part] = self._own_reads(part)
        return self._reads[node]

    def _own_reads(self, node: n.Node) -> frozenset[str]:
        """Combine what the (known) children read with what the node itself does."""
        own, parts = self._marked(node), children(node)
        match node:
            case n.Name(name=name):
                own |= {name}
            case n.Call(name=name, args=args) if name in self.functions:
                own |= self.linked(name).head.live_at_entry
                parts = args
            case n.Assign(op="=", target=n.Name(), value=value):
                parts = (value,)
        # Most nodes read what their only child does: one set will do for both.
        if len(parts) == 1 and not own:
            return self._reads[parts[0]]
        return own.union(*(self._reads[part] for part in parts))

    def _marked(self, node: n.Node) -> frozenset[str]:
        return frozenset((self._marks[node],)) if node in self._marks else _NO_NAMES

    def summary(self, name: str) -> Effects:
        """What a call of the user's function ``name`` does outside of the function."""
        return self.linked(name).head.effects

    def linked(self, name: str) -> Linked:
        """The user's function ``name`` with what it has to know of those it calls."""
        if name not in self._by_name:
            function = self.functions[name]
            # Built-in functions need no head: what they do is the same in every module.
            heads = tuple(
                self.linked(callee).head if callee in self.functions else None
                for callee in self._called(function)
            )
            kept: dict[object, Linked] = self._memo.table("linked functions")
            if (function, heads) not in kept:
                kept[function, heads] = self._link(function)
            self._by_name[name] = kept[function, heads]
        return self._by_name[name]

    def _link(self, function: n.FunctionDef) -> Linked:
        inside = self.of(function.body)
        own = local_names(function)
        # A return or a jump ends inside the call; a discard ends its callers as well.
        does = inside.does & ~(Does.RETURN | Does.JUMP)
        effects = Effects(inside.reads - own, inside.writes - own, does)
        params = tuple(
            (param.writes_back, param.type, param.dims) for param in function.proto.params
        )
        live = _Liveness(self).block(function.body.body, _NO_NAMES) - own
        overwritten = _overwritten_in(function, self) - own
        head = FunctionSummary(effects, live, overwritten, params)
        heads: dict[object, FunctionSummary] = self._memo.table("heads of functions")
        # Of the flags the bits: flags themselves hash slowly.
        key = (effects.reads, effects.writes, live, overwritten, does.value, params)
        return Linked(function, own | inside.writes, heads.setdefault(key, head))

    def callees(self, name: str) -> list[str]:
        """The user's functions that the user's function ``name`` calls."""
        return [callee for callee in self._called(self.functions[name]) if callee in self.functions]

    def _called(self, function: n.FunctionDef) -> tuple[str, ...]:
        """The names of all functions that a function calls, built-in ones too."""
        kept: dict[n.FunctionDef, tuple[str, ...]] = self._memo.table("callees")
        if function not in kept:
            calls = (call.name for call in walk(function.body) if isinstance(call, n.Call))
            kept[function] = tuple(dict.fromkeys(calls))
        return kept[function]

    def _own(self, node: n.Node) -> Effects:
        """Combine the (known) effects of the children with what the node itself does."""
        match node:
            case n.Name():
                return Effects(reads=frozenset((node.name,)))
            case n.Assign(target=target, value=value):
                inside = self._table[value]
                if node.op != "=" or not isinstance(target, n.Name):  # else no old value is read
                    inside |= self._table[target]
                return inside | _written(target)
            case n.Unary(op="++" | "--") | n.Postfix():
                return self._table[node.operand] | _written(node.operand)
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

    def _call(self, node: n.Call) -> Effects:
        outs = zip(node.args, out_arguments(node, self), strict=True)
        if node.name in self.functions:
            own = self.summary(node.name)
        else:
            own = Effects(does=_builtin_does(node))
        written = (_written(arg) for arg, out in outs if out)
        return union((*(self._table[arg] for arg in node.args), own, *written))


class _Liveness(Backward[frozenset[str]]):
    """Variables that may be read before they are overwritten; a loop or a ``switch`` is taken as a
    whole."""

    def __init__(self, table: EffectTable) -> None:
        self._table = table

    def branch(self, stmt: n.If, fact: frozenset[str]) -> frozenset[str]:
        other = fact if stmt.other is None else self.statement(stmt.other, fact)
        return self.statement(stmt.then, fact) | other | self._table.reads(stmt.condition)

    def loop(self, stmt: Loop | n.Switch, fact: frozenset[str]) -> frozenset[str]:
        return fact | self._table.reads(stmt)

    switch = loop

    def jump(self, stmt: n.Return | n.Jump, fact: frozenset[str]) -> frozenset[str]:
        if isinstance(stmt, n.Jump) and stmt.word != "discard":
            return fact
        # Behind a return only the caller reads on, and behind a discard nobody does.
        return self._table.reads(stmt)

    def plain(self, stmt: n.Stmt, fact: frozenset[str]) -> frozenset[str]:
        return (fact - overwritten_by(stmt, self._table)) | self._table.reads(stmt)


def overwritten_by(node: n.Node, table: EffectTable) -> frozenset[str]:
    """Variables whose old value is gone behind a plain statement, whatever they held."""
    match node:
        case n.ExprStmt(expr=n.Assign(op="=", target=n.Name(name=name))):
            return frozenset((name,))
        case n.ExprStmt(expr=n.Call(name=name)) if name in table.functions:
            return table.linked(name).head.overwritten
        case n.DeclStmt(decl=n.VarDecl(declarators=items)):
            return frozenset(variable.name for variable in items)
    return _NO_NAMES


def _overwritten_in(function: n.FunctionDef, table: EffectTable) -> frozenset[str]:
    """Variables that a function overwrites wholly, wherever it returns."""
    names, todo = _NO_NAMES, [*function.body.body[::-1]]
    while todo:
        stmt = todo.pop()
        if isinstance(stmt, n.Block):
            todo += stmt.body[::-1]
        # Whoever returns here has not come past the rest. A discard is no obstacle: behind it
        # nobody reads.
        elif table.of(stmt).does & Does.RETURN:
            break
        else:
            names |= overwritten_by(stmt, table)
    return names


def direct_writes(node: n.Node, table: EffectTable) -> frozenset[str]:
    """What a node writes itself: not its operands, but the functions that it calls."""
    targets: tuple[n.Expr, ...] = ()
    names: frozenset[str] = frozenset()
    match node:
        case n.Assign(target=target):
            targets = (target,)
        case n.Unary(op="++" | "--", operand=target) | n.Postfix(operand=target):
            targets = (target,)
        case n.Call(args=args):
            outs = out_arguments(node, table)
            targets = tuple(arg for arg, out in zip(args, outs, strict=True) if out)
            if node.name in table.functions:
                names = table.summary(node.name).writes
    return names.union(root for expr in targets if (root := root_variable(expr)))


def out_arguments(call: n.Call, table: EffectTable) -> tuple[bool, ...]:
    """For each argument of a call: may the called function write to it?"""
    function = table.functions.get(call.name)
    if function is not None:
        return tuple(param.writes_back for param in function.proto.params)
    # There is no table of types here to choose an overload by: what one may write, all may.
    signatures = _signatures(call)
    return tuple(
        any(signature.params[i].direction != "in" for signature in signatures)
        for i in range(len(call.args))
    )


def _signatures(call: n.Call) -> list[Signature]:
    return [
        signature for signature in overloads(call.name) if len(signature.params) == len(call.args)
    ]


def needs_derivative(call: n.Call, table: EffectTable) -> bool:
    """Is it a built-in that takes a derivative, openly or for a level of detail?"""
    return call.name not in table.functions and bool(_builtin_does(call))


def _builtin_does(call: n.Call) -> Does:
    does = Does.NOTHING
    for signature in _signatures(call):
        if signature.derivative:
            does |= Does.DERIVATIVE
        if signature.implicit_lod:
            does |= Does.IMPLICIT_LOD
    return does


def _written(target: n.Expr) -> Effects:
    root = root_variable(target)
    return Effects(writes=frozenset((root,))) if root else NO_EFFECTS
