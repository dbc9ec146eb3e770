"""Which expressions may come to a place that fragments share, by a coarse account of flow.

Such a place is a derivative (openly, or for a level of detail), a look-up in a cube map or a
discard. The account is independent of the compiler's analyses and takes no notice of order, calls
or copies: whatever a variable is given anywhere flows to all that reads it anywhere. The nodes that
it names and that the compiler lets through are those to be tried first.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.effect_table import EffectTable, needs_derivative, out_arguments
from shadercache.analysis.effects import Does, local_names, root_variable
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk

Key = str | n.Node
"""A global, ``f.x`` for the local ``x`` of ``f``, ``f()`` for its result, or an expression."""

SHARED = "%shared"
_EXITS = Does.RETURN | Does.DISCARD | Does.JUMP
_CUBE = "u_cube"


def near(module: n.Module, nodes: Iterable[Candidate]) -> list[Candidate]:
    """Those of the nodes that may reach a shared place."""
    reaching = _Account(module).reaching()
    return [node for node in nodes if node.expr in reaching]


class _Account:
    """Edges from what is read to what it is written to, backwards."""

    def __init__(self, module: n.Module) -> None:
        self._table = EffectTable(module)
        self._sources: dict[Key, set[Key]] = {}
        for function in self._table.functions.values():
            self._function = function
            self._locals = local_names(function)
            self._statement(function.body, self._exits(function.body))

    def reaching(self) -> Collection[Key]:
        """Everything that may come to a shared place."""
        found: set[Key] = {SHARED}
        waiting: list[Key] = [SHARED]
        while waiting:
            new = self._sources.get(waiting.pop(), set()) - found
            found |= new
            waiting += new
        return found

    def _key(self, name: str) -> str:
        return f"{self._function.name}.{name}" if name in self._locals else name

    def _reads(self, *nodes: n.Node) -> set[Key]:
        found = set[Key]()
        for item in (item for node in nodes for item in walk(node)):
            found.add(item)
            if isinstance(item, n.Name):
                found.add(self._key(item.name))
            elif isinstance(item, n.Call) and item.name in self._table.functions:
                found.add(f"{item.name}()")
        return found

    def _exits(self, body: n.Node) -> set[Key]:
        """What decides on jumps: all that follows hangs on it."""
        found = set[Key]()
        for item in walk(body):
            if self._table.of(item).does & _EXITS:
                found |= self._reads(*_heads(item))
        return found

    def _flow(self, sources: set[Key], target: Key) -> None:
        self._sources.setdefault(target, set()).update(sources)

    def _statement(self, node: n.Node, under: set[Key]) -> None:
        inner = under | self._reads(*_heads(node))
        if isinstance(node, n.Stmt) and any(isinstance(part, n.Stmt) for part in children(node)):
            for part in children(node):
                self._statement(part, inner)
            return
        for item in walk(node):
            self._item(item, inner | self._choices(node))

    def _choices(self, node: n.Node) -> set[Key]:
        """What decides which parts of an expression are evaluated."""
        return {
            key
            for item in walk(node)
            if isinstance(item, n.Conditional | n.Binary)
            for key in self._reads(*_choosing(item))
        }

    def _item(self, item: n.Node, under: set[Key]) -> None:
        match item:
            case n.Assign(target=target, value=value):
                self._write(target, self._reads(*children(target), value) | under)
            case n.Unary(op="++" | "--", operand=target) | n.Postfix(operand=target):
                self._write(target, under)
            case n.Declarator(name=name, init=init) if init is not None:
                self._flow(self._reads(init) | under, self._key(name))
            case n.Return(value=value):
                reads = self._reads(value) if value is not None else set[Key]()
                self._flow(reads | under, f"{self._function.name}()")
            case n.Jump(word="discard"):
                self._flow(under, SHARED)
            case n.Call():
                self._call(item, under)

    def _write(self, target: n.Expr, sources: set[Key]) -> None:
        root = root_variable(target)
        if root is not None:
            self._flow(sources, self._key(root))

    def _call(self, call: n.Call, under: set[Key]) -> None:
        function = self._table.functions.get(call.name)
        if function is None:
            if needs_derivative(call, self._table) or _is_of_cube(call):
                self._flow(self._reads(*call.args) | under, SHARED)
            return
        summary = self._table.summary(call.name)
        if summary.does:
            self._flow(under, SHARED)
        for name in summary.writes:
            self._flow(under, name)
        outs = out_arguments(call, self._table)
        for param, arg, out in zip(function.proto.params, call.args, outs, strict=True):
            inner = f"{call.name}.{param.name}"
            self._flow(self._reads(arg) | under, inner)
            if out:
                self._write(arg, {inner} | under)


def _heads(node: n.Node) -> Iterator[n.Node]:
    match node:
        case n.If(condition=head) | n.Switch(selector=head):
            yield head
        case n.For() | n.While() | n.DoWhile() if node.condition is not None:
            yield node.condition


def _choosing(node: n.Node) -> Iterator[n.Node]:
    match node:
        case n.Conditional(condition=first) | n.Binary(op="&&" | "||", left=first):
            yield first


def _is_of_cube(call: n.Call) -> bool:
    return any(isinstance(arg, n.Name) and arg.name == _CUBE for arg in call.args)
