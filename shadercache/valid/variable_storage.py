"""Qualifiers and types of variables, and values that have to be constant (GLSL 3.30 sections 4.1.7
and 4.3): SC215, SC221, SC222."""

from __future__ import annotations

from shadercache.ast.nodes import (
    Declarator,
    QualifierDecl,
    Qualifiers,
    StructDef,
    VarDecl,
)
from shadercache.lang.words import MEMORY_QUALIFIERS, PRECISIONS
from shadercache.sema.facts import Symbol
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR
from shadercache.valid.qualifier_words import (
    global_problem,
    invariable,
    version_problem,
    words_problem,
)
from shadercache.valid.suspect import Suspect

_LOCAL_WORDS = frozenset((*PRECISIONS, "const", "precise"))
_ANY_INITIALISER = "GL_EXT_shader_non_constant_global_initializers"


def check_variables(suspect: Suspect) -> None:
    """Every declaration of variables, and each variable."""
    for decl, local in suspect.variables:
        check_words(decl.qualifiers, local, suspect)
        storage = suspect.storage(decl.qualifiers, local)
        for node in decl.declarators:
            symbol = suspect.tables.declared[node]
            if symbol.type is not ERROR:
                _check_type(node, symbol, storage, suspect)
            # ES wants constant initialisers of all global variables (ES 3.00 section 4.3).
            if storage in ("const", "uniform") or (storage == "global" and suspect.language.es):
                _check_constant(node, symbol, storage, suspect)


def check_words(qualifiers: Qualifiers, local: bool, suspect: Suspect) -> None:
    """The qualifiers of a variable or block."""
    language, words = suspect.language, qualifiers.words
    if not words:
        return
    if language.stage == "fragment" and "attribute" in words:
        suspect.problems.error("SC221", "a fragment shader has no attributes", qualifiers)
    problem = words_problem(words, language) or version_problem(words, language)
    misplaced = [word for word in words if word not in _LOCAL_WORDS]
    if language.bindless:
        misplaced = [word for word in misplaced if word not in MEMORY_QUALIFIERS]
    if local and misplaced:
        problem = f"'{misplaced[0]}' stands only on global variables and parameters"
    elif not local and problem is None:
        problem = global_problem(words, suspect.storage(qualifiers), language)
    if problem is not None:
        suspect.problems.error("SC221", problem, qualifiers)


def _check_type(node: Declarator, symbol: Symbol, storage: str, suspect: Suspect) -> None:
    """What types each kind of variable may have (sections 4.1.7, 4.3.4 to 4.3.6)."""
    kind, problem = symbol.type, None
    if storage == "buffer":
        problem = f"'{node.name}' is not in a block: buffers have blocks only"
    elif kind.holds_opaque and storage != "uniform" and not suspect.language.bindless:
        problem = f"'{node.name}' of type {kind} must be a uniform or a parameter"
    elif storage in ("in", "out"):
        problem = _interface_problem(symbol, storage, suspect)
    if problem is not None:
        suspect.problems.error("SC221", problem, node)
    if suspect.language.es and kind.is_unsized:
        suspect.problems.error("SC215", f"'{node.name}' has no size", node)


def _interface_problem(symbol: Symbol, storage: str, suspect: Suspect) -> str | None:
    language, name, kind = suspect.language, symbol.name, symbol.type
    outer = (language.stage == "vertex") == (storage == "in")
    if not outer and kind.struct is not None and not language.at_least(150, 300):
        return f"'{name}' is a struct: it cannot be '{storage}' before GLSL 1.50"
    if language.version == 100 and not kind.bases.isdisjoint(("int", "bool")):
        return f"'{name}' of type {kind}: '{storage}' variables hold floats only here"
    if "bool" in kind.bases:
        return f"'{name}' of type {kind} cannot be '{storage}'"
    return (_outer_problem if outer else _passed_problem)(symbol, storage, suspect)


def _outer_problem(symbol: Symbol, storage: str, suspect: Suspect) -> str | None:
    """Attributes, and the outputs of fragment shaders."""
    language, name, kind = suspect.language, symbol.name, symbol.type
    wide = not kind.bases.isdisjoint(("double", "int64_t", "uint64_t")) and not language.bindless
    if storage == "out" and wide:
        return f"'{name}' of type {kind} cannot be an output of a fragment shader"
    if storage == "in" and wide and not _has_wide_attributes(suspect):
        return f"'{name}' of type {kind}: attributes of 64 bits need GLSL 4.10"
    if storage == "in" and kind.dims and not language.at_least(150, NEVER):
        return f"'{name}' is an array: it cannot be an attribute in this version"
    if kind.struct is not None:
        return f"'{name}' is a struct: it cannot be '{storage}' here"
    if storage == "out" and kind.cols > 1:
        return f"'{name}' is a matrix: it cannot be an output of a fragment shader"
    return None


