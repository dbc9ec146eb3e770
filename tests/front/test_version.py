"""``#version``, and what each version predefines (section 3.3)."""

from __future__ import annotations

import pytest
from preprocessing import errors, problem, rejected, run, words

from shadercache.lang.words import ES_VERSIONS, VERSIONS


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("profile", [None, "core", "compatibility"])
def test_desktop_versions(version: int, profile: str | None) -> None:
    text = f"// first\n\n  #  version {version} {profile or ''} // last\nfloat a;"
    if profile and version < 150:
        assert errors(text) == ["3:3 SC100"]
    else:
        result = run(text)
        assert (result.version, result.profile) == (version, profile)
        assert result.lexemes.texts == ["float", "a", ";"]


@pytest.mark.parametrize("version", ES_VERSIONS)
def test_es_versions_have_the_profile_es(version: int) -> None:
    text = "#version 100" if version == 100 else f"#version {version} es"
    result = run(text)
    assert (result.version, result.profile) == (version, "es")


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        ("100 es", "version 100 has no profiles"),
        ("100 core", "version 100 has no profiles"),
        ("300", "version 300 is one of GLSL ES"),
        ("310 core", "version 310 is one of GLSL ES"),
        ("330 es", "version 330 is not one of GLSL ES"),
        ("331", "there is no GLSL version 331"),
        ("330 best", "there is no profile 'best'"),
        ("330 core x", "#version is followed by a number and a profile"),
        ("330.0", "#version is followed by a number and a profile"),
        ("0x14A", "#version is followed by a number and a profile"),
        ("", "#version is followed by a number and a profile"),
    ],
)
def test_versions_that_there_are_not(rest: str, message: str) -> None:
    assert problem("", rest) == f"1:1 SC100 {message}"


def test_a_missing_version_means_110() -> None:
    result = run("// nothing\nfloat a = __VERSION__;\n")
    assert (result.version, result.profile) == (110, None)
    assert result.lexemes.texts[-2] == "110"
    assert run("").version == 110


@pytest.mark.parametrize("before", ["float a;", "#define A", "#", "#pragma x", "#version 330"])
def test_version_comes_first_and_once(before: str) -> None:
    assert errors(f"{before}\n#version 330\n") == ["2:1 SC100"]


BEFORE = ["// x\n", "\n", " \n", "/* x */", "/* x\n*/", "\\\n", "\r\n"]


@pytest.mark.parametrize("before", BEFORE)
def test_es_3_00_section_3_3_nothing_stands_before_the_version(before: str) -> None:
    for version in (300, 310, 320):
        (error,) = rejected(f"{before}#version {version} es\nfloat a;")
        assert (error.code, error.hint) == (
            "SC100",
            "move it up: there may be no empty line and no comment before it",
        )


@pytest.mark.parametrize("before", ["", "  ", "\t", "\ufeff"])
def test_es_3_00_blanks_may_stand_before_the_version(before: str) -> None:
    assert run(f"{before}#version 300 es\n").version == 300


@pytest.mark.parametrize("before", BEFORE)
@pytest.mark.parametrize("version", [100, 110, 330, 460])
def test_other_versions_may_have_comments_and_lines_before_them(before: str, version: int) -> None:
    assert run(f"{before}#version {version}\n").version == version


def test_a_version_that_is_skipped_does_no_harm() -> None:
    assert words("#if 0\n#version 400\n#endif\n__VERSION__") == "330"


# What glslang 12 defines: core, compatibility, GL_ES, GL_FRAGMENT_PRECISION_HIGH.
@pytest.mark.parametrize(
    ("version", "defined"),
    [
        ("100", [0, 0, 1, 1]),
        ("110", [0, 0, 0, 0]),
        ("120", [0, 0, 0, 0]),
        ("130", [0, 0, 0, 1]),
        ("140", [0, 0, 0, 1]),
        ("150", [1, 0, 0, 1]),
        ("150 compatibility", [1, 1, 0, 1]),
        ("300 es", [0, 0, 1, 1]),
        ("320 es", [0, 0, 1, 1]),
        ("330 core", [1, 0, 0, 1]),
        ("460 compatibility", [1, 1, 0, 1]),
    ],
)
def test_macros_of_the_profiles(version: str, defined: list[int]) -> None:
    names = ("core_profile", "compatibility_profile", "ES", "FRAGMENT_PRECISION_HIGH")
    text = "".join(f"#ifdef GL_{name}\nGL_{name}\n#else\n0\n#endif\n" for name in names)
    assert words(text, version) == " ".join(map(str, defined))
