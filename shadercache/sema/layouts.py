"""Layout qualifiers (GLSL 3.30 sections 4.3.8 and 4.3.9): values, places, overlapping locations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from shadercache.ast.nodes import BlockDecl, Expr, Literal, Node, Qualifiers
from shadercache.lang.types import INT, UINT, Type
from shadercache.sema.context import ERROR, NEVER, Context, did_you_mean
from shadercache.sema.expressions import ExpressionChecker

# First version of a location: (stage, storage) -> version; what is missing needs 4.10.
_LOCATION_SINCE = {("vertex", "in"): 330, ("fragment", "out"): 330}
_LOCATING = "GL_ARB_explicit_attrib_location"
_BLOCK_LOCATIONS = frozenset(
    ("GL_ARB_enhanced_layouts", "GL_EXT_shader_io_blocks", "GL_OES_shader_io_blocks")
)
_INTERFACE_SINCE = 410
_UNIFORM_SINCE = 430
_ES_SINCE = {"uniform": 310, "interface": 310}

_PACKINGS = frozenset(("shared", "packed", "std140", "std430"))
_ORDERS = frozenset(("row_major", "column_major"))
_ORIGINS = frozenset(("origin_upper_left", "pixel_center_integer"))
IMAGE_FORMATS = frozenset(
    (
        *(f"{channels}{bits}{kind}" for channels in ("r", "rg", "rgba") for bits in (8, 16, 32)
          for kind in ("f", "i", "ui", "_snorm", "") if (kind, bits) not in (("f", 8), ("", 32))),
        *("r11f_g11f_b10f", "rgb10_a2", "rgb10_a2ui"),
    )
)  # fmt: skip
_MAX_LOCATIONS = 4096  # No implementation has more; those of larger arrays are not looked at.
_BINDLESS = ("bindless_sampler", "bindless_image", "bound_sampler", "bound_image")
_DEPTHS = ("depth_any", "depth_greater", "depth_less", "depth_unchanged")
_BLENDS = (
    *("multiply", "screen", "overlay", "darken", "lighten", "colordodge", "colorburn", "hardlight"),
    *("softlight", "difference", "exclusion", "hsl_hue", "hsl_saturation", "hsl_color"),
    *("hsl_luminosity", "all_equations"),
)
_ENHANCED = (440, NEVER, "ARB_enhanced_layouts")

# First desktop version of the extensions that need one.
_NEEDS = {"ARB_enhanced_layouts": 150, "ARB_shader_storage_buffer_object": 150}

# First desktop and ES version of each word, and the extensions that have it.
_SINCE: dict[str, tuple[int, int, *tuple[str, ...]]] = {
    **dict.fromkeys(("location", "index", "shared", "packed", "std140"), (0, 0)),
    **dict.fromkeys(_ORDERS, (0, 0)),
    "std430": (430, 310, "ARB_shader_storage_buffer_object"),
    **dict.fromkeys(_ORIGINS, (150, NEVER, "ARB_fragment_coord_conventions")),
    **dict.fromkeys(IMAGE_FORMATS, (420, 310, "ARB_shader_image_load_store")),
    "binding": (420, 310, "ARB_shading_language_420pack"),
    "offset": (420, 310, "ARB_enhanced_layouts", "ARB_shader_atomic_counters"),
    **dict.fromkeys(("component", "align", "xfb_buffer", "xfb_stride", "xfb_offset"), _ENHANCED),
    "early_fragment_tests": (420, 310, "ARB_shader_image_load_store"),
    "post_depth_coverage": (NEVER, NEVER, "ARB_post_depth_coverage", "EXT_post_depth_coverage"),
    **dict.fromkeys(
        _DEPTHS,
        (420, NEVER, "ARB_conservative_depth", "AMD_conservative_depth", "EXT_conservative_depth"),
    ),
    **dict.fromkeys(_BINDLESS, (NEVER, NEVER, "ARB_bindless_texture")),
    **dict.fromkeys(
        (f"blend_support_{name}" for name in _BLENDS),
        (NEVER, 320, "KHR_blend_equation_advanced"),
    ),
    "num_views": (NEVER, NEVER, "OVR_multiview", "OVR_multiview2"),
}


class LayoutChecker:
    """Checks ``layout(...)`` of declarations and remembers which locations are taken."""

    def __init__(self, context: Context, expressions: ExpressionChecker) -> None:
        self._context = context
        self._check = expressions.check
        self._values = expressions.constants.values
        self._taken: dict[tuple[str, int, int, int], str] = {}

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
            # Only GLSL ES tells small letters from capitals here (section 4.4 of 4.60).
            word = item.name if self._context.es else item.name.lower()
            problem = self._unknown(word) or _misplaced(word, names, member, default)
            if problem is not None:
                hint = did_you_mean(word, _SINCE) if word not in _SINCE else None
                self._context.error("SC223", problem, item, hint)
            number = None if item.value is None else self._number(word, item.value)
            if number is not None:
                values[word] = number
        return values

    def _unknown(self, word: str) -> str | None:
        """What is wrong with a word, wherever it stands."""
        if word not in _SINCE:
            return f"'{word}' is no layout qualifier"
        desktop, es, *extensions = _SINCE[word]
        context = self._context
        if context.at_least(desktop, es):
            return None
        for name in extensions:
            if f"GL_{name}" in context.extensions and context.at_least(_NEEDS.get(name, 0), 0):
                return None
        return f"this version of GLSL has no layout qualifier '{word}'"

    def _number(self, name: str, value: Expr) -> int | None:
        kind, number = self._check(value), self._values.get(value)
        if kind is ERROR:
            return None
        if not isinstance(value, Literal) and not self._takes_expressions():
            message = f"before GLSL 4.40 the layout value of '{name}' is a plain number"
            self._context.error("SC223", message, value)
            return None
        if kind in (INT, UINT) and isinstance(number, int) and number >= 0:
            return number
        message = f"the layout value of '{name}' is a constant integer, not negative"
        self._context.error("SC223", message, value)
        return None

    def _takes_expressions(self) -> bool:
        context = self._context
        enhanced = "GL_ARB_enhanced_layouts" in context.extensions and context.version >= 150
        return enhanced or context.at_least(440, NEVER)

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
        elif kind is not ERROR and self._exclusive(storage):
            self._take(node, name, kind, storage, values)

    def place_members(self, block: BlockDecl, storage: str, fields: Mapping[str, Type]) -> None:
        """Check the layouts of a block and of its members, and where these stand: one behind the
        other, unless they say otherwise (4.40 section 4.4.1)."""
        at = self.check(block.qualifiers, default=True).get("location")
        context = self._context
        if at is not None and not self._takes_block_locations():
            context.error("SC223", "this version of GLSL has no locations of blocks", block)
        for decl in block.fields:
            values = self.check(decl.qualifiers, member=True)
            if "location" in values and block.dims:
                message = "a member of an array of blocks has no location of its own"
                context.error("SC223", message, decl)
            at = values.get("location", at)
            for node in decl.declarators:
                kind = fields[node.name]
                if at is None or kind is ERROR or storage not in ("in", "out") or block.dims:
                    continue
                self._take(node, node.name, kind, storage, {**values, "location": at})
                at += kind.slots

    def _takes_block_locations(self) -> bool:
        context = self._context
        enhanced = not context.extensions.isdisjoint(_BLOCK_LOCATIONS)
        return enhanced or context.at_least(440, 320)

    def _since(self, storage: str) -> int:
        known = _LOCATION_SINCE.get((self._context.stage, storage))
        extensions = self._context.extensions
        if "GL_ARB_enhanced_layouts" in extensions or (known and _LOCATING in extensions):
            return 0
        if storage == "uniform":
            return _ES_SINCE["uniform"] if self._context.es else _UNIFORM_SINCE
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
        if "component" in values and max(_components(kind, values), default=0) > 3:
            message = f"'{name}' of type {kind} does not fit behind that component"
            self._context.error("SC223", message, node)
            return
        first = values["location"]
        for step in range(min(kind.slots, _MAX_LOCATIONS)):
            # The second half of dvec3 and dvec4 stands in a location of its own.
            second = step % 2 == 1 and kind.base == "double" and kind.rows > 2
            used = range(2 * (kind.rows - 2)) if second else _components(kind, values)
            for component in used:
                key = (storage, first + step, component, values.get("index", 0))
                other = self._taken.setdefault(key, name)
                if other != name:
                    message = f"'{name}' and '{other}' share the location {first + step}"
                    self._context.error("SC223", message, node)
                    return


def _components(kind: Type, values: Mapping[str, int]) -> range:
    """Which components of its (first) location a variable takes."""
    if kind.base is None or kind.cols > 1:
        return range(4)
    width = kind.rows * (2 if kind.base == "double" else 1)
    start = values.get("component", 0)
    return range(start, start + min(width, 4))


def _misplaced(word: str, names: Sequence[str], member: bool, default: bool) -> str | None:
    """Why a layout word cannot stand where it does."""
    if word in _PACKINGS and not default:
        return f"'{word}' is for uniform blocks"
    if word in _ORDERS and not (default or member):
        return f"'{word}' is for uniform blocks and their members"
    if word in _ORIGINS and list(names) != ["gl_FragCoord"]:
        return f"'{word}' is for gl_FragCoord"
    return None
