"""The words of ``layout(...)``: since when they are there, and what they stand on (GLSL 4.60
section 4.4, the table at its end)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from shadercache.lang.types import Type
from shadercache.sema.facts import Stage
from shadercache.sema.language import NEVER, Language

PACKINGS = ("shared", "packed", "std140", "std430")
ORDERS = ("row_major", "column_major")
_DEPTHS = ("depth_any", "depth_greater", "depth_less", "depth_unchanged")
_INTERLOCKS = tuple(
    f"{what}_interlock_{order}"
    for what in ("pixel", "sample")
    for order in ("ordered", "unordered")
)
_BLENDS = (
    *("multiply", "screen", "overlay", "darken", "lighten", "colordodge", "colorburn", "hardlight"),
    *("softlight", "difference", "exclusion", "hsl_hue", "hsl_saturation", "hsl_color"),
    *("hsl_luminosity", "all_equations"),
)
_FORMATS = frozenset(
    (
        *(f"{channels}{bits}{kind}" for channels in ("r", "rg", "rgba") for bits in (8, 16, 32)
          for kind in ("f", "i", "ui", "_snorm", "") if (kind, bits) not in (("f", 8), ("", 32))),
        *("r11f_g11f_b10f", "rgb10_a2", "rgb10_a2ui"),
    )
)  # fmt: skip

# What a layout stands on: the form of a declaration, and how that is stored.
_BUFFERS = ("block uniform", "block buffer")
_MEMBERS = ("member uniform", "member buffer")
_DEFAULTS = ("default uniform", "default buffer")
_BOUND = ("variable uniform", *_BUFFERS)
_PASSED = ("variable in", "variable out", "member in", "member out")


class LayoutWord(NamedTuple):
    """``since``: first desktop and ES version, and the extensions that have the word; ``on``: what
    it stands on, everything where that is empty; ``variable``: the only one that it is for."""

    since: tuple[int, int, *tuple[str, ...]] = (0, 0)
    on: tuple[str, ...] = ()
    valued: bool = False
    stage: Stage | None = None
    variable: str | None = None


_IMAGES = (420, 310, "ARB_shader_image_load_store")
_ENHANCED = (440, NEVER, "ARB_enhanced_layouts")
_ORIGIN = (140, NEVER, "ARB_fragment_coord_conventions")
_DEPTHS_SINCE = (
    420,
    NEVER,
    "ARB_conservative_depth",
    "AMD_conservative_depth",
    "EXT_conservative_depth",
)
_COVERAGE = (NEVER, NEVER, "ARB_post_depth_coverage", "EXT_post_depth_coverage")
_INTERLOCK = (NEVER, NEVER, "ARB_fragment_shader_interlock", "NV_fragment_shader_interlock")
_VIEWS = (NEVER, NEVER, "OVR_multiview", "OVR_multiview2")
_RELATIVE = (NEVER, NEVER, "NV_viewport_array2", "NV_stereo_view_rendering")
_VULKAN = (NEVER, NEVER, "KHR_vulkan_glsl")
_STEREO = (NEVER, NEVER, "NV_stereo_view_rendering")

WORDS: Mapping[str, LayoutWord] = {
    # Since when depends on stage and storage, and is told where locations are given out.
    "location": LayoutWord(on=(*_PASSED, "block in", "block out", "variable uniform"), valued=True),
    "component": LayoutWord(_ENHANCED, _PASSED, valued=True),
    "index": LayoutWord((0, 310, "EXT_blend_func_extended"), ("variable out",), True, "fragment"),
    **dict.fromkeys(PACKINGS, LayoutWord(on=(*_BUFFERS, *_DEFAULTS))),
    "std430": LayoutWord(
        (430, 310, "ARB_shader_storage_buffer_object"), ("block buffer", "default buffer")
    ),
    **dict.fromkeys(ORDERS, LayoutWord(on=(*_BUFFERS, *_MEMBERS, *_DEFAULTS))),
    "binding": LayoutWord((420, 310, "ARB_shading_language_420pack"), _BOUND, valued=True),
    "push_constant": LayoutWord(_VULKAN, ("block uniform",)),
    "constant_id": LayoutWord(_VULKAN, valued=True),
    "input_attachment_index": LayoutWord(_VULKAN, ("variable uniform",), valued=True),
    # Vulkan's: an OpenGL program has the set 0 alone, and compilers take that.
    "set": LayoutWord(on=_BOUND, valued=True),
    "offset": LayoutWord(
        (420, 310, "ARB_enhanced_layouts", "ARB_shader_atomic_counters"),
        ("variable uniform", *_MEMBERS),
        valued=True,
    ),
    "align": LayoutWord(_ENHANCED, (*_BUFFERS, *_MEMBERS), valued=True),
    **dict.fromkeys(
        ("origin_upper_left", "pixel_center_integer"),
        LayoutWord(_ORIGIN, ("variable in", "default in"), variable="gl_FragCoord"),
    ),
    **dict.fromkeys(
        _DEPTHS,
        LayoutWord(_DEPTHS_SINCE, ("variable out",), variable="gl_FragDepth"),
    ),
    **dict.fromkeys(
        _FORMATS,
        LayoutWord(_IMAGES, ("variable in", "variable out", "variable uniform", "default uniform")),
    ),
    "early_fragment_tests": LayoutWord(_IMAGES, ("default in",), stage="fragment"),
    "post_depth_coverage": LayoutWord(_COVERAGE, ("default in",), stage="fragment"),
    "override_coverage": LayoutWord(
        (NEVER, NEVER, "NV_sample_mask_override_coverage"),
        ("variable out",),
        variable="gl_SampleMask",
    ),
    **dict.fromkeys(
        ("bindless_sampler", "bindless_image", "bound_sampler", "bound_image"),
        LayoutWord((NEVER, NEVER, "ARB_bindless_texture")),
    ),
    **dict.fromkeys(
        (f"blend_support_{name}" for name in _BLENDS),
        LayoutWord((NEVER, 320, "KHR_blend_equation_advanced"), ("default out",)),
    ),
    "num_views": LayoutWord(_VIEWS, ("default in",), True, "vertex"),
    "viewport_relative": LayoutWord(_RELATIVE, ("variable out",), variable="gl_Layer"),
    "secondary_view_offset": LayoutWord(_STEREO, ("variable out",), True, variable="gl_Layer"),
    # Where feedback and interlocks may stand is left to the reference compiler.
    **dict.fromkeys(("xfb_buffer", "xfb_stride", "xfb_offset"), LayoutWord(_ENHANCED, valued=True)),
    **dict.fromkeys(_INTERLOCKS, LayoutWord(_INTERLOCK)),
}

# First desktop version of the extensions that need one.
_NEEDS = {"ARB_enhanced_layouts": 150, "ARB_shader_storage_buffer_object": 150}

_FORMS = {
    "variable": "'{}' variables",
    "block": "'{}' blocks",
    "member": "members of '{}' blocks",
    "default": "'{}' alone",
}


class LayoutPlace(NamedTuple):
    """What a layout stands on.

    ``form`` is ``variable``, ``block``, ``member`` of a block or ``default`` for what follows;
    ``storage`` is how that is stored, ``name`` and ``type`` what it is, where it has any.
    """

    form: str
    storage: str
    name: str | None = None
    type: Type | None = None


def word_problem(word: str, valued: bool, place: LayoutPlace, language: Language) -> str | None:
    """Why a layout word cannot stand where it does; ``None`` if it can."""
    entry = WORDS.get(word)
    if entry is None:
        return f"'{word}' is no layout qualifier"
    if not _is_known(entry, language):
        return f"this version of GLSL has no layout qualifier '{word}'"
    if valued != entry.valued:
        return f"'{word}' takes no value" if valued else f"'{word}' needs a value: {word} = 0"
    if entry.stage not in (None, language.stage):
        return f"a {language.stage} shader has no layout qualifier '{word}'"
    # The extension lays out uniform blocks like this as well, and Vulkan push constants.
    laid_out = language.vulkan or "GL_EXT_scalar_block_layout" in language.extensions
    if word == "std430" and laid_out:
        return None
    if entry.on and f"{place.form} {place.storage}" not in entry.on:
        return f"'{word}' does not apply to {_FORMS[place.form].format(place.storage)}"
    if place.form != "variable":
        return None
    if entry.variable not in (None, place.name):
        return f"'{word}' is for {entry.variable}"
    # `<error>`: the type is wrong, which is told already.
    if place.type is None or place.type.name.startswith("<"):
        return None
    return _wrong_type(word, place.type, language)


def _is_known(entry: LayoutWord, language: Language) -> bool:
    desktop, es, *extensions = entry.since
    if language.at_least(desktop, es):
        return True
    return any(
        f"GL_{name}" in language.extensions and language.at_least(_NEEDS.get(name, 0), 0)
        for name in extensions
    )


def _wrong_type(word: str, kind: Type, language: Language) -> str | None:
    if word in _FORMATS and "image" not in kind.name:
        return f"'{word}' is a format of images, not of {kind}"
    if word == "binding" and not kind.holds_opaque and not language.bindless:
        return f"'binding' is for blocks, samplers, images and atomic counters, not for {kind}"
    if word == "offset" and kind.name != "atomic_uint":
        return f"'offset' is for members of blocks and for atomic counters, not for {kind}"
    if word == "component" and (kind.cols > 1 or kind.struct is not None):
        return f"'component' does not apply to {kind}"
    return None
