"""Built-in variables that a shader may declare again (GLSL 4.60 section 7.1 and 7.2): with a size,
an interpolation or a layout. All others are left alone."""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast.nodes import Node
from shadercache.sema.check_context import ERROR, NEVER, Context
from shadercache.sema.facts import Symbol

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
MOST_ELEMENTS = {"gl_ClipDistance": 8, "gl_CullDistance": 8}
"""Elements of built-in arrays without a size, on every driver."""


def redeclared(symbol: Symbol, node: Node, context: Context) -> Symbol:
    """The built-in variable that ``symbol`` declares again; complains where that cannot be."""
    known, kind = context.builtin_variable(symbol.name), symbol.type
    before = context.scopes.here(symbol.name)
    if known is None or known.storage == "const" or context.scopes.depth:
        context.error("SC203", "names with 'gl_' are reserved", node)
        return symbol
    if symbol.block is None and not _may_be_redeclared(symbol.name, context):
        message = f"'{symbol.name}' is a built-in variable, which is not declared again"
        context.error("SC203", message, node, _instead(symbol.name, context))
    elif kind is not ERROR and (
        kind.name != known.type.name or bool(kind.dims) != bool(known.type.dims)
    ):
        message = f"'{symbol.name}' is redeclared as {kind}; it is {known.type}"
        context.error("SC202", message, node)
    elif symbol.kind != known.storage:
        message = f"'{symbol.name}' is redeclared as '{symbol.kind}'; it is '{known.storage}'"
        context.error("SC202", message, node)
    elif symbol.name == "gl_FragCoord" and before is None and context.is_used(symbol.name):
        context.error("SC202", f"'{symbol.name}' is redeclared after its first use", node)
    elif kind.dims and (kind.dims[0] or 0) > MOST_ELEMENTS.get(symbol.name, NEVER):
        message = f"'{symbol.name}' has {MOST_ELEMENTS[symbol.name]} elements at most"
        context.error("SC215", message, node)
    if isinstance(before, Symbol) and _layout(before) != _layout(symbol):
        message = f"'{symbol.name}' was redeclared with another layout before"
        context.error("SC223", message, node)
    return replace(symbol, kind="builtin", writable=known.storage == "out")


def _instead(name: str, context: Context) -> str:
    """What to write in the place of a declaration that nobody needs."""
    if name in _OF_VERTICES and context.at_least(150, NEVER):
        return (
            f"leave it out, or redeclare the block: out gl_PerVertex {{ {_OF_VERTICES[name]}; }};"
        )
    return "leave it out"


def _may_be_redeclared(name: str, context: Context) -> bool:
    desktop, es, *extensions = _SINCE.get(name, (NEVER, NEVER))
    known = context.at_least(desktop, es)
    return known or any(f"GL_{item}" in context.extensions for item in extensions)


def _layout(symbol: Symbol) -> set[str]:
    return {item.name for item in symbol.qualifiers.layout or ()}
