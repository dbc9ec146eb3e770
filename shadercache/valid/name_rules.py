"""Names that a shader may not give (GLSL 4.60 section 3.7), and built-in variables that it may
declare again, with a size, an interpolation or a layout (sections 7.1 and 7.2)."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.lang.builtins import MOST_ELEMENTS, BuiltinVariable
from shadercache.sema.declarations import BUILTIN_BLOCK
from shadercache.sema.facts import Symbol
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Finding, Suspect

_IO_BLOCKS = ("EXT_shader_io_blocks", "OES_shader_io_blocks", "ANDROID_extension_pack_es31a")
_DEPTH = ("ARB_conservative_depth", "AMD_conservative_depth", "EXT_conservative_depth")
_COLORS = ("Color", "SecondaryColor", "FrontColor", "BackColor")

# First desktop and ES version, and extensions.
_REDECLARED_SINCE: dict[str, tuple[int, int, *tuple[str, ...]]] = {
    "gl_TexCoord": (110, NEVER),
    "gl_FragCoord": (140, 320, *_IO_BLOCKS, "ARB_fragment_coord_conventions"),
    "gl_FragDepth": (420, 320, *_IO_BLOCKS, *_DEPTH),
    "gl_FragStencilRefARB": (140, NEVER),
    "gl_LastFragData": (NEVER, 100),
    **dict.fromkeys(("gl_ClipDistance", "gl_CullDistance"), (130, 320, "EXT_clip_cull_distance")),
    **dict.fromkeys((f"gl_{name}" for name in _COLORS), (130, NEVER)),
    **dict.fromkeys(("gl_FrontSecondaryColor", "gl_BackSecondaryColor"), (130, NEVER)),
    **dict.fromkeys(("gl_SampleMask", "gl_Layer"), (130, 320)),
    # Programs of one stage each name what they pass on.
    **dict.fromkeys(
        ("gl_Position", "gl_PointSize", "gl_ClipVertex", "gl_FogFragCoord"),
        (NEVER, NEVER, "ARB_separate_shader_objects"),
    ),
}
_OF_VERTICES = {"gl_Position": "vec4 gl_Position", "gl_PointSize": "float gl_PointSize"}


def given_names(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """The names of everything that the shader declares."""
    language = suspect.language
    blocks = (block for block in suspect.nodes(n.BlockDecl) if block.name != BUILTIN_BLOCK)
    owners: list[n.StructDef | n.BlockDecl] = [*suspect.nodes(n.StructDef), *blocks]
    for proto in suspect.nodes(n.FunctionProto):
        yield from _reserved(proto.name, proto, suspect)
    for owner in owners:
        yield from _reserved(owner.name, owner, suspect)
    for field in (field for owner in owners for decl in owner.fields for field in decl.declarators):
        if field.name.startswith("gl_"):
            yield from _reserved(field.name, field, suspect)
    for node, symbol in suspect.tables.declared.items():
        # GLSL ES 3.00 lets only local names hide built-in functions (section 4.2.2).
        name, is_hiding = symbol.name, symbol.is_global and language.es_version >= 300
        if isinstance(node, n.Param) or (not name.startswith("gl_") and "__" in name):
            yield from _reserved(name, node, suspect)
        elif is_hiding and not name.startswith("gl_") and language.builtin_functions(name):
            yield Finding("SC202", f"'{name}' is a built-in function", node)


def _reserved(name: str, node: n.Node, suspect: Suspect) -> Iterator[Finding]:
    """Names with ``gl_`` are reserved, those with ``__`` doubtful."""
    if name.startswith("gl_"):
        yield Finding("SC203", "names with 'gl_' are reserved", node)
    elif "__" in name:
        # An error in GLSL ES 1.00; elsewhere compilers take such names and warn.
        wrong = suspect.language.es_version == 100
        message = f"'{name}': names with '__' are reserved"
        yield Finding("SC203" if wrong else "SC292", message, node, warning=not wrong)


def redeclared(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """Every declaration of a variable whose name begins with ``gl_``."""
    earlier: dict[str, Symbol] = {}
    for node, symbol in suspect.tables.declared.items():
        if isinstance(node, n.Param) or not symbol.name.startswith("gl_"):
            continue
        known = suspect.language.builtin_variable(symbol.name)
        if known is None or known.storage == "const" or not symbol.is_global:
            yield Finding("SC203", "names with 'gl_' are reserved", node)
            continue
        before = earlier.get(symbol.name)
        yield from _against(known, symbol, node, before is None, suspect)
        if before is not None and _layout(before) != _layout(symbol):
            message = f"'{symbol.name}' was redeclared with another layout before"
            yield Finding("SC223", message, node)
        earlier[symbol.name] = symbol


def _against(
    known: BuiltinVariable, symbol: Symbol, node: n.Node, first: bool, suspect: Suspect
) -> Iterator[Finding]:
    kind, name = symbol.type, symbol.name
    storage = suspect.storage((symbol.block or symbol).qualifiers, not symbol.is_global)
    if symbol.block is None and not _may_be_redeclared(name, suspect):
        message = f"'{name}' is a built-in variable, which is not declared again"
        hint = "leave it out"
        if name in _OF_VERTICES and suspect.language.at_least(150, NEVER):
            hint += f", or redeclare the block: out gl_PerVertex {{ {_OF_VERTICES[name]}; }};"
        yield Finding("SC203", message, node, hint)
    elif kind is not ERROR and (
        kind.name != known.type.name or bool(kind.dims) != bool(known.type.dims)
    ):
        yield Finding("SC202", f"'{name}' is redeclared as {kind}; it is {known.type}", node)
    elif storage != known.storage:
        message = f"'{name}' is redeclared as '{storage}'; it is '{known.storage}'"
        yield Finding("SC202", message, node)
    elif name == "gl_FragCoord" and first and suspect.is_used_before(node, name, None):
        yield Finding("SC202", f"'{name}' is redeclared after its first use", node)
    elif kind.dims and (kind.dims[0] or 0) > MOST_ELEMENTS.get(name, NEVER):
        yield Finding("SC215", f"'{name}' has {MOST_ELEMENTS[name]} elements at most", node)


def _may_be_redeclared(name: str, suspect: Suspect) -> bool:
    desktop, es, *extensions = _REDECLARED_SINCE.get(name, (NEVER, NEVER))
    if suspect.language.at_least(desktop, es):
        return True
    return any(f"GL_{extension}" in suspect.language.extensions for extension in extensions)


def _layout(symbol: Symbol) -> set[str]:
    return {entry.name for entry in symbol.qualifiers.layout or ()}
