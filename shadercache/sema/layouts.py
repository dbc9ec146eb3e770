"""Layout qualifiers (GLSL 3.30 sections 4.3.8 and 4.3.9): values, places, overlapping locations."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from shadercache.ast.nodes import Expr, Node, Qualifiers
from shadercache.lang.types import INT, UINT, Type
from shadercache.sema.context import ERROR, Context, did_you_mean
from shadercache.sema.expressions import ExpressionChecker

# First version of a location: (stage, storage) -> version; what is missing needs 4.10.
_LOCATION_SINCE = {("vertex", "in"): 330, ("fragment", "out"): 330}
_INTERFACE_SINCE = 410
_UNIFORM_SINCE = 430
_PACKINGS = frozenset(("shared", "packed", "std140", "std430"))
_ORDERS = frozenset(("row_major", "column_major"))
_ORIGINS = frozenset(("origin_upper_left", "pixel_center_integer"))
_WORDS = frozenset(
    (
        *_PACKINGS,
        *_ORDERS,
        *_ORIGINS,
        *("location", "index", "component", "binding", "offset", "align"),
        *("depth_any", "depth_greater", "depth_less", "depth_unchanged"),
        *("early_fragment_tests", "xfb_buffer", "xfb_stride", "xfb_offset"),
    )
)
_ES_SINCE = {"uniform": 310, "interface": 310}


class LayoutChecker:
    """Checks ``layout(...)`` of declarations and remembers which locations are taken."""

    def __init__(self, context: Context, expressions: ExpressionChecker) -> None:
        self._context = context
        self._check = expressions.check
        self._values = expressions.constants.values
        self._taken: dict[tuple[str, int, int], str] = {}

    def check(
        self,
        qualifiers: Qualifiers,
        names: Sequence[str] = (),
        *,
        member: bool = False,
        default: bool = False,
    ) -> dict[str, int]:
        """The values by name; each is a constant integer, not negative.

        ``names`` are the variables that the layout is for; ``member``: of a block; ``default``: it
        is for a block or for all that follows.
        """
        values: dict[str, int] = {}
        for item in qualifiers.layout or ():
            problem = _misplaced(item.name, names, member, default)
            if problem is not None:
                hint = did_you_mean(item.name, _WORDS)
                self._context.error("SC223", problem, item, hint)
            number = None if item.value is None else self._number(item.name, item.value)
            if number is not None:
                values[item.name] = number
        return values

    def _number(self, name: str, value: Expr) -> int | None:
        kind, number = self._check(value), self._values.get(value)
        if kind is ERROR:
            return None
        if kind in (INT, UINT) and isinstance(number, int) and number >= 0:
            return number
        message = f"the layout value of '{name}' is a constant integer, not negative"
        self._context.error("SC223", message, value)
        return None

    def place(
        self, node: Node, name: str, kind: Type, storage: str, values: dict[str, int]
    ) -> None:
        """``name`` of type ``kind`` stands at the location that its layout gives."""
        if "location" not in values:
            return
        since = self._since(storage)
        if self._context.interface_version < since:
            version = f"GLSL ES {since}" if self._context.es else f"GLSL {since / 100:.2f}"
            what = "a uniform" if storage == "uniform" else f"this '{storage}' variable"
            self._context.error("SC223", f"a location of {what} needs {version}", node)
        elif kind is not ERROR and "component" not in values and self._exclusive(storage):
            self._take(node, name, kind, storage, values)

    def _since(self, storage: str) -> int:
        if storage == "uniform":
            return _ES_SINCE["uniform"] if self._context.es else _UNIFORM_SINCE
        known = _LOCATION_SINCE.get((self._context.stage, storage))
        if self._context.es:
            return 300 if known else _ES_SINCE["interface"]
        return known or _INTERFACE_SINCE

    def _exclusive(self, storage: str) -> bool:
        """Do locations belong to one variable? Attributes may share one on the desktop."""
        attribute = self._context.stage == "vertex" and storage == "in"
        return storage != "uniform" and (self._context.es or not attribute)

    def _take(
        self, node: Node, name: str, kind: Type, storage: str, values: dict[str, int]
    ) -> None:
        first = values["location"]
        for location in range(first, first + slots(kind)):
            key = (storage, location, values.get("index", 0))
            other = self._taken.setdefault(key, name)
            if other != name:
                message = f"'{name}' and '{other}' share the location {location}"
                self._context.error("SC223", message, node)
                return


def _misplaced(word: str, names: Sequence[str], member: bool, default: bool) -> str | None:
    """Why a layout word cannot stand where it does."""
    if word not in _WORDS:
        return f"'{word}' is no layout qualifier"
    if word in _PACKINGS and not default:
        return f"'{word}' is for uniform blocks"
    if word in _ORDERS and not (default or member):
        return f"'{word}' is for uniform blocks and their members"
    if word in _ORIGINS and list(names) != ["gl_FragCoord"]:
        return f"'{word}' is for gl_FragCoord"
    return None


def slots(kind: Type) -> int:
    """Number of locations that a variable of this type takes (section 4.3.8.1)."""
    if kind.struct is not None:
        one = sum(slots(field) for field in kind.struct.fields.values())
    else:
        one = kind.cols
    return one * prod(size or 1 for size in kind.dims)
