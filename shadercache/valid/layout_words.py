"""The words of ``layout(...)``: since when they are there, and what they stand on (GLSL 4.60
section 4.4, the table at its end)."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.lang.types import Type
from shadercache.sema.language import NEVER, Language

_PACKINGS = ("shared", "packed", "std140", "std430")
_ORDERS = ("row_major", "column_major")
_ORIGINS = ("origin_upper_left", "pixel_center_integer")
_BINDLESS = ("bindless_sampler", "bindless_image", "bound_sampler", "bound_image")
_DEPTHS = ("depth_any", "depth_greater", "depth_less", "depth_unchanged")
_INTERLOCKS = (
    *("pixel_interlock_ordered", "pixel_interlock_unordered"),
    *("sample_interlock_ordered", "sample_interlock_unordered"),
)
_BLENDS = (
    *("multiply", "screen", "overlay", "darken", "lighten", "colordodge", "colorburn", "hardlight"),
    *("softlight", "difference", "exclusion", "hsl_hue", "hsl_saturation", "hsl_color"),
    *("hsl_luminosity", "all_equations"),
)
IMAGE_FORMATS = frozenset(
    (
        *(f"{channels}{bits}{kind}" for channels in ("r", "rg", "rgba") for bits in (8, 16, 32)
          for kind in ("f", "i", "ui", "_snorm", "") if (kind, bits) not in (("f", 8), ("", 32))),
        *("r11f_g11f_b10f", "rgb10_a2", "rgb10_a2ui"),
    )
)  # fmt: skip

# Words with a value.
VALUED = frozenset(
    (
        *("location", "component", "index", "binding", "offset", "align", "num_views", "set"),
        *("xfb_buffer", "xfb_stride", "xfb_offset", "secondary_view_offset"),
    )
)

# First desktop version of the extensions that need one.
_NEEDS = {"ARB_enhanced_layouts": 150, "ARB_shader_storage_buffer_object": 150}
_ENHANCED = (440, NEVER, "ARB_enhanced_layouts")

# First desktop and ES version of each word, and the extensions that have it.
SINCE: dict[str, tuple[int, int, *tuple[str, ...]]] = {
    **dict.fromkeys(("location", "shared", "packed", "std140", *_ORDERS), (0, 0)),
    "index": (0, 310, "EXT_blend_func_extended"),
    "std430": (430, 310, "ARB_shader_storage_buffer_object"),
    **dict.fromkeys(_ORIGINS, (140, NEVER, "ARB_fragment_coord_conventions")),
    **dict.fromkeys(IMAGE_FORMATS, (420, 310, "ARB_shader_image_load_store")),
    "binding": (420, 310, "ARB_shading_language_420pack"),
    # Vulkan's: an OpenGL program has the set 0 alone, and compilers take that.
    "set": (0, 0),
    "offset": (420, 310, "ARB_enhanced_layouts", "ARB_shader_atomic_counters"),
    **dict.fromkeys(("component", "align", "xfb_buffer", "xfb_stride", "xfb_offset"), _ENHANCED),
    "early_fragment_tests": (420, 310, "ARB_shader_image_load_store"),
    "post_depth_coverage": (NEVER, NEVER, "ARB_post_depth_coverage", "EXT_post_depth_coverage"),
    **dict.fromkeys(
        _INTERLOCKS,
        (NEVER, NEVER, "ARB_fragment_shader_interlock", "NV_fragment_shader_interlock"),
    ),
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
    "override_coverage": (NEVER, NEVER, "NV_sample_mask_override_coverage"),
    "viewport_relative": (NEVER, NEVER, "NV_viewport_array2", "NV_stereo_view_rendering"),
    "secondary_view_offset": (NEVER, NEVER, "NV_stereo_view_rendering"),
}

_BUFFERS = ("block uniform", "block buffer")
_MEMBERS = ("member uniform", "member buffer")
_DEFAULTS = ("default uniform", "default buffer")
_PASSED = ("variable in", "variable out", "block in", "block out", "member in", "member out")
_FEEDBACK = ("variable out", "block out", "member out")

# The forms of declarations that a word may stand in.
_PLACES: dict[str, tuple[str, ...]] = {
    "location": (*_PASSED, "variable uniform"),
    "component": ("variable in", "variable out", "member in", "member out"),
    "index": ("variable out",),
    **dict.fromkeys(("binding", "set"), ("variable uniform", *_BUFFERS)),
    "offset": ("variable uniform", *_MEMBERS),
    "align": (*_BUFFERS, *_MEMBERS),
    **dict.fromkeys(_PACKINGS, (*_BUFFERS, *_DEFAULTS)),
    "std430": ("block buffer", "default buffer"),
    **dict.fromkeys(_ORDERS, (*_BUFFERS, *_MEMBERS, *_DEFAULTS)),
    **dict.fromkeys(_ORIGINS, ("variable in", "default in")),
    **dict.fromkeys(
        IMAGE_FORMATS, ("variable in", "variable out", "variable uniform", "default uniform")
    ),
    **dict.fromkeys(
        ("early_fragment_tests", "post_depth_coverage", *_INTERLOCKS, "num_views"),
        ("default in",),
    ),
    **dict.fromkeys(_DEPTHS, ("variable out",)),
    **dict.fromkeys((f"blend_support_{name}" for name in _BLENDS), ("default out",)),
    **dict.fromkeys(("xfb_buffer", "xfb_stride"), (*_FEEDBACK, "default out")),
    "xfb_offset": _FEEDBACK,
    **dict.fromkeys(
        ("override_coverage", "viewport_relative", "secondary_view_offset"), ("variable out",)
    ),
}
_FRAGMENT = frozenset(("early_fragment_tests", "post_depth_coverage", "index", *_INTERLOCKS))
_VERTEX = frozenset(("xfb_buffer", "xfb_stride", "xfb_offset", "num_views"))
_ONLY_ON = {
    **dict.fromkeys(_ORIGINS, "gl_FragCoord"),
    **dict.fromkeys(_DEPTHS, "gl_FragDepth"),
    "override_coverage": "gl_SampleMask",
    "viewport_relative": "gl_Layer",
    "secondary_view_offset": "gl_Layer",
}


@dataclass(frozen=True, slots=True)
class LayoutPlace:
    """What a layout stands on.

    ``form`` is ``variable``, ``block``, ``member`` of a block, ``default`` for what follows, or the
    name of something that has no layout at all; ``storage`` is how that is stored, ``names`` and
    ``type`` what it is, where it has any.
    """

    form: str
    storage: str
    names: tuple[str, ...] = ()
    type: Type | None = None

    def __str__(self) -> str:
        return f"{self.form} {self.storage}"


def word_problem(word: str, valued: bool, place: LayoutPlace, language: Language) -> str | None:
    """Why a layout word cannot stand where it does; ``None`` if it can."""
    if word not in SINCE:
        return f"'{word}' is no layout qualifier"
    if not _is_known(word, language):
        return f"this version of GLSL has no layout qualifier '{word}'"
    if valued != (word in VALUED):
        return f"'{word}' takes no value" if valued else f"'{word}' needs a value: {word} = 0"
    stages = (_FRAGMENT, _VERTEX) if language.stage == "vertex" else (_VERTEX, _FRAGMENT)
    if word in stages[0]:
        return f"a {language.stage} shader has no layout qualifier '{word}'"
    if word == "std430" and "GL_EXT_scalar_block_layout" in language.extensions:
        return None
    if str(place) not in _PLACES.get(word, (str(place),)):
        return f"'{word}' does not apply to {_described(place)}"
    only = _ONLY_ON.get(word)
    if only is not None and place.form == "variable" and place.names != (only,):
        return f"'{word}' is for {only}"
    return _wrong_type(word, place, language)


def _is_known(word: str, language: Language) -> bool:
    desktop, es, *extensions = SINCE[word]
    if language.at_least(desktop, es):
        return True
    return any(
        f"GL_{name}" in language.extensions and language.at_least(_NEEDS.get(name, 0), 0)
        for name in extensions
    )


def _wrong_type(word: str, place: LayoutPlace, language: Language) -> str | None:
    kind = place.type
    if kind is None or place.form != "variable" or kind.name.startswith("<"):
        return None
    if word in IMAGE_FORMATS and "image" not in kind.name:
        return f"'{word}' is a format of images, not of {kind}"
    if word == "binding" and not kind.holds_opaque and not language.bindless:
        return f"'binding' is for blocks, samplers, images and atomic counters, not for {kind}"
    if word == "offset" and kind.name != "atomic_uint":
        return f"'offset' is for members of blocks and for atomic counters, not for {kind}"
    if word == "component" and (kind.cols > 1 or kind.struct is not None):
        return f"'component' does not apply to {kind}"
    return None


def _described(place: LayoutPlace) -> str:
    storage = f"'{place.storage}'"
    forms = {
        "variable": f"{storage} variables",
        "block": f"{storage} blocks",
        "member": f"members of {storage} blocks",
        "default": f"{storage} alone",
    }
    return forms.get(place.form, place.form)
