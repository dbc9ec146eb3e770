"""Why a value may not be cached: the codes, and the sentence for each."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


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
    def sentence(self) -> str:
        """The reason as a sentence without its subject, with the culprit."""
        return self.code.sentence + (f" ({self.detail})" if self.detail else "")
