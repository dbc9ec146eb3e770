"""Layout qualifiers (GLSL 4.60 section 4.4): what each declaration says, and whether it may."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.lang import extension_words
from shadercache.lang.block_layout import LAID_OUT, alignment, up
from shadercache.lang.types import INT, UINT
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR, did_you_mean
from shadercache.sema.storage import of_one_vertex
from shadercache.valid.layout_words import ORDERS, PACKINGS, WORDS, LayoutPlace, word_problem
from shadercache.valid.locations import Locations, Values
from shadercache.valid.suspect import Finding, Suspect

# Blending has two sources, OpenGL one set of descriptors, a location four components.
_MOST = {"index": 1, "set": 0, "component": 3}
"""Values above these are wrong here."""


def layouts(module: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """The layouts of all declarations, in the order of the source: a default holds for what
    follows."""
    checker = _Layouts(suspect)
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            checker.variables(decl, suspect.storage(decl.qualifiers))
        elif isinstance(decl, n.BlockDecl):
            checker.block(decl, suspect.storage(decl.qualifiers))
        elif isinstance(decl, n.QualifierDecl) and not decl.names:
            checker.default(decl.qualifiers, suspect.storage(decl.qualifiers))
    for decl, local in suspect.variables:
        if local:
            checker.variables(decl, suspect.storage(decl.qualifiers, local))
    yield from checker.findings


class _Layouts:
    def __init__(self, suspect: Suspect) -> None:
        self.findings: list[Finding] = []
        self._suspect = suspect
        self._locations = Locations(suspect, self.findings)
        self._defaults: dict[str, set[str]] = {"uniform": set(), "buffer": set()}

    def _error(self, message: str, node: n.Node, hint: str | None = None) -> None:
        self.findings.append(Finding("SC223", message, node, hint))

    def _check(self, qualifiers: n.Qualifiers, place: LayoutPlace) -> Values:
        """The values by name; each is a constant integer, not negative. The last one counts."""
        values: dict[str, int] = {}
        for entry in qualifiers.layout or ():
            # Compilers do not tell small letters from capitals, in GLSL ES neither.
            word = entry.name.lower()
            problem = word_problem(word, entry.value is not None, place, self._suspect.language)
            of_extension = extension_words.explained(word) if word not in WORDS else None
            if of_extension is not None:
                self.findings.append(Finding("SC111", of_extension[0], entry, of_extension[1]))
            elif problem is not None:
                self._error(problem, entry, None if word in WORDS else did_you_mean(word, WORDS))
            number = None if entry.value is None else self._number(entry, word, entry.value)
            if number is not None and problem is None:
                values[word] = number
        return values

    def _number(self, entry: n.LayoutItem, name: str, value: n.Expr) -> int | None:
        kind, number = self._suspect.type_of(value), self._suspect.value(value)
        if kind is ERROR:
            return None
        language = self._suspect.language
        enhanced = "GL_ARB_enhanced_layouts" in language.extensions and language.version >= 150
        if not isinstance(value, n.Literal) and not enhanced and not language.at_least(440, NEVER):
            self._error(f"before GLSL 4.40 the layout value of '{name}' is a plain number", value)
            return None
        if kind not in (INT, UINT) or not isinstance(number, int) or number < 0:
            message = f"the layout value of '{name}' is a constant integer, not negative"
            self._error(message, value)
            return None
        # Vulkan has as many sets as its driver.
        if number > _MOST.get(name, number) and not (name == "set" and language.vulkan):
            self._error(f"the layout value of '{name}' is at most {_MOST[name]} here", entry)
        return number

    def variables(self, decl: n.VarDecl, storage: str) -> None:
        """The layout of variables; one without any is that of the counters that follow."""
        if not decl.qualifiers.layout:
            return
        for node in decl.declarators:
            kind = self._suspect.tables.declared[node].type
            place = LayoutPlace("variable", storage, node.name, kind)
            values = self._check(decl.qualifiers, place)
            if storage in ("in", "out", "uniform"):
                one = of_one_vertex(kind, decl.qualifiers)
                self._locations.place(node, one, storage, values)
        if not decl.declarators:
            kind = self._suspect.tables.specs[decl.type]
            self._check(decl.qualifiers, LayoutPlace("variable", storage, None, kind))

    def block(self, block: n.BlockDecl, storage: str) -> None:
        """The layouts of a block and of its members."""
        own = self._check(block.qualifiers, LayoutPlace("block", storage))
        place = LayoutPlace("member", storage)
        members = [self._check(decl.qualifiers, place) for decl in block.fields]
        self._locations.place_block(block, storage, own.get("location"), members)
        if storage not in self._defaults:
            return
        words = {entry.name.lower() for entry in block.qualifiers.layout or ()}
        packing = _packing(words) or _packing(self._defaults[storage])
        packing = packing or ("std140" if self._suspect.language.vulkan else "shared")
        # Offsets behind matrices that are stored by rows are left alone.
        parts = [words, self._defaults[storage]]
        parts += [
            {entry.name.lower() for entry in decl.qualifiers.layout or ()} for decl in block.fields
        ]
        if not any("row_major" in part for part in parts):
            self._offsets(block, packing, own.get("align", 0), members)

    def default(self, qualifiers: n.Qualifiers, storage: str) -> None:
        """``layout(std140) uniform;``: for what follows."""
        self._check(qualifiers, LayoutPlace("default", storage))
        known = self._defaults.get(storage, set())
        for word in (entry.name.lower() for entry in qualifiers.layout or ()):
            if word in PACKINGS:
                # Of several defaults the last one counts, among packings and among orders.
                known.difference_update(PACKINGS)
            elif word in ORDERS:
                known.discard("row_major")
            known.add(word)

    def _offsets(
        self, block: n.BlockDecl, packing: str, shared_align: int, members: list[Values]
    ) -> None:
        """Offsets and alignments stand in ``std140`` and ``std430`` blocks, and grow (section
        4.4.5)."""
        given = any("offset" in values or "align" in values for values in members)
        if (given or shared_align) and packing not in LAID_OUT:
            message = "'offset' and 'align' are for blocks with the layout std140 or std430"
            self._error(message, block)
            return
        end = 0
        for decl, values in zip(block.fields, members, strict=True):
            for node in decl.declarators:
                kind = self._suspect.tables.fields[block][node.name]
                # Behind a member of unknown size no offset can be judged.
                if kind is ERROR or kind.components is None:
                    return
                unit, size = alignment(kind, packing)
                align = values.get("align", shared_align)
                if align & (align - 1):
                    self._error(f"an alignment is a power of 2, not {align}", decl)
                if "offset" in values:
                    offset = values["offset"]
                    if offset % unit:
                        message = f"the offset of {kind} is a multiple of {unit}, not {offset}"
                        self._error(message, node)
                    elif offset < end:
                        message = f"'{node.name}' at the offset {offset} lies in members before it"
                        self._error(message, node)
                    end = max(end, offset)
                # A greater `align` counts instead of the alignment of the type (section 4.4.5).
                end = up(end, max(unit, align)) + size


def _packing(words: set[str]) -> str | None:
    return next((word for word in PACKINGS if word in words), None)
