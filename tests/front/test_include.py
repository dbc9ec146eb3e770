"""``#include``: which files are found, and the places of what they hold."""

from __future__ import annotations

from pathlib import Path

import pytest
from preprocessing import rejected, run

from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.front.preprocess import preprocess
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source


def write(folder: Path, **files: str) -> Path:
    """A folder with these ``.glsl`` files."""
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / f"{name}.glsl").write_text(text)
    return folder


def texts(text: str, *folders: Path, name: str = "test.frag") -> str:
    result = run(f"#version 330\n{text}\n", ReadOptions(include_folders=folders), name)
    return " ".join(result.lexemes.texts)


def refusal(text: str, *folders: Path, name: str = "test.frag") -> str:
    (item,) = rejected(f"#version 330\n{text}\n", ReadOptions(include_folders=folders), name)
    assert item.code == "SC123"
    return item.message


# --- what is found --------------------------------------------------------------------------------


def test_a_file_of_a_folder(tmp_path: Path) -> None:
    write(tmp_path, a="x\n#define A 1\n", b='#include "a.glsl"\ny')
    assert texts('#include "a.glsl"\nA', tmp_path) == "x 1"
    assert texts("  # include <b.glsl> // why\nA", tmp_path) == "x y 1"
    text = "#extension GL_GOOGLE_include_directive : require\n#include <a.glsl>"
    assert texts(text, tmp_path) == "x"


def test_the_folder_of_the_file_comes_first_for_quotes_only(tmp_path: Path) -> None:
    (tmp_path / "main.frag").write_text("")
    write(tmp_path, a="beside")
    inner = write(tmp_path / "lib", a="lib", b='#include "a.glsl"')
    name = str(tmp_path / "main.frag")
    assert texts('#include "a.glsl"', inner, name=name) == "beside"
    assert texts("#include <a.glsl>", inner, name=name) == "lib"
    assert texts("#include <b.glsl>", inner, name=name) == "lib"
    assert texts('#include "lib//a.glsl"', name=name) == "lib"


def test_folders_are_looked_at_in_order(tmp_path: Path) -> None:
    first, second = write(tmp_path / "1", a="first"), write(tmp_path / "2", a="second", b="b")
    assert texts("#include <a.glsl>\n#include <b.glsl>", first, second) == "first b"


def test_a_path_may_go_up_within_the_folders(tmp_path: Path) -> None:
    write(tmp_path, a="a")
    write(tmp_path / "sub", b='#include "../a.glsl"')
    assert texts("#include <sub/b.glsl>\n#include <sub/../a.glsl>", tmp_path) == "a a"


def test_pragma_once(tmp_path: Path) -> None:
    write(tmp_path, a="#pragma once\nx")
    result = run("#version 330\n" + "#include <a.glsl>\n" * 3, ReadOptions((), (), (tmp_path,)))
    assert result.lexemes.texts == ["x"]
    assert result.directives == ()


def test_line_and_file_numbers_are_those_of_each_file(tmp_path: Path) -> None:
    write(tmp_path, a="__LINE__\n#line 50 2\n__LINE__ __FILE__")
    assert texts("#line 7 1\n#include <a.glsl>\n__LINE__ __FILE__", tmp_path) == "1 50 2 8 1"


# --- what is refused ------------------------------------------------------------------------------


def test_no_path_leaves_the_folders(tmp_path: Path) -> None:
    write(tmp_path, secret="x")
    inside = write(tmp_path / "in", a='#include "../secret.glsl"')
    (inside / "link.glsl").symlink_to(tmp_path / "secret.glsl")
    (inside / "up").symlink_to(tmp_path)
    (inside / "loop.glsl").symlink_to(inside / "loop.glsl")
    (inside / "main.frag").write_text("")
    outside = "leads out of the folders for included files"
    for name in ("../secret.glsl", "../../x", str(tmp_path / "secret.glsl"), "/etc/passwd"):
        assert refusal(f"#include <{name}>", inside).endswith(outside)
        assert refusal(f'#include "{name}"', name=str(inside / "main.frag")).endswith(outside)
    for name in ("link.glsl", "up/secret.glsl", "../missing.glsl", "a.glsl"):
        assert refusal(f"#include <{name}>", inside).endswith(outside)
    assert "is not in" in refusal("#include <loop.glsl>", inside)


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "bad.glsl").write_bytes(b"\xff\xfe")
    write(tmp_path / "folder.glsl")
    assert refusal("#include <none.glsl>", tmp_path).endswith(f"it is not in '{tmp_path}'")
    assert "is not in" in refusal("#include <folder.glsl>", tmp_path)
    assert "is not in" in refusal(f"#include <{'x' * 5000}>", tmp_path)
    assert refusal("#include <bad.glsl>", tmp_path).endswith("it is not UTF-8 text")
    assert "no folder to look in" in refusal("#include <a.glsl>")
    assert "no folder to look in" in refusal('#include "a.glsl"', name="<stdin>")


@pytest.mark.parametrize("rest", ["", "a.glsl", '"a.glsl', "<a.glsl", '""', '"a.glsl" b'])
def test_include_needs_a_name(rest: str, tmp_path: Path) -> None:
    assert refusal(f"#include {rest}", tmp_path) == '#include is followed by "name" or <name>'


def test_a_version_cannot_be_included(tmp_path: Path) -> None:
    write(tmp_path, a="#version 330\n")
    (item,) = rejected("#version 330\n#include <a.glsl>", ReadOptions((), (), (tmp_path,)))
    assert item.code == "SC100"


