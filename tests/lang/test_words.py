"""Keywords and reserved words of each version (section 3.6 of each specification)."""

from __future__ import annotations

import pytest

from shadercache.lang import words


@pytest.mark.parametrize(
    ("word", "version", "es", "sort"),
    [
        ("uint", 120, False, "name"),
        ("uint", 130, False, "keyword"),
        ("uint", 100, True, "name"),
        ("uint", 300, True, "keyword"),
        ("double", 330, False, "reserved"),
        ("double", 400, False, "keyword"),
        ("double", 320, True, "reserved"),
        ("varying", 460, False, "keyword"),
        ("varying", 100, True, "keyword"),
        ("varying", 300, True, "reserved"),
        ("sample", 330, False, "name"),
        ("sample", 400, False, "keyword"),
        ("sample", 300, True, "reserved"),
        ("sample", 320, True, "keyword"),
        ("switch", 120, False, "reserved"),
        ("switch", 130, False, "keyword"),
        ("precision", 120, False, "name"),
        ("packed", 120, False, "reserved"),
        ("packed", 140, False, "name"),
        ("buffer", 430, False, "keyword"),
        ("buffer", 420, False, "name"),
        ("image2D", 300, True, "reserved"),
        ("image2D", 310, True, "keyword"),
        ("imageBuffer", 310, True, "reserved"),
        ("subroutine", 400, False, "reserved"),
        ("input", 110, False, "reserved"),
    ],
)
def test_3_6_words(word: str, version: int, es: bool, sort: str) -> None:
    is_keyword = word in words.keywords(version, es)
    is_reserved = word in words.reserved_words(version, es)
    assert (is_keyword, is_reserved) == (sort == "keyword", sort == "reserved")


def test_3_6_an_extension_brings_its_keywords() -> None:
    on = frozenset(("GL_OES_texture_3D",))
    assert "sampler3D" in words.reserved_words(100, True)
    assert "sampler3D" in words.type_names(100, True, on)
    assert "sampler3D" not in words.reserved_words(100, True, on)


@pytest.mark.parametrize("es", [False, True])
def test_3_6_no_word_is_a_keyword_and_reserved(es: bool) -> None:
    for version in words.ES_VERSIONS if es else words.VERSIONS:
        known, reserved = words.keywords(version, es), words.reserved_words(version, es)
        assert not known & reserved


def test_keyword_since_names_the_first_version() -> None:
    assert words.keyword_since("precise") == 400
    assert words.keyword_since("precise", es=True) == 320
    assert words.keyword_since("goto") is None
