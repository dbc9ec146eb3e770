"""Calls: which function a call means (GLSL 3.30 section 6.1, 4.00 section 6.1)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from shadercache.ast.nodes import Call
from shadercache.lang.builtins import Signature, nonuniform
from shadercache.lang.types import Type
from shadercache.lang.words import NONUNIFORM
from shadercache.sema.conversions import Conversions
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import FunctionSet, Overload

_SHOWN = 8

Candidate: TypeAlias = Overload | Signature


class CallChecker:
    """Resolves calls; what was found for a name and argument types is remembered."""

    def __init__(self, context: InferenceContext) -> None:
        self._context = context
        self._visible, self._mark = context.scopes.visible, context.scopes.function_mark
        self._resolved: dict[tuple[str, tuple[Type, ...]], tuple[int, Candidate]] = {}

    def check(self, node: Call, *args: Type) -> Type:
        """Resolve a call whose arguments have these types; the type of its result."""
        entry = self._visible.get(node.name + self._mark)
        own = entry if isinstance(entry, FunctionSet) else None
        if entry is not None and own is None:
            what = "a type" if isinstance(entry, Type) else "a variable"
            message = f"'{node.name}' is {what}, not a function"
            return self._context.problems.error("SC204", message, node)
        # More overloads may have been declared since the same call was resolved last.
        count = len(own) if own else 0
        key = (node.name, args)
        known_count, callee = self._resolved.get(key, (-1, None))
        if known_count != count:
            callee = self._resolve(node, own or {}, args)
        if callee is None:
            return ERROR
        self._resolved[key] = (count, callee)
        context = self._context
        context.tables.calls[node] = callee
        if context.function is not None:
            context.tables.called[context.function].append(node)
        if isinstance(callee, Signature) and callee.foldable:
            context.constants.call(node, callee)
        return callee.result

    def _resolve(
        self, node: Call, own: Mapping[tuple[Type, ...], Overload], args: tuple[Type, ...]
    ) -> Candidate | None:
        """The function that is called; ``None`` once a diagnostic or an earlier one says why."""
        builtin = self._context.language.builtin_functions(node.name)
        if not own and not builtin:
            known = self._context.known_functions
            self._context.problems.undeclared("function", node.name, node, known)
            return None
        # An unknown function is told all the same; which overload is meant nobody can say.
        if ERROR in args:
            return None
        if node.name == NONUNIFORM and builtin and len(args) == 1:
            return nonuniform(args[0])
        # The shader's own functions hide the built-in ones of that name (section 6.1), but some
        # compilers still find a built-in overload that fits exactly.
        exact = own.get(args) or _exact_match(builtin, args)
        if exact is not None:
            if own and isinstance(exact, Signature):
                message = f"'{exact}' is hidden by the shader's own '{node.name}' on some drivers"
                self._context.problems.warn("SC290", message, node)
            return exact
        # Functions of the user hide the built-in ones.
        candidates: list[Candidate] = [*own.values()] if own else [*builtin]
        best = _convertible(candidates, args, self._context.language.conversions)
        if len(best) == 1:
            return best[0]
        self._complain(node, args, candidates, best)
        return None

    def _complain(
        self, node: Call, args: tuple[Type, ...], candidates: list[Candidate], best: list[Candidate]
    ) -> None:
        call = f"{node.name}({', '.join(map(str, args))})"
        counts = sorted({len(parameters(candidate)) for candidate in candidates})
        same = [one for one in candidates if len(parameters(one)) == len(args)]
        if best:
            code, message, shown = "SC208", f"the call {call} is ambiguous", best
        elif not same:
            takes = " or ".join(map(str, counts))
            message = f"'{node.name}' takes {takes} arguments, not {len(args)}"
            code, shown = "SC207", candidates
        else:
            code, message, shown = "SC206", f"no function fits the call {call}", same
        self._context.problems.error(code, message, node, _listed(shown))


def _listed(candidates: Sequence[Candidate]) -> str:
    """``candidates: float f(int), float f(vec2)``; long lists are cut."""
    shown = [_described(candidate) for candidate in candidates[:_SHOWN]]
    more = len(candidates) - len(shown)
    return f"candidates: {', '.join(shown)}" + (f" and {more} more" if more else "")


def _described(candidate: Candidate) -> str:
    if isinstance(candidate, Signature):
        return str(candidate)
    params = [f"{way} {kind}".removeprefix("in ") for kind, way in parameters(candidate)]
    return f"{candidate.result} {candidate.proto.name}({', '.join(params)})"


def parameters(candidate: Candidate) -> tuple[tuple[Type, str], ...]:
    """Types and directions of the parameters."""
    if isinstance(candidate, Signature):
        return tuple((param.type, param.direction) for param in candidate.params)
    return tuple(zip(candidate.params, candidate.directions, strict=True))


def _exact_match(candidates: Sequence[Signature], args: tuple[Type, ...]) -> Signature | None:
    """The built-in overload whose parameters have exactly these types."""
    for candidate in candidates:
        if tuple([param.type for param in candidate.params]) == args:
            return candidate
    return None


def _convertible(
    candidates: Sequence[Candidate], args: tuple[Type, ...], conversions: Conversions
) -> list[Candidate]:
    """The best of the overloads that the arguments convert to; several: the call is ambiguous."""
    viable = [one for one in candidates if _accepts(one, args, conversions)]
    # Before 4.00 no conversion is better than another.
    if len(viable) < 2 or not conversions.ranked:
        return viable
    for one in viable:
        if all(other is one or _better(one, other, args, conversions) for other in viable):
            return [one]
    return viable


def _accepts(candidate: Candidate, args: tuple[Type, ...], conversions: Conversions) -> bool:
    params = parameters(candidate)
    if len(params) != len(args):
        return False
    for arg, (kind, direction) in zip(args, params, strict=True):
        # Values go in by conversion to the parameter, and come out by conversion from it.
        # So an `inout` argument has exactly the type of its parameter (section 6.1.1).
        if direction != "out" and not conversions.converts(arg, kind):
            return False
        if direction != "in" and not conversions.converts(kind, arg):
            return False
    return True


def _better(
    one: Candidate, two: Candidate, args: tuple[Type, ...], conversions: Conversions
) -> bool:
    """Is some conversion to ``one`` better, and none worse?"""
    ranks = [
        (conversions.rank(arg, first), conversions.rank(arg, second))
        for arg, (first, _), (second, _) in zip(args, parameters(one), parameters(two), strict=True)
    ]
    return all(a <= b for a, b in ranks) and any(a < b for a, b in ranks)
