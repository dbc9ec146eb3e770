"""Every input of a vertex shader is twinned, named in the manifest, or refused.

The files say what holds of them: ``NAMED`` and ``NOT`` what stands among the names that must not
change, ``SAYS`` a sentence of ``relies_on``, ``TWINNED`` what has a twin, ``REFUSED`` a code and
the culprit. ``MOVING`` is what the command line names.
"""

from __future__ import annotations

import re
from typing import Any

import pytest
from manifests import plain
from vertex_stages import REPORTS, analysed, names, without_position

from shadercache.analysis.vertex_inputs import Fate, function_fate, variable_fate
from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.lang.builtins import functions_of, variables_of
from tests.configured import rewritten

FOLDER = REPORTS / "vertex_inputs"
EXPECTED = {
    "o03_vertex_storage_buffer": {"TWINNED": ["Poses"]},
    "o14_instance_matrix_attribute": {"TWINNED": ["i_place"], "NAMED": ["a_position"]},
    "o05_instance_number": {
        "SAYS": [
            "an instance keeps its number from frame to frame (gl_InstanceID decides the position)"
        ]
    },
    "o15_layered": {"REFUSED": ["SC461 gl_Layer"]},
}
UNCHANGING = "these decide the position and do not change between frames: "


def expected(name: str) -> dict[str, list[str]]:
    """What the head of a file says of it."""
    if name in EXPECTED:
        return EXPECTED[name]
    found: dict[str, list[str]] = {}
    for word, rest in re.findall(
        r"^// ([A-Z]+): (.*)", (FOLDER / f"{name}.vert").read_text(), re.M
    ):
        found.setdefault(word, []).append(rest)
    return found


ACCEPTED = [name for name in names(FOLDER) if "REFUSED" not in expected(name)]
REFUSED = [name for name in names(FOLDER) if "REFUSED" in expected(name)]


def manifest(name: str) -> dict[str, Any]:
    moving = tuple(expected(name).get("MOVING", ()))
    analysis = analysed(FOLDER, name, ReadOptions(moving=moving))
    node = next(node for node in analysis.nodes if node.text == "costly(v_p)")
    emission = rewritten(analysis, node)
    assert not list(without_position(emission))
    return plain(emission.manifest)


@pytest.mark.parametrize("name", ACCEPTED)
def test_what_must_not_change_is_named(name: str) -> None:
    told = manifest(name)
    relies = told["relies_on"]
    kept = [text.removeprefix(UNCHANGING) for text in relies if text.startswith(UNCHANGING)]
    named = {item for text in kept for item in text.split(", ")}
    wanted = expected(name)
    for text in wanted.get("NAMED", ()):
        assert set(text.split(", ")) <= named
    assert set(wanted.get("SAYS", ())) <= set(relies)
    for text in wanted.get("TWINNED", ()):
        entries = {entry.get("previous_of"): entry for entry in told["inputs"]}
        for one in text.split(", "):
            assert one not in named
            assert entries[one]["name"] == told["previous"][one]
            bindings = [
                entry["binding"]
                for entry in told["inputs"]
                if entry["kind"] == entries[one]["kind"] and entry.get("binding") is not None
            ]
            assert len(bindings) == len(set(bindings))
    for text in wanted.get("NOT", ()):
        assert not [sentence for sentence in relies if text in sentence]


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_known_is_refused(name: str) -> None:
    code, culprit = expected(name)["REFUSED"][0].split()
    with pytest.raises(InputError) as caught:
        analysed(FOLDER, name)
    found = caught.value.diagnostics
    assert {item.code for item in found} == {code}
    assert any(culprit in item.message for item in found)
    assert all(item.span is not None and item.source is not None for item in found)


def test_no_built_in_variable_is_forgotten() -> None:
    """A new one in the tables of the language has to get its place in the list."""
    found = {item.name: variable_fate(item.name) for item in variables_of("vertex")}
    assert [name for name, fate in found.items() if fate is None] == []
    assert set(found.values()) == set(Fate)
    for item in variables_of("vertex"):
        assert (item.storage != "in") or variable_fate(item.name) is not Fate.TWINNED


def test_no_function_of_memory_is_forgotten() -> None:
    fates = {item.name: function_fate(item) for item in functions_of("vertex") if item.memory}
    assert None not in fates.values()
    assert [name for name, fate in fates.items() if fate is Fate.NAMED] == [
        "imageLoad",
        "sparseImageLoadARB",
    ]
    assert {"clock2x32ARB", "anyInvocation", "subgroupBallot"} <= fates.keys()


def test_uniforms_of_all_sorts_have_twins() -> None:
    twins = manifest("numbers_by_functions")["previous"]
    assert twins.keys() == {"u_vp", "u_places"}
