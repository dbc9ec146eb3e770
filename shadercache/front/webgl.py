"""Files of WebGL, which name no version: they are GLSL ES 1.00.

Without ``#version`` a file is GLSL 1.10 or GLSL ES 1.00, as its host has it. What tells them apart
is a precision: 1.10 has none, and no name may stand before a type there::

    precision mediump float;            varying highp vec2 v_uv;

What only WebGL sees (``#ifdef GL_ES``) tells nothing: such a file is GLSL 1.10 as well.
"""

from __future__ import annotations

import re
from itertools import pairwise

from shadercache.front.dialects import host_of
from shadercache.front.preprocess import NO_VERSION, Version, preprocess_broken, version_line
from shadercache.front.read_options import ReadOptions
from shadercache.lang.words import PRECISIONS, type_names
from shadercache.source import Source

WEBGL = Version(100, "es")

# A quick test of the text; the precision may stand in an included file.
_TELLING = re.compile(r"\b(?:highp|mediump|lowp)\b|#[ \t]*include\b")


def names_version(text: str) -> bool:
    """Has the text a ``#version``?"""
    return version_line(text) is not None


def is_webgl(source: Source, options: ReadOptions) -> bool:
    """Is it a file without a version that can only be GLSL ES 1.00?"""
    if names_version(source.text) or not _TELLING.search(source.text):
        return False
    if host_of(source, options.dialect) is not None:
        return False
    # Read as GLSL 1.10, so that precisions behind `#ifdef GL_ES` are left out: such a file is both.
    texts = preprocess_broken(source, options, NO_VERSION)[0].lexemes.texts
    types = type_names(WEBGL.number, es=True)
    return any(one in PRECISIONS and other in types for one, other in pairwise(texts))
