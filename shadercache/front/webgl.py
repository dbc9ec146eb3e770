"""Files of WebGL, which name no version: they are GLSL ES 1.00.

Without ``#version`` a file is GLSL 1.10 or GLSL ES 1.00, as its host has it. What tells them apart
is a precision: 1.10 has none, and no name may stand before a type there::

    precision mediump float;            varying highp vec2 v_uv;

Precisions that only WebGL sees (behind ``#ifdef GL_ES``) are in files that are both. Nearly all of
these are written for WebGL, and read as that, unless a stage has a word that only desktops know
(``gl_Color``, ``texture3D``), names a version of theirs, or uses a precision's name as its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from enum import IntEnum
from itertools import pairwise

from shadercache.front.dialects import host_of
from shadercache.front.preprocess import (
    NO_VERSION,
    Version,
    enabled_extensions,
    preprocess_broken,
    version_line,
)
from shadercache.front.read_options import ReadOptions
from shadercache.lang.builtins import functions, variable
from shadercache.lang.words import PRECISIONS, type_names
from shadercache.source import Source

WEBGL = Version(100, "es")

_STAGES = "fragment", "vertex"
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)
# Quick tests of the text; the precision may stand in an included file.
_TELLING = re.compile(r"\b(?:highp|mediump|lowp)\b|#[ \t]*include\b")
_GUARD = re.compile(r"\bGL_ES\b")


class Says(IntEnum):
    """What a file says of its language, by how little doubt it leaves."""

    NOTHING = 0
    MAYBE_WEBGL = 1
    DESKTOP = 2
    WEBGL = 3


def names_version(text: str) -> bool:
    """Has the text a ``#version``?"""
    return version_line(text) is not None


def is_webgl(stages: Iterable[tuple[Source, ReadOptions]]) -> bool:
    """Are the files of a program without a version GLSL ES 1.00?"""
    said = max(_said(source, options) for source, options in stages)
    return said in (Says.MAYBE_WEBGL, Says.WEBGL)


def _said(source: Source, options: ReadOptions) -> Says:
    version = version_line(source.text)
    if version is not None:
        number = source.text[slice(*version)].split()
        return Says.WEBGL if "100" in number else Says.DESKTOP
    if host_of(source, options.dialect) is not None:
        return Says.DESKTOP
    if _TELLING.search(source.text):
        # Read as GLSL 1.10, so that precisions behind `#ifdef GL_ES` are left out.
        if _has_precision(preprocess_broken(source, options, NO_VERSION)[0].lexemes.texts):
            return Says.WEBGL
        if _GUARD.search(source.text):
            return _said_as_webgl(source, options)
    words = _WORD.findall(source.text)
    return Says.DESKTOP if any(map(_only_on_desktops, set(words))) else Says.NOTHING


def _said_as_webgl(source: Source, options: ReadOptions) -> Says:
    """What a file says where only WebGL sees its precisions."""
    read = preprocess_broken(source, options, WEBGL)[0]
    texts = read.lexemes.texts
    if not _has_precision(texts):
        return Says.NOTHING
    types = type_names(WEBGL.number, es=True)
    named = any(one in PRECISIONS and other not in types for one, other in pairwise(texts))
    extensions = enabled_extensions(read)
    foreign = any(_only_on_desktops(word, extensions) for word in set(texts))
    return Says.DESKTOP if named or foreign else Says.MAYBE_WEBGL


def _has_precision(texts: Sequence[str]) -> bool:
    types = type_names(WEBGL.number, es=True)
    return any(one in PRECISIONS and other in types for one, other in pairwise(texts))


def _only_on_desktops(word: str, extensions: frozenset[str] = frozenset()) -> bool:
    """Does GLSL 1.10 know the word, and GLSL ES 1.00 not?"""
    if word in type_names(NO_VERSION.number):
        return word not in type_names(WEBGL.number, es=True)
    return _known(word, NO_VERSION) and not _known(word, WEBGL, extensions)


def _known(word: str, version: Version, extensions: frozenset[str] = frozenset()) -> bool:
    number, profile = version.number, version.profile
    return any(
        functions(word, number, profile, stage, extensions)
        or variable(word, stage, number, profile, extensions)
        for stage in _STAGES
    )
