"""Shaders that are no GLSL, or not yet: what they are, and how to get GLSL of them.

A file of HLSL has a mistake in nearly every line, of which none is one. So where a file cannot be
read and is recognised, that is all that is told::

    @fragment fn main() -> @location(0) vec4<f32> { ... }    // WGSL
    #include <common>                                        // to be put together by three.js
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import PurePath

from shadercache.diagnostics import Diagnostic
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source, Span

CODE = "SC112"

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@dataclass(frozen=True, slots=True)
class ForeignKind:
    """A kind of file: what it is, what to do, and how it is known.

    One of ``marks`` makes a file one of these, or two different ones of ``hints``, or a suffix.
    ``needs``: the code of a mistake without which it may be GLSL that is whole; ``glsl``: is it
    GLSL but for what is to be put in?
    """

    what: str
    advice: str
    marks: str = ""
    hints: tuple[str, ...] = ()
    suffixes: tuple[str, ...] = ()
    needs: str = ""
    glsl: bool = False

    def place(self, text: str, suffix: str) -> Span | None:
        """Where a text without comments says that it is one of these; None if it is none."""
        if self.marks and (mark := re.search(self.marks, text, re.MULTILINE)):
            return Span(*mark.span())
        found = [mark for hint in self.hints if (mark := re.search(hint, text, re.MULTILINE))]
        if len(found) > 1 or (found and suffix in self.suffixes):
            return Span(*found[0].span())
        return Span(0, 0) if suffix in self.suffixes else None


KINDS = (
    ForeignKind(
        "a shader in Godot's own language",
        "give the GLSL that Godot makes of it: 'Inspect Native Shader Code' in its editor",
        marks=r"^[ \t]*shader_type[ \t]+\w+[ \t]*;",
        suffixes=(".gdshader", ".gdshaderinc"),
    ),
    ForeignKind(
        "a file of several sections for Godot",
        "save the text below #[vertex] and #[fragment] as a .vert and a .frag file, without the "
        "lines that Godot replaces",
        marks=r"^[ \t]*#\[\w+\]",
        glsl=True,
    ),
    ForeignKind(
        "a file that glslify is to put together",
        "give what 'glslify FILE' prints",
        marks=r"^[ \t]*#[ \t]*pragma[ \t]+glslify[ \t]*:.*",
        glsl=True,
    ),
    ForeignKind(
        "a shader of Unity's ShaderLab",
        "give the GLSL that Unity makes of it: 'Compile and show code' for OpenGL Core",
        marks=r"^[ \t]*Shader[ \t]+\"|^[ \t]*(?:CGPROGRAM|HLSLPROGRAM|CGINCLUDE|HLSLINCLUDE)\b",
    ),
    ForeignKind(
        "a shader in Metal's language",
        "give the GLSL that it was made from, or translate it",
        marks=r"#[ \t]*include[ \t]*<metal_\w+>|\busing[ \t]+namespace[ \t]+metal\b"
        r"|\[\[[ \t]*(?:stage_in|(?:buffer|texture|sampler|color|attribute)[ \t]*\()",
        suffixes=(".metal",),
    ),
    ForeignKind(
        "a shader in WGSL",
        "translate it, say with 'naga FILE out.frag'",
        marks=r"@(?:vertex|fragment|compute|group|binding|builtin|location)\b"
        r"|\bvar[ \t]*<[ \t]*(?:uniform|storage|private|workgroup)\b"
        r"|^[ \t]*fn[ \t]+\w+[ \t]*\(",
        suffixes=(".wgsl",),
    ),
    ForeignKind(
        "a shader in HLSL",
        "translate it, say with dxc -spirv and spirv-cross",
        marks=r"\bSV_[A-Z]\w+",
        hints=(
            r"\bcbuffer[ \t]+\w+",
            r":[ \t]*register[ \t]*\(",
            r"\bSampler(?:State|ComparisonState)\b",
            r"\b(?:RW)?(?:Texture(?:1D|2D|3D|Cube)|StructuredBuffer)\b",
            r"\btex(?:1D|2D|3D|CUBE)(?:lod|bias|grad)?[ \t]*\(",
            r":[ \t]*(?:POSITION|NORMAL|TEXCOORD|COLOR|TANGENT)\d*\b",
            r"\b(?:saturate|lerp|mul)[ \t]*\(",
            r"\b(?:float|half|fixed)[234](?:x[234])?\b",
        ),
        suffixes=(".hlsl", ".hlsli", ".fx", ".fxh", ".cg", ".cginc", ".usf", ".ush"),
    ),
    ForeignKind(
        "a shader that three.js is to put together",
        "give the whole text, as gl.getShaderSource() returns it",
        marks=r"^[ \t]*#[ \t]*include[ \t]+<(?:common|packing|bsdfs|[a-z_0-9]+_pars(?:_[a-z]+)?"
        r"|[a-z_0-9]+_(?:vertex|fragment|begin|maps|end))>",
        needs="SC123",
        glsl=True,
    ),
    ForeignKind(
        "a shader before which three.js puts declarations",
        "give the whole text, as gl.getShaderSource() returns it",
        marks=r"\b(?:projectionMatrix|modelViewMatrix|cameraPosition)\b",
        needs="SC201",
        glsl=True,
    ),
)

_SHADERTOY = ForeignKind(
    "a file of Shadertoy, which has no main",
    "--dialect shadertoy reads it",
    marks=r"\bvoid\s+mainImage\s*\(",
    glsl=True,
)

_VULKAN = ForeignKind(
    "Vulkan GLSL",
    "--dialect vulkan reads it",
    marks=r"\blayout[ \t]*\([^()]*\b(?:push_constant|constant_id|input_attachment_index"
    r"|set[ \t]*=[ \t]*[1-9])|\bgl_(?:Vertex|Instance)Index\b|\b[iu]?subpassInput(?:MS)?\b"
    r"|\buniform[ \t]+(?:(?:highp|mediump|lowp)[ \t]+)?"
    r"(?:sampler|samplerShadow|[iu]?texture(?:1D|2D|3D|Cube|Buffer)\w*)[ \t]+\w",
    glsl=True,
)

_GLSL = re.compile(r"^[ \t]*#[ \t]*version\b|\bgl_[A-Z]", re.MULTILINE)


def recognised(
    source: Source, options: ReadOptions, mistakes: Sequence[Diagnostic]
) -> Diagnostic | None:
    """What a file is that cannot be read as GLSL for these mistakes, if that is known."""
    text = _COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), source.text)
    suffix = PurePath(source.name).suffix.lower()
    is_glsl = _GLSL.search(text) is not None
    first, last = _of_dialects(text, options)
    for kind in (*first, *KINDS, *last):
        span = kind.place(text, suffix)
        if span is not None and (kind.glsl or not is_glsl) and _fits(kind, mistakes):
            return Diagnostic(CODE, f"this is {kind.what}; {kind.advice}", source, span)
    return None


def _of_dialects(
    text: str, options: ReadOptions
) -> tuple[tuple[ForeignKind, ...], tuple[ForeignKind, ...]]:
    """The kinds of files that another dialect reads: those that come first, and those that what
    comes to Vulkan as well, such as Godot's, comes before."""
    plain = options.dialect == "glsl" and not re.search(r"\bvoid\s+main\s*\(", text)
    return (_SHADERTOY,) * plain, (_VULKAN,) * (options.dialect != "vulkan")


def _fits(kind: ForeignKind, mistakes: Sequence[Diagnostic]) -> bool:
    """Are the mistakes such as a file of this kind has?"""
    found = [mistake for mistake in mistakes if mistake.code == kind.needs]
    if kind.needs == "SC201":  # One of its own names is not declared.
        return any(re.search(kind.marks, mistake.message) for mistake in found)
    return bool(found) or not kind.needs
