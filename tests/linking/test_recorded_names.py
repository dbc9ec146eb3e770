"""What is said of names and numbers of a recording that do not fit the shaders of its scene."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.linking.inputs_declared import uniform_sizes
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene, open_scene
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import load_scene, recorded
from shadercache.scene.recording import read_recording
from tests.recordings import dumped, write_csv


def linked(scene: Path, text: str) -> list[str]:
    """What is said of a recording of a scene."""
    path = scene / "r.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        Linker(*analyse_scene(recorded(load_scene(scene), read_recording(path))))
    return [one.render() for one in caught.value.diagnostics]


def test_a_name_that_no_shader_has(scene_folder: Path) -> None:
    header = "u_ligth[0],u_ligth[1],u_ligth[2],u_scale"
    [said] = linked(scene_folder, f"{header}\n1,2,3,4\n1,2,3,4\n")
    assert "r.csv:1:1: error: u_ligth: the scene's shaders have no uniform u_ligth" in said
    assert "[SC551]" in said and "did you mean u_light? there are: u_" in said


def test_another_number_of_numbers(scene_folder: Path) -> None:
    [said] = linked(scene_folder, "u_scale,u_light[0],u_light[1]\n1,2,3\n1,2,3\n")
    assert "r.csv:1:9: error: u_light takes 3 numbers, and the recording has 2 [SC523]" in said


def test_a_name_of_another_objects_shader(scene_folder: Path) -> None:
    # Of all objects it may be recorded: the one with bones takes it.
    folder = scene_folder / "objects"
    text = "plain/u_bones[0],u_bones[0]\n1,2\n1,2\n"
    no_uniform, count = linked(folder, text)
    assert "plain/u_bones: its shaders have no uniform u_bones" in no_uniform
    assert "u_bones takes 32 numbers, and the recording has 1" in count


def test_what_fits_is_taken(scene_folder: Path) -> None:
    folder = scene_folder / "objects"
    scene = load_scene(folder)
    frames = dumped(scene, 3, (64, 64))
    # Each object has a value for what its own shader does not have.
    sizes = {
        part.name: uniform_sizes(Linker(*analyse_scene(scene)).analysis_of(part))
        for part in scene.parts
    }
    known = [
        {key: v for key, v in frame.items() if key.split("/")[1] in sizes[key.split("/")[0]]}
        for frame in frames
    ]
    path = write_csv(folder / "r.csv", known)
    linker = Linker(*analyse_scene(recorded(scene, read_recording(path))))
    bones = linker.scene.parts[2].inputs.animated["u_bones"]
    assert bones.at(1).tobytes() == frames[1]["bent/u_bones"].tobytes()


SHADER = """#version 430
struct Lamp { vec3 color; float power[2]; };
uniform Lamp lamps[2];
uniform mat2x3 tilt = mat2x3(1.0);
uniform float rows[2][3];
uniform sampler2D map;
layout(std140) uniform Camera { mat4 view; } camera;
layout(std140) uniform Rest { ivec2 cells; };
uniform float iTime;
out vec4 color;
void main() {
    float sum = lamps[1].power[1] + tilt[0].x + rows[1][2] + float(cells.x) + iTime;
    color = texture(map, vec2(sum)) * camera.view[0] + lamps[0].color.x;
}
"""


def test_uniforms_have_the_names_that_opengl_has(tmp_path: Path) -> None:
    (tmp_path / "a.frag").write_text(SHADER)
    analysis = open_scene(tmp_path / "a.frag")[1]
    assert uniform_sizes(analysis) == {
        **{f"lamps[{at}].color": 3 for at in range(2)},
        **{f"lamps[{at}].power": 2 for at in range(2)},
        **{"tilt": 6, "rows[0]": 3, "rows[1]": 3, "camera.view": 16, "cells": 2, "iTime": 1},
    }


OLD = "uniform float layout;\nvoid main() { gl_FragColor = vec4(layout); }\n"


def test_a_full_screen_shader_is_recorded_under_its_own_names(tmp_path: Path) -> None:
    """Raised to a later version, the shader has another name for what is a keyword there."""
    (tmp_path / "a.frag").write_text(OLD)
    (tmp_path / "r.csv").write_text("layout,cut\n0.25,0\n0.75,1\n")
    recording = read_recording(tmp_path / "r.csv")
    scene, analysis = open_scene(tmp_path / "a.frag", ReadOptions(), None, recording)
    assert analysis.renamed.keys() >= {"layout"}
    Linker(scene, analysis)
    values = uniform_values(scene.view, scene.common, 1, (8, 8))
    assert values["layout"] == values[analysis.renamed["layout"]] == 0.75
    assert scene.view.camera_path.cuts == {1}
