"""Words of extensions that are known by name and not supported, and the extension of each.

Source: the extensions' texts in the OpenGL registry, and the tables of glslang.
"""

from __future__ import annotations

import re
from functools import cache

_SIZES = r"(?:vec[234]|mat[234](?:x[234])?)"
_ARITHMETIC = "GL_EXT_shader_explicit_arithmetic_types"

_INT64 = "GL_ARB_gpu_shader_int64"
"""The one among them that is supported, where it is turned on."""

_WORDS: tuple[tuple[str, str], ...] = (
    # Types.
    (rf"float16_t|f16{_SIZES}", f"{_ARITHMETIC}_float16"),
    (rf"float32_t|f32{_SIZES}", f"{_ARITHMETIC}_float32"),
    (rf"float64_t|f64{_SIZES}", f"{_ARITHMETIC}_float64"),
    (r"u?int8_t|[iu]8vec[234]", f"{_ARITHMETIC}_int8"),
    (r"u?int16_t|[iu]16vec[234]", f"{_ARITHMETIC}_int16"),
    (r"u?int32_t|[iu]32vec[234]", f"{_ARITHMETIC}_int32"),
    (r"u?int64_t|[iu]64vec[234]", _INT64),
    (r"f16(?:sampler|image|texture|subpassInput)\w+", "GL_AMD_gpu_shader_half_float_fetch"),
    (r"[iu]64(?:image|texture)\w+", "GL_EXT_shader_image_int64"),
    (r"bfloat16_t|bf16vec[234]", "GL_EXT_bfloat16"),
    (r"[fiu]?coopmat(?:NV)?|coopMat\w+", "GL_KHR_cooperative_matrix"),
    (r"accelerationStructure(?:EXT|NV)|traceRayEXT|rayPayload\w*EXT", "GL_EXT_ray_tracing"),
    (r"hitAttributeEXT|callableData\w*EXT|executeCallableEXT", "GL_EXT_ray_tracing"),
    (r"rayQuery\w*EXT", "GL_EXT_ray_query"),
    (r"[iu]?subpassInput(?:MS)?|subpassLoad", "GL_KHR_vulkan_glsl"),
    # Qualifiers.
    (r"perprimitive(?:EXT|NV)|taskPayloadSharedEXT|taskNV", "GL_EXT_mesh_shader"),
    (r"(?:device|queuefamily|workgroup|subgroup)coherent|nonprivate",
     "GL_KHR_memory_scope_semantics"),
    (r"shadercallcoherent", "GL_EXT_ray_tracing"),
    (r"nonuniformEXT", "GL_EXT_nonuniform_qualifier"),
    (r"buffer_reference\w*", "GL_EXT_buffer_reference"),
    # Functions.
    (r"sparse(?:Texture\w*Clamp)ARB|texture\w*ClampARB", "GL_ARB_sparse_texture_clamp"),
    (r"sparse\w+ARB", "GL_ARB_sparse_texture2"),
    (r"subgroup(?:All|Any|AllEqual)", "GL_KHR_shader_subgroup_vote"),
    (r"subgroup(?:Inclusive|Exclusive)?(?:Add|Mul|Min|Max|And|Or|Xor)",
     "GL_KHR_shader_subgroup_arithmetic"),
    (r"subgroupClustered\w+", "GL_KHR_shader_subgroup_clustered"),
    (r"subgroupQuad\w+", "GL_KHR_shader_subgroup_quad"),
    (r"subgroupShuffle(?:Up|Down)", "GL_KHR_shader_subgroup_shuffle_relative"),
    (r"subgroupShuffle\w*", "GL_KHR_shader_subgroup_shuffle"),
    (r"subgroup(?:Broadcast\w*|Ballot\w*|InverseBallot)|gl_Subgroup\w+Mask",
     "GL_KHR_shader_subgroup_ballot"),
    (r"subgroup\w+|gl_Subgroup\w+|gl_NumSubgroups", "GL_KHR_shader_subgroup_basic"),
    (r"ballotARB|read(?:First)?InvocationARB|gl_SubGroup\w+ARB", "GL_ARB_shader_ballot"),
    (r"(?:any|all)Invocations?(?:Equal)?ARB", "GL_ARB_shader_group_vote"),
    (r"(?:swizzleInvocations|writeInvocation|mbcnt|\w+Invocations\w*)\w*AMD",
     "GL_AMD_shader_ballot"),
    (r"(?:min|max|mid)3", "GL_AMD_shader_trinary_minmax"),
    (r"texture\w*Gather(?:Lod)\w*AMD", "GL_AMD_texture_gather_bias_lod"),
    (r"image(?:Load|Store)LodAMD|sparseImageLoadLodAMD", "GL_AMD_shader_image_load_store_lod"),
    (r"fragment(?:Mask)?FetchAMD", "GL_AMD_shader_fragment_mask"),
    (r"cubeFace(?:Index|Coord)AMD|timeAMD", "GL_AMD_gcn_shader"),
    (r"interpolateAtVertexAMD", "GL_AMD_shader_explicit_vertex_parameter"),
    (r"(?:un)?packFloat2x16|(?:un)?pack(?:16|32|64|8)|(?:half|int16|uint16)BitsTo\w+",
     _ARITHMETIC),
    (r"clock(?:2x32)?ARB", "GL_ARB_shader_clock"),
    (r"clockRealtime(?:2x32)?EXT", "GL_EXT_shader_realtime_clock"),
    (r"debugPrintfEXT", "GL_EXT_debug_printf"),
    (r"textureFootprint\w*NV", "GL_NV_shader_texture_footprint"),
    (r"subgroupPartition\w*NV", "GL_NV_shader_subgroup_partitioned"),
    (r"gl_FragSizeEXT|gl_FragInvocationCountEXT", "GL_EXT_fragment_invocation_density"),
    (r"gl_ShadingRateEXT|gl_PrimitiveShadingRateEXT", "GL_EXT_fragment_shading_rate"),
    (r"gl_DeviceIndex", "GL_EXT_device_group"),
    (r"gl_FragFullyCoveredNV", "GL_NV_conservative_raster_underestimation"),
    (r"beginInvocationInterlockNV|endInvocationInterlockNV", "GL_NV_fragment_shader_interlock"),
)  # fmt: skip


@cache
def unsupported_extension(word: str) -> str | None:
    """The extension that gives ``word`` a meaning, where the word has none here."""
    for pattern, extension in _WORDS:
        if re.fullmatch(pattern, word):
            return extension
    return None


def told(word: str) -> tuple[str, str | None] | None:
    """Message and hint for a word that only an extension has; ``None`` for any other."""
    extension = unsupported_extension(word)
    if extension is None:
        return None
    if extension == _INT64:
        hint = f"write '#extension {_INT64} : enable', and #version 400 or later"
        return f"'{word}' is of the extension {_INT64}, which is not turned on", hint
    message = f"'{word}' is of the extension {extension}, which is not supported"
    return message, "write a type of 32 bits" if extension.startswith(_ARITHMETIC) else None


_SUFFIXES = (
    (re.compile(r"[\d.]+(?:[eE][+-]?\d+)?(?:hf|HF)", re.ASCII), f"{_ARITHMETIC}_float16"),
    (re.compile(r"(?:0[xX][\da-fA-F]+|\d+)[uU]?[sS]", re.ASCII), f"{_ARITHMETIC}_int16"),
)


def extension_of_number(text: str) -> str | None:
    """The extension that has numbers which end like this one."""
    found = (extension for pattern, extension in _SUFFIXES if pattern.fullmatch(text))
    return next(found, None)
