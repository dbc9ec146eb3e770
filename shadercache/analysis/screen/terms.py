"""What a vertex shader writes into its variables, as terms over its inputs.

``main`` is gone through once, calls and all, with a term for what each variable holds::

    vec4 at = u_model * vec4(a_position, 1.0);
    gl_Position = u_vp * at;                    // product(u_vp, u_model, vec4(a_position, 1.0))
    v_at = at.xyz;                              // swizzle xyz (product(u_model, ...))

Terms that are built alike are the same object, so they can be compared by identity. Products of
matrices are flat, for they are associative. Where ways meet, a term holds those of all ways; what
a loop leaves holds what it may have been made of.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeAlias

from shadercache.lang.types import Type

Where: TypeAlias = int | str | tuple[int, ...]
"""A part of a value: the element of an array, the field of a struct, components of a vector."""


@dataclass(frozen=True, slots=True, eq=False)
class Term:
    """``op`` applied to terms.

    ``leaf`` (``data``: a name), ``literal``, ``product`` (of matrices, with a vector at one end),
    ``swizzle`` (``data``: indices of components), ``insert`` (into the first term the second one;
    ``data``: where), ``join`` (of several ways; what decides between them comes last in
    ``decides``), ``construct``, ``call`` and operators. ``moves``: does it depend on a uniform?
    ``constant``: is it made of literals only?
    """

    op: str
    data: object
    args: tuple[Term, ...]
    type: Type | None
    moves: bool
    constant: bool
    decides: tuple[Term, ...] = ()

    @property
    def width(self) -> int:
        """Its number of components; 0 for what is no scalar or vector."""
        kind = self.type
        return kind.rows if kind is not None and (kind.is_scalar or kind.is_vector) else 0


class Terms:
    """Makes terms, each once."""

    def __init__(self) -> None:
        self._known: dict[object, Term] = {}
        self._opaque = 0

    def leaf(self, name: str, kind: Type | None, moves: bool) -> Term:
        """An input, or something else that nothing is known of."""
        return self._known.setdefault((name, kind), Term("leaf", name, (), kind, moves, False))

    def make(
        self,
        op: str,
        data: object,
        args: Iterable[Term],
        kind: Type | None,
        decides: tuple[Term, ...] = (),
    ) -> Term:
        """A term of an operator or of a function, or a literal."""
        args = tuple(args)
        # Equal terms are one object already, so a key is as long as the term has operands.
        key = (op, data, args, kind, decides)
        term = self._known.get(key)
        if term is None:
            parts = (*args, *decides)
            moves = any(part.moves for part in parts)
            constant = op == "literal" or (bool(parts) and all(part.constant for part in parts))
            term = self._known[key] = Term(op, data, args, kind, moves, constant, decides)
        return term

    def unknown(self, parts: Iterable[Term], kind: Type | None) -> Term:
        """Something that is made of ``parts``, like nothing else."""
        self._opaque += 1
        return self.make("unknown", self._opaque, dict.fromkeys(parts), kind)

    def multiply(self, one: Term, other: Term, kind: Type) -> Term:
        """``one * other``, where at least one of the two is a matrix and none a scalar."""
        parts = [term.args if term.op == "product" else (term,) for term in (one, other)]
        return self.make("product", None, parts[0] + parts[1], kind)

    def join(self, ways: Iterable[Term], decides: Iterable[Term] = ()) -> Term:
        """What a variable holds where ways meet."""
        different = tuple(dict.fromkeys(ways))
        if len(different) == 1:
            return different[0]
        controls = tuple(dict.fromkeys(decides))
        return self.make("join", None, different, different[0].type, controls)

    def _swizzle(self, of: Term, places: tuple[int, ...], kind: Type | None) -> Term:
        """Components of a vector."""
        while places != tuple(range(of.width)):
            if of.op == "swizzle":
                assert isinstance(of.data, tuple)
                places, of = tuple(of.data[place] for place in places), of.args[0]
                continue
            if of.op != "insert" or not isinstance(of.data, tuple):
                return self.make("swizzle", places, (of,), kind)
            inside = [place for place in places if place in of.data]
            # Neither the old vector nor what was put into it holds all of these components.
            if inside and len(inside) < len(places):
                return self.make("swizzle", places, (of,), kind)
            if inside:
                places = tuple(of.data.index(place) for place in places)
            of = of.args[1] if inside else of.args[0]
        return of

    def insert(self, into: Term, where: Where, value: Term) -> Term:
        """A vector, a struct or an array with one part of it replaced."""
        # Where all components are written the old value is gone: v.yx = w leaves w.yx.
        if isinstance(where, tuple) and sorted(where) == list(range(into.width)):
            places = tuple(where.index(place) for place in range(into.width))
            return self._swizzle(value, places, into.type)
        return self.make("insert", where, (into, value), into.type)

    def part(self, of: Term, where: Where, kind: Type | None) -> Term:
        """Components of a vector, a field of a struct, an element of an array."""
        if isinstance(where, tuple):
            return self._swizzle(of, where, kind)
        while of.op == "insert" and not isinstance(of.data, tuple):
            if of.data == where:
                return of.args[1]
            if not isinstance(where, str) and {type(where), type(of.data)} != {int}:
                break
            of = of.args[0]
        if of.op == "struct" and isinstance(where, str):
            assert isinstance(of.data, tuple)
            return of.args[of.data.index(where)]
        return self.make("part", where, (of,), kind)
