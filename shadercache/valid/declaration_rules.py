"""Variables, structs and interface blocks: their qualifiers, types, sizes, values and precisions
(GLSL 3.30 sections 4.1.7 and 4.3, 4.60 section 4.3.9)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children
from shadercache.lang.types import FLOAT, INT, Type
from shadercache.lang.words import MEMORY_QUALIFIERS, NONUNIFORM, PRECISIONS
from shadercache.sema.declarations import BUILTIN_BLOCK
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.language import NEVER
from shadercache.sema.operators import INDICES
from shadercache.sema.problems import ERROR
from shadercache.valid.qualifier_words import (
    STORAGE,
    global_problem,
    invariable,
    version_problem,
    words_problem,
)
from shadercache.valid.suspect import Finding, Suspect

_LOCAL_WORDS = frozenset((*PRECISIONS, "const", "precise", NONUNIFORM))
_ANY_INITIALISER = "GL_EXT_shader_non_constant_global_initializers"
_IO_EXTENSIONS = ("GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
# First desktop and ES versions of the blocks of each storage, and the extensions that have them.
_BLOCKS_SINCE: Mapping[str, tuple[int, int, *tuple[str, ...]]] = {
    "uniform": (140, 300, "GL_ARB_uniform_buffer_object"),
    "buffer": (430, 310, "GL_ARB_shader_storage_buffer_object"),
    "in": (150, 320, *_IO_EXTENSIONS),
    "out": (150, 320, *_IO_EXTENSIONS),
}
_Typed: TypeAlias = n.VarDecl | n.Param | n.FunctionProto | n.PrecisionDecl

_SETTLED = ("int", "sampler2D", "samplerCube", "samplerExternalOES", "atomic_uint")
"""Types that have a default precision in every shader of GLSL ES."""

_SCOPES = (n.FunctionDef, n.Block, n.For, n.While, n.Switch)
# Attributes and what goes to render targets stand in no blocks (4.60 section 4.3.9).
_STAGE_HAS_NONE = (("vertex", "in"), ("fragment", "out"))


def variables(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """Every declaration of variables, and each variable."""
    for decl, local in suspect.variables:
        yield from _words(decl.qualifiers, local, suspect)
        storage = suspect.storage(decl.qualifiers, local)
        for node in decl.declarators:
            symbol = suspect.tables.declared[node]
            if symbol.type is not ERROR:
                problem = _type_problem(symbol, storage, suspect)
                if problem is not None:
                    yield Finding("SC221", problem, node)
                if suspect.language.es and symbol.type.is_unsized:
                    yield Finding("SC215", f"'{node.name}' has no size", node)
            # ES wants constant initialisers of all global variables (ES 3.00 section 4.3).
            if storage in ("const", "uniform") or (storage == "global" and suspect.language.es):
                yield from _initialiser(node, symbol, storage, suspect)


def _words(qualifiers: n.Qualifiers, local: bool, suspect: Suspect) -> Iterator[Finding]:
    """The qualifiers of a variable or block."""
    language, words = suspect.language, qualifiers.words
    if not words:
        return
    if language.stage == "fragment" and "attribute" in words:
        yield Finding("SC221", "a fragment shader has no attributes", qualifiers)
    problem = words_problem(words, language) or version_problem(words, language)
    allowed = {*_LOCAL_WORDS, *(MEMORY_QUALIFIERS if language.bindless else ())}
    misplaced = [word for word in words if word not in allowed]
    if local and misplaced:
        problem = f"'{misplaced[0]}' stands only on global variables and parameters"
    elif not local and problem is None:
        problem = global_problem(words, suspect.storage(qualifiers), language)
    if problem is not None:
        yield Finding("SC221", problem, qualifiers)


def _type_problem(symbol: Symbol, storage: Kind, suspect: Suspect) -> str | None:
    """What types each kind of variable may have (sections 4.1.7, 4.3.4 to 4.3.6)."""
    language, name, kind = suspect.language, symbol.name, symbol.type
    if storage == "buffer":
        return f"'{name}' is not in a block: buffers have blocks only"
    if kind.holds_opaque and storage != "uniform" and not language.bindless:
        return f"'{name}' of type {kind} must be a uniform or a parameter"
    if storage not in ("in", "out"):
        return None
    # Attributes and the outputs of fragments; the others pass from stage to stage.
    outer = (language.stage == "vertex") == (storage == "in")
    if not outer and kind.struct is not None and not language.at_least(150, 300):
        return f"'{name}' is a struct: it cannot be '{storage}' before GLSL 1.50"
    if language.version == 100 and not kind.bases.isdisjoint(("int", "bool")):
        return f"'{name}' of type {kind}: '{storage}' variables hold floats only here"
    if "bool" in kind.bases:
        return f"'{name}' of type {kind} cannot be '{storage}'"
    return (_outer_problem if outer else _passed_problem)(symbol, storage, suspect)


def _outer_problem(symbol: Symbol, storage: Kind, suspect: Suspect) -> str | None:
    """Attributes, and the outputs of fragment shaders."""
    language, name, kind = suspect.language, symbol.name, symbol.type
    wide = not kind.bases.isdisjoint(("double", "int64_t", "uint64_t")) and not language.bindless
    if storage == "out" and wide:
        return f"'{name}' of type {kind} cannot be an output of a fragment shader"
    takes_wide = "GL_ARB_vertex_attrib_64bit" in language.extensions
    if storage == "in" and wide and not (takes_wide or language.at_least(410, NEVER)):
        return f"'{name}' of type {kind}: attributes of 64 bits need GLSL 4.10"
    if storage == "in" and kind.dims and not language.at_least(150, NEVER):
        return f"'{name}' is an array: it cannot be an attribute in this version"
    if kind.struct is not None:
        return f"'{name}' is a struct: it cannot be '{storage}' here"
    if storage == "out" and kind.cols > 1:
        return f"'{name}' is a matrix: it cannot be an output of a fragment shader"
    return None


def _passed_problem(symbol: Symbol, storage: Kind, suspect: Suspect) -> str | None:
    """What a vertex shader passes to a fragment shader."""
    name, kind = symbol.name, symbol.type
    # Integers and doubles are not interpolated (GLSL 3.30 section 4.3.4).
    # ES 3.00 wants `flat` on the outputs of vertex shaders as well (section 4.3.6).
    passed = storage == "in" or suspect.language.es_version == 300
    # Integers that are built in, such as gl_Layer, are flat by themselves.
    smooth = passed and not symbol.qualifiers.has("flat") and not name.startswith("gl_")
    if smooth and not kind.bases.isdisjoint((*INDICES, "double")):
        return f"'{name}' of type {kind} needs the qualifier 'flat'"
    return None


def _initialiser(
    node: n.Declarator, symbol: Symbol, storage: Kind, suspect: Suspect
) -> Iterator[Finding]:
    """A constant needs a constant value; a uniform may have one (sections 4.3.3, 4.3.5)."""
    language = suspect.language
    if node.init is None:
        if storage == "const":
            yield Finding("SC222", f"the constant '{node.name}' has no value", node)
        return
    if suspect.is_constant(node.init) or suspect.type_of(node.init) is ERROR:
        return
    any_value = storage == "global" and _ANY_INITIALISER in language.extensions
    # From 4.20 on a local constant may have any value.
    if (symbol.is_global or language.qualifier_version < 420) and not any_value:
        message = f"the value of '{node.name}' is not a constant expression"
        yield Finding("SC222", message, node.init)


def struct(definition: n.StructDef, suspect: Suspect) -> Iterator[Finding]:
    """Fields of a struct have no qualifiers but precision, and define no struct."""
    for decl in definition.fields:
        extra = [word for word in decl.qualifiers.words if word not in PRECISIONS]
        if extra:
            message = f"'{extra[0]}' does not apply to a field"
            yield Finding("SC221", message, decl.qualifiers)
        if decl.qualifiers.layout and not suspect.language.bindless:
            yield Finding("SC223", "a field of a struct has no layout", decl.qualifiers)
        if decl.type.struct is not None:
            yield Finding("SC221", "a struct cannot be defined inside of a struct", decl.type)


def qualifiers_alone(decl: n.QualifierDecl, suspect: Suspect) -> Iterator[Finding]:
    """``invariant gl_Position;`` is about outputs (or inputs of a fragment shader, section 4.6.1),
    ``layout(std140) uniform;`` about what follows."""
    language, words = suspect.language, decl.qualifiers.words
    at_top = decl not in suspect.nested
    if not decl.names:
        problem = words_problem(words, language) or version_problem(words, language)
        if not at_top:
            problem = "defaults stand only at global scope"
        elif suspect.storage(decl.qualifiers) not in ("in", "out", "uniform", "buffer"):
            problem = "only 'in', 'out', 'uniform' and 'buffer' stand on their own"
        if problem is not None:
            yield Finding("SC221", problem, decl)
        return
    invariant = decl.qualifiers.has("invariant")
    if invariant and not at_top:
        yield Finding("SC221", "'invariant' stands only at global scope", decl)
    for symbol in suspect.tables.qualified.get(decl, ()):
        known = language.builtin_variable(symbol.name)
        storage = symbol.kind if known is None else known.storage
        if invariant and storage not in invariable(language):
            message = f"'{symbol.name}' is no output: it cannot be invariant"
            yield Finding("SC221", message, decl)
        elif suspect.is_used_before(decl, symbol.name, symbol.node):
            message = f"'{symbol.name}' was used before: its qualifiers stay as they are"
            yield Finding("SC221", message, decl)


def block(node: n.BlockDecl, suspect: Suspect) -> Iterator[Finding]:
    """An interface block, and its members."""
    storage, stage = suspect.storage(node.qualifiers), suspect.language.stage
    yield from _words(node.qualifiers, False, suspect)
    if storage not in _BLOCKS_SINCE:
        message = f"the block '{node.name}' is not uniform, buffer, in or out"
        yield Finding("SC221", message, node)
    elif not _has_blocks(storage, suspect):
        yield Finding("SC221", f"this version of GLSL has no '{storage}' blocks", node.qualifiers)
    elif (stage, storage) in _STAGE_HAS_NONE:
        yield Finding("SC221", f"a {stage} shader has no '{storage}' blocks", node.qualifiers)
    if node.name == BUILTIN_BLOCK:
        yield from _builtin_block(node, suspect)
    for decl in node.fields:
        yield from _members(decl, node, storage, suspect)
    if suspect.language.es:
        # Arrays without a size stand only at the end of a buffer (ES 3.10 section 4.1.9).
        names = [field for decl in node.fields for field in decl.declarators]
        for field in names[:-1] if storage == "buffer" else names:
            kind = suspect.tables.fields[node][field.name]
            if kind is not ERROR and kind.is_unsized:
                yield Finding("SC215", f"'{field.name}' has no size", field)


def _has_blocks(storage: Kind, suspect: Suspect) -> bool:
    desktop, es, *extensions = _BLOCKS_SINCE[storage]
    language = suspect.language
    if language.at_least(desktop, es):
        return True
    extended = storage != "buffer" or language.at_least(150, 310)
    return extended and not language.extensions.isdisjoint(extensions)


def _builtin_block(node: n.BlockDecl, suspect: Suspect) -> Iterator[Finding]:
    """``out gl_PerVertex { vec4 gl_Position; };`` (4.10 section 7.1): only what is there."""
    language = suspect.language
    extensions = ("GL_ARB_separate_shader_objects", *_IO_EXTENSIONS)
    if not language.at_least(410, 320) and language.extensions.isdisjoint(extensions):
        yield Finding("SC221", "this version of GLSL has gl_PerVertex as it is", node)
        return
    for field in (field for decl in node.fields for field in decl.declarators):
        if language.builtin_variable(field.name) is None:
            yield Finding("SC202", f"gl_PerVertex has no member '{field.name}'", field)


def _members(
    decl: n.VarDecl, owner: n.BlockDecl, storage: Kind, suspect: Suspect
) -> Iterator[Finding]:
    words = decl.qualifiers.words
    for field in decl.declarators:
        kind = suspect.tables.fields[owner][field.name]
        if kind is not ERROR and suspect.language.only_handles(kind):
            yield Finding("SC221", f"the member '{field.name}' of a block cannot be {kind}", field)
    other = [word for word in words if word in STORAGE and word != storage]
    if other:
        message = f"'{other[0]}' does not apply to a member of a '{storage}' block"
        yield Finding("SC221", message, decl)
    problem = words_problem(words, suspect.language)
    if problem is not None:
        yield Finding("SC221", problem, decl)
    if decl.type.struct is not None:
        yield Finding("SC221", "a struct cannot be defined inside of a block", decl.type)


def default_precision(decl: n.PrecisionDecl, suspect: Suspect) -> Iterator[Finding]:
    """Only floats, integers and what is opaque have one."""
    kind = suspect.tables.specs.get(decl.type, ERROR)
    if kind not in (FLOAT, INT, ERROR) and not kind.is_opaque:
        yield Finding("SC221", f"there is no default precision of {kind}", decl.type)


def precisions(module: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """GLSL ES wants a precision for what is declared, its own or a default (ES 1.00 section 4.5.3,
    ES 3.00 section 4.5.4). Each sort of type is told once."""
    if not suspect.language.es:
        return
    settled = set(_SETTLED)
    # A fragment shader has no default for float.
    if suspect.language.stage == "vertex":
        settled.add("float")
    for node, given in _scoped(module):
        kind = suspect.tables.specs.get(node.type, ERROR)
        sort = _sort(kind)
        if isinstance(node, n.PrecisionDecl):
            given.update(() if sort is None else (sort,))
        elif not PRECISIONS.isdisjoint(node.qualifiers.words):
            if sort is None and kind is not ERROR:
                yield Finding("SC221", f"{kind} has no precision", node.type)
        elif sort is not None and sort not in settled and sort not in given:
            settled.add(sort)
            message = f"{kind} has no precision, and {sort} no default one"
            hint = f"write 'precision mediump {sort};' at the top"
            yield Finding("SC228", message, node.type, hint)


def _scoped(module: n.Module) -> Iterator[tuple[_Typed, set[str]]]:
    """What is declared, in source order, with the default precisions of its scope."""
    stack: list[tuple[n.Node, set[str]]] = [(module, set())]
    while stack:
        node, given = stack.pop()
        if isinstance(node, _Typed):
            yield node, given
        # A copy for each scope: what `precision` says there ends with it. Elsewhere the set is
        # shared, so that what follows sees it.
        inner = set(given) if isinstance(node, _SCOPES) else given
        below = reversed(children(node))
        stack += [(child, inner) for child in below if not isinstance(child, EXPRESSIONS)]


def _sort(kind: Type) -> str | None:
    """The type whose default precision counts for ``kind``; ``None`` where none does."""
    if kind is ERROR or kind.struct is not None or kind.is_void:
        return None
    if kind.base is None:
        return kind.name
    # The default of int holds for uint too (ES 3.00 section 4.5.4).
    return {"float": "float", "int": "int", "uint": "int"}.get(kind.base)
