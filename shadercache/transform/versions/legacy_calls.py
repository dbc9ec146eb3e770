"""The texture functions of old under their names of today (GLSL 1.30, section 8.7, and 3.30).

``texture2DProjLod(s, p, l)`` is ``textureProjLod(s, p, l)``. Shadows were four components, those of
the depth mode ``LUMINANCE``: ``shadow2D(s, p)`` is ``vec4(vec3(texture(s, p)), 1.0)``.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.lang.builtins import Signature, functions

Place: TypeAlias = tuple[int, str | None, str, frozenset[str]]
"""Version, profile, stage and extensions of a shader: where a name may or may not be built in."""

# Extensions brought their functions under names of their own: ``texture2DGradARB``.
_SHAPE = r"(?:1D|2D|3D|Cube|Buffer)(?:Rect)?(?:Array)?"
_SAMPLED = re.compile(
    rf"(?:texture|shadow){_SHAPE}(Proj)?(Lod|Grad)?(Offset)?(?:ARB|EXT|NV|ATI|OES)?"
)
_WHOLE = re.compile(rf"(texelFetch|textureSize){_SHAPE}(Offset)?")


def modern_call(call: n.Call, callee: Signature, place: Place) -> n.Expr | None:
    """The call in a shader at ``place``; ``None`` where there is nothing like it."""
    name = modern_name(callee.name)
    modern = _overload(name, callee, place) if name else None
    if name is None or modern is None:
        return call if _overload(callee.name, callee, place) else None
    renamed = replace(call, name=name)
    if modern.result is callee.result:
        return renamed
    grey = n.Construct(call.span, n.TypeSpec(call.span, "vec3"), (renamed,))
    one = n.Literal(call.span, "1.0")
    return n.Construct(call.span, n.TypeSpec(call.span, "vec4"), (grey, one))


def modern_name(name: str) -> str | None:
    """``texture`` for ``texture2D``, ``textureProjLod`` for ``shadow2DProjLod``, and so on."""
    sampled = _SAMPLED.fullmatch(name)
    if sampled is not None:
        return "texture" + "".join(part or "" for part in sampled.groups())
    whole = _WHOLE.fullmatch(name)
    return whole[1] + (whole[2] or "") if whole is not None else None


def _overload(name: str, callee: Signature, place: Place) -> Signature | None:
    kinds = [param.type for param in callee.params]
    for signature in functions(name, *place):
        if [param.type for param in signature.params] == kinds:
            return signature
    return None
