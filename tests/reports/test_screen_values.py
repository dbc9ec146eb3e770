"""Values of the screen are refused by what the vertex shader writes into a varying.

Lines of the fragment shaders say what holds of the ``wave(...)`` in them: ``screen: NAME`` (refused
with the culprit) or ``surface``.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from vertex_stages import REPORTS, analysed, sources

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.refusals import Code
from shadercache.caching.algorithms import NAMES as NAMED
from shadercache.compiler import Analysis, analyse
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from tests.configured import rewritten
from tests.shaders import find

FOLDER = REPORTS / "screen_values"
NAMES = sorted(path.stem for path in FOLDER.glob("*.frag") if not re.match(r"o\d", path.stem))


def told(name: str) -> dict[int, str]:
    """Line -> the culprit, or nothing for a value of the surface."""
    lines = (FOLDER / f"{name}.frag").read_text("utf-8").splitlines()
    found = {
        at: re.search(r"// (?:screen: (\w+)|surface)$", line) for at, line in enumerate(lines, 1)
    }
    return {at: match[1] or "" for at, match in found.items() if match}


def waves(analysis: Analysis) -> dict[int, Candidate]:
    """The outermost call of each line."""
    found: dict[int, Candidate] = {}
    for node in analysis.nodes:
        if node.text.startswith("wave(") and node.path == "main":
            found.setdefault(analysis.fragment.position(node.expr.span.start).line, node)
    return found


@pytest.mark.parametrize("name", NAMES)
def test_by_what_the_vertex_shader_writes(name: str) -> None:
    lines, nodes = told(name), waves(analysed(FOLDER, name))
    assert lines and lines.keys() == nodes.keys()
    for line, culprit in lines.items():
        refusal = nodes[line].refusal
        if culprit:
            assert refusal is not None and refusal.code is Code.SCREEN, (line, nodes[line].text)
            assert refusal.detail.removeprefix("legacy_") == culprit
        else:
            assert nodes[line].legal, (line, nodes[line].text)


@pytest.mark.parametrize("name", NAMES)
def test_by_the_screen_all_of_them_are_legal(name: str) -> None:
    analysis = analyse(*sources(FOLDER, name), mapping="screen")
    assert all(node.legal for node in waves(analysis).values())


def test_the_clip_position_of_the_report() -> None:
    analysis = analysed(FOLDER, "o09_clip_position_as_varying")
    by_text = {node.text: node for node in analysis.nodes if node.path == "main"}
    payload = by_text["costly(vec3(screen * 9.0, 1.0))"].refusal
    assert payload is not None and (payload.code, payload.detail) == (Code.SCREEN, "v_clip")
    assert by_text["max(v_n.z, 0.2)"].legal and by_text["v_clip.w"].legal
    assert by_text["screen"].inputs == {"v_clip"}


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("o09_clip_position_as_varying", "costly(vec3(screen * 9.0, 1.0))", Code.SCREEN),
        ("o12_normal_from_derivatives", "costly(n)", Code.DERIVATIVE),
    ],
)
def test_the_values_of_the_reports_are_offered_on_request(name: str, text: str, code: Code) -> None:
    refusal = find(analysed(FOLDER, name), text).refusal
    assert refusal is not None and refusal.code is code
    asked = analyse(*sources(FOLDER, name), ReadOptions(approximate=True))
    node = find(asked, text)
    assert node.offered and node.approximate
    manifest = rewritten(asked, node, algorithms=NAMED).manifest
    assert not manifest.refused, "by every algorithm"
    assert [entry.approximate for entry in manifest.nodes] == [True]


def test_without_a_vertex_shader_only_what_the_fragment_shader_says_counts() -> None:
    for name, refused in (("same_expression", 0), ("interpolation", 7)):
        analysis = analyse(sources(FOLDER, name)[0], mapping="surface")
        found = [node for node in waves(analysis).values() if not node.legal]
        assert len(found) == refused


def test_a_long_vertex_shader_is_given_up(tmp_path: Path) -> None:
    """What would take too long to follow is not refused on suspicion."""
    fragment, vertex = sources(FOLDER, "read_back")
    calls = "".join(
        f"float f{i}(float x) {{ return f{i - 1}(x) + f{i - 1}(x); }}\n" for i in range(1, 20)
    )
    text = vertex.text.replace(
        "void main() {", f"float f0(float x) {{ return x; }}\n{calls}void main() {{"
    )
    text = text.replace("v_depth = 1.0", "v_depth = f19(1.0)")
    analysis = analyse(fragment, Source("long.vert", text))
    assert all(node.legal for node in waves(analysis).values())
