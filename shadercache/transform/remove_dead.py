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
(:mod:`shadercache.transform.unique_names`). It never removes a ``discard``, and what it cannot
follow (``switch``) it keeps or drops as a whole.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from shadercache.analysis.effects import Does, EffectTable, root_variable
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk
from shadercache.transform.reachable import keep_reachable, names_in

Live = frozenset[str]


def remove_dead(module: n.Module, wanted: Iterable[str]) -> n.Module:
    """The module with only what ``main`` needs to write the ``wanted`` global variables.

    Other outputs are no longer written; where one is still read it becomes a plain global.
    """
    outputs = frozenset(wanted)
    while True:
        pruned = keep_reachable(_prune_functions(module, outputs), outputs)
        if pruned is module:
            return module
        module = pruned


def _prune_functions(module: n.Module, outputs: Live) -> n.Module:
    table = EffectTable(module)
    read = frozenset[str]().union(*(table.summary(name).reads for name in table.functions))
    decls: list[n.Decl] = []
    for decl in module.decls:
        if isinstance(decl, n.FunctionDef):
            # The caller may need what other functions leave in out parameters and in any global
            # that is read anywhere.
            at_exit = outputs if decl.name == "main" else outputs | read | _written_back(decl)
            body, _ = _Pruner(table, at_exit).block(decl.body, at_exit)
            decl = decl if body is decl.body else replace(decl, body=body)
        decls.append(decl)
    if all(new is old for new, old in zip(decls, module.decls, strict=True)):
        return module
    return replace(module, decls=tuple(decls))


def _written_back(function: n.FunctionDef) -> Live:
    return frozenset(item.name for item in function.proto.params if item.writes_back and item.name)


@dataclass(frozen=True, slots=True)
class _Jumps:
    """What is live where ``break`` and ``continue`` lead."""

    after_break: Live = frozenset()
    after_continue: Live = frozenset()


_NO_JUMPS = _Jumps()


