"""Why a value may not be cached: the codes with a sentence for each, and the rules in the order in
which they are reported."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, TypeAlias

from shadercache.analysis.call_paths import Instance, Place, Use
from shadercache.analysis.costs.cost import FETCH
from shadercache.analysis.derivative_uses import Dependents, SharedUses
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.slices import Slice, SliceTable
from shadercache.ast import nodes as n
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts

FIRST_TEXEL, SECOND_TEXEL = 3, 4
"""Channels for the payload in the two texels that a cache can have; the eighth holds the depth."""

AT_REST = frozenset(("gl_FragCoord", "gl_FrontFacing", "gl_PrimitiveID"))
"""Built-in inputs that the same pixel has again where nothing moves. (Not those of points, samples,
layers and viewports, of which a cache knows nothing.)"""

STORABLE = frozenset[str | None](
    (
        *("float", "int", "uint", "bool"),
        *("float16_t", "int16_t", "uint16_t", "int8_t", "uint8_t"),
    )
)
"""Scalar types that a channel of 32 bits can hold."""


class Code(Enum):
    """Refusal codes. The value is the diagnostic's code and the sentence that is shown."""

    LOOP = ("SC301", "is computed inside a loop, so it has many values in one fragment")
    CONSTANT = ("SC302", "is a constant; the driver folds it")
    UNIFORM = ("SC303", "depends on uniforms only; compute it once on the CPU")
    SIDE_EFFECT = ("SC304", "has a side effect, which a hit would skip")
    OPAQUE = ("SC305", "has no value that could be stored (a sampler or void)")
    WIDE = ("SC306", "is wider than the seven channels that two cache texels have for it")
    LVALUE = ("SC307", "is the place that an assignment writes to, not a value")
    CHEAP = ("SC308", "costs less than the cache fetch that would replace it")
    CONDITIONAL = ("SC309", "is evaluated only under a condition inside its statement")
    MUTABLE_GLOBAL = ("SC311", "reads a global variable that the shader changes")
    DERIVATIVE = ("SC312", "contains or depends on a screen-space derivative")
    SCREEN = ("SC313", "depends on where the fragment is on the screen, not only on the surface")
    ORDER = ("SC314", "stands in a statement with side effects, out of which nothing may be moved")
    FEEDS_DERIVATIVE = (
        "SC315",
        "decides a derivative or a texture's level of detail later in the shader; neighbouring "
        "fragments may hold reused values, so that would be wrong",
    )
    FEEDS_CUBE = (
        "SC319",
        "decides where a cube map is looked up later in the shader; a driver may round that "
        "look-up together with neighbouring fragments, which may hold reused values",
    )
    DISCARDS = ("SC316", "decides whether the fragment is discarded, which a reused value must not")
    UNSTORABLE = (
        "SC317",
        "is of a type that cannot be stored: numbers of 64 bits, or a struct that is not declared "
        "by name outside of functions",
    )
    INITIALISER = ("SC318", "is evaluated before main, in the initialiser of a global")

    @property
    def code(self) -> str:
        """The diagnostic code, ``SC3nn``."""
        return self.value[0]

    @property
    def sentence(self) -> str:
        """The reason as a sentence without its subject."""
        return self.value[1]


