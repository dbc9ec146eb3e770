"""The words and operators of GLSL: keywords, type names, reserved words, precedences.

Source: section 3.6 (keywords) of the specifications from 1.10 to 4.60 and of GLSL ES 1.00 to 3.20,
and section 5.1 (operators). Where compilers are laxer than the text (``image1DShadow`` is reserved
and every driver takes it) they are followed. The parser folds operator chains by the same
precedence table that the printer sets parentheses by, so the two cannot disagree.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cache

# --- keywords and reserved words ------------------------------------------------------------------

_NEVER = 9999
_NO_EXTENSIONS: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class _Row:
    """Words with the same history: since (and until) which version they are keywords or reserved.

    ``extensions``: the words are keywords where any of these is on, in the version
    ``extended_since`` and later ones.
    """

    words: frozenset[str]
    desktop: int
    es: int
    reserved: int = _NEVER
    reserved_es: int = _NEVER
    es_until: int = _NEVER
    extensions: frozenset[str] = _NO_EXTENSIONS
    extended_since: int = 0

    def is_keyword(self, version: int, es: bool, extensions: frozenset[str]) -> bool:
        """Has a shader of this version these keywords?"""
        since = self.es if es else self.desktop
        if since <= version <= (self.es_until if es else _NEVER):
            return True
        extended = not self.extensions.isdisjoint(extensions)
        return extended and version >= self.extended_since


def _row(
    words: str | Iterable[str],
    desktop: int,
    es: int,
    *,
    reserved: tuple[int, int] = (_NEVER, _NEVER),
    ext: str = "",
) -> _Row:
    split = words.split() if isinstance(words, str) else words
    extensions = frozenset("GL_" + name for name in ext.split())
    return _Row(frozenset(split), desktop, es, *reserved, extensions=extensions)


def _since(version: int, row: _Row) -> _Row:
    """The row where its extensions begin with a version."""
    return replace(row, extended_since=version)


def _with_int_kinds(names: str) -> tuple[str, ...]:
    """Each opaque type with its signed and unsigned integer twin."""
    return tuple(kind + name for name in names.split() for kind in ("", "i", "u"))


def _int_kinds(names: str) -> tuple[str, ...]:
    """The signed and unsigned integer twins of opaque types."""
    return tuple(kind + name for name in names.split() for kind in ("i", "u"))


_MATRICES = tuple(f"mat{columns}x{rows}" for columns in (2, 3, 4) for rows in (2, 3, 4))
_IMAGES = "ARB_shader_image_load_store EXT_shader_image_load_store"
_GPU5 = "EXT_gpu_shader5 OES_gpu_shader5 ARB_gpu_shader5 ANDROID_extension_pack_es31a"
_CUBE_ARRAYS = "ARB_texture_cube_map_array EXT_texture_cube_map_array OES_texture_cube_map_array"
_BUFFERS = "EXT_texture_buffer OES_texture_buffer ANDROID_extension_pack_es31a"
_FP64 = "ARB_gpu_shader_fp64 ARB_vertex_attrib_64bit"
_INT64 = "ARB_gpu_shader_int64 EXT_shader_explicit_arithmetic_types_int64"
_RECTANGLES = "ARB_texture_rectangle"

_TYPES = (
    _row("void bool int float vec2 vec3 vec4 bvec2 bvec3 bvec4 ivec2 ivec3 ivec4", 0, 0),
    _row("mat2 mat3 mat4 sampler2D samplerCube", 0, 0),
    _row("sampler1D sampler1DShadow", 0, _NEVER, reserved=(0, 0)),
    _row("sampler2DShadow", 0, 300, reserved=(0, 0), ext="EXT_shadow_samplers"),
    _row("sampler3D", 0, 300, reserved=(0, 0), ext="OES_texture_3D"),
    _row(_MATRICES, 120, 300),
    _row("uint uvec2 uvec3 uvec4", 130, 300, ext="EXT_gpu_shader4"),
    _row(_int_kinds("sampler2D sampler2DArray sampler3D samplerCube"), 130, 300,
         ext="EXT_gpu_shader4"),
    _row("sampler2DArray", 130, 300, ext="EXT_gpu_shader4 EXT_texture_array"),
    _row("sampler2DArrayShadow", 130, 300, ext="EXT_gpu_shader4 EXT_texture_array"),
    _row("samplerCubeShadow", 130, 300, ext="EXT_gpu_shader4"),
    _row("sampler1DArray sampler1DArrayShadow", 130, _NEVER, reserved=(_NEVER, 300),
         ext="EXT_gpu_shader4 EXT_texture_array"),
    _row(_int_kinds("sampler1D sampler1DArray"), 130, _NEVER, reserved=(_NEVER, 300),
         ext="EXT_gpu_shader4"),
    _row("sampler2DRect sampler2DRectShadow", 140, _NEVER, reserved=(0, 0),
         ext=_RECTANGLES),
    _row(_int_kinds("sampler2DRect"), 140, _NEVER, reserved=(_NEVER, 300),
         ext="EXT_gpu_shader4"),
    _row("samplerBuffer", 130, 320, reserved=(_NEVER, 300),
         ext=f"{_BUFFERS} EXT_gpu_shader4"),
    _row("isamplerBuffer usamplerBuffer", 140, 320, reserved=(_NEVER, 300),
         ext=f"{_BUFFERS} EXT_gpu_shader4 ARB_texture_buffer_object"),
    _row(_with_int_kinds("sampler2DMS"), 150, 310, reserved=(_NEVER, 300),
         ext="ARB_texture_multisample"),
    _row(_with_int_kinds("sampler2DMSArray"), 150, 320, reserved=(_NEVER, 300),
         ext="ARB_texture_multisample OES_texture_storage_multisample_2d_array"),
    _since(150, _row("double dvec2 dvec3 dvec4", 400, _NEVER, reserved=(0, 0), ext=_FP64)),
    _since(150, _row((f"d{name}" for name in ("mat2", "mat3", "mat4", *_MATRICES)), 400, _NEVER,
                     reserved=(_NEVER, 300), ext=_FP64)),
    _row(("samplerCubeArrayShadow", *_with_int_kinds("samplerCubeArray")), 400, 320,
         reserved=(0, 0), ext=f"{_CUBE_ARRAYS} ANDROID_extension_pack_es31a"),
    _row("atomic_uint", 420, 310, reserved=(_NEVER, 300),
         ext="ARB_shader_atomic_counters"),
    _row(_with_int_kinds("image2D image2DArray image3D imageCube"), 420, 310,
         reserved=(130, 300), ext=_IMAGES),
    _row(_with_int_kinds("image1D image1DArray image2DRect"), 420, _NEVER,
         reserved=(130, 300), ext=_IMAGES),
    _row(_with_int_kinds("imageBuffer"), 420, 320, reserved=(130, 300),
         ext=f"{_IMAGES} {_BUFFERS}"),
    _row(_with_int_kinds("imageCubeArray"), 420, 320, reserved=(_NEVER, 310),
         ext=f"{_IMAGES} {_CUBE_ARRAYS} ANDROID_extension_pack_es31a"),
    _row(_with_int_kinds("image2DMS image2DMSArray"), 420, _NEVER,
         reserved=(_NEVER, 310), ext=_IMAGES),
    _since(400, _row("int64_t uint64_t", _NEVER, _NEVER, ext=_INT64)),
    _since(400, _row((f"{sign}64vec{size}" for sign in "iu" for size in (2, 3, 4)),
                     _NEVER, _NEVER, ext=_INT64)),
    _row("samplerExternalOES", _NEVER, _NEVER,
         ext="OES_EGL_image_external OES_EGL_image_external_essl3"),
)  # fmt: skip

_QUALIFIERS = (
    _row("const in out inout uniform", 0, 0),
    replace(_row("attribute varying", 0, 0, reserved=(_NEVER, 300)), es_until=100),
    _row("highp mediump lowp", 130, 0),
    _row("invariant", 120, 0),
    _row("centroid", 120, 300, ext="EXT_gpu_shader4"),
    _row("flat", 130, 300, reserved=(_NEVER, 0), ext="EXT_gpu_shader4"),
    _row("smooth", 130, 300),
    _row("noperspective", 130, _NEVER, reserved=(_NEVER, 300),
         ext="EXT_gpu_shader4 NV_shader_noperspective_interpolation"),
    _row("pervertexEXT", _NEVER, _NEVER, ext="EXT_fragment_shader_barycentric"),
    _row("pervertexNV", _NEVER, _NEVER, ext="NV_fragment_shader_barycentric"),
    _row("__explicitInterpAMD", _NEVER, _NEVER,
         ext="AMD_shader_explicit_vertex_parameter"),
    _row("precise", 400, 320, reserved=(_NEVER, 310), ext=_GPU5),
    _row("patch", 400, 320, reserved=(_NEVER, 300),
         ext="ARB_tessellation_shader EXT_tessellation_shader OES_tessellation_shader"),
    _row("sample", 400, 320, reserved=(_NEVER, 300),
         ext="ARB_gpu_shader5 OES_shader_multisample_interpolation ANDROID_extension_pack_es31a"),
    _row("volatile", 420, 310, reserved=(0, 0), ext=_IMAGES),
    _row("coherent restrict readonly writeonly", 420, 310, reserved=(_NEVER, 300),
         ext=f"{_IMAGES} ARB_shader_storage_buffer_object"),
    _row("buffer", 430, 310, ext="ARB_shader_storage_buffer_object"),
    _row("shared", 140, 300),
)  # fmt: skip

_STATEMENTS = (
    _row("if else for while do break continue return discard struct", 0, 0),
    _row("switch case default", 130, 300, reserved=(0, 0), ext="EXT_gpu_shader4"),
    _row("precision", 130, 0),
    _row("layout", 140, 300,
         ext="ARB_explicit_attrib_location ARB_shading_language_420pack "
             "ARB_uniform_buffer_object ARB_fragment_coord_conventions"),
    _row("demote", _NEVER, _NEVER, ext="EXT_demote_to_helper_invocation"),
)  # fmt: skip

_RESERVED = (
    _row("active asm cast class common enum extern external filter fixed",
         _NEVER, _NEVER, reserved=(0, 0)),
    _row("goto half inline input interface long namespace noinline output partition",
         _NEVER, _NEVER, reserved=(0, 0)),
    _row("public sampler3DRect short sizeof static template this typedef union",
         _NEVER, _NEVER, reserved=(0, 0)),
    _row("unsigned using hvec2 hvec3 hvec4 fvec2 fvec3 fvec4", _NEVER, _NEVER,
         reserved=(0, 0)),
    _row("superp", _NEVER, _NEVER, reserved=(130, 0)),
    _row("resource", _NEVER, _NEVER, reserved=(420, 300)),
    # The keyword of subroutines, which are refused.
    _row("subroutine", _NEVER, _NEVER, reserved=(400, 300)),
)  # fmt: skip

_PACKED_UNTIL = 130
_ROWS = (*_TYPES, *_QUALIFIERS, *_STATEMENTS, *_RESERVED)

PRECISIONS = frozenset(("highp", "mediump", "lowp"))
MEMORY_QUALIFIERS = ("coherent", "volatile", "restrict", "readonly", "writeonly")
BUILTIN_STRUCTS = frozenset(
    (
        *("gl_DepthRangeParameters", "gl_PointParameters", "gl_MaterialParameters"),
        *("gl_LightSourceParameters", "gl_LightModelParameters", "gl_LightModelProducts"),
        *("gl_LightProducts", "gl_FogParameters"),
    )
)
"""The structs that are declared from the start (section 7.4.1 of 4.60)."""

TRUTH_WORDS = frozenset(("true", "false"))
STATEMENT_WORDS: frozenset[str] = frozenset(word for row in _STATEMENTS for word in row.words)
"""The words that begin or divide statements, in any version."""

VERSIONS = (110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460)
ES_VERSIONS = (100, 300, 310, 320)

QUALIFIER_ORDER: dict[str, int] = {
    word: rank
    for rank, group in enumerate(
        (
            ("precise",),
            ("invariant",),
            ("smooth", "flat", "noperspective"),
            ("pervertexEXT", "pervertexNV", "__explicitInterpAMD"),
            ("const", "centroid", "patch", "sample"),
            MEMORY_QUALIFIERS,
            ("in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying"),
            ("highp", "mediump", "lowp"),
        )
    )
    for word in group
}
"""The order that versions before 4.20 demand of qualifiers; layouts may stand anywhere in it, and
so may what is said about memory, but that Mesa wants it ahead of the storage of a block."""


def _words_of(
    rows: tuple[_Row, ...], version: int, es: bool, extensions: frozenset[str]
) -> frozenset[str]:
    found = (row.words for row in rows if row.is_keyword(version, es, extensions))
    return frozenset().union(*found)


@cache
def type_names(
    version: int, es: bool = False, extensions: frozenset[str] = _NO_EXTENSIONS
) -> frozenset[str]:
    """The names of the types that are built into a version.

    ``version`` is the number of ``#version`` (100 to 460), ``es``: it is one of GLSL ES;
    ``extensions`` are those that ``#extension`` turned on. The same for the other functions.
    """
    return _words_of(_TYPES, version, es, extensions)


@cache
def qualifier_words(
    version: int, es: bool = False, extensions: frozenset[str] = _NO_EXTENSIONS
) -> frozenset[str]:
    """The qualifier keywords of a version."""
    return _words_of(_QUALIFIERS, version, es, extensions)


@cache
def keywords(
    version: int, es: bool = False, extensions: frozenset[str] = _NO_EXTENSIONS
) -> frozenset[str]:
    """Every word that a version gives a meaning to."""
    return _words_of(_ROWS, version, es, extensions) | TRUTH_WORDS


@cache
def reserved_words(
    version: int, es: bool = False, extensions: frozenset[str] = _NO_EXTENSIONS
) -> frozenset[str]:
    """Words that a version reserves without giving them a meaning."""
    found = (r.words for r in _ROWS if version >= (r.reserved_es if es else r.reserved))
    packed = frozenset(("packed",)) if version <= _PACKED_UNTIL else frozenset()
    return (packed.union(*found)) - keywords(version, es, extensions)


def keyword_since(word: str, es: bool = False) -> int | None:
    """The first version that gives the word a meaning without an extension, or ``None``."""
    return next((v for v in (ES_VERSIONS if es else VERSIONS) if word in keywords(v, es)), None)


ALL_WORDS: frozenset[str] = frozenset(("packed",)).union(*(r.words for r in _ROWS)) | TRUTH_WORDS
"""Every word that is a keyword or reserved in some version. A fresh name keeps clear of them."""

# --- operators ------------------------------------------------------------------------------------

COMMA = 1
ASSIGN = 2
CONDITIONAL = 3
UNARY = 15
POSTFIX = 16
PRIMARY = 17

PRECEDENCE: dict[str, int] = {
    "||": 4,
    "^^": 5,
    "&&": 6,
    "|": 7,
    "^": 8,
    "&": 9,
    **dict.fromkeys(("==", "!="), 10),
    **dict.fromkeys(("<", ">", "<=", ">="), 11),
    **dict.fromkeys(("<<", ">>"), 12),
    **dict.fromkeys(("+", "-"), 13),
    **dict.fromkeys(("*", "/", "%"), 14),
}
"""Binary operators; a higher number binds tighter, and all associate to the left."""

ASSIGN_OPS: frozenset[str] = frozenset(
    ("=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|=")
)
SIGN_OPS = frozenset(("+", "-"))
PREFIX_OPS = frozenset(("!", "~"))
STEP_OPS = frozenset(("++", "--"))
