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

import operator
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import cast

from shadercache.analysis.dataflow import NAMES, before_cases, before_loop
from shadercache.analysis.effect_table import EffectTable, out_arguments
from shadercache.analysis.effects import Does, Linked, root_variable
from shadercache.analysis.liveness import overwritten_by, reads_of
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.source import NOWHERE
from shadercache.transform.jumps import (
    NO_JUMPS,
    Jumps,
    Live,
    ends_here,
    is_break,
    is_empty,
    returns_nothing,
)
from shadercache.transform.reachable import keep_reachable, kept_names, names_in


def remove_dead(module: n.Module, wanted: Iterable[str], memo: Memo | None = None) -> n.Module:
    """The module with only what ``main`` needs to write the ``wanted`` global variables.

    Other outputs are no longer written; where one is still read it becomes a plain global.
    """
    outputs = frozenset(wanted)
    memo = Memo() if memo is None else memo
    while True:
        pruned = keep_reachable(_prune_functions(module, outputs, memo), outputs, memo)
        if pruned is module:
            return module
        module = pruned


def _prune_functions(module: n.Module, outputs: Live, memo: Memo) -> n.Module:
    """Callers come first: what is live after their calls is live where the callee returns."""
    table = EffectTable(module, memo)
    live: dict[str, Live] = {"main": outputs}
    pruned: dict[n.Decl, n.FunctionDef] = {}
    for function in _callers_first(table.functions, memo):
        # What no call leads to is never executed; it goes with the declarations.
        at_exit = live.get(function.name, frozenset())
        linked = table.linked(function.name)
        found = _pruned(table, linked, at_exit & linked.names, memo)
        if found.function is not function:
            pruned[function] = found.function
        # What it has no say in is live throughout.
        through = at_exit - linked.names
        for name, after in found.after_calls.items():
            live[name] = live.get(name, frozenset()) | after | through
    if not pruned:
        return module
    return replace(module, decls=tuple(pruned.get(decl, decl) for decl in module.decls))


@dataclass(frozen=True, slots=True)
class _Pruned:
    """A function without what is dead in it, and what is live behind its calls."""

    function: n.FunctionDef
    after_calls: dict[str, Live]


def _pruned(table: EffectTable, linked: Linked, at_exit: Live, memo: Memo) -> _Pruned:
    """One function pruned, where ``at_exit`` is live when it returns: of its own names."""
    kept: dict[tuple[Linked, Live], _Pruned] = memo.table("pruned functions")
    found = kept.get((linked, at_exit))
    if found is None:
        function, after_calls = linked.function, dict[str, Live]()
        body, _ = _Pruner(table, at_exit, after_calls).block(function.body, at_exit)
        if body is not function.body:
            function = replace(function, body=body)
        found = kept[linked, at_exit] = _Pruned(function, after_calls)
    return found