class _Pruner:
    """Prunes one function; ``at_exit`` is live where it returns."""

    def __init__(self, table: EffectTable, at_exit: Live) -> None:
        self.table = table
        self.at_exit = at_exit
        self.mentioned: set[str] = set()
        """Names that kept statements use; later in the text than the statement at hand."""

    # --- statement lists ---

    def block(self, block: n.Block, live: Live, jumps: _Jumps = _NO_JUMPS) -> tuple[n.Block, Live]:
        """The pruned block and what is live before it."""
        kept: list[n.Stmt] = []
        same = True
        for stmt in reversed(block.body):
            new, live = self.statement(stmt, live, jumps)
            same = same and new is stmt
            if new is not None:
                kept.append(new)
                self.mentioned |= names_in(new)
        if same:
            return block, live
        return replace(block, body=tuple(reversed(kept))), live

    def nested(self, stmt: n.Stmt, live: Live, jumps: _Jumps) -> tuple[n.Stmt | None, Live]:
        """A statement under ``if`` or a loop: ``None`` where nothing of it is left."""
        new, before = self.statement(stmt, live, jumps)
        if new is not None:
            self.mentioned |= names_in(new)
        return new, before

    def statement(self, stmt: n.Stmt, live: Live, jumps: _Jumps) -> tuple[n.Stmt | None, Live]:
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
                return self.whole(stmt, live, jumps)
            case n.Return():
                reads = self.table.of(stmt.value).reads if stmt.value else frozenset[str]()
                return stmt, self.at_exit | reads
            case n.Jump(word="break"):
                return stmt, jumps.after_break
            case n.Jump(word="continue"):
                return stmt, jumps.after_continue
            case _:
                return stmt, live

    # --- statements ---

    def expression(self, stmt: n.ExprStmt, live: Live) -> tuple[n.Stmt | None, Live]:
        if stmt.expr is None or not self._matters(stmt.expr, live):
            return None, live
        if isinstance(stmt.expr, n.Assign) and self._is_unread(stmt.expr.target, live):
            return self.expression(replace(stmt, expr=stmt.expr.value), live)
        effects = self.table.of(stmt.expr)
        return stmt, (live - _killed(stmt.expr)) | effects.reads

    def declaration(self, stmt: n.DeclStmt, live: Live) -> tuple[n.Stmt | None, Live]:
        """Declarators are one to a statement (:mod:`shadercache.transform.split`)."""
        decl = stmt.decl
        assert isinstance(decl, n.VarDecl)
        reads = self.table.of(decl).reads
        if len(decl.declarators) != 1:  # a struct alone, or variables of an anonymous struct
            return stmt, live | reads
        (item,) = decl.declarators
        if item.name in live or decl.qualifiers.has("const"):
            if item.name not in live and item.name not in self.mentioned:
                return None, live
            return stmt, (live - {item.name}) | reads
        if item.init is not None and self._matters(item.init, live):
            if item.name in self.mentioned:
                return stmt, (live - {item.name}) | reads
            return n.ExprStmt(stmt.span, item.init), live | reads
        if item.name not in self.mentioned:
            return None, live
        if item.init is None:
            return stmt, live
        bare = replace(decl, declarators=(replace(item, init=None),))
        return replace(stmt, decl=bare), live

    def branch(self, stmt: n.If, live: Live, jumps: _Jumps) -> tuple[n.Stmt | None, Live]:
        then, live_then = self.nested(stmt.then, live, jumps)
        other, live_other = (None, live)
        if stmt.other is not None:
            other, live_other = self.nested(stmt.other, live, jumps)
        if then is None and other is None:
            return self.expression(n.ExprStmt(stmt.span, stmt.condition), live)
        before = live_then | live_other | self.table.of(stmt.condition).reads
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
        effects = self.table.of(stmt)
        if not effects.writes & live and not effects.does & (Does.DISCARD | Does.RETURN):
            return None, live
        header = [part for part in children(stmt) if part is not stmt.body]
        around = live.union(*(self.table.of(part).reads for part in header))
        while True:
            # Liveness at the head of the loop: what is live after it, or in the next round.
            jumps = _Jumps(after_break=live, after_continue=around)
            trial = _Pruner(self.table, self.at_exit)
            trial.mentioned = set(self.mentioned)
            _, before = trial.nested(stmt.body, around, jumps)
            if before <= around:
                break
            around |= before
        for part in header:
            self.mentioned |= names_in(part)
        body, _ = self.nested(stmt.body, around, _Jumps(live, around))
        if body is stmt.body or (body is None and _is_empty(stmt.body)):
            return stmt, around
        return replace(stmt, body=body or n.Block(stmt.body.span, ())), around

    def whole(self, stmt: n.Switch, live: Live, jumps: _Jumps) -> tuple[n.Stmt | None, Live]:
        effects = self.table.of(stmt)
        leaves = effects.does & (Does.DISCARD | Does.RETURN) or _continues(stmt)
        if not effects.writes & live and not leaves:
            return None, live
        # A return inside leads to the exit, a ``continue`` to the next round of the loop outside.
        return stmt, live | effects.reads | self.at_exit | jumps.after_continue

    def _is_unread(self, target: n.Expr, live: Live) -> bool:
        """Is what is assigned to of no use, and nothing else done by naming it?"""
        root = root_variable(target)
        return root is not None and root not in live and not self.table.of(target).writes

    def _matters(self, expr: n.Expr, live: Live) -> bool:
        effects = self.table.of(expr)
        return bool(effects.writes & live) or bool(effects.does & Does.DISCARD)


def _continues(stmt: n.Stmt) -> bool:
    return any(isinstance(item, n.Jump) and item.word == "continue" for item in walk(stmt))


def _is_empty(stmt: n.Stmt) -> bool:
    return (isinstance(stmt, n.Block) and not stmt.body) or (
        isinstance(stmt, n.ExprStmt) and stmt.expr is None
    )


def _killed(expr: n.Expr) -> Live:
    """Variables that the expression overwrites wholly, whatever they held."""
    if isinstance(expr, n.Assign) and expr.op == "=" and isinstance(expr.target, n.Name):
        return frozenset((expr.target.name,))
    return frozenset()
