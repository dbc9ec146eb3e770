"""What is left out before anything is drawn, and what is tried together."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from shadercache.caching.configuration import Configuration
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.tuning.groups import assignment_of, groups_of
from shadercache.tuning.values import Pool, changing_inputs, pool_of, sets_of

SHADER = """#version 330
uniform float u_time; uniform int u_frame; uniform vec2 u_resolution; uniform float u_gain;
out vec4 o_color;
float waves(vec2 p) {
    float sum = 0.0;
    for (int i = 0; i < 40; i++) sum += sin(p.x * float(i)) * cos(p.y + float(i));
    return sum;
}
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float still = waves(p * 3.0);
    float moving = waves(p + u_time);
    float other = waves(p * float(u_frame));
    o_color = vec4(still + moving * u_gain, other, still * moving, 1.0);
}
"""


def linker_of(path: Path, text: str = SHADER) -> Linker:
    path.write_text(text, encoding="utf-8")
    return Linker(*open_scene(path))


def pool(linker: Linker) -> Pool:
    [group] = groups_of(linker)
    return pool_of(group, linker.scene)


def test_only_inputs_that_really_change_count(tmp_path: Path) -> None:
    linker = linker_of(tmp_path / "a.frag")
    [group] = groups_of(linker)
    assert changing_inputs(group, linker.scene) == {"u_time", "u_frame"}


def test_what_is_another_in_every_frame_is_left_out(tmp_path: Path) -> None:
    found = pool(linker_of(tmp_path / "a.frag"))
    texts = [value.text for value in found.values]
    assert "waves(p * 3.0)" in texts and "waves(p + u_time)" in texts
    assert not any("u_frame" in text or "other" in text for text in texts)
    assert found.left_out["are another in every frame"] > 0


def test_what_changes_with_least_comes_first(tmp_path: Path) -> None:
    first, *others = pool(linker_of(tmp_path / "a.frag")).values
    assert first.changes == frozenset()
    assert any(value.changes == {"u_time"} for value in others)


def test_what_is_not_tried_is_counted(tmp_path: Path) -> None:
    linker = linker_of(tmp_path / "a.frag")
    [group] = groups_of(linker)
    found = pool_of(group, linker.scene)
    tried = len(found.values)
    assert tried + sum(found.left_out.values()) == len(group.analysis.nodes)


def test_sets_go_together_and_are_no_single_values(tmp_path: Path) -> None:
    linker = linker_of(tmp_path / "a.frag")
    [group] = groups_of(linker)
    found = pool_of(group, linker.scene)
    sets = list(sets_of(found, group.analysis))
    assert sets and all(len(value.nodes) > 1 for value in sets)
    assert len({frozenset(value.ids) for value in sets}) == len(sets)
    for value in sets:
        group.analysis.require_all(value.nodes)


def test_a_shader_of_cheap_values_tries_a_few_all_the_same(tmp_path: Path) -> None:
    text = SHADER.replace("i < 40", "i < 1")
    found = pool(linker_of(tmp_path / "b.frag", text))
    assert 0 < len(found.values) <= 2


@pytest.mark.parametrize(("name", "files"), [("heroine", 2), ("colonnade", 2), ("chess", 1)])
def test_groups_are_shaders_and_what_may_not_be_cached_is_in_none(name: str, files: int) -> None:
    linker = Linker(*open_scene(Path(data_path("corpus", name, "scene.toml"))))
    groups = groups_of(linker)
    assert len(groups) == files and groups[0].number == 0
    assert groups[0].fragment == linker.scene.common.fragment
    named = [one for group in groups for one in group.objects]
    assert len(set(named)) == len(named)
    assert "sky" not in named  # cached = false
    chosen = replace(Configuration(), nodes=("x",))
    assignment = dict(assignment_of(linker.scene, {groups[0]: chosen}).objects)
    assert {name for name, one in assignment.items() if one} == set(groups[0].objects)
