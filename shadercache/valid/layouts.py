"""Layout qualifiers (GLSL 4.60 section 4.4): what each declaration says, and whether it may."""

from __future__ import annotations

from shadercache.ast.nodes import (
    BlockDecl,
    Declarator,
    Expr,
    LayoutItem,
    Literal,
    QualifierDecl,
    Qualifiers,
    VarDecl,
)
from shadercache.lang import unsupported
from shadercache.lang.types import INT, UINT, Type
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR, did_you_mean
from shadercache.sema.storage import of_one_vertex
from shadercache.valid.layout_words import SINCE, LayoutPlace, word_problem
from shadercache.valid.locations import Locations
from shadercache.valid.member_offsets import check_member_offsets
from shadercache.valid.suspect import Suspect

_PACKINGS = ("shared", "packed", "std140", "std430")


def check_layouts(suspect: Suspect) -> None:
    """The layouts of all declarations, in the order of the source: a default holds for what
    follows."""
    layouts = _Layouts(suspect)
    for decl in suspect.module.decls:
        if isinstance(decl, VarDecl):
            layouts.variables(decl, suspect.storage(decl.qualifiers))
        elif isinstance(decl, BlockDecl):
            layouts.block(decl, suspect.storage(decl.qualifiers))
        elif isinstance(decl, QualifierDecl) and not decl.names:
            layouts.default(decl.qualifiers, suspect.storage(decl.qualifiers))
    for decl, local in suspect.variables:
        if local:
            layouts.variables(decl, suspect.storage(decl.qualifiers, local))


class _Layouts:
    def __init__(self, suspect: Suspect) -> None:
        self._suspect = suspect
        self._language, self._problems = suspect.language, suspect.problems
        self._locations = Locations(suspect)
        self._defaults: dict[str, set[str]] = {"uniform": set(), "buffer": set()}

    def check(self, qualifiers: Qualifiers, place: LayoutPlace) -> dict[str, int]:
        """The values by name; each is a constant integer, not negative. The last one counts."""
        values: dict[str, int] = {}
        for item in qualifiers.layout or ():
            # Compilers do not tell small letters from capitals, in GLSL ES neither.
            word = item.name.lower()
            problem = word_problem(word, item.value is not None, place, self._language)
            of_extension = unsupported.told(word) if word not in SINCE else None
            if of_extension is not None:
                self._problems.error("SC111", of_extension[0], item, of_extension[1])
            elif problem is not None:
                hint = did_you_mean(word, SINCE) if word not in SINCE else None
                self._problems.error("SC223", problem, item, hint)
            number = None if item.value is None else self._number(item, word, item.value)
            if number is not None and problem is None:
                values[word] = number
        return values

    def _number(self, item: LayoutItem, name: str, value: Expr) -> int | None:
        kind, number = self._suspect.type_of(value), self._suspect.value(value)
        if kind is ERROR:
            return None
        if not isinstance(value, Literal) and not self._takes_expressions():
            message = f"before GLSL 4.40 the layout value of '{name}' is a plain number"
            self._problems.error("SC223", message, value)
            return None
        if kind not in (INT, UINT) or not isinstance(number, int) or number < 0:
            message = f"the layout value of '{name}' is a constant integer, not negative"
            self._problems.error("SC223", message, value)
            return None
        most = {"index": 1, "set": 0, "component": 3}.get(name, number)
        if number > most:
            message = f"the layout value of '{name}' is at most {most} here"
            self._problems.error("SC223", message, item)
        return number

    def _takes_expressions(self) -> bool:
        language = self._language
        enhanced = "GL_ARB_enhanced_layouts" in language.extensions and language.version >= 150
        return enhanced or language.at_least(440, NEVER)

    def variables(self, decl: VarDecl, storage: str) -> None:
        """The layout of variables; one without any is that of the counters that follow."""
        if not decl.qualifiers.layout:
            return
        for node in decl.declarators:
            self._variable(node, decl.qualifiers, storage)
        if not decl.declarators:
            kind = self._suspect.tables.specs[decl.type]
            self.check(decl.qualifiers, LayoutPlace("variable", storage, (), kind))

    def _variable(self, node: Declarator, qualifiers: Qualifiers, storage: str) -> None:
        kind = self._suspect.tables.declared[node].type
        values = self.check(qualifiers, LayoutPlace("variable", storage, (node.name,), kind))
        if storage in ("in", "out", "uniform"):
            one = of_one_vertex(kind, qualifiers)
            self._locations.place(node, node.name, one, storage, values)

    def block(self, block: BlockDecl, storage: str) -> None:
        """The layouts of a block and of its members."""
        own = self.check(block.qualifiers, LayoutPlace("block", storage))
        members = [
            self.check(
                decl.qualifiers, LayoutPlace("member", storage, (), self._type_of(block, decl))
            )
            for decl in block.fields
        ]
        self._locations.place_block(block, storage, own.get("location"), members)
        if storage not in self._defaults:
            return
        words = {item.name.lower() for item in block.qualifiers.layout or ()}
        packing = _packing(words) or _packing(self._defaults[storage]) or "shared"
        parts = [words, self._defaults[storage]]
        parts += [{item.name for item in decl.qualifiers.layout or ()} for decl in block.fields]
        if not any("row_major" in part for part in parts):
            check_member_offsets(block, packing, own.get("align"), members, self._suspect)

    def _type_of(self, block: BlockDecl, decl: VarDecl) -> Type | None:
        """The type of the members that one declaration declares (the first, where sizes differ)."""
        fields = self._suspect.fields(block)
        kind = fields.get(decl.declarators[0].name) if decl.declarators else None
        return None if kind is ERROR else kind

    def default(self, qualifiers: Qualifiers, storage: str) -> None:
        """``layout(std140) uniform;``: for what follows."""
        self.check(qualifiers, LayoutPlace("default", storage))
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
