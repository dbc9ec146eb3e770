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

And where not every fragment comes by the expression:

* *keep*: as store, and it is noted in the cut's flag (``sc_valid``) that there is a value;
* *fill*: as keep, but a value from the cache (``sc_reuse``) is taken as it is;
* *need*: as use, but a fragment without a value from the cache is discarded;
* *lack*: as need, but it is only noted (``sc_lacks``), and what follows goes on.

``main`` is cloned like any function, so several programs' bodies can be made from one module.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import Literal, TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.source import NOWHERE
from shadercache.transform.hoist_fetches import FetchForm, hoisted_part, remaining_part
from shadercache.transform.names import FreshNames
from shadercache.transform.replace import replace_expressions

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


@dataclass(slots=True)
class _Tree:
    """The cuts sorted by call path: those in this function, and those below its calls."""

    cuts: list[Cut] = field(default_factory=list)
    below: dict[n.Call, _Tree] = field(default_factory=dict)
    has_goal: bool = False


@dataclass(frozen=True, slots=True)
class Clones:
    """The clone of ``main``, and of every function on the way, each with what it was made from."""

    entry: str
    made: tuple[tuple[n.FunctionDef, n.FunctionDef], ...]
    """Pairs (original, clone)."""


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
    maker.clone(functions["main"], _sort(cuts), entry)
    return Clones(entry, tuple(maker.made))


def insert_clones(module: n.Module, *clones: Clones) -> n.Module:
    """The module with each clone behind its original (and its prototype behind the original's)."""
    by_original: dict[str, list[n.FunctionDef]] = {}
    for group in clones:
        for original, clone in group.made:
            by_original.setdefault(original.name, []).append(clone)
    decls: list[n.Decl] = []
    for decl in module.decls:
        decls.append(decl)
        if isinstance(decl, n.FunctionDef):
            decls.extend(by_original.get(decl.name, ()))
        elif isinstance(decl, n.FunctionProto):
            decls.extend(clone.proto for clone in by_original.get(decl.name, ()))
    return replace(module, decls=tuple(decls))


def _sort(cuts: tuple[Cut, ...]) -> _Tree:
    root = _Tree()
    for cut in cuts:
        at = root
        at.has_goal = at.has_goal or cut.kind == "goal"
        for call in cut.path:
            at = at.below.setdefault(call, _Tree())
            at.has_goal = at.has_goal or cut.kind == "goal"
        at.cuts.append(cut)
    return root


class _Maker:
    """Clones functions, callees first."""

    def __init__(self, functions: dict[str, n.FunctionDef], names: FreshNames, prefix: str) -> None:
        self.functions, self.names, self.prefix = functions, names, prefix
        self.made: list[tuple[n.FunctionDef, n.FunctionDef]] = []

    def clone(
        self, function: n.FunctionDef, tree: _Tree, name: str | None = None, ends: bool = True
    ) -> str:
        """Add the clone of a function with the cuts of ``tree`` made; return its name.

        ``ends``: is a clone with goals left at the last of them?
        """
        end = _find_end(function, tree) if ends and tree.has_goal else None
        body = _CloneBody(self.prefix, end.stmt if end else None)
        for call, below in tree.below.items():
            left = end is not None and call in end.calls
            body.renamed[call] = self.clone(self.functions[call.name], below, ends=left)
            if left:
                body.moved.append(_Moved(call, None))
        for cut in tree.cuts:
            body.used[cut.expr] = cut
            if cut.kind == "use":
                body.given[cut.expr] = cut
            else:
                body.moved.append(_Moved(cut.expr, cut))
        name = name or self.names.make(self.prefix + function.name)
        proto = replace(function.proto, name=name)
        if end is not None:
            void = n.TypeSpec(NOWHERE, "void")
            proto = replace(proto, type=void, qualifiers=n.NO_QUALIFIERS)
        clone = replace(function, proto=proto, body=body.block(function.body)[0])
        self.made.append((function, clone))
        return name


@dataclass(frozen=True, slots=True)
class _End:
    """The statement of a function with the last goal, and the calls in it that lead to goals.

    A call whose value another goal of that statement needs is not among them.
    """

    stmt: n.Stmt
    calls: frozenset[n.Expr]


def _find_end(function: n.FunctionDef, tree: _Tree) -> _End:
    goals: list[n.Expr] = [cut.expr for cut in tree.cuts if cut.kind == "goal"]
    goals += [call for call, below in tree.below.items() if below.has_goal]
    stmt = next(item for item in _last_first(function.body) if any(_holds(item, g) for g in goals))
    inside = [goal for goal in goals if _holds(stmt, goal)]
    free = [g for g in inside if not any(_holds(o, g) for o in inside if o is not g)]
    return _End(stmt, frozenset(g for g in free if g in tree.below))


def _last_first(block: n.Block) -> Iterator[n.Stmt]:
    """The statements of a block and of plain blocks in it, from the last to the first."""
    for stmt in reversed(block.body):
        if isinstance(stmt, n.Block):
            yield from _last_first(stmt)
        else:
            yield stmt


@dataclass(frozen=True, slots=True)
class _Moved:
    """An expression that gets statements of its own before the one it stands in.

    Without a ``cut`` it is a call on the way to the last goals, which returns nothing any more.
    """

    expr: n.Expr
    cut: Cut | None