def test_conditions_end_in_the_file_where_they_begin(tmp_path: Path) -> None:
    write(tmp_path, a="#if 1\n", b="#endif\n")
    options = ReadOptions(include_folders=(tmp_path,))
    found = rejected("#version 330\n#include <a.glsl>\n#include <b.glsl>\n", options)
    assert [item.code for item in found] == ["SC121", "SC121"]


def test_files_that_include_themselves(tmp_path: Path) -> None:
    twice = '#include "{0}.glsl"\n#include "{0}.glsl"\n'
    write(tmp_path, a='x\n#include "a.glsl"\n', b=twice.format("b"))
    for name in "ab":
        message = refusal(f"#include <{name}.glsl>", tmp_path)
        assert message == "more than 50 files include one another here"


@pytest.mark.slow
def test_included_files_are_limited_in_all(tmp_path: Path) -> None:
    chain = {f"t{n}": f"#include <t{n + 1}.glsl>\n" * 2 for n in range(40)}
    write(tmp_path, **chain, t40="", big="// comment\n" * 100_000)
    for text in ("#include <t0.glsl>", "#include <big.glsl>\n" * 100):
        assert refusal(text, tmp_path) == "included files have more than 16 million characters"


def test_a_mistake_of_a_file_that_is_included_twice_is_told_once(tmp_path: Path) -> None:
    write(tmp_path, a="#foo\n/*")
    options = ReadOptions(include_folders=(tmp_path,))
    found = rejected("#version 330\n" + "#include <a.glsl>\n" * 3, options)
    assert [item.code for item in found] == ["SC108", "SC104"]


# --- places ---------------------------------------------------------------------------------------


def test_every_lexeme_knows_its_file(tmp_path: Path) -> None:
    write(tmp_path, a="x y\n#include <b.glsl>\nw", b="\n z")
    source = Source("main.frag", "#version 330\n#define M m\na\n#include <a.glsl>\nb M\n")
    lexemes = preprocess(source, ReadOptions(include_folders=(tmp_path,))).lexemes
    places = {
        text: (Path(source.part(start).name).name, *source.position(start))
        for text, start in zip(lexemes.texts, lexemes.starts, strict=True)
    }
    assert places == {
        "a": ("main.frag", 3, 1),
        "x": ("a.glsl", 1, 1),
        "y": ("a.glsl", 1, 3),
        "z": ("b.glsl", 2, 2),
        "w": ("a.glsl", 3, 1),
        "b": ("main.frag", 5, 1),
        "m": ("main.frag", 5, 3),
    }


def test_diagnostics_name_the_included_file(tmp_path: Path) -> None:
    write(tmp_path, a="float a = ;\n", b='\n#include "a.glsl"')
    source = Source("main.frag", "#version 330\n #include <b.glsl>\n")
    with pytest.raises(InputError) as caught:
        parse(source, ReadOptions(include_folders=(tmp_path,)))
    (item,) = caught.value.diagnostics
    assert item.render().splitlines() == [
        f"{tmp_path}/a.glsl:1:11: error: expected an expression after '=' [SC103]",
        "    1 | float a = ;",
        "      |           ^",
        f"  included at {tmp_path}/b.glsl:2:1",
        "  included at main.frag:2:2",
    ]
    place = item.to_json()
    assert (place["file"], place["line"]) == (f"{tmp_path}/a.glsl", 1)


def test_the_text_of_a_span(tmp_path: Path) -> None:
    write(tmp_path, a="b;\nfloat c;")
    source = Source("main.frag", "#version 330\nfloat a = 1.0 +\n#include <a.glsl>\n")
    (decl,) = parse(source, ReadOptions(include_folders=(tmp_path,))).decls[:1]
    init = decl.declarators[0].init  # type: ignore[union-attr]
    assert source.excerpt(init.left.span) == "1.0"
    assert source.excerpt(init.right.span) == "b"
    assert source.excerpt(init.span) == "1.0 +"


# --- names of other systems -----------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["C:/lib/a.glsl", "C:a.glsl", r"C:\lib\a.glsl", r"\\server\lib\a.glsl", "c:../a.glsl"]
)
def test_a_drive_is_in_no_folder(tmp_path: Path, name: str) -> None:
    """Not even where a folder here has the name of one."""
    write(tmp_path / "C:", a="x")
    for quoted in (f'"{name}"', f"<{name}>"):
        assert "leads out of the folders" in refusal(f"#include {quoted}", tmp_path)


def test_a_backslash_divides_folders_on_one_system_only(tmp_path: Path) -> None:
    write(tmp_path / "lib", a="x")
    options = ReadOptions(include_folders=(tmp_path,))
    (item,) = rejected('#version 330\n#include "lib\\a.glsl"\n', options)
    assert item.code == "SC123"
    assert item.hint == "write / between folders: every system takes that"


def test_line_ends_of_windows_in_included_files(tmp_path: Path) -> None:
    (tmp_path / "größe 1.glsl").write_bytes(
        "\ufeff#define A \\\r\n 1 // ü\r\n#if A\r\nA\r\n#endif\r\n".encode()
    )
    assert texts('#include "größe 1.glsl"\r\nb', tmp_path) == "1 b"


@pytest.mark.parametrize("other", ["lib/../lib/a.glsl", "link/a.glsl", "./lib/a.glsl"])
def test_a_file_is_read_once_whatever_its_path(tmp_path: Path, other: str) -> None:
    """Capitals are such another path where they do not count, as on Windows and macOS."""
    write(tmp_path / "lib", a="#pragma once\nx", b="#pragma once\nx")
    (tmp_path / "link").symlink_to("lib")
    assert texts(f'#include "lib/a.glsl"\n#include "{other}"', tmp_path) == "x"
    # Another file, although it holds the same.
    assert texts('#include "lib/a.glsl"\n#include "lib/b.glsl"', tmp_path) == "x x"