def _callers_first(functions: dict[str, n.FunctionDef], memo: Memo) -> list[n.FunctionDef]:
    order: dict[str, n.FunctionDef] = {}
    stack = [*functions.values()]
    open_: set[str] = set()
    while stack:
        function = stack[-1]
        if function.name not in open_:
            open_.add(function.name)
            called = kept_names(function.body, memo) & functions.keys()
            stack += [functions[name] for name in called if name not in open_]
            continue
        stack.pop()
        order.setdefault(function.name, function)
    return [*order.values()][::-1]


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

    # --- statement lists ---

    def block(self, block: n.Block, live: Live, jumps: Jumps = NO_JUMPS) -> tuple[n.Block, Live]:
        """The pruned block and what is live before it."""
        kept: list[n.Stmt] = []
        same = True
        for stmt in reversed(block.body):
            new, live = self.statement(stmt, live, jumps)
            same = same and new is stmt
            if new is not None:
                kept.append(new)
                self.mentioned |= names_in(new)
                self.at_end = ends_here(new, jumps)
        if same:
            return block, live
        return replace(block, body=tuple(reversed(kept))), live

    def nested(self, stmt: n.Stmt, live: Live, jumps: Jumps) -> tuple[n.Stmt | None, Live]:
        """A statement under ``if`` or a loop: ``None`` where nothing of it is left."""
        new, before = self.statement(stmt, live, jumps)
        if new is not None:
            self.mentioned |= names_in(new)
        return new, before

    def statement(self, stmt: n.Stmt, live: Live, jumps: Jumps) -> tuple[n.Stmt | None, Live]:
        """The pruned statement (``None``: dead) and what is live before it."""
        match stmt:
            case n.ExprStmt():
                return self.expression(stmt, live)
            case n.DeclStmt(decl=n.VarDecl()):
                return self.declaration(stmt, live)
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
            case _:
                return stmt, live

    # --- statements ---

    def expression(self, stmt: n.ExprStmt, live: Live) -> tuple[n.Stmt | None, Live]:
        if stmt.expr is None:
            return None, live
        parts = list(self._needed(stmt.expr, live))
        if not parts:
            return None, live
        if parts == [stmt.expr]:
            self._note_calls(stmt, live)
            return stmt, (live - overwritten_by(stmt, self.table)) | reads_of(stmt, self.table)
        kept = [n.ExprStmt(part.span, part) for part in parts]
        for item in kept:
            live = self.evaluated(item, live)
        return kept[0] if len(kept) == 1 else n.Block(stmt.span, tuple(kept)), live

    def evaluated(self, node: n.Node, live: Live) -> Live:
        """What is live before something that is kept as it is, and overwrites nothing wholly."""
        self._note_calls(node, live)
        return live | reads_of(node, self.table)

    def _note_calls(self, node: n.Node, live: Live) -> None:
        """Note what is live behind the calls inside: globals, and parameters that write back."""
        functions = self.table.functions
        calls = [item for item in walk(node) if isinstance(item, n.Call) and item.name in functions]
        last = _last_call(node)
        for call in calls:
            # Other parts may be evaluated after it.
            after = live if call is last else live | reads_of(node, self.table)
            params = functions[call.name].proto.params
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
        match expr:
            case n.Assign(target=target, value=value) if self._is_dead(target, live):
                yield from self._needed(value, live)
            case n.Binary(op="&&" | "||") | n.Conditional():
                first, *others = cast("tuple[n.Expr, ...]", children(expr))
                if any(self._matters(other, live) for other in others):
                    yield expr
                else:
                    yield from self._needed(first, live)
            case n.Call(args=args) if not self._acts(expr, live):
                for arg in args:
                    yield from self._needed(arg, live)
            case n.Binary() | n.Unary(op="+" | "-" | "!" | "~") | n.Construct() | n.Comma():
                for part in children(expr):
                    if isinstance(part, EXPRESSIONS):
                        yield from self._needed(cast("n.Expr", part), live)
            case n.Member(object=inner):
                yield from self._needed(inner, live)
            case _:
                yield expr

    def _acts(self, call: n.Call, live: Live) -> bool:
        """Does the called function do something which matters?"""
        if call.name in self.table.functions:
            summary = self.table.summary(call.name)
            if summary.writes & live or summary.does & Does.DISCARD:
                return True
        outs = zip(call.args, out_arguments(call, self.table), strict=True)
        return any(out and not self._is_dead(arg, live) for arg, out in outs)

    def declaration(self, stmt: n.DeclStmt, live: Live) -> tuple[n.Stmt | None, Live]:
        """Declarators are one to a statement (:mod:`shadercache.transform.split`)."""
        decl = stmt.decl
        assert isinstance(decl, n.VarDecl)
        if len(decl.declarators) != 1:  # a struct alone, or variables of an anonymous struct
            return stmt, self.evaluated(decl, live)
        (item,) = decl.declarators
        if item.name in live or decl.qualifiers.has("const"):
            if item.name not in live and item.name not in self.mentioned:
                return None, live
            return stmt, self.evaluated(decl, live - {item.name})
        if item.init is not None and self._matters(item.init, live):
            if item.name in self.mentioned:
                return stmt, self.evaluated(decl, live - {item.name})
            return self.expression(n.ExprStmt(stmt.span, item.init), live)
        if item.name not in self.mentioned:
            return None, live
        if item.init is None:
            return stmt, live
        bare = replace(decl, declarators=(replace(item, init=None),))
        return replace(stmt, decl=bare), live

    def branch(self, stmt: n.If, live: Live, jumps: Jumps) -> tuple[n.Stmt | None, Live]:
        at_end = self.at_end
        then, live_then = self.nested(stmt.then, live, jumps)
        self.at_end = at_end
        other, live_other = (None, live)
        if stmt.other is not None:
            other, live_other = self.nested(stmt.other, live, jumps)
        if then is None and other is None:
            return self.expression(n.ExprStmt(stmt.span, stmt.condition), live)
        before = self.evaluated(stmt.condition, live_then | live_other)
        if then is stmt.then and other is stmt.other:
            return stmt, before
        if then is not None:
            return replace(stmt, then=then, other=other), before
        assert other is not None
        condition = n.Unary(stmt.condition.span, "!", stmt.condition)
        return replace(stmt, condition=condition, then=other, other=None), before

    def loop(self, stmt: n.For | n.While | n.DoWhile, live: Live) -> tuple[n.Stmt | None, Live]:
        """A loop goes as a whole where nothing live comes out of it; else its body is pruned.

        Its header stays: it decides how often the body runs.
        """
        if self.is_idle(stmt, live):
            return None, live
        self.at_end = False
        header = [part for part in children(stmt) if part is not stmt.body]
        around = live.union(*(self.table.of(part).reads for part in header))

        def round_(head: Live) -> Live:
            jumps = Jumps(after_break=live, after_continue=head)
            trial = _Pruner(self.table, self.at_exit, self.after_calls)
            trial.mentioned, trial.at_end = set(self.mentioned), False
            return trial.nested(stmt.body, head, jumps)[1]

        around = before_loop(NAMES, around, round_)
        for part in header:
            self.evaluated(part, around)
            self.mentioned |= names_in(part)
        body, _ = self.nested(stmt.body, around, Jumps(live, around))
        if body is stmt.body or (body is None and is_empty(stmt.body)):
            return stmt, around
        return replace(stmt, body=body or n.Block(stmt.body.span, ())), around

    def is_idle(self, stmt: n.Stmt, live: Live) -> bool:
        """Does nothing live come out of it, and does it end nothing that would go on?"""
        effects = self.table.of(stmt)
        left = effects.does & Does.RETURN and not (self.at_end and returns_nothing(stmt))
        return not (effects.writes & live or effects.does & Does.DISCARD or left)

    def switch(self, stmt: n.Switch, live: Live, jumps: Jumps) -> tuple[n.Stmt | None, Live]:
        """Statement by statement; a group of cases falls through to the next."""
        inside = Jumps(live, jumps.after_continue, self.at_end)
        kept: list[n.Stmt] = []

        def before(item: n.Stmt, after: Live) -> Live:
            if isinstance(item, n.Case):
                kept.append(item)
                return after
            new, at = self.nested(item, after, inside)
            if new is not None:
                kept.append(new)
                self.at_end = ends_here(new, inside)
            return at

        head = before_cases(NAMES, stmt.body, live, before)
        if all(isinstance(item, n.Case) or is_break(item) for item in kept):
            return self.expression(n.ExprStmt(stmt.span, stmt.selector), live)
        at_selector = self.evaluated(stmt.selector, head)
        if isinstance(kept[0], n.Case):  # Something has to follow the last label.
            kept.insert(0, n.Jump(NOWHERE, "break"))
        body = tuple(reversed(kept))
        same = len(body) == len(stmt.body) and all(map(operator.is_, body, stmt.body))
        return (stmt if same else replace(stmt, body=body)), at_selector

    def _is_dead(self, target: n.Expr, live: Live) -> bool:
        """Is nothing of what is assigned there wanted, and does nothing else happen there?"""
        effects = self.table.of(target)
        return root_variable(target) not in live and not effects.writes and not effects.does

    def _matters(self, expr: n.Expr, live: Live) -> bool:
        effects = self.table.of(expr)
        return bool(effects.writes & live) or bool(effects.does & Does.DISCARD)


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
