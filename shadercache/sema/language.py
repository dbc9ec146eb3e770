"""Which GLSL a module is written in, and what that has and lacks."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.ast.nodes import Module
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang import builtins
from shadercache.lang.availability import NEVER as NEVER
from shadercache.lang.availability import VULKAN
from shadercache.lang.builtins import BuiltinVariable, Signature
from shadercache.lang.types import Type
from shadercache.lang.words import type_names
from shadercache.sema.conversions import Conversions
from shadercache.sema.facts import Stage

_INTERFACE_VERSIONS = {
    "GL_ARB_separate_shader_objects": 410,
    "GL_ARB_explicit_uniform_location": 430,
}
_QUALIFIER_VERSIONS = {"GL_ARB_shading_language_420pack": 420}
_INDEXING = ("GL_ARB_gpu_shader5", "GL_EXT_gpu_shader5", "GL_OES_gpu_shader5")
_NOT_VULKAN = ("gl_VertexID", "gl_InstanceID", "gl_DepthRange", "gl_NumSamples")
"""Built-in variables that Vulkan GLSL lacks."""
_CONVERTING = ("GL_ARB_gpu_shader5", "GL_ARB_gpu_shader_fp64")


@dataclass(frozen=True, slots=True)
class Language:
    """Version, profile, stage and extensions of a module.

    An extension may lift a part of the language to a later version: ``interface_version`` is the
    one whose rules of inputs and outputs hold, ``qualifier_version`` the one of qualifiers.
    """

    version: int
    es: bool
    profile: str | None
    stage: Stage
    extensions: frozenset[str]
    interface_version: int
    qualifier_version: int
    conversions: Conversions

    def at_least(self, desktop: int, es: int) -> bool:
        """Is it this version of GLSL, or this one of GLSL ES, or a later one?"""
        return self.version >= (es if self.es else desktop)

    @property
    def es_version(self) -> int:
        """The version of GLSL ES; 0 for desktop GLSL."""
        return self.version if self.es else 0

    @property
    def arrays_are_values(self) -> bool:
        """Can arrays be assigned, compared, returned, constructed and asked for their length?"""
        return self.at_least(120, 300) or "GL_3DL_array_objects" in self.extensions

    @property
    def has_integer_operators(self) -> bool:
        """Are there ``%``, ``&``, ``<<`` and the like (1.30 section 5.9)?"""
        return self.at_least(130, 300) or "GL_EXT_gpu_shader4" in self.extensions

    def has_type(self, kind: Type) -> bool:
        """Is the built-in type one of this version?"""
        return kind.name in type_names(self.version, self.es, self.extensions)

    @property
    def vulkan(self) -> bool:
        """Is it Vulkan GLSL?"""
        return VULKAN in self.extensions

    @property
    def bindless(self) -> bool:
        """Are samplers and images values like any other (ARB_bindless_texture)?"""
        return "GL_ARB_bindless_texture" in self.extensions

    def only_handles(self, kind: Type) -> bool:
        """Does it hold a sampler or image, which is no value (4.60 section 4.1.7)?"""
        return kind.holds_opaque and (kind.name == "atomic_uint" or not self.bindless)

    @property
    def indexes_samplers(self) -> bool:
        """May an array of samplers be indexed with what is not constant (4.00 section 4.1.7)?"""
        # Before 1.30 any index will do, and GLSL ES 1.00 leaves it to the driver (appendix A.5).
        old = self.version < (300 if self.es else 130)
        return old or self.at_least(400, 320) or not self.extensions.isdisjoint(_INDEXING)

    def builtin_functions(self, name: str) -> tuple[Signature, ...]:
        """The overloads of a built-in function in this version and stage."""
        return builtins.functions(name, self.version, self.profile, self.stage, self.extensions)

    def builtin_variable(self, name: str) -> BuiltinVariable | None:
        """The built-in variable or constant of that name in this version and stage."""
        if self.vulkan and name in _NOT_VULKAN:
            return None
        return builtins.variable(name, self.stage, self.version, self.profile, self.extensions)


def language_of(module: Module, stage: Stage) -> Language:
    """What the ``#version`` and the ``#extension`` lines of a module say."""
    version, profile, es = module.version, module.profile, module.profile == "es"
    extensions = enabled_extensions(module)
    # 1.40 has no profiles: there this extension brings back what it dropped.
    if "GL_ARB_compatibility" in extensions and not es:
        profile = "compatibility"
    # Both bring the implicit conversions of 4.00, and the ranking of overloads that goes with them.
    converts = not es and not extensions.isdisjoint(_CONVERTING)
    return Language(
        version=version,
        es=es,
        profile=profile,
        stage=stage,
        extensions=extensions,
        interface_version=_lifted(version, extensions, _INTERFACE_VERSIONS),
        qualifier_version=_lifted(version, extensions, _QUALIFIER_VERSIONS),
        conversions=Conversions(max(version, 400 if converts else 0), es, extensions),
    )


def _lifted(version: int, extensions: frozenset[str], versions: dict[str, int]) -> int:
    return max([version, *(versions.get(name, 0) for name in extensions)])
