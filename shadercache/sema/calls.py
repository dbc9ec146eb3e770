"""Calls: which function a call means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from shadercache.ast.nodes import Call
from shadercache.lang.builtins import Signature
from shadercache.lang.types import Type
from shadercache.sema.constants import Constants
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.overloads import Candidate, convertible, exact_match, parameters
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import FunctionSet, Overload

_SHOWN = 8


class CallChecker:
    """Resolves calls; what was found for a name and argument types is remembered."""

    def __init__(self, context: InferenceContext, constants: Constants) -> None:
        self._context = context
        self._constants = constants
        self._visible, self._mark = context.scopes.visible, context.scopes.function_mark
        self._resolved: dict[tuple[str, tuple[Type, ...]], tuple[int, Candidate]] = {}

    def check(self, node: Call) -> Type:
        """Resolve a call whose arguments are typed; the type of its result."""
        types = self._context.tables.types
        args = tuple([types[arg] for arg in node.args])
        entry = self._visible.get(node.name + self._mark)
        own = entry if isinstance(entry, FunctionSet) else None
        if entry is not None and own is None:
            what = "a type" if isinstance(entry, Type) else "a variable"
            return self._context.problems.error(
                "SC204", f"'{node.name}' is {what}, not a function", node
            )
        # More overloads may have been declared since the same call was resolved last.
        count = len(own.overloads) if own else 0
        key = (node.name, args)
        known = self._resolved.get(key)
        if known is None or known[0] != count:
            found = self._resolve(node, own.overloads if own else {}, args)
            if found is None:
                return ERROR
            known = self._resolved[key] = (count, found)
        return self._use(node, known[1])

    def _use(self, node: Call, found: Candidate) -> Type:
        context = self._context
        context.tables.calls[node] = found
        if context.function is not None:
            context.tables.called[context.function].append(node)
        if isinstance(found, Signature) and found.foldable:
            self._constants.call(node, found, node.args)
        return found.result

    def _resolve(
        self, node: Call, own: Mapping[tuple[Type, ...], Overload], args: tuple[Type, ...]
    ) -> Candidate | None:
        """The function that is called; ``None`` once a diagnostic or an earlier one says why."""
        builtin = self._context.language.builtin_functions(node.name)
        if not own and not builtin:
            known = self._context.known_functions
            self._context.problems.undeclared("function", node.name, node, known)
            return None
        if ERROR in args:
            return None
        exact = own.get(args) or exact_match(builtin, args)
        if exact is not None:
            if own and isinstance(exact, Signature):
                self._warn_hidden(node, exact)
            return exact
        # Functions of the user hide the built-in ones.
        candidates: list[Candidate] = [*own.values()] if own else [*builtin]
        best = convertible(candidates, args, self._context.language.conversions)
        if len(best) == 1:
            return best[0]
        self._complain(node, args, candidates, best)
        return None

    def _warn_hidden(self, node: Call, found: Signature) -> None:
        message = f"'{found}' is hidden by the shader's own '{node.name}' on some drivers"
        self._context.problems.warn("SC290", message, node)

    def _complain(
        self, node: Call, args: tuple[Type, ...], candidates: list[Candidate], best: list[Candidate]
    ) -> None:
        call = f"{node.name}({', '.join(map(str, args))})"
        if best:
            message = f"the call {call} is ambiguous"
            self._context.problems.error("SC208", message, node, _listed(best))
            return
        counts = sorted({len(parameters(item)) for item in candidates})
        if len(args) not in counts:
            takes = " or ".join(map(str, counts))
            message = f"'{node.name}' takes {takes} arguments, not {len(args)}"
            self._context.problems.error("SC207", message, node, _listed(candidates))
            return
        message = f"no function fits the call {call}"
        same = [item for item in candidates if len(parameters(item)) == len(args)]
        self._context.problems.error("SC206", message, node, _listed(same))


def _listed(candidates: Sequence[Candidate]) -> str:
    """``candidates: float f(int), float f(vec2)``; long lists are cut."""
    shown = [_described(item) for item in candidates[:_SHOWN]]
    more = len(candidates) - len(shown)
    return f"candidates: {', '.join(shown)}" + (f" and {more} more" if more else "")


def _described(candidate: Candidate) -> str:
    if isinstance(candidate, Signature):
        return str(candidate)
    params = [f"{way} {kind}".removeprefix("in ") for kind, way in parameters(candidate)]
    return f"{candidate.result} {candidate.proto.name}({', '.join(params)})"