@dataclass(slots=True)
class _CloneBody:
    """Rewrites the statements of one function, up to the own statements of ``last``."""

    prefix: str
    last: n.Stmt | None
    renamed: dict[n.Expr, str] = field(default_factory=dict)
    used: dict[n.Expr, Cut] = field(default_factory=dict)
    given: dict[n.Expr, Cut] = field(default_factory=dict)
    moved: list[_Moved] = field(default_factory=list)

    def block(self, block: n.Block) -> tuple[n.Block, bool]:
        """The rewritten block, and whether it ends in the last goal."""
        body: list[n.Stmt] = []
        for stmt in block.body:
            if isinstance(stmt, n.Block):
                new, ended = self.block(stmt)
                body.append(new)
            else:
                ended = self.statement(stmt, body)
            if ended:
                return replace(block, body=tuple(body)), True
        return replace(block, body=tuple(body)), False

    def statement(self, stmt: n.Stmt, body: list[n.Stmt]) -> bool:
        """Append the rewritten statement; tell whether the last goal is reached with it."""
        inside = [item for item in self.moved if _holds(stmt, item.expr)]
        parts = _head(stmt)
        ahead = [item for item in inside if any(_holds(part, item.expr) for part in parts)]
        for item in _operands_first(ahead):
            body += self._own_statements(item)
        if stmt is self.last:
            return True
        deeper = len(ahead) < len(inside)
        body.append(self._control(stmt) if deeper else replace_expressions(stmt, self._rewritten))
        return False

    def _control(self, stmt: n.Stmt) -> n.Stmt:
        """A conditional under which there are expressions to move."""
        match stmt:
            case n.If():
                condition = replace_expressions(stmt.condition, self._rewritten)
                other = None if stmt.other is None else self._alone(stmt.other)
                return replace(stmt, condition=condition, then=self._alone(stmt.then), other=other)
            case n.Switch():
                selector = replace_expressions(stmt.selector, self._rewritten)
                return replace(stmt, selector=selector, body=tuple(self._list(stmt.body)))
        raise AssertionError(f"nothing is moved within {type(stmt).__name__}")

    def _alone(self, stmt: n.Stmt) -> n.Block:
        """A statement under a conditional, as a block that has room for others."""
        stmts = stmt.body if isinstance(stmt, n.Block) else (stmt,)
        return n.Block(stmt.span, tuple(self._list(stmts)))

    def _list(self, stmts: Iterable[n.Stmt]) -> list[n.Stmt]:
        body: list[n.Stmt] = []
        for stmt in stmts:
            if isinstance(stmt, n.Block):
                body.append(self._alone(stmt))
            else:
                self.statement(stmt, body)
        return body

    def _rewritten(self, original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        cut = self.used.get(original)
        if cut is not None:
            return remaining_part(rebuilt, cut.form, cut.variable)
        return self._to_clone(original, rebuilt)

    def _to_clone(self, original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        if original in self.renamed and isinstance(rebuilt, n.Call):
            return replace(rebuilt, name=self.renamed[original])
        return rebuilt

    def _own_statements(self, item: _Moved) -> list[n.Stmt]:
        """``variable = expression;`` and the like, or the call that leads to the last goals."""
        span = item.expr.span
        if item.cut is None:
            return [n.ExprStmt(span, replace_expressions(item.expr, self._rewritten))]
        match item.cut.kind:
            case "need":
                return [self._unless_reused(n.Jump(span, "discard"))]
            case "lack":
                return [self._unless_reused(_set(self.prefix + "lacks"))]
            case "fill":
                return [self._unless_reused(*self._computed(item.cut)), _set(item.cut.flag)]
            case "keep":
                return [*self._computed(item.cut), _set(item.cut.flag)]
        return self._computed(item.cut)

    def _computed(self, cut: Cut) -> list[n.Stmt]:
        value = replace_expressions(
            cut.expr,
            lambda old, new: (self._to_clone if old is cut.expr else self._rewritten)(old, new),
        )
        given = self.given.get(cut.expr)
        if given is not None:  # a fetch that was made ahead, in whole or in part
            value = remaining_part(value, given.form, given.variable)
        return [_assign(cut.variable, hoisted_part(value, cut.form))]

    def _unless_reused(self, *stmts: n.Stmt) -> n.Stmt:
        reuse = n.Name(NOWHERE, self.prefix + "reuse")
        return n.If(NOWHERE, n.Unary(NOWHERE, "!", reuse), n.Block(NOWHERE, stmts), None)


def _operands_first(items: list[_Moved]) -> list[_Moved]:
    """What stands inside of another comes before it."""

    def depth(item: _Moved) -> int:
        return sum(_holds(other.expr, item.expr) for other in items)

    return sorted(items, key=depth, reverse=True) if len(items) > 1 else items


def _set(flag: str) -> n.Stmt:
    return _assign(flag, n.Literal(NOWHERE, "true"))


def _assign(name: str, value: n.Expr) -> n.Stmt:
    span = value.span
    return n.ExprStmt(span, n.Assign(span, "=", n.Name(span, name), value))


def _holds(root: n.Node, expr: n.Expr) -> bool:
    return any(part is expr for part in walk(root))


def _head(stmt: n.Stmt) -> tuple[n.Node, ...]:
    """What of a statement is evaluated before any statement inside it."""
    match stmt:
        case n.If(condition=first) | n.Switch(selector=first):
            return (first,)
    return (stmt,)
