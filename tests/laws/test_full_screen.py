"""Full-screen shaders: laws 1 to 4, and what each mapping promises beside them.

``clouds`` is a Shadertoy and reuses the value of the same pixel; ``orbit`` (in space) and
``scroll`` (flat, and in GLSL ES) say where the last frame showed what a pixel shows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from laws.ground_truth import VERTEX, body_mesh, body_scene
from laws.slices import VARIABLE, day_slice, seed
from manifests import plain

from shadercache.analysed import unchanged_for
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis, analyse, emit_original
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.made_scene import made_scene
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.configured import configured, rewritten, variant
from tests.conftest import Golden
from tests.glslang import needs_glslang, objections

pytestmark = pytest.mark.xdist_group("gl")

FOLDER = Path(__file__).with_name("full_screen")
MAPPINGS: dict[str, MappingKind] = {"clouds": "screen", "orbit": "user", "scroll": "user"}
SIZE = (64, 48)
NODES = 3
FRAMES = range(4)
ALL = ("1-pass", "2-pass", "3-pass")

Change = Callable[[str], str]


def reading(name: str) -> ReadOptions:
    return ReadOptions(dialect="shadertoy" if name == "clouds" else "glsl")


@cache
def analysed(name: str) -> Analysis:
    return open_scene(FOLDER / f"{name}.frag", reading(name), MAPPINGS[name])[1]


def node_of(analysis: Analysis, text: str) -> Candidate:
    return next(node for node in analysis.nodes if node.legal and node.text == text)


def bundle_of(analysis: Analysis, text: str, mode: Mode, change: Change | None = None) -> Bundle:
    """The variants of a node, with every text changed."""
    found = rewritten(
        analysis, node_of(analysis, text), configured(mode=mode, form="rgba32f"), unprofitable=True
    )
    if change is None:
        return Bundle(found.manifest, found.files)
    files = {file: change(text) for file, text in found.files.items()}
    assert files != found.files, "a mutation of nothing is no test"
    return Bundle(found.manifest, files)


@pytest.mark.parametrize("name", MAPPINGS)
def test_laws_1_to_4(name: str, gpu: Gpu) -> None:
    scene, analysis = open_scene(FOLDER / f"{name}.frag", reading(name), MAPPINGS[name])
    legal = [node for node in analysis.nodes if node.legal]
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        found = verifier.round_trip()
        assert found is not None and found.exact
        assert verifier.references.covered[0].all(), "the triangle covers the whole picture"
        verdicts = [verifier.check(node) for node in day_slice(legal, seed(), NODES)]
    broken = {item.text: item.failure or item.broken for item in verdicts if item.broken}
    assert not broken, f"{VARIABLE}={seed()} repeats this"


@pytest.fixture(scope="module")
def clouds(gpu: Gpu) -> Iterator[RenderScene]:
    with RenderScene(
        gpu, made_scene(FOLDER / "clouds.frag", analysed("clouds")), SIZE, "rgba32f"
    ) as made:
        yield made


@dataclass(frozen=True)
class Run:
    """Frames of a variant beside those of the original: which differ, and how much was reused."""

    exact: bool
    reused: float


def run(world: RenderScene, bundle: Bundle, algorithm: str, period: int) -> Run:
    truth = render_original(world, [bundle], FRAMES)
    assert not np.array_equal(truth[0], truth[-1]), "nothing moves, so nothing is tested"
    exact, reused = True, 1.0
    with variant(world, bundle, algorithm, period=period) as runner:
        for frame in FRAMES:
            if frame > 0:
                mask = runner.hit_mask(frame)
                reused = min(reused, float((mask == bundle.mask_values["hit"]).mean()))
            exact &= runner.image(frame).tobytes() == truth[frame].tobytes()
    return Run(exact, reused)


BUT_THREE = ("1-pass", "2-pass")
STATIC = (
    "smoothstep(0.35, 0.8, fbm(5.0 * uv))",
    "uv.y > horizon",
    "1.0 / (horizon + 0.01 - uv.y)",
)


@pytest.mark.parametrize("text", STATIC)
def test_what_depends_on_nothing_that_changes_is_exact_for_any_period(
    clouds: RenderScene, text: str
) -> None:
    analysis = analysed("clouds")
    node = node_of(analysis, text)
    assert set(unchanged_for(analysis, (node,)) or ()) <= {"iResolution", "iChannel0"}
    bundle = bundle_of(analysis, text, "proof")
    assert tuple(bundle.algorithms) == ALL
    for algorithm in ALL:
        found = run(clouds, bundle, algorithm, NEVER)
        assert found.exact
        assert found.reused > 0.99 or node.unsure, "below the horizon alone there is a depth"
        assert found.reused > 0.2


def test_what_changes_with_time_is_as_old_as_the_period(clouds: RenderScene) -> None:
    analysis = analysed("clouds")
    text = "fbm(vec2(uv.x * depth, depth + 2.0 * iTime))"
    assert "iTime" in (unchanged_for(analysis, (node_of(analysis, text),)) or ())
    bundle = bundle_of(analysis, text, "proof")
    assert all(run(clouds, bundle, algorithm, 1).exact for algorithm in ALL)
    stale = run(clouds, bundle, "1-pass", 4)
    assert not stale.exact and stale.reused > 0.1


def replaced(old: str, new: str) -> Change:
    return lambda text: text.replace(old, new)


OWN = "ivec2 near = ivec2(gl_FragCoord.xy);"
BROKEN = {
    "one pixel off": replaced(OWN, f"{OWN[:-1]} + ivec2(1, 0);"),
    "payload not stored": replaced("vec4(sc_payload, ", "vec4(0.0, "),
}


@pytest.mark.parametrize("name", BROKEN)
@pytest.mark.parametrize("algorithm", ALL)
def test_a_broken_look_up_is_noticed(clouds: RenderScene, name: str, algorithm: str) -> None:
    bundle = bundle_of(analysed("clouds"), next(iter(STATIC)), "proof", BROKEN[name])
    assert not run(clouds, bundle, algorithm, NEVER).exact


def test_a_look_up_without_hits_is_noticed(clouds: RenderScene) -> None:
    bundle = bundle_of(
        analysed("clouds"), next(iter(STATIC)), "proof", replaced("return sc_hit;", "return 4;")
    )
    assert run(clouds, bundle, "1-pass", NEVER).reused == 0.0


LARGE = (256, 192)
LEAST_HITS = 0.9
"""Of the pixels that show the ball or the floor. Measured: 0.94; the rest is seen edge on."""

FARTHEST = 0.1
"""How far, in pixels, a frame of reuse may lead away from the point: 99 of 100. Measured: 0.033."""

SKY = 11.9


@cache
def points() -> Analysis:
    """``orbit`` with the point that a pixel shows in place of its colour, and how far it is."""
    text = (FOLDER / "orbit.frag").read_text(encoding="utf-8")
    body = text[: text.rindex("    o_color =")]
    body += "    o_color = vec4(p, length(p - camera(u_time).eye));\n}\n"
    return analyse(Source("points.frag", body), mapping="user")


def astray(gpu: Gpu, algorithm: str, change: Change | None = None) -> list[str]:
    """What is wrong with the hits of ``orbit`` in motion, by the true point of each pixel."""
    bundle = bundle_of(points(), "shown()", "plain", change)
    wrong: list[str] = []
    with RenderScene(gpu, made_scene(FOLDER / "orbit.frag", points()), LARGE, "rgba32f") as world:
        truth = render_original(world, [bundle], FRAMES)
        with variant(world, bundle, algorithm, period=NEVER) as runner:
            for frame in FRAMES:
                hit = runner.hit_mask(frame) == bundle.mask_values["hit"]
                image, true = runner.image(frame), truth[frame]
                solid = true[..., 3] < SKY
                assert 0.5 < solid.mean() < 1.0
                if frame == 0:
                    continue
                pixel = true[..., 3] / (1.6 * LARGE[1] / 2)
                off = np.linalg.norm(image[..., :3] - true[..., :3], axis=-1) / pixel
                if (hit & solid).sum() < LEAST_HITS * solid.sum():
                    wrong.append("hits are missing")
                elif np.percentile(off[hit & solid], 99) > FARTHEST * frame:
                    wrong.append("another point is shown")
                elif not off[hit & solid].any():
                    wrong.append("nothing was reused")
    return wrong


@pytest.mark.parametrize("algorithm", BUT_THREE)
def test_the_users_mapping_finds_the_same_point(gpu: Gpu, algorithm: str) -> None:
    assert astray(gpu, algorithm) == []


ASTRAY = {
    "one pixel off": (
        replaced("place = gl_FragCoord.xy - 0.5", "place = gl_FragCoord.xy + vec2(0.5, -0.5)"),
        "hits are missing",
    ),
    "as if nothing moved": (
        replaced("sc_previous = scPreviousClip()", "sc_previous = sc_current"),
        "another point is shown",
    ),
    "half the way": (
        replaced("place = gl_FragCoord.xy - 0.5 + 0.5", "place = gl_FragCoord.xy - 0.5 + 0.25"),
        "hits are missing",
    ),
    "no hits": (replaced("return sc_hit;", "return 4;"), "hits are missing"),
    "depth not stored": (replaced("16.0 / sc_current.w", "16.0"), "hits are missing"),
}


@pytest.mark.parametrize("name", ASTRAY)
def test_a_broken_mapping_is_noticed(gpu: Gpu, name: str) -> None:
    change, words = ASTRAY[name]
    assert words in astray(gpu, "1-pass", change)


def test_slow_scrolling_is_no_rest(gpu: Gpu) -> None:
    """Where only the previous place is told, what is no motion is far less than a pixel."""
    analysis = analysed("scroll")
    bundle = bundle_of(analysis, "rings", "plain")
    scene = made_scene(FOLDER / "scroll.frag", analysis)
    with RenderScene(gpu, scene, LARGE, "rgba32f") as world:
        truth = render_original(world, [bundle], FRAMES)
        with variant(world, bundle, "2-pass", period=NEVER) as runner:
            for frame in FRAMES:
                hit = runner.hit_mask(frame) == bundle.mask_values["hit"]
                off = np.abs(runner.image(frame) - truth[frame])[..., 0]
                if frame:
                    assert hit.mean() > 0.95
                    assert off[hit].max() < 0.01
                    assert np.abs(truth[frame] - truth[0]).max() > 0.05


SOLID = """#version 330
in vec3 v_position;
in vec3 v_normal;
uniform mat4 u_modelViewProjection;
out vec4 o_color;
float bands(vec3 p) { return sin(9.0 * p.x) * cos(5.0 * p.y) + sin(4.0 * p.z + cos(p.x)); }
vec4 scPreviousClip() { return u_modelViewProjection * vec4(v_position, 1.0); }
vec4 scCurrentClip() { return u_modelViewProjection * vec4(v_position, 1.0); }
void main() {
    float grain = bands(v_position) * bands(0.1 * vec3(gl_FragCoord.xy, 1.0));
    o_color = vec4(0.5 + 0.5 * grain * normalize(v_normal).z + bands(v_normal));
}
"""


@pytest.mark.parametrize("mapping", ["screen", "user"])
def test_laws_2_to_4_on_a_mesh(gpu: Gpu, mapping: MappingKind) -> None:
    """With a vertex shader of the user's, which stays as it is: no twins, no added varyings."""
    analysis = analyse(Source("solid.frag", SOLID), Source("solid.vert", VERTEX), mapping=mapping)
    nodes = [node_of(analysis, text) for text in ("bands(v_position)", "bands(v_normal)")]
    if mapping == "screen":
        nodes.append(node_of(analysis, "grain"))
        assert unchanged_for(analysis, nodes[-1:]) == ("a_position", "u_modelViewProjection")
    emission = rewritten(analysis, nodes[0])
    assert not emission.manifest.previous
    assert plain(emission.manifest)["draw"] == {"geometry": "objects"}
    assert "sc_" not in emission.files["1-pass.vert"]
    scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
    with closing(Verifier(gpu, (scene, analysis), SIZE, mesh)) as verifier:
        verdicts = [verifier.check(node) for node in nodes]
    broken = {item.text: item.failure or item.broken for item in verdicts if item.broken}
    assert not broken


@pytest.mark.parametrize("name", MAPPINGS)
def test_golden(name: str, golden: Golden) -> None:
    texts = {
        "clouds": next(iter(STATIC)),
        "orbit": "marble(p) + 0.5 * marble(2.1 * p.zxy)",
        "scroll": "rings",
    }
    analysis = analysed(name)
    emission = rewritten(analysis, node_of(analysis, texts[name]), unprofitable=True)
    for file in ("1-pass.frag", "1-pass.vert", "2-pass.miss.frag", "3-pass.reuse.frag"):
        golden(FOLDER / name / file, emission.files[file])


@needs_glslang
@pytest.mark.parametrize("mode", ("plain", "proof"))
@pytest.mark.parametrize("name", MAPPINGS)
def test_the_reference_compiler_takes_every_program(name: str, mode: Mode, tmp_path: Path) -> None:
    analysis = analysed(name)
    files = emit_original(analysis, mode).files
    assert not objections(files.items(), tmp_path)
    for node in day_slice([n for n in analysis.nodes if n.legal], seed(), NODES):
        files = rewritten(analysis, node, configured(mode=mode), unprofitable=True).files
        assert not objections(files.items(), tmp_path), node.text
