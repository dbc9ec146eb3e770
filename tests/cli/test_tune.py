"""``shadercache tune``: what it promises, and what it says where there is nothing to gain."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from shadercache.paths import data_path
from tests.cli.conftest import Shell

SMALL = ("--mesh", str(data_path("corpus", "dragon", "dragon-small.npz")), "--size", "96")


@pytest.mark.slow
def test_choices_hold_their_bounds_and_come_with_their_numbers(shell: Shell) -> None:
    told = shell(
        "tune", "dragon", "--max-error", "0.004,0.3", "--budget", "12s", *SMALL, "--json"
    ).json
    assert told["bounds"] == [0.004, 0.3] and 0 < told["drawn"] < told["combinations"]
    for answer in told["answers"]:
        if answer["proven"] is None:
            assert answer["why"]
            continue
        proven = told["proven"][answer["proven"]]
        assert [passage["step"] for passage in proven["passages"]] == [1, 2]
        assert max(p["worst"] for p in proven["passages"]) == proven["worst"] <= answer["bound"]
        assert all(p["speedup"]["low"] > 1.0 for p in proven["passages"])
        [group] = answer["assignment"]
        assert group["objects"] == ["dragon"] and group["configuration"]["nodes"]
    seen = {one["start"] for proven in told["proven"] for one in proven["passages"]}
    assert 0 not in seen  # no frame that the choice was made by


@pytest.mark.slow
@pytest.mark.parametrize("metric", ["psnr", "flip", "flicker"])
def test_every_metric(shell: Shell, metric: str) -> None:
    limit = "20" if metric == "psnr" else "0.3"
    outcome = shell(
        "tune", "dragon", "--metric", metric, "--max-error", limit, "--budget", "8s", *SMALL
    )
    assert outcome.status == 0
    assert f"{metric} {limit}" in outcome.out


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--max-error", "0"), "'0' is no bound for rmse"),
        (("--max-error", "-1"), "'-1' is no bound"),
        (("--max-error", "nan"), "'nan' is no bound"),
        (("--max-error", "2"), "'2' is no bound"),
        (("--max-error", "x"), "'x' is no value for --max-error"),
        (("--max-error", "0.1,"), "'0.1,' is no value for --max-error"),
        (("--max-error", "0.1", "--budget", "0"), "'0' is no value for --budget"),
        (("--max-error", "0.1", "--budget", "-3s"), "'-3s' is no value for --budget"),
        (("--max-error", "0.1", "--budget", "soon"), "'soon' is no value for --budget"),
        ((), "missing option"),
    ],
)
def test_wrong_options(shell: Shell, options: tuple[str, ...], message: str) -> None:
    outcome = shell("tune", "dragon", *options)
    assert outcome.status == 2 and message in outcome.err.lower()


def test_a_budget_that_is_too_short_says_what_it_takes(shell: Shell) -> None:
    outcome = shell("tune", "dragon", "--max-error", "0.01", "--budget", "0.1s", *SMALL)
    assert outcome.status == 2
    assert "SC047" in outcome.err and "--budget" in outcome.err


def test_a_scene_that_never_moves(shell: Shell, scene_folder: Path, tmp_path: Path) -> None:
    folder = tmp_path / "still"
    shutil.copytree(scene_folder, folder)
    path = folder / "scene.toml"
    text = path.read_text(encoding="utf-8").replace(
        "degrees_per_frame = 2.0", "degrees_per_frame = 0.0"
    )
    path.write_text(text, encoding="utf-8")
    outcome = shell("tune", str(path), "--max-error", "0.01")
    assert outcome.status == 1
    assert "SC048" in outcome.err and "nothing moves" in outcome.err


NOTHING = """#version 330
uniform float u_time; out vec4 o_color;
void main() { o_color = vec4(u_time); }
"""
NOISE = """#version 330
uniform int u_frame; uniform vec2 u_resolution; out vec4 o_color;
float noise(vec2 p) {
    for (int i = 0; i < 9; i++) p = fract(sin(p.yx * 91.7 + float(u_frame)) * 437.5);
    return p.x;
}
void main() { o_color = vec4(noise(gl_FragCoord.xy / u_resolution)); }
"""


@pytest.mark.parametrize(
    ("text", "why"), [(NOTHING, "no value to cache"), (NOISE, "in every frame")]
)
def test_nothing_to_gain_is_an_answer(shell: Shell, tmp_path: Path, text: str, why: str) -> None:
    path = tmp_path / "full.frag"
    path.write_text(text, encoding="utf-8")
    outcome = shell("tune", str(path), "--max-error", "0.01", "--size", "64", "--budget", "10s")
    assert outcome.status == 0
    assert "leave it alone" in outcome.out and why in outcome.out


def test_recorded_frames_are_played(shell: Shell, tmp_path: Path) -> None:
    outcome = shell("tune", "dragon", "--max-error", "0.1", "--frames", str(tmp_path / "no.csv"))
    assert outcome.status == 1 and "no.csv" in outcome.err
    path = tmp_path / "still.csv"
    path.write_text("u_light[0],u_light[1],u_light[2]\n" + 4 * "0.4,0.8,0.4\n", encoding="utf-8")
    # The recording holds the light alone; what the scene says of the rest goes on.
    text = data_path("corpus", "dragon", "scene.toml").read_text(encoding="utf-8")
    folder = tmp_path / "dragon"
    shutil.copytree(data_path("corpus", "dragon"), folder)
    (folder / "scene.toml").write_text(
        text.replace("degrees_per_frame = 1.0", "degrees_per_frame = 0.0"), encoding="utf-8"
    )
    still = shell("tune", str(folder), "--max-error", "0.1", "--frames", str(path))
    assert still.status == 1 and "SC048" in still.err


@pytest.mark.slow
def test_what_was_chosen_is_handed_over_and_runs(shell: Shell, tmp_path: Path) -> None:
    out, page = tmp_path / "out", tmp_path / "page.html"
    asked = ("tune", "dragon", "--max-error", "0.02,0.3", "--budget", "12s", *SMALL)
    outcome = shell(*asked, "-o", str(out), "--page", str(page))
    assert outcome.status == 0 and page.stat().st_size > 1e6
    folders = [folder for folder in (out / "0.02", out / "0.3") if folder.is_dir()]
    assert len(folders) == outcome.out.count("INTEGRATION.md")
    for folder in folders:
        assert (folder / "manifest.json").is_file()
        text = (folder / "INTEGRATION.md").read_text(encoding="utf-8")
        assert "Error in rmse" in text
        ran = subprocess.run(
            [sys.executable, "example.py"], cwd=folder, capture_output=True, text=True, check=False
        )
        assert ran.returncode == 0, ran.stderr
        assert (folder / "example.png").is_file()


def test_rewrite_chooses_where_it_is_asked(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "full.frag"
    path.write_text(NOTHING, encoding="utf-8")
    asked = ("rewrite", str(path), "-o", str(tmp_path / "out"))
    outcome = shell(*asked, "--auto", "--max-error", "0.01", "--budget", "10s")
    assert outcome.status == 0 and "leave it alone" in outcome.out
    assert not (tmp_path / "out").exists()
    sized = shell(*asked, "--auto", "--max-error=0.01", "--budget=10s", "--size=96x64")
    assert sized.status == 0 and "at 96x64" in sized.out
    for options in (("--max-error=0.1",), ("--size=96",), ("--auto", "--size=x")):
        assert shell(*asked, *options, "--node=a.1-0").status == 2
    for options in (("--auto",), ("--auto", "--max-error", "0.1", "--node", "a.1-0"), ()):
        assert shell(*asked, *options).status == 2
