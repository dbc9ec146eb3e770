"""What a pass has beside the user's code: the chosen files, filled in for the payloads, and a
``main``."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.fill import Filler
from shadercache.caching.layout import structs_in
from shadercache.caching.payload_text import payload_text
from shadercache.caching.per_target import PerTarget
from shadercache.caching.read_template import FOLDER, Template, parse_template, read_template
from shadercache.caching.slots import NUMBERS, Choice
from shadercache.transform.reachable import declared_names, names_in

D = TypeVar("D", bound=n.Decl)


@lru_cache(maxsize=512)  # each struct of each shader is a type of its own
def program_part(main: Path, choice: Choice) -> Template:
    """The declarations of a pass with the ``main`` of a file, callees first, and their comments."""
    template = read_template(main, choice.prefix)
    # Only what was looked up can come from a part of a filter, and be marked.
    library = _library(choice, f"{choice.prefix}look_up" in _called(template.decls))
    decls = [filled for decl in template.decls for filled in library.filled(decl)]
    functions = library.with_callees(d for d in decls if isinstance(d, n.FunctionDef))
    named = set[str]().union(*map(names_in, functions))
    variables = [
        decl
        for decl in (*library.variables, *(d for d in decls if isinstance(d, n.VarDecl)))
        if not decl.qualifiers.has("uniform", "in", "const")
        or not named.isdisjoint(declared_names(decl))
    ]
    every: tuple[n.Decl, ...] = (*sorted(variables, key=_rank), *functions)
    return Template(every, _comments(every, (*library.comments, *template.comments)))


@lru_cache(maxsize=512)
def _library(choice: Choice, looks: bool) -> _Library:
    names = (*choice.files, choice.marking(looks))
    files = [read_template(FOLDER / f"{name}.glsl", choice.prefix) for name in names]
    text = payload_text(choice.layout, choice.prefix, choice.whole, choice.depths)
    files.append(parse_template(text, choice.prefix, tuple(structs_in(choice.layout.types))))
    return _Library(files, choice)


class _Library:
    """The functions and variables that the passes of a choice may have; those that they have are
    filled in when they are asked for."""

    def __init__(self, files: Sequence[Template], choice: Choice) -> None:
        decls = [decl for file in files for decl in file.decls]
        self._filler = Filler(decls, NUMBERS, choice.prefix)
        kept = [decl for decl in decls if not self._filler.stands_for(decl)]
        self._targets = PerTarget(kept, choice.layout, self._filler, choice.prefix)
        self._known = {decl.name: decl for decl in kept if isinstance(decl, n.FunctionDef)}
        self._filled: dict[str, n.FunctionDef] = {}
        variables = (decl for decl in kept if isinstance(decl, n.VarDecl))
        self.variables = [one for decl in variables for one in self.filled(decl)]
        self.comments = [comment for file in files for comment in file.comments]

    def filled(self, decl: D) -> list[D]:
        """A declaration, filled in: of a variable, for each texture."""
        return self._targets(self._filler.rewrite(decl))

    def with_callees(self, functions: Iterable[n.FunctionDef]) -> list[n.FunctionDef]:
        """Functions with all that they call, each behind those that it calls itself."""
        ordered: dict[str, n.FunctionDef] = {}

        def add(function: n.FunctionDef) -> None:
            for name in _called([function]):
                if name in self._known and name not in ordered:
                    if name not in self._filled:
                        (self._filled[name],) = self.filled(self._known[name])
                    add(self._filled[name])
            ordered[function.name] = function

        for function in functions:
            add(function)
        return list(ordered.values())


def _rank(decl: n.VarDecl) -> int:
    """Constants stand first, for the others use them; then what comes from outside."""
    kinds = ("const", "uniform", "in", "out")
    return next((at for at, kind in enumerate(kinds) if decl.qualifiers.has(kind)), len(kinds))


def _called(decls: Iterable[n.Decl]) -> dict[str, None]:
    """The functions that are called, in order."""
    return {node.name: None for d in decls for node in walk(d) if isinstance(node, n.Call)}


def _comments(decls: Iterable[n.Decl], comments: Iterable[n.Comment]) -> tuple[n.Comment, ...]:
    """Those of the comments that belong to something in the declarations."""
    places = {
        place
        for decl in decls
        for node in walk(decl)
        # Comments ahead of a closing brace are anchored to the brace itself.
        for place in (node.span.start, node.span.end, node.span.end - 1)
    }
    return tuple(comment for comment in comments if comment.anchor in places)
