"""Clone the functions along call paths, so that one call can be changed and the others stay.

With a *use* of ``fbm(q)`` in ``marble``, reached from ``main``::

    float marble(vec3 p) {                      float marble(vec3 p) { ... }
        return sin(fbm(p * 2.0));        =>     float sc_marble(vec3 p) {
    }                                               return sin(sc_payload);
    void main() { color = marble(v_p); }        }
                                                void main() { ... }
                                                void sc_main() { color = sc_marble(v_p); }

Several things can be asked for, each at an expression on a call path:

* *use*: the expression is replaced by a variable;
* *store*: its value goes to the variable first (in a statement of its own), then the variable is
  used;
* *goal*: as store, and everything after the last goal is cut off: the functions on its path return
  nothing.

And where not every fragment reaches the expression:

* *keep*: as store, and it is noted in the cut's flag (``sc_valid``) that there is a value;
* *fill*: as keep, but a value from the cache (``sc_reuse``) is taken as it is;
* *need*: as use, but a fragment without a value from the cache is discarded;
* *lack*: as need, but it is only noted (``sc_lacks``), and what follows goes on.

``main`` is cloned like any function, so several programs' bodies can be made from one module.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple, TypeAlias, cast

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import children, walk
from shadercache.source import NOWHERE
from shadercache.transform.drop_results import returning_nothing
from shadercache.transform.hoist_fetches import FetchForm, hoisted_part, remaining_part
from shadercache.transform.names import FreshNames
from shadercache.transform.trees import assigned, block_of, change_declarations

CutKind: TypeAlias = Literal["use", "store", "goal", "keep", "fill", "need", "lack"]


@dataclass(frozen=True, slots=True, eq=False)
class Cut:
    """One expression to replace: the calls from ``main`` to its function, itself, the variable.

    ``flag`` is the variable that says whether there is a value, for the kinds that set it.
    ``form``: what of a texture fetch goes to the variable (:mod:`transform.hoist_fetches`).
    """

    path: tuple[n.Call, ...]
    expr: n.Expr
    variable: str
    kind: CutKind
    flag: str = ""
    form: FetchForm = "whole"


@dataclass(frozen=True, slots=True)
class Clones:
    """The clone of ``main``, and of every function on the way, each with what it was made from."""

    entry: str
    pairs: tuple[tuple[n.FunctionDef, n.FunctionDef], ...]
    """(original, clone)"""


def specialise(
    module: n.Module, cuts: tuple[Cut, ...], entry: str, names: FreshNames, prefix: str
) -> Clones:
    """Clone ``main`` (as ``entry``) and the functions on the cuts' paths, with the cuts made.

    The other clones get fresh names that begin with ``prefix``. Goals are evaluated in every run:
    none stands under a condition.
    The clones are not yet in the module: see :func:`insert_clones`.
    """
    functions = {d.name: d for d in module.decls if isinstance(d, n.FunctionDef)}
    maker = _Maker(functions, names, prefix)
    maker.clone(functions["main"], cuts, 0, entry)
    return Clones(entry, tuple(maker.pairs))


def insert_clones(module: n.Module, *clones: Clones) -> n.Module:
    """The module with each clone behind its original (and its prototype behind the original's)."""
    by_original: dict[str, list[n.FunctionDef]] = {}
    for group in clones:
        for original, clone in group.pairs:
            by_original.setdefault(original.name, []).append(clone)

    def with_clones(decl: n.Decl) -> tuple[n.Decl, ...]:
        match decl:
            case n.FunctionDef(name=name):
                # Functions are declared before they are called (GLSL 3.30 section 6.1): whoever
                # calls the original stands behind it, and so behind the clones.
                return (decl, *by_original.get(name, ()))
            case n.FunctionProto(name=name):
                return (decl, *(clone.proto for clone in by_original.get(name, ())))
        return (decl,)

    return change_declarations(module, with_clones)


class _Moved(NamedTuple):
    """An expression that gets statements of its own before the one it stands in.

    Without a ``cut`` it is a call on the way to the last goals, which returns nothing any more.
    """

    expr: n.Expr
    cut: Cut | None


class _Maker:
    """Clones functions, callees first."""

    def __init__(self, functions: dict[str, n.FunctionDef], names: FreshNames, prefix: str) -> None:
        self.functions, self.names, self.prefix = functions, names, prefix
        self.pairs: list[tuple[n.FunctionDef, n.FunctionDef]] = []

    def clone(
        self, function: n.FunctionDef, cuts: Sequence[Cut], depth: int, name: str, ends: bool = True
    ) -> str:
        """Add the clone of a function with these cuts made, to which ``depth`` calls lead; return
        its name.

        ``ends``: is a clone with goals left at the last of them?
        """
        own = [cut for cut in cuts if len(cut.path) == depth]
        # By call, not by function: what is cut on one path must not be missing on another.
        below: dict[n.Call, list[Cut]] = {}
        for cut in cuts:
            if len(cut.path) > depth:
                below.setdefault(cut.path[depth], []).append(cut)
        goals: list[n.Expr] = [cut.expr for cut in own if cut.kind == "goal"]
        # Seen from here, a call that leads to a goal is one itself.
        goals += [call for call, inner in below.items() if _has_goal(inner)]
        last, leading = _find_end(function, goals) if ends and goals else (None, [])
        body = _CloneBody(self.prefix, own, last)
        for call, inner in below.items():
            callee = self.functions[call.name]
            # A call ahead of the last goals runs on behind its own: what it returns may be needed.
            body.renamed[call] = self.clone(callee, inner, depth + 1, "", call in leading)
        moved = [_Moved(call, None) for call in below if call in leading]
        moved += [_Moved(cut.expr, cut) for cut in own if cut.kind != "use"]
        body.place(function.body.body, moved)
        # Names are given from the callees up: one for each call path.
        name = name or self.names.make(self.prefix + function.name)
        proto = replace(function.proto, name=name)
        if last is not None:
            proto = returning_nothing(proto)
        clone = replace(function, proto=proto, body=body.rewrite(function.body))
        self.pairs.append((function, clone))
        return name


def _has_goal(cuts: Iterable[Cut]) -> bool:
    return any(cut.kind == "goal" for cut in cuts)


def _find_end(function: n.FunctionDef, goals: Sequence[n.Expr]) -> tuple[n.Stmt, list[n.Expr]]:
    """The statement of a function with the last goal, and the goals in it whose value no other one
    needs: a call among them leads to goals and to nothing else."""
    stmts = _last_first(function.body)
    last = next(stmt for stmt in stmts if any(_holds(stmt, goal) for goal in goals))
    inside = [goal for goal in goals if _holds(last, goal)]
    return last, [g for g in inside if not any(_holds(o, g) for o in inside if o is not g)]


def _last_first(block: n.Block) -> Iterator[n.Stmt]:
    """The statements of a block and of plain blocks in it, from the last to the first."""
    for stmt in reversed(block.body):
        if isinstance(stmt, n.Block):
            yield from _last_first(stmt)
        else:
            yield stmt


_GONE = n.Block(NOWHERE, ())
"""Stands for what comes behind the last goal."""


class _CloneBody(Rewriter):
    """Rewrites the statements of one function, up to the own statements of ``last``."""

    def __init__(self, prefix: str, cuts: Sequence[Cut], last: n.Stmt | None) -> None:
        self.renamed: dict[n.Expr, str] = {}
        self._prefix, self._last = prefix, last
        self._used = {cut.expr: cut for cut in cuts}
        self._given = {cut.expr: cut for cut in cuts if cut.kind == "use"}
        self._ahead: dict[n.Stmt, list[_Moved]] = {}
        self._parted: set[n.Stmt] = set()
        self._values: dict[n.Expr, n.Expr] = {}
        self._ended = False

    def place(self, stmts: Sequence[n.Stmt], moved: list[_Moved]) -> None:
        """Find the statements that ``moved`` expressions come before."""
        for stmt in stmts:
            inside = [move for move in moved if _holds(stmt, move.expr)]
            match stmt:
                case n.Block():
                    self.place(stmt.body, inside)
                case n.If(condition=head) | n.Switch(selector=head):
                    # A condition is evaluated once, before all that it decides, and so may be what
                    # is in it.
                    ahead = [move for move in inside if _holds(head, move.expr)]
                    self._ahead[stmt] = _operands_first(ahead)
                    if len(ahead) < len(inside):
                        self._parted.add(stmt)
                        self.place(cast("tuple[n.Stmt, ...]", children(stmt)[1:]), inside)
                case _:
                    self._ahead[stmt] = _operands_first(inside)

    def enter(self, node: n.Node) -> n.Node | None:
        # The last goal stands in plain blocks alone, so what comes next are statements of these.
        return _GONE if self._ended else None

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if original in self.renamed and isinstance(node, n.Call):
            node = replace(node, name=self.renamed[original])
        # From the bottom up, so the cuts inside are made: it goes to a statement of its own.
        self._values[original] = node
        cut = self._used.get(original)
        return node if cut is None else remaining_part(node, cut.form, cut.variable)

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        match node, original:
            case n.Block(), _ if self._ended:
                return replace(node, body=tuple(stmt for stmt in node.body if stmt is not _GONE))
            case n.If(), n.If() if original in self._parted:
                if node.other is not None and original.other is not None:
                    node = replace(node, other=_block(node.other, original.other))
                node = replace(node, then=_block(node.then, original.then))
        ahead = [
            new for move in self._ahead.get(original, ()) for new in self._own_statements(move)
        ]
        self._ended = original is self._last
        # Of the statement itself nothing is needed: its value was for what comes behind.
        if self._ended:
            return ahead
        return (*ahead, node) if ahead else node

    def _own_statements(self, move: _Moved) -> list[n.Stmt]:
        """``variable = expression;`` and the like, or the call that leads to the last goals."""
        span, cut = move.expr.span, move.cut
        if cut is None:
            return [n.ExprStmt(span, self._values[move.expr])]
        match cut.kind:
            case "need":
                return [self._unless_reused(n.Jump(span, "discard"))]
            case "lack":
                return [self._unless_reused(_set(self._prefix + "lacks"))]
            case "fill":
                return [self._unless_reused(self._computed(cut)), _set(cut.flag)]
            case "keep":
                return [self._computed(cut), _set(cut.flag)]
        return [self._computed(cut)]

    def _computed(self, cut: Cut) -> n.Stmt:
        value = self._values[cut.expr]
        given = self._given.get(cut.expr)
        if given is not None:  # a fetch that was made ahead, in whole or in part
            value = remaining_part(value, given.form, given.variable)
        value = hoisted_part(value, cut.form)
        return assigned(cut.variable, value, value.span)

    def _unless_reused(self, stmt: n.Stmt) -> n.Stmt:
        reuse = n.Name(NOWHERE, self._prefix + "reuse")
        return n.If(NOWHERE, n.Unary(NOWHERE, "!", reuse), n.Block(NOWHERE, (stmt,)), None)


def _block(new: n.Stmt, old: n.Stmt) -> n.Block:
    """What stands under a conditional, as a block in the place of what stood there."""
    return n.Block(old.span, block_of(new).body)


def _operands_first(items: list[_Moved]) -> list[_Moved]:
    """What stands inside of another comes before it."""

    def depth(move: _Moved) -> int:
        return sum(_holds(other.expr, move.expr) for other in items)

    return sorted(items, key=depth, reverse=True) if len(items) > 1 else items


def _set(flag: str) -> n.Stmt:
    return assigned(flag, n.Literal(NOWHERE, "true"))


def _holds(root: n.Node, expr: n.Expr) -> bool:
    return any(part is expr for part in walk(root))