@dataclass(frozen=True, slots=True)
class Refusal:
    """A refused node's reason. ``detail`` names the culprit where there is one."""

    code: Code
    detail: str = ""

    @property
    def unprofitable(self) -> bool:
        """Would caching be right, only not worth it? Such a node is rewritten on request."""
        return self.code is Code.CHEAP

    @property
    def approximable(self) -> bool:
        """Would it be right at rest? (What else is in the way, the option does not tell.)"""
        if self.code is Code.SCREEN:
            names = self.detail.split(", ")
            return AT_REST.issuperset(name for name in names if name.startswith("gl_"))
        return self.code is Code.DERIVATIVE

    @property
    def sentence(self) -> str:
        """The reason as a sentence without its subject, with the culprit."""
        return self.code.sentence + (f" ({self.detail})" if self.detail else "")


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What the rules know of the shader. ``mutable``, ``derivative`` and ``varying`` are leaves as
    bit sets; ``structs`` those that are declared outside of functions; ``reused`` the built-in
    inputs that do not bind a value to its place on the screen; ``approximate``: are values that are
    bound to it offered, where they are the same again at rest?"""

    facts: Facts
    table: EffectTable
    slices: SliceTable
    derivatives: SharedUses
    cubes: SharedUses
    discards: Dependents
    structs: frozenset[n.StructDef | None]
    mutable: int
    derivative: int
    varying: int
    reused: frozenset[str]
    approximate: bool = False


class Trial(NamedTuple):
    """An expression on a call path, its type, what its value depends on and what that costs."""

    evidence: Evidence
    instance: Instance
    place: Place
    type: Type
    slice: Slice
    cost: float


Rule: TypeAlias = Callable[[Trial], Refusal | None]


def refusal_of(trial: Trial) -> Refusal | None:
    """What the first rule says that has something to say."""
    for rule in RULES:
        refusal = rule(trial)
        if refusal is not None:
            return refusal
    return None


def by_place(trial: Trial) -> Refusal | None:
    """Where it stands, and whether it is a place that is written to."""
    uses = (trial.instance.use, trial.place.use)
    if Use.LOOP in uses:
        return Refusal(Code.LOOP)
    if trial.place.use is Use.LVALUE:
        return Refusal(Code.LVALUE)
    if Use.CONSTANT in uses or trial.evidence.facts.is_constant(trial.place.expr):
        return Refusal(Code.CONSTANT)
    return Refusal(Code.CONDITIONAL) if Use.CONDITIONAL in uses else None


def by_type(trial: Trial) -> Refusal | None:
    """Whether texels can hold it."""
    kind = trial.type
    if kind.is_void or kind.holds_opaque:
        return Refusal(Code.OPAQUE, str(kind))
    if kind.components is None or kind.components > FIRST_TEXEL + SECOND_TEXEL:
        return Refusal(Code.WIDE, str(kind))
    spelled = not isinstance(trial.place.expr, n.InitList)  # Else its type has no name of its own.
    if not (spelled and kind.bases <= STORABLE and _is_declared_outside(kind, trial.evidence)):
        return Refusal(Code.UNSTORABLE, str(kind))
    return None


def _is_declared_outside(kind: Type, evidence: Evidence) -> bool:
    """Can a global variable of the type be declared?"""
    if kind.struct is None:
        return True
    # The payload is a global of ours, and its declaration has to name the type.
    if not kind.struct.name or evidence.facts.structs.get(kind.struct) not in evidence.structs:
        return False
    return all(_is_declared_outside(field, evidence) for field in kind.struct.fields.values())


def by_effects(trial: Trial) -> Refusal | None:
    """What it does beside having a value, and what its statement does."""
    effects = trial.evidence.table.of(trial.place.expr)
    if effects.writes:
        return Refusal(Code.SIDE_EFFECT, "writes " + ", ".join(sorted(effects.writes)))
    if effects.does & Does.DISCARD:
        return Refusal(Code.SIDE_EFFECT, "discards the fragment")
    if trial.instance.order_matters or trial.place.order_matters:
        return Refusal(Code.ORDER)
    return None


def by_inputs(trial: Trial) -> Refusal | None:
    """What it depends on."""
    evidence, leaves = trial.evidence, trial.slice.leaves
    names = evidence.slices.leaves.names
    if leaves & evidence.mutable:
        return Refusal(Code.MUTABLE_GLOBAL, ", ".join(sorted(names(leaves & evidence.mutable))))
    if leaves & evidence.derivative and not evidence.approximate:
        return Refusal(Code.DERIVATIVE)
    screen = bound_to_screen(evidence, leaves)
    if evidence.approximate:
        screen = frozenset(name for name in screen - AT_REST if not name.startswith("%"))
    if screen:
        told = sorted(name.removeprefix("%") for name in screen)
        return Refusal(Code.SCREEN, ", ".join(told))
    if not leaves and not evidence.table.of(trial.place.expr).does:
        return Refusal(Code.CONSTANT)
    if not leaves & evidence.varying:
        return Refusal(Code.UNIFORM, ", ".join(sorted(names(leaves))))
    return None


def bound_to_screen(evidence: Evidence, leaves: int) -> frozenset[str]:
    """The inputs and marks that bind a value to its place on the screen, derivatives among them."""
    names = evidence.slices.leaves.names(leaves)
    return frozenset(name for name in names if name.startswith(("gl_", "%"))) - evidence.reused


def by_use(trial: Trial) -> Refusal | None:
    """What it decides later on."""
    at = trial.instance, trial.place
    if trial.evidence.derivatives.fed_by(*at):
        return Refusal(Code.FEEDS_DERIVATIVE)
    if trial.evidence.cubes.fed_by(*at):
        return Refusal(Code.FEEDS_CUBE)
    return Refusal(Code.DISCARDS) if trial.evidence.discards.fed_by(*at) else None


def by_cost(trial: Trial) -> Refusal | None:
    """Whether the fetches that would replace it cost more."""
    fetches = 1 if trial.type.components_or_one <= FIRST_TEXEL else 2
    return Refusal(Code.CHEAP) if trial.cost < fetches * FETCH else None


# Cost comes last: what is refused for its cost alone is legal in every other respect.
RULES: tuple[Rule, ...] = (by_place, by_type, by_effects, by_inputs, by_use, by_cost)
