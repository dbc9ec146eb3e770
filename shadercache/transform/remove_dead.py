"""Remove everything that the wanted outputs of a program do not need.

Backward liveness over the structured statements of every function, then reachability over the
declarations, until nothing changes any more::

    in vec3 v_a; in vec3 v_b; out vec4 color; out vec4 store;
    float noise(vec3 p) { ... }              in vec3 v_b; out vec4 color;
    void main() {                      =>    void main() {
        float s = noise(v_a);                    color = vec4(v_b, 1.0);
        store = vec4(s);                     }
        color = vec4(v_b, 1.0);              (wanted: color)
    }

Works by name, on a module in which every identifier means one thing
(:mod:`shadercache.transform.unique_names`). It never removes a ``discard``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from graphlib import TopologicalSorter
from operator import is_
from typing import TypeAlias, TypeVar, cast

from shadercache.analysis.dataflow import NAMES, before_cases, before_loop
from shadercache.analysis.effect_table import EffectTable, out_arguments, overwritten_by
from shadercache.analysis.effects import Does, Linked, root_variable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.source import NOWHERE
from shadercache.transform.reachable import keep_reachable, names_in
from shadercache.transform.trees import change_functions

S = TypeVar("S", n.Block, n.Switch)

Live: TypeAlias = frozenset[str]
"""Variables whose value is still wanted."""

Left: TypeAlias = tuple[n.Stmt | None, Live]
"""What is left of a statement (``None``: it is dead), and what is live before it."""


def remove_dead(module: n.Module, wanted: Iterable[str], memo: Memo | None = None) -> n.Module:
    """The module with only what ``main`` needs to write the ``wanted`` global variables.

    Other outputs are no longer written; where one is still read it becomes a plain global.
    """
    outputs = frozenset(wanted)
    memo = Memo() if memo is None else memo
    # A function that has lost its last effect makes its calls dead, and these what only fed them.
    # Its callers were pruned before it, so that takes another round.
    while True:
        pruned = keep_reachable(_prune_functions(module, outputs, memo), outputs, memo)
        if pruned is module:
            return module
        module = pruned


def _prune_functions(module: n.Module, outputs: Live, memo: Memo) -> n.Module:
    table = EffectTable(module, memo)
    live: dict[str, Live] = {"main": outputs}
    pruned: dict[n.FunctionDef, n.FunctionDef] = {}
    callees = {name: table.callees(name) for name in table.functions}
    # Callers come first: what is live behind their calls is live where the callee returns.
    # There is such an order: recursion is not allowed (GLSL 3.30 section 6.1).
    for name in reversed([*TopologicalSorter(callees).static_order()]):
        # What no call leads to is never executed; it goes with the declarations.
        at_exit = live.get(name, frozenset())
        linked = table.linked(name)
        function, after_calls = _prune_function(table, linked, at_exit & linked.names, memo)
        pruned[linked.function] = function
        # Names that the function neither declares nor writes are live throughout.
        through = at_exit - linked.names
        for callee, after in after_calls.items():
            live[callee] = live.get(callee, frozenset()) | after | through
    return change_functions(module, pruned.__getitem__)


def _prune_function(
    table: EffectTable, linked: Linked, at_exit: Live, memo: Memo
) -> tuple[n.FunctionDef, dict[str, Live]]:
    """One function pruned, where ``at_exit`` is live when it returns; what is live behind its
    calls, by function."""
    known: dict[tuple[Linked, Live], tuple[n.FunctionDef, dict[str, Live]]]
    known = memo.table("pruned functions")
    # Linked to other callees the same function is another key: they decide what in it is dead.
    if (linked, at_exit) not in known:
        function, after_calls = linked.function, dict[str, Live]()
        body, _ = _Pruner(table, at_exit, after_calls).block(function.body, at_exit)
        if body is not function.body:
            function = replace(function, body=body)
        known[linked, at_exit] = function, after_calls
    return known[linked, at_exit]


@dataclass(frozen=True, slots=True)
class _Jumps:
    """What is live where ``break`` and ``continue`` lead.

    ``ends``: is nothing executed behind a ``break``?
    """

    after_break: Live = frozenset()
    after_continue: Live = frozenset()
    ends: bool = False


_NO_JUMPS = _Jumps()


class _Pruner:
    """Prunes one function; ``at_exit`` is live where it returns.

    ``after_calls`` collects what is live behind the calls of each function.
    """

    def __init__(self, table: EffectTable, at_exit: Live, after_calls: dict[str, Live]) -> None:
        self.table = table
        self.at_exit = at_exit
        self.after_calls = after_calls
        self.mentioned: set[str] = set()
        """Names that kept statements use; later in the text than the statement at hand."""
        self.at_end = True
        """Is nothing executed behind the statement at hand?"""

    def block(self, block: n.Block, live: Live, jumps: _Jumps = _NO_JUMPS) -> tuple[n.Block, Live]:
        """The pruned block and what is live before it."""
        kept: list[n.Stmt] = []
        for stmt in reversed(block.body):
            new, live = self.statement(stmt, live, jumps)
            if new is not None:
                kept.append(new)
                self.at_end = _ends_here(new, jumps)
        return _with_body(block, kept), live

    def statement(self, stmt: n.Stmt, live: Live, jumps: _Jumps) -> Left:
        new, before = self._left_of(stmt, live, jumps)
        if new is not None:
            self.mentioned |= names_in(new)
        return new, before

    def _left_of(self, stmt: n.Stmt, live: Live, jumps: _Jumps) -> Left:
        match stmt:
            case n.ExprStmt():
                return self.expression(stmt, live)
            case n.DeclStmt(decl=n.VarDecl() as decl):
                return self.declaration(stmt, decl, live)
            case n.Block():
                block, live = self.block(stmt, live, jumps)
                return (block if block.body else None), live
            case n.If():
                return self.branch(stmt, live, jumps)
            case n.For() | n.While() | n.DoWhile():
                return self.loop(stmt, live)
            case n.Switch():
                return self.switch(stmt, live, jumps)
            case n.Return(value=None) if self.at_end:
                return None, self.at_exit
            case n.Return():
                return stmt, self.evaluated(stmt, self.at_exit)
            case n.Jump(word="break"):
                return stmt, jumps.after_break
            case n.Jump(word="continue"):
                return stmt, jumps.after_continue
        return stmt, live

    def expression(self, stmt: n.ExprStmt, live: Live) -> Left:
        parts = [] if stmt.expr is None else list(self._needed(stmt.expr, live))
        if not parts:
            return None, live
        if parts == [stmt.expr]:
            self._note_calls(stmt, live)
            return stmt, (live - overwritten_by(stmt, self.table)) | self.table.reads(stmt)
        kept = [n.ExprStmt(part.span, part) for part in parts]
        # Backwards: behind the calls of a part, what the later ones read is live.
        for part in reversed(kept):
            live = self.evaluated(part, live)
        return kept[0] if len(kept) == 1 else n.Block(stmt.span, tuple(kept)), live

    def evaluated(self, node: n.Node, live: Live) -> Live:
        """What is live before something that is kept as it is, and overwrites nothing wholly."""
        self._note_calls(node, live)
        return live | self.table.reads(node)

    def _note_calls(self, node: n.Node, live: Live) -> None:
        """Note what is live behind the calls inside: globals, and parameters that write back."""
        functions = self.table.functions
        calls = [call for call in walk(node) if isinstance(call, n.Call) and call.name in functions]
        last = _last_call(node)
        for call in calls:
            # Other parts may be evaluated after it.
            after = live if call is last else live | self.table.reads(node)
            params = functions[call.name].proto.params
            # What a parameter writes back is wanted where its argument is live.
            back = {
                param.name
                for param, arg in zip(params, call.args, strict=True)
                if param.name and param.writes_back and root_variable(arg) in after
            }
            known = self.after_calls.get(call.name, frozenset())
            self.after_calls[call.name] = known | after | back

    def _needed(self, expr: n.Expr, live: Live) -> Iterator[n.Expr]:
        """The largest parts of an expression that do something which matters.

        The value of the whole is wanted by nobody: ``x = 2.0 * f(y)`` with a dead ``x`` comes down
        to ``f(y)`` where that has a side effect, and to nothing where not.
        """
        if not self._matters(expr, live):
            return
        parts: Iterable[n.Node] = ()
        match expr:
            case n.Comma(left=left, right=right):
                # The one operator besides those with conditions that has an order (GLSL 3.30
                # section 5.9): what the right side reads is live behind the left one.
                rest = list(self._needed(right, live))
                behind = live.union(*(self.table.reads(part) for part in rest))
                yield from self._needed(left, behind)
                yield from rest
                return
            case n.Assign(target=target, value=value) if self._is_dead(target, live):
                parts = (value,)
            case n.Binary(op="&&" | "||") | n.Conditional():
                first, *others = cast("tuple[n.Expr, ...]", children(expr))
                # What is evaluated only under a condition cannot stand alone.
                parts = () if any(self._matters(other, live) for other in others) else (first,)
            case n.Call(args=args) if not self._acts(expr, live):
                parts = args
            case n.Binary() | n.Unary(op="+" | "-" | "!" | "~") | n.Construct():
                parts = children(expr)
            case n.Member(object=inner):
                parts = (inner,)
        if not parts:
            yield expr
        for part in parts:
            if isinstance(part, EXPRESSIONS):
                yield from self._needed(cast("n.Expr", part), live)

    def _acts(self, call: n.Call, live: Live) -> bool:
        """Does the called function do something which matters?"""
        if call.name in self.table.functions:
            summary = self.table.summary(call.name)
            if summary.writes & live or summary.does & Does.DISCARD:
                return True
        outs = zip(call.args, out_arguments(call, self.table), strict=True)
        return any(out and not self._is_dead(arg, live) for arg, out in outs)

    def declaration(self, stmt: n.DeclStmt, decl: n.VarDecl, live: Live) -> Left:
        """Declarators are one to a statement (:mod:`shadercache.transform.split`)."""
        if len(decl.declarators) != 1:  # a struct alone, or variables of an anonymous struct
            return stmt, self.evaluated(decl, live)
        (variable,) = decl.declarators
        mentioned = variable.name in self.mentioned
        acts = variable.init is not None and self._matters(variable.init, live)
        # A const must have its value (GLSL 3.30 section 4.3.2), though nobody reads it.
        if variable.name in live or (mentioned and (acts or decl.qualifiers.has("const"))):
            return stmt, self.evaluated(decl, live - {variable.name})
        if not mentioned:
            return self.expression(n.ExprStmt(stmt.span, variable.init), live)
        # Nobody wants the value, but a kept statement names the variable: an `out` argument, say.
        if variable.init is None:
            return stmt, live
        bare = replace(decl, declarators=(replace(variable, init=None),))
        return replace(stmt, decl=bare), live

    def branch(self, stmt: n.If, live: Live, jumps: _Jumps) -> Left:
        at_end = self.at_end
        then, live_then = self.statement(stmt.then, live, jumps)
        # Both branches end where the conditional does.
        self.at_end = at_end
        other, live_other = (None, live)
        if stmt.other is not None:
            other, live_other = self.statement(stmt.other, live, jumps)
        if then is None and other is None:
            return self.expression(n.ExprStmt(stmt.span, stmt.condition), live)
        before = self.evaluated(stmt.condition, live_then | live_other)
        if then is stmt.then and other is stmt.other:
            return stmt, before
        if then is not None:
            return replace(stmt, then=then, other=other), before
        # Something has to stand under an ``if``: what is left is its ``else``, negated.
        assert other is not None
        condition = n.Unary(stmt.condition.span, "!", stmt.condition)
        return replace(stmt, condition=condition, then=other, other=None), before

    def loop(self, stmt: n.For | n.While | n.DoWhile, live: Live) -> Left:
        """A loop goes as a whole where nothing live comes out of it; else its body is pruned.

        Its header stays: it decides how often the body runs.
        """
        if self.is_idle(stmt, live):
            return None, live
        # Behind the end of the body comes the next round.
        self.at_end = False
        header = [part for part in children(stmt) if part is not stmt.body]
        around = live.union(*(self.table.of(part).reads for part in header))

        # Each trial may find more to be live at the head; what it notes of calls only grows.
        def round_(head: Live) -> Live:
            trial = _Pruner(self.table, self.at_exit, self.after_calls)
            trial.mentioned, trial.at_end = set(self.mentioned), False
            return trial.statement(stmt.body, head, _Jumps(live, head))[1]

        around = before_loop(NAMES, around, round_)
        for part in header:
            self.evaluated(part, around)
            self.mentioned |= names_in(part)
        body, _ = self.statement(stmt.body, around, _Jumps(live, around))
        if body is stmt.body or (body is None and _is_empty(stmt.body)):
            return stmt, around
        return replace(stmt, body=body or n.Block(stmt.body.span, ())), around

    def is_idle(self, stmt: n.Stmt, live: Live) -> bool:
        """Does nothing live come out of it, and does it end nothing that would go on?"""
        effects = self.table.of(stmt)
        # Where nothing follows the loop, a `return` in it ends no more than a `break` would.
        left = effects.does & Does.RETURN and not (self.at_end and _returns_nothing(stmt))
        return not (effects.writes & live or effects.does & Does.DISCARD or left)

    def switch(self, stmt: n.Switch, live: Live, jumps: _Jumps) -> Left:
        """Statement by statement; a group of cases falls through to the next."""
        # A `break` leaves the switch, a `continue` leaves it for the loop around.
        inside = _Jumps(live, jumps.after_continue, self.at_end)
        kept: list[n.Stmt] = []

        def before(part: n.Stmt, after: Live) -> Live:
            new, at = self.statement(part, after, inside)
            if new is not None:
                kept.append(new)
                if not isinstance(new, n.Case):
                    self.at_end = _ends_here(new, inside)
            return at

        head = before_cases(NAMES, stmt.body, live, before)
        if all(isinstance(part, n.Case) or _is_break(part) for part in kept):
            return self.expression(n.ExprStmt(stmt.span, stmt.selector), live)
        at_selector = self.evaluated(stmt.selector, head)
        if isinstance(kept[0], n.Case):  # Something has to follow the last label.
            kept.insert(0, n.Jump(NOWHERE, "break"))
        return _with_body(stmt, kept), at_selector

    def _is_dead(self, target: n.Expr, live: Live) -> bool:
        """Is nothing of what is assigned there wanted, and does nothing else happen there?"""
        effects = self.table.of(target)
        return root_variable(target) not in live and not effects.writes and not effects.does

    def _matters(self, expr: n.Expr, live: Live) -> bool:
        effects = self.table.of(expr)
        return bool(effects.writes & live) or bool(effects.does & Does.DISCARD)


def _with_body(stmt: S, backward: list[n.Stmt]) -> S:
    body = tuple(reversed(backward))
    same = len(body) == len(stmt.body) and all(map(is_, body, stmt.body))
    return stmt if same else replace(stmt, body=body)


def _last_call(node: n.Node) -> n.Call | None:
    """The call that is the last thing which a statement does, an assignment to a variable apart."""
    match node:
        case n.ExprStmt(expr=n.Assign(op="=", target=n.Name(), value=n.Call() as call)):
            return call
        case n.ExprStmt(expr=n.Call() as call) | n.Return(value=n.Call() as call):
            return call
        case n.VarDecl(declarators=(n.Declarator(init=n.Call() as call),)):
            return call
    return None


def _ends_here(stmt: n.Stmt, jumps: _Jumps) -> bool:
    """Is nothing executed behind a statement for sure, and nothing returned by it?"""
    return (isinstance(stmt, n.Return) and stmt.value is None) or (_is_break(stmt) and jumps.ends)


def _returns_nothing(stmt: n.Stmt) -> bool:
    return all(node.value is None for node in walk(stmt) if isinstance(node, n.Return))


def _is_break(stmt: n.Stmt) -> bool:
    return isinstance(stmt, n.Jump) and stmt.word == "break"


def _is_empty(stmt: n.Stmt) -> bool:
    match stmt:
        case n.Block(body=()) | n.ExprStmt(expr=None):
            return True
    return False
