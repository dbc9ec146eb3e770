"""Which varyings carry the place on the screen: by what the vertex shader writes into them.

A value of the screen is the position itself, read back or computed in the same way, what is
multiplied by the same projection, and whatever is made of their first two components::

    gl_Position = u_vp * world;
    v_clip = gl_Position;                       // the screen, in x and y
    v_uv = (u_vp * world).xy / gl_Position.w;   // the screen
    v_depth = gl_Position.w;                    // not: how far it is from the eye
    v_world = world.xyz;                        // not
    v_shadow = u_light_vp * world;              // not: another projection

So is nothing of a position that no uniform moves: it is the same place in every frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from shadercache.analysis.dataflow import reached
from shadercache.analysis.screen.symbolic import Evaluator, TooLongError
from shadercache.analysis.screen.terms import Term
from shadercache.analysis.stages import Key
from shadercache.analysis.vertex_inputs import POSITION
from shadercache.ast import nodes as n
from shadercache.sema.facts import Facts

Components = frozenset[int | str]
"""Components of a vector, elements of an array, fields of a struct; ``*`` for all of them."""

WHOLE: Components = frozenset("*")
_NONE: Components = frozenset()
_SCREEN = frozenset((0, 1))

_BY_COMPONENT = frozenset(
    (
        *("+", "-", "*", "/", "Unary"),
        *("abs", "sign", "floor", "ceil", "fract", "trunc", "round", "mod", "min", "max", "clamp"),
        *("mix", "step", "smoothstep", "pow", "exp", "log", "sqrt", "sin", "cos", "fma"),
    )
)
"""Operators and functions of which a component depends on that component of the arguments."""


@dataclass(frozen=True, slots=True)
class ScreenVaryings:
    """``moves``: is the position another one when uniforms change? ``components``: of the outputs
    that carry the place on the screen; keys are a variable, or a block's name and a member.
    ``projection``: the uniforms that positions are multiplied by last."""

    moves: bool = True
    components: Mapping[Key, Components] = field(default_factory=dict)
    projection: frozenset[str] = frozenset()


def screen_varyings(module: n.Module, facts: Facts) -> ScreenVaryings:
    """What a vertex shader with unique names passes on of its position."""
    evaluator = Evaluator(module, facts)
    try:
        evaluator.run()
    except TooLongError:
        # Nothing is refused on suspicion: what was not followed counts as not of the screen.
        return ScreenVaryings()
    position = evaluator.env.get(POSITION)
    if position is None or not position.moves:
        return ScreenVaryings(False)
    screen = _Screen(position)
    outputs = ((key, screen.of(term)) for key, term in _outputs(module, evaluator))
    bound = {key: components for key, components in outputs if components}
    return ScreenVaryings(True, bound, screen.projection)


def _outputs(module: n.Module, evaluator: Evaluator) -> Iterator[tuple[Key, Term]]:
    env, terms = evaluator.env, evaluator.terms
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl | n.BlockDecl) or not decl.qualifiers.has("out"):
            continue
        owner = decl.name if isinstance(decl, n.BlockDecl) else None
        instance = decl.instance if isinstance(decl, n.BlockDecl) else None
        fields = decl.fields if isinstance(decl, n.BlockDecl) else (decl,)
        for name in (variable.name for part in fields for variable in part.declarators):
            if instance is None and name in env:
                yield (owner, name), env[name]
            elif instance in env:
                yield (owner, name), terms.part(env[instance], name, None)


class _Screen:
    """What is made of a position."""

    def __init__(self, position: Term) -> None:
        self._positions: set[Term] = set()
        self._projections: set[tuple[Term, bool]] = set()
        self._known: dict[Term, Components] = {}
        # The position, and what it was before something was done to it.
        for term, whole in reached([(position, True)], lambda step: self._behind(*step)):
            if term.moves and term.op != "leaf" and (whole or term.op == "product"):
                self._positions.add(term)

    @property
    def projection(self) -> frozenset[str]:
        """The uniforms that positions are multiplied by last."""
        factors = [factor for factor, _ in self._projections]
        parts = reached(factors, lambda term: term.args)
        return frozenset(str(part.data) for part in parts if part.op == "leaf" and part.moves)

    def _behind(self, term: Term, whole: bool) -> Iterator[tuple[Term, bool]]:
        """Terms that are a position if ``term`` is one (``whole``), or gives one its x and y."""
        match term.op:
            case "product":
                self._projections.update(_projection(term))
            case "join":
                yield from ((way, whole) for way in term.args)
            case "insert" if whole:
                # gl_Position.z -= 0.001 leaves a position; only x and y that are put in make one.
                yield term.args[0], True
                if isinstance(term.data, tuple) and _SCREEN.intersection(term.data):
                    yield term.args[1], False
            case "+" | "-":
                yield from ((part, False) for part in term.args)
            # A constant scales what is on the screen; a uniform may be what brings it there.
            case "*" if any(part.constant for part in term.args):
                yield from ((part, False) for part in term.args)
            case "/":
                yield term.args[0], False
            case "swizzle":
                assert isinstance(term.data, tuple)
                # clip.xyww, as of a sky on the far plane, is where clip is.
                if _SCREEN.issuperset(term.data[:2]):
                    yield term.args[0], False
            case "construct":
                yield from ((part, False) for part in self._constructed(term))

    def _constructed(self, term: Term) -> Iterator[Term]:
        """``vec4(clip.xy, z, clip.w)`` is a position, and so is ``vec4(screen, z, 1.0)``; in
        ``vec4(eye.xy * scale, z, -eye.z)`` it is the product."""
        last = term.args[-1]
        if last.op == "swizzle" and isinstance(last.data, tuple) and last.data[-1] == 3:
            yield last.args[0]
            return
        # What gives x and y: one vector, or two scalars.
        for arg in term.args[: 1 if term.args[0].width > 1 else 2]:
            if last.op == "literal" and last.data == 1.0:
                yield arg
            if arg.moves and arg.op in ("+", "-", "*", "/"):
                self._positions.add(arg)

    def of(self, term: Term) -> Components:
        """Which components of a term depend on where on the screen the position is."""
        # With a stack, for terms are as deep as chains of statements are long.
        todo = [term]
        while todo:
            subterm = todo[-1]
            if subterm not in self._known and self._is_position(subterm):
                # The screen has two components, whatever else the position has.
                limited = frozenset(_SCREEN & set(range(subterm.width))) if subterm.width else WHOLE
                self._known[subterm] = limited
            elif subterm not in self._known:
                below = (*subterm.args, *subterm.decides)
                missing = [part for part in below if part not in self._known]
                if missing:
                    todo += missing
                    continue
                self._known[subterm] = self._components(subterm)
            todo.pop()
        return self._known[term]

    def _is_position(self, term: Term) -> bool:
        if term in self._positions:
            return True
        return term.op == "product" and not self._projections.isdisjoint(_projection(term))

    def _components(self, term: Term) -> Components:
        parts = [self._known[part] for part in term.args]
        # Which way was taken depends on the screen, so whatever the ways hold does.
        if any(self._known[part] for part in term.decides):
            return WHOLE
        if not any(parts):
            return _NONE
        match term.op:
            case "join":
                return _NONE.union(*parts)
            case "swizzle":
                assert isinstance(term.data, tuple)
                return frozenset(at for at, of in enumerate(term.data) if touches(parts[0], of))
            case "part":
                return WHOLE if touches(parts[0], term.data) else _NONE
            case "insert":
                return _inserted(term.data, *parts)
            case "struct":
                assert isinstance(term.data, tuple)
                return frozenset(name for name, part in zip(term.data, parts, strict=True) if part)
            case "construct" if term.type is not None and term.type.is_array:
                return frozenset(at for at, part in enumerate(parts) if part)
            case "construct" if _is_joined(term):
                return frozenset(_placed(term, parts))
        if term.op in _BY_COMPONENT or (term.op == "call" and term.data in _BY_COMPONENT):
            return _by_component(term, parts)
        return WHOLE


def touches(components: Components, part: object) -> bool:
    """Is a part of a vector, an array or a struct among them?"""
    return part in components or components.issuperset(WHOLE)


def _inserted(where: object, into: Components, value: Components) -> Components:
    if isinstance(where, tuple):
        put = frozenset(of for at, of in enumerate(where) if touches(value, at))
        return (into - frozenset(where)) | put
    assert isinstance(where, int | str)
    return (into | {where}) if value else (into - {where})


def _by_component(term: Term, parts: list[Components]) -> Components:
    components = _NONE
    for arg, part in zip(term.args, parts, strict=True):
        # A scalar goes into every component.
        if part and arg.width != term.width:
            return WHOLE
        components |= part
    return components


def _is_joined(term: Term) -> bool:
    """Are the components of a vector those of its arguments, one behind the other?"""
    widths = [arg.width for arg in term.args]
    return term.width > 0 and all(widths) and (len(widths) > 1 or widths[0] >= term.width)


def _placed(term: Term, parts: list[Components]) -> Iterator[int]:
    at = 0
    for arg, part in zip(term.args, parts, strict=True):
        yield from (at + of for of in range(arg.width) if touches(part, of))
        at += arg.width


def _projection(product: Term) -> Iterator[tuple[Term, bool]]:
    """What a product multiplies its position by last, and from which side."""
    # Columns are multiplied from the left (M * v), rows from the right (v * M).
    for *factors, vector in (product.args, product.args[::-1]):
        if vector.type is not None and vector.type.is_vector and not _is_direction(vector):
            # Constant factors before the first that a uniform moves turn axes or mirror.
            moving = next((factor for factor in factors if factor.moves), None)
            if moving is not None:
                yield moving, vector is product.args[-1]
            return


def _is_direction(vector: Term) -> bool:
    """Is its last component 0, so that it has no place?"""
    last = vector.args[-1] if vector.op == "construct" else vector
    return vector.width == 4 and last.op == "literal" and last.data == 0.0
