"""Layout qualifiers (GLSL 4.60 section 4.4): what each declaration says, and whether it may."""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.ast.nodes import BlockDecl, Expr, LayoutItem, Literal, Node, Qualifiers, VarDecl
from shadercache.lang import unsupported
from shadercache.lang.types import INT, UINT, Type
from shadercache.sema.check_context import ERROR, NEVER, Context, did_you_mean
from shadercache.sema.counters import Counters
from shadercache.sema.expression_types import ExpressionChecker
from shadercache.sema.feedback import Feedback
from shadercache.sema.layout_words import SINCE, Place, word_problem
from shadercache.sema.locations import Locations, of_one_vertex
from shadercache.sema.offsets import check_offsets

_PACKINGS = ("shared", "packed", "std140", "std430")


class LayoutChecker:
    """Checks ``layout(...)`` of declarations."""

    def __init__(self, context: Context, expressions: ExpressionChecker) -> None:
        self._context = context
        self._check = expressions.check
        self._values = expressions.constants.values
        self._locations = Locations(context)
        self._feedback = Feedback(context)
        self._counters = Counters(context)
        self._defaults: dict[str, set[str]] = {"uniform": set(), "buffer": set()}

    def check(self, qualifiers: Qualifiers, place: Place) -> dict[str, int]:
        """The values by name; each is a constant integer, not negative. The last one counts."""
        values: dict[str, int] = {}
        for item in qualifiers.layout or ():
            # Compilers do not tell small letters from capitals, in GLSL ES neither.
            word = item.name.lower()
            problem = word_problem(word, item.value is not None, place, self._context)
            of_extension = unsupported.told(word) if word not in SINCE else None
            if of_extension is not None:
                self._context.error("SC111", of_extension[0], item, of_extension[1])
            elif problem is not None:
                hint = did_you_mean(word, SINCE) if word not in SINCE else None
                self._context.error("SC223", problem, item, hint)
            number = None if item.value is None else self._number(item, word, item.value)
            if number is not None and problem is None:
                values[word] = number
        if place.form == "block" or any(word.startswith("xfb_") for word in values):
            self._feedback.check(qualifiers, values, place)
        return values

    def _number(self, item: LayoutItem, name: str, value: Expr) -> int | None:
        kind, number = self._check(value), self._values.get(value)
        if kind is ERROR:
            return None
        if not isinstance(value, Literal) and not self._takes_expressions():
            message = f"before GLSL 4.40 the layout value of '{name}' is a plain number"
            self._context.error("SC223", message, value)
            return None
        if kind not in (INT, UINT) or not isinstance(number, int) or number < 0:
            message = f"the layout value of '{name}' is a constant integer, not negative"
            self._context.error("SC223", message, value)
            return None
        most = {"index": 1, "set": 0, "component": 3}.get(name, number)
        if number > most:
            message = f"the layout value of '{name}' is at most {most} here"
            self._context.error("SC223", message, item)
        return number

    def _takes_expressions(self) -> bool:
        context = self._context
        enhanced = "GL_ARB_enhanced_layouts" in context.extensions and context.version >= 150
        return enhanced or context.at_least(440, NEVER)

    def variable(
        self, node: Node, name: str, kind: Type, qualifiers: Qualifiers, storage: str
    ) -> None:
        """The layout of one variable."""
        values = self.check(qualifiers, Place("variable", storage, (name,), kind))
        if kind.name == "atomic_uint" and storage == "uniform":
            self._counters.place(node, name, kind, values)
        if storage in ("in", "out", "uniform"):
            self._locations.place(node, name, of_one_vertex(kind, qualifiers), storage, values)

    def nameless(self, qualifiers: Qualifiers, kind: Type, storage: str) -> None:
        """``layout(binding = 1, offset = 4) uniform atomic_uint;``: for counters that follow."""
        values = self.check(qualifiers, Place("variable", storage, (), kind))
        if kind.name == "atomic_uint":
            self._counters.default(values)

    def block(self, block: BlockDecl, storage: str, fields: Mapping[str, Type]) -> None:
        """The layouts of a block and of its members."""
        own = self.check(block.qualifiers, Place("block", storage))
        members = [
            self.check(decl.qualifiers, Place("member", storage, (), _type_of(decl, fields)))
            for decl in block.fields
        ]
        self._locations.place_block(block, storage, fields, own.get("location"), members)
        if storage not in self._defaults:
            return
        words = {item.name.lower() for item in block.qualifiers.layout or ()}
        packing = _packing(words) or _packing(self._defaults[storage]) or "shared"
        parts = [words, self._defaults[storage]]
        parts += [{item.name for item in decl.qualifiers.layout or ()} for decl in block.fields]
        if not any("row_major" in part for part in parts):
            check_offsets(block, packing, own.get("align"), fields, members, self._context)

    def default(self, qualifiers: Qualifiers, storage: str) -> None:
        """``layout(std140) uniform;``: for what follows."""
        self.check(qualifiers, Place("default", storage))
        words = [item.name.lower() for item in qualifiers.layout or ()]
        known = self._defaults.get(storage, set())
        for word in words:
            if word in _PACKINGS:
                known.difference_update(_PACKINGS)
            elif word in ("row_major", "column_major"):
                known.discard("row_major")
            known.add(word)


def _packing(words: set[str]) -> str | None:
    return next((word for word in _PACKINGS if word in words), None)


def _type_of(decl: VarDecl, fields: Mapping[str, Type]) -> Type | None:
    """The type of the members that one declaration declares (the first, where sizes differ)."""
    kind = fields.get(decl.declarators[0].name) if decl.declarators else None
    return None if kind is ERROR else kind
