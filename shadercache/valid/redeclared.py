"""Built-in variables that a shader may declare again (GLSL 4.60 section 7.1 and 7.2): with a size,
an interpolation or a layout. All others are left alone."""

from __future__ import annotations

from shadercache.ast.nodes import Node, Param
from shadercache.lang.builtins import MOST_ELEMENTS, BuiltinVariable
from shadercache.sema.facts import Symbol
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect

_IO_BLOCKS = ("EXT_shader_io_blocks", "OES_shader_io_blocks", "ANDROID_extension_pack_es31a")
_DEPTH = ("ARB_conservative_depth", "AMD_conservative_depth", "EXT_conservative_depth")

# First desktop and ES version, and extensions.
_SINCE: dict[str, tuple[int, int, *tuple[str, ...]]] = {
    "gl_TexCoord": (110, NEVER),
    "gl_FragCoord": (140, 320, *_IO_BLOCKS, "ARB_fragment_coord_conventions"),
    "gl_FragDepth": (420, 320, *_IO_BLOCKS, *_DEPTH),
    "gl_FragStencilRefARB": (140, NEVER),
    "gl_LastFragData": (NEVER, 100),
    **dict.fromkeys(("gl_ClipDistance", "gl_CullDistance"), (130, 320, "EXT_clip_cull_distance")),
    **dict.fromkeys(
        (
            *("gl_Color", "gl_SecondaryColor", "gl_FrontColor", "gl_BackColor"),
            *("gl_FrontSecondaryColor", "gl_BackSecondaryColor"),
        ),
        (130, NEVER),
    ),
    **dict.fromkeys(("gl_SampleMask", "gl_Layer"), (130, 320)),
    # Programs of one stage each name what they pass on.
    **dict.fromkeys(
        ("gl_Position", "gl_PointSize", "gl_ClipVertex", "gl_FogFragCoord"),
        (NEVER, NEVER, "ARB_separate_shader_objects"),
    ),
}
_OF_VERTICES = {"gl_Position": "vec4 gl_Position", "gl_PointSize": "float gl_PointSize"}


def check_redeclared(suspect: Suspect) -> None:
    """Every declaration of a variable whose name begins with ``gl_``."""
    earlier: dict[str, Symbol] = {}
    for node, symbol in suspect.tables.declared.items():
        if isinstance(node, Param) or not symbol.name.startswith("gl_"):
            continue
        known = suspect.language.builtin_variable(symbol.name)
        if known is None or known.storage == "const" or not symbol.is_global:
            suspect.problems.error("SC203", "names with 'gl_' are reserved", node)
            continue
        before = earlier.get(symbol.name)
        _check(symbol, node, known, before is None, suspect)
        if before is not None and _layout(before) != _layout(symbol):
            message = f"'{symbol.name}' was redeclared with another layout before"
            suspect.problems.error("SC223", message, node)
        earlier[symbol.name] = symbol


def _check(
    symbol: Symbol, node: Node, known: BuiltinVariable, first: bool, suspect: Suspect
) -> None:
    kind, name, problems = symbol.type, symbol.name, suspect.problems
    storage = suspect.storage_of(symbol)
    if symbol.block is None and not _may_be_redeclared(name, suspect):
        message = f"'{name}' is a built-in variable, which is not declared again"
        problems.error("SC203", message, node, _instead(name, suspect))
    elif kind is not ERROR and (
        kind.name != known.type.name or bool(kind.dims) != bool(known.type.dims)
    ):
        problems.error("SC202", f"'{name}' is redeclared as {kind}; it is {known.type}", node)
    elif storage != known.storage:
        message = f"'{name}' is redeclared as '{storage}'; it is '{known.storage}'"
        problems.error("SC202", message, node)
    elif name == "gl_FragCoord" and first and suspect.is_used_before(node, name, None):
        problems.error("SC202", f"'{name}' is redeclared after its first use", node)
    elif kind.dims and (kind.dims[0] or 0) > MOST_ELEMENTS.get(name, NEVER):
        problems.error("SC215", f"'{name}' has {MOST_ELEMENTS[name]} elements at most", node)


def _instead(name: str, suspect: Suspect) -> str:
    """What to write in the place of a declaration that nobody needs."""
    if name in _OF_VERTICES and suspect.language.at_least(150, NEVER):
        return (
            f"leave it out, or redeclare the block: out gl_PerVertex {{ {_OF_VERTICES[name]}; }};"
        )
    return "leave it out"


def _may_be_redeclared(name: str, suspect: Suspect) -> bool:
    desktop, es, *extensions = _SINCE.get(name, (NEVER, NEVER))
    if suspect.language.at_least(desktop, es):
        return True
    return any(f"GL_{item}" in suspect.language.extensions for item in extensions)


def _layout(symbol: Symbol) -> set[str]:
    return {item.name for item in symbol.qualifiers.layout or ()}
