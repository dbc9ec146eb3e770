"""Recordings: what is read of CSV and TOML, how a scene takes it, and what is said of mistakes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.scene import recording as recordings
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import Scene, load_scene, recorded
from shadercache.scene.recording import Recording, read_recording
from tests.recordings import dumped, write_csv, write_toml

SIZE = (64, 64)


def read(folder: Path, name: str, text: str) -> Recording:
    path = folder / name
    path.write_bytes(text.encode())
    return read_recording(path)


def told(folder: Path, name: str, text: str) -> list[str]:
    """The first lines of what is said of a file: place, sentence and code."""
    with pytest.raises(InputError) as caught:
        read(folder, name, text)
    lines = [one.render().splitlines()[0] for one in caught.value.diagnostics]
    return [line.removeprefix(str(folder / name)) for line in lines]


def rows(recording: Recording) -> dict[str, list[list[float]]]:
    return {str(key): track.rows.tolist() for key, track in recording.tracks.items()}


CSV = 'u_a[1],u_time,"lamp 1/u_a[0]",u_a[0], cut\r\n2,0.5,7,1,0\r\n4,"1.5", 8 ,3,1\r\n\r\n'
TOML = """
[[frames]]
u_time = 0.5
u_a = [1, 2.0]
objects."lamp 1".u_a = 7
[[frames]]
cut = true
u_a = [[3], [4]]
u_time = 1.5
[frames.objects."lamp 1"]
u_a = 8
"""


@pytest.mark.parametrize(("name", "text"), [("a.csv", CSV), ("b.CSV", CSV), ("a.toml", TOML)])
def test_both_forms_say_the_same(tmp_path: Path, name: str, text: str) -> None:
    found = read(tmp_path, name, text)
    wanted = {"u_time": [[0.5], [1.5]], "u_a": [[1, 2], [3, 4]], "lamp 1/u_a": [[7], [8]]}
    assert rows(found) == wanted
    assert found.cuts == {1} and found.frames == 2
    assert found.of("lamp 1")["u_a"].at(1) == 8.0 and found.of("nobody") == {}


def test_members_and_elements_keep_their_names(tmp_path: Path) -> None:
    header = "lamps[1].power,lamps[0].colour[1],lamps[0].colour[0],rows[1][1],rows[1][0]"
    found = read(tmp_path, "a.csv", f"{header}\n1,2,3,4,5\n1,2,3,4,5\n")
    wanted = {"lamps[1].power": [1], "lamps[0].colour": [3, 2], "rows[1]": [5, 4]}
    assert {name: first for name, (first, _) in rows(found).items()} == wanted
    assert not any(track.moves for track in found.tracks.values())


def test_what_is_dumped_is_what_is_read(scene: Scene, scene_folder: Path, tmp_path: Path) -> None:
    frames = dumped(scene, 5, SIZE)
    for path in (
        write_csv(tmp_path / "r.csv", frames, cuts=[3]),
        write_toml(tmp_path / "r.toml", frames, cuts=[3]),
    ):
        found = read_recording(path)
        assert found.cuts == {3}
        assert {key.name for key in found.tracks} == set(frames[0])
        for frame, values in enumerate(frames):
            for name, numbers in values.items():
                assert found.of(None)[name].at(frame).tobytes() == numbers.tobytes()


def test_a_scene_plays_it(scene: Scene, tmp_path: Path) -> None:
    # u_model has a semantic, u_light is a constant; nobody else says a value of u_wind.
    text = "u_light[0],u_light[1],u_light[2],u_model[0],u_wind,cut\n1,2,3,4,5,0\n6,7,8,9,10,1\n"
    played = recorded(scene, read(tmp_path, "r.csv", text))
    assert played.view.camera_path.cuts == {1} and played.common.motion.frames == 2
    for frame, light in ((0, [1, 2, 3]), (1, [6, 7, 8]), (2, [6, 7, 8]), (99, [6, 7, 8])):
        values = uniform_values(played.view, played.common, frame, SIZE)
        assert values["u_light"].tolist() == light
        assert values["u_model"].tolist() == [4 if frame == 0 else 9]
        own = uniform_values(scene.view, scene.common, frame, SIZE)
        assert values["u_modelViewProjection"].tobytes() == own["u_modelViewProjection"].tobytes()
    assert not {"u_light", "u_model"} & {
        *played.common.inputs.constants,
        *played.common.inputs.semantics,
    }
    assert played.changes["u_wind"] == "time" and played.changes["u_model"] == "view"


def test_an_object_may_have_values_of_its_own(scene_folder: Path, tmp_path: Path) -> None:
    scene = load_scene(scene_folder / "objects")
    text = "plain/u_time,u_swell\n1,2\n3,4\n"
    played = recorded(scene, read(tmp_path, "r.csv", text))
    time = {part.name: part.inputs.animated.get("u_time") for part in played.parts}
    assert [name for name, track in time.items() if track is not None] == ["plain"]
    assert all("u_swell" in part.inputs.animated for part in played.parts)
    # Where it is with these values, the scene cannot tell.
    assert scene.parts[0].bounds is not None and played.parts[0].bounds is None


def test_what_has_no_recorded_values_is_still_culled(scene_folder: Path, tmp_path: Path) -> None:
    scene = load_scene(scene_folder / "objects")
    played = recorded(scene, read(tmp_path, "r.csv", "plain/u_time\n1\n3\n"))
    assert played.parts[0].bounds == scene.parts[0].bounds is not None


def test_a_scene_file_names_its_recording(scene: Scene, scene_folder: Path) -> None:
    write_csv(scene_folder / "played.csv", dumped(scene, 3, SIZE))
    text = (scene_folder / "scene.toml").read_text()
    path = scene_folder / "played.toml"
    path.write_text(f'{text}\n[recording]\nfile = "played.csv"\n')
    played = load_scene(path)
    assert played.recording is not None and played.common.motion.frames == 3
    path.write_text(f'{text}\n[recording]\nfile = "nothing.csv"\n')
    with pytest.raises(InputError, match="SC507"):
        load_scene(path)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", ": error: a recording has two frames at least, and this has none [SC550]"),
        ("a\n1\n", ": error: a recording has two frames at least, and this has 1 [SC550]"),
        ("a,b[0],b[1]\n1,2,3\n4,,6\n", ":3:3: error: b[0] is blank [SC550]"),
        ("a,b\n1,2\n\n3,4\n", ":3:1: error: a is blank [SC550]"),
        ("a,b\n1,2\n3\n", ":3:1: error: cells: 1 in this line, 2 in the first [SC550]"),
        ("a\r\n1\r\n2,3\r\n", ":3:3: error: cells: 2 in this line, 1 in the first [SC550]"),
        ("a,b\n1, x\n", ":2:4: error: b must be a number, not 'x' [SC550]"),
        ("a,b\n1,NaN\n", ":2:3: error: b must be a finite number, not NaN [SC550]"),
        ("a\n1e999\n", ":2:1: error: a must be a finite number, not 1e999 [SC550]"),
        ("a,cut\n1,2\n", ":2:3: error: cut must be 0 or 1, not 2 [SC550]"),
        ("b[0],b[2]\n1,2\n", ":1:1: error: b has 2 columns, but no b[1] [SC550]"),
        ("cut\n1\n0\n", ":1:1: error: no column is a uniform [SC550]"),
        ("a;b\n1;2\n", ":1:1: error: columns are parted by commas [SC550]"),
    ],
)
def test_mistakes_of_csv(tmp_path: Path, text: str, said: str) -> None:
    assert told(tmp_path, "r.csv", text) == [said]


def test_all_mistakes_of_a_header_are_told(tmp_path: Path) -> None:
    assert told(tmp_path, "r.csv", "a,,a,cut,cut\n") == [
        ":1:3: error: column 2 has no name [SC550]",
        ":1:4: error: the column a is there twice [SC550]",
        ":1:10: error: the column cut is there twice [SC550]",
    ]
    assert len(told(tmp_path, "r.csv", "," * 99)) == 20


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", ": error: a recording has two frames at least, and this has none [SC550]"),
        ("[[frame]]\na = 1\n", ":1:3: error: unknown key frame [SC504]"),
        (
            "[[frames]]\na = 1\nb = 1\n[[frames]]\na = 1\n",
            ":4:3: error: frames[1] has no b, which frames[0] has [SC550]",
        ),
        (
            "[[frames]]\na = 1\n[[frames]]\na = 1\nb = 1\n",
            ":5:1: error: numbers of b: 1 here, none in frames[0] [SC550]",
        ),
        (
            "frames = [{ a = 1 },\n{ a = [1, 2] }]\n",
            ":2:3: error: numbers of a: 2 here, 1 in frames[0] [SC550]",
        ),
        (
            "[[frames]]\na = nan\n[[frames]]\na = 2\n",
            ":2:1: error: frames[0].a must be a finite number, or an array of them, not nan"
            " [SC505]",
        ),
        (
            "[[frames]]\na = 1\ncut = 1\n",
            ":3:1: error: frames[0].cut must be true or false, not 1 [SC505]",
        ),
        ("[[frames]]\n[[frames]]\n", ":1:3: error: frames[0] has no uniform [SC550]"),
        ("a = \n", ":1:5: error: not TOML: Invalid value [SC502]"),
    ],
)
def test_mistakes_of_toml(tmp_path: Path, text: str, said: str) -> None:
    assert told(tmp_path, "r.toml", text) == [said]


def test_other_files_are_no_recordings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "the recording is neither a .csv nor a .toml file [SC501]"
    [said] = told(tmp_path, "r.json", "{}")
    assert said == f"error: {text}".replace("recording", f"recording {tmp_path / 'r.json'}")
    with pytest.raises(InputError, match="SC501"):
        read_recording(tmp_path / "nothing.csv")
    (tmp_path / "bytes.csv").write_bytes(b"a\n\xff\n")
    with pytest.raises(InputError, match="not UTF-8"):
        read_recording(tmp_path / "bytes.csv")
    monkeypatch.setattr(recordings, "MAX_RECORDING", 8)
    [said] = told(tmp_path, "long.csv", "a\n1\n2\n3\n4\n")
    assert "it has more than 8 bytes" in said


def test_an_object_that_is_not_there(scene_folder: Path, tmp_path: Path) -> None:
    scene = load_scene(scene_folder / "objects")
    found = read(tmp_path, "r.csv", "u_time,plane/u_time,plane/u_swell\n1,2,3\n1,2,3\n")
    with pytest.raises(InputError) as caught:
        recorded(scene, found)
    [one] = caught.value.diagnostics
    text = one.render()
    assert "r.csv:1:8: error: plane/u_time: the scene objects has no object 'plane'" in text
    assert "did you mean plain? it has: turning, drifting, bent, plain" in text


def test_numbers_cannot_be_changed(tmp_path: Path) -> None:
    found = read(tmp_path, "a.csv", "a\n1\n2\n")
    with pytest.raises(ValueError, match="read-only"):
        found.of(None)["a"].at(0)[:] = np.array([3.0])
