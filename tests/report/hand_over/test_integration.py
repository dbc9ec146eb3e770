"""INTEGRATION.md tells all that the manifests tell of a variant, and little else."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from shadercache.diagnostics import InputError
from shadercache.linking.linker import Linker
from shadercache.manifest.codec import decode
from shadercache.render.bundle import load_bundle
from shadercache.report.hand_over.handed_files import hand_over
from tests.conftest import Golden
from tests.report.hand_over.handed import CHOICES, EXPECTED, Choice, Handed, chosen, handed, written

GOLDENS = "tests/report/hand_over/goldens"
MOST_LINES = 150


def manifests(made: Handed) -> Iterator[tuple[str, dict[str, Any]]]:
    """Each with the folder that it is in."""
    for name in made.files:
        if name.endswith("manifest.json"):
            yield name.removesuffix("manifest.json"), json.loads(made.text(name))


def steps(text: str) -> list[str]:
    """The passes of a frame, in the order of the text."""
    return re.findall(r"^   \* \*\*\d+\. (.*?)\*\*", text, re.MULTILINE)


@pytest.mark.parametrize("name", CHOICES)
def test_all_of_the_manifest_is_told(name: str) -> None:
    made = handed(CHOICES[name])
    text = made.text("INTEGRATION.md")
    assert len(text.splitlines()) < MOST_LINES
    assert "None" not in text and "$" not in text
    told = set(re.findall(r"`([^`]+)`", text))
    for folder, manifest in manifests(made):
        [variant] = manifest["variants"]
        assert manifest["refused"] == []
        assert {one["name"] for one in manifest["uniforms"]} <= told
        assert {*manifest["previous"]} | {*manifest["previous"].values()} <= told
        assert {*manifest["targets"]} <= told
        for one in (*variant["passes"], manifest["debug"]):
            assert {f"{folder}{one['vertex']}", f"{folder}{one['fragment']}"} <= told
            assert {*one["uniforms"], *one["attributes"]} <= told
        for one in variant["passes"]:
            assert one["name"] in told
            assert f"Depth: `{one['depth']['test']}`" in text
        for needed in manifest["depends_on"]:
            assert needed["name"] in told or needed.get("members")
        for words in manifest["relies_on"]:
            assert words[1:] in text
        for state in manifest["state"]:
            assert state["state"] in text
        assert " ".join(manifest["nodes"][0]["text"].split())[:60] in text


@pytest.mark.parametrize("name", CHOICES)
def test_the_folder_has_what_an_engine_needs_and_no_more(name: str, tmp_path: Path) -> None:
    """Beside the passes: the original to compare with, and the hit mask of section 6."""
    made = handed(CHOICES[name])
    wanted = {"INTEGRATION.md", "example.py", "example.npz"}
    for folder, manifest in manifests(made):
        wanted.add(f"{folder}manifest.json")
        passes = (*manifest["variants"][0]["passes"], manifest["original"], manifest["debug"])
        wanted |= {folder + one[stage] for one in passes for stage in ("vertex", "fragment")}
        decode(manifest, name)
    if name in ("heroine", "colonnade, parked"):
        wanted |= {"sky/original.vert", "sky/original.frag"}
    if name == "meadow, instances":
        wanted |= {"ground/original.vert", "ground/original.frag"}
    assert set(made.files) == wanted
    folder = written(made, tmp_path)
    for place, manifest in manifests(made):
        bundle = load_bundle(folder / place)
        assert bundle.algorithms == (CHOICES[name].algorithm,)
        assert "/" not in manifest["source"]["fragment"]["name"]
        with pytest.raises(InputError) as caught:
            _ = bundle.payload
        assert caught.value.diagnostics[0].code == "SC021"


def test_the_numbers_chosen_are_the_defaults_of_the_manifest() -> None:
    made = handed(Choice("dragon", "whole noise", "2-pass", period=21))
    [(_, manifest)] = manifests(made)
    defaults = {one["role"]: one["default"] for one in manifest["uniforms"]}
    assert (defaults["period"], defaults["block"]) == (21, 4)
    assert "| `sc_period` | int | 21, the period in frames |" in made.text("INTEGRATION.md")


def test_all_objects_finish_a_pass_before_the_next_begins() -> None:
    assert steps(handed(CHOICES["heroine"]).text("INTEGRATION.md")) == [
        "Not cached: `sky`.",
        "`hit` of heroine",
        "`hit` of ground",
        "`miss` of heroine",
        "`miss` of ground",
    ]
    # What marks pixels is drawn once for all, and behind the last pass of objects.
    assert steps(handed(CHOICES["colonnade, parked"]).text("INTEGRATION.md")) == [
        "Not cached: `sky`.",
        "`find` of stone",
        "`find` of land",
        "`mark` of stone",
        "`fix-up` of stone",
        "`fix-up` of land",
    ]


def test_what_was_measured_is_told() -> None:
    choice = CHOICES["a Shadertoy"]
    text = handed(choice).text("INTEGRATION.md")
    assert "2.03 times as fast as the original (95 % interval 1.98 to 2.08)" in text
    assert "Error in RMSE: 0.00312 on average, 0.0042 in the worst frame" in text
    assert "0.005 was the bound" in text
    without = handed(choice, replace(EXPECTED, bound=None)).text("INTEGRATION.md")
    assert "bound" not in without
    assert "were not measured" in handed(choice, None).text("INTEGRATION.md")


def test_each_variant_has_its_own_words() -> None:
    """No sentence that does not apply."""
    texts = {name: handed(choice).text("INTEGRATION.md") for name, choice in CHOICES.items()}
    for name, text in texts.items():
        assert ("marks" in text) == ("parked" in name)
        assert ("upsampled" in text) == ("half" in name)
        assert ("twins" in text) == (name != "a Shadertoy")
        assert ("An object that the last frame" in text) == (name != "a Shadertoy")
        assert ("Not cached:" in text) == (name.split(",")[0] in ("heroine", "colonnade", "meadow"))
    assert "expect 75.0 % hits (1 - 1/4)" in texts["dragon, two passes"]
    assert "Then draw `miss` alone" in texts["dragon, two passes"]
    assert "set `sc_epsilon` = -1" in texts["dragon, one pass"]
    assert "set `sc_epsilon`" not in texts["dragon, two passes"]
    assert "Refresh of king: each pixel once in 4 frames" in texts["chess, a period of its own"]
    assert "`sc_first_object`" in texts["meadow, instances"]


def test_the_engine_of_the_scene_is_told_what_differs() -> None:
    linker, assignment = chosen(CHOICES["dragon, two passes"])
    engine = replace(linker.scene.view.engine, depth="greater")
    scene = replace(linker.scene, view=replace(linker.scene.view, engine=engine))
    reversed_depth = Linker(scene, linker.analysis)
    text = hand_over(reversed_depth, assignment, EXPECTED, frames=2)["INTEGRATION.md"].decode()
    assert "Your depth function is `greater`: in all passes above `less` becomes `greater`" in text


def test_nothing_cached_is_nothing_to_hand_over() -> None:
    linker, assignment = chosen(CHOICES["dragon, two passes"])
    nothing = assignment.with_originals([name for name, _ in assignment.objects])
    with pytest.raises(InputError) as caught:
        hand_over(linker, nothing, EXPECTED)
    assert caught.value.diagnostics[0].code == "SC542"


@pytest.mark.parametrize("name", ["dragon, two passes", "colonnade, parked"])
def test_goldens(golden: Golden, name: str) -> None:
    made = handed(CHOICES[name])
    stem = f"{GOLDENS}/{name.split(',')[0]}"
    golden(f"{stem}.INTEGRATION.md", made.text("INTEGRATION.md"))
    golden(f"{stem}.example.txt", made.text("example.py"))