def _passed_problem(symbol: Symbol, storage: str, suspect: Suspect) -> str | None:
    """What a vertex shader passes to a fragment shader."""
    language, name, kind = suspect.language, symbol.name, symbol.type
    passed = storage == "in" or language.es_version == 300
    smooth = passed and not symbol.qualifiers.has("flat") and not name.startswith("gl_")
    if smooth and not kind.bases.isdisjoint(("int", "uint", "double")):
        return f"'{name}' of type {kind} needs the qualifier 'flat'"
    return None


def _has_wide_attributes(suspect: Suspect) -> bool:
    language = suspect.language
    return language.at_least(410, NEVER) or "GL_ARB_vertex_attrib_64bit" in language.extensions


def _check_constant(node: Declarator, symbol: Symbol, storage: str, suspect: Suspect) -> None:
    """A constant needs a constant value; a uniform may have one (sections 4.3.3, 4.3.5)."""
    problems, language = suspect.problems, suspect.language
    if node.init is None:
        if storage == "const":
            problems.error("SC222", f"the constant '{node.name}' has no value", node)
        return
    if suspect.is_constant(node.init) or suspect.type_of(node.init) is ERROR:
        return
    if symbol.is_global or language.qualifier_version < 420:
        if storage == "global" and _ANY_INITIALISER in language.extensions:
            return
        message = f"the value of '{node.name}' is not a constant expression"
        problems.error("SC222", message, node.init)


def check_structs(suspect: Suspect) -> None:
    """Fields of a struct have no qualifiers but precision, and define no struct."""
    for struct in suspect.nodes(StructDef):
        for decl in struct.fields:
            _check_field(decl, suspect)


def _check_field(decl: VarDecl, suspect: Suspect) -> None:
    problems = suspect.problems
    extra = [word for word in decl.qualifiers.words if word not in PRECISIONS]
    if extra:
        problems.error("SC221", f"'{extra[0]}' does not apply to a field", decl.qualifiers)
    if decl.qualifiers.layout and not suspect.language.bindless:
        problems.error("SC223", "a field of a struct has no layout", decl.qualifiers)
    if decl.type.struct is not None:
        problems.error("SC221", "a struct cannot be defined inside of a struct", decl.type)


def check_qualifier_declarations(suspect: Suspect) -> None:
    """``invariant gl_Position;`` is about outputs (or inputs of a fragment shader, section 4.6.1),
    ``layout(std140) uniform;`` about what follows."""
    top = {decl for decl in suspect.module.decls if isinstance(decl, QualifierDecl)}
    for decl in suspect.nodes(QualifierDecl):
        if not decl.names:
            _check_default(decl, decl in top, suspect)
            continue
        invariant = decl.qualifiers.has("invariant")
        if invariant and decl not in top:
            message = "'invariant' stands only at global scope"
            suspect.problems.error("SC221", message, decl)
        for symbol in suspect.tables.qualified.get(decl, ()):
            _check_qualified(decl, symbol, invariant, suspect)


def _check_qualified(
    decl: QualifierDecl, symbol: Symbol, invariant: bool, suspect: Suspect
) -> None:
    known = suspect.language.builtin_variable(symbol.name)
    storage = symbol.kind if known is None else known.storage
    if invariant and storage not in invariable(suspect.language):
        message = f"'{symbol.name}' is no output: it cannot be invariant"
        suspect.problems.error("SC221", message, decl)
    elif suspect.is_used_before(decl, symbol.name, symbol.node):
        message = f"'{symbol.name}' was used before: its qualifiers stay as they are"
        suspect.problems.error("SC221", message, decl)


def _check_default(decl: QualifierDecl, at_top: bool, suspect: Suspect) -> None:
    words, language = decl.qualifiers.words, suspect.language
    problem = words_problem(words, language) or version_problem(words, language)
    if not at_top:
        problem = "defaults stand only at global scope"
    elif suspect.storage(decl.qualifiers) not in ("in", "out", "uniform", "buffer"):
        problem = "only 'in', 'out', 'uniform' and 'buffer' stand on their own"
    if problem is not None:
        suspect.problems.error("SC221", problem, decl)
