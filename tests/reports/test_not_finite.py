"""Payloads that are not finite, or fit no format: right in their own frame, and never reused.

Each shader swallows what is not finite, by a comparison, ``min``, ``clamp`` or a branch, so that
nothing odd is left in the picture.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import closing
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from laws.ground_truth import VERTEX, body_mesh, body_scene
from numpy.typing import NDArray

from shadercache.caching.configuration import CacheFormat, Mode
from shadercache.caching.layout import Layout
from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis, analyse
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.source import Source
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.configured import DEFAULT, configured, rewritten, variant

pytestmark = pytest.mark.xdist_group("gl")

FOLDER = Path(__file__).with_name("not_finite")
SIZE = (48, 32)
ALL = ("1-pass", "2-pass", "3-pass")

PAYLOADS = {
    "o08_payload_not_finite": ("pow(uv - 0.5, vec2(1.7))", "vec4(exp(a), uv.x, 1.0)"),
    "o20_not_finite_but_absorbed": ("acos(p.x * 2.0) * exp(p.y)", "acos(p.x * 2.0)"),
    "almost_the_largest": ("march(p)",),
    "infinity_in_a_branch": ("exp(2.0 * p.y) / floor(4.0 * p.x)", "2.0 * far"),
    "integers_beside_a_nan": ("march(p)",),
    "inverse_of_a_matrix": ("turned * (p + 1.0)",),
    "packed_in_a_float": ("held",),
    "struct_in_two_texels": ("lit(p)", "it.more"),
    "subnormal_bits": ("tiny",),
    "surface_mixed": ("layer(v_position)",),
    "surface_spots": ("odd", "sqrt(wave.x + 0.6)"),
    "surface_two_texels": ("lit(v_position)", "abs(it.more)"),
}
"""Shader -> the values that are cached."""

LARGE = "1e4 + 1e5 * sin(1.5 * p.x) * sin(1.5 * p.y)"

CASES = [(name, text) for name, texts in PAYLOADS.items() for text in texts]


@cache
def analysed(name: str) -> Analysis:
    path = FOLDER / f"{name}.frag"
    if name.startswith("surface"):
        text = path.read_text(encoding="utf-8")
        return analyse(Source(path.name, text), Source("shader.vert", VERTEX))
    return open_scene(path, mapping="screen")[1]


def verifier(gpu: Gpu, name: str, settings: str = "") -> Verifier:
    cached = with_settings(DEFAULT, [settings] if settings else [])
    if name.startswith("surface"):
        scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
        return Verifier(gpu, (scene, analysed(name)), SIZE, mesh=mesh, configuration=cached)
    scene, _ = open_scene(FOLDER / f"{name}.frag", mapping="screen")
    return Verifier(gpu, (scene, analysed(name)), SIZE, configuration=cached)


def world(gpu: Gpu, name: str) -> RenderScene:
    if name.startswith("surface"):
        scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
        return RenderScene(gpu, scene, (96, 96), "rgba32f", mesh)
    scene, _ = open_scene(FOLDER / f"{name}.frag", mapping="screen")
    return RenderScene(gpu, scene, SIZE, "rgba32f")


def bundle(
    name: str, text: str, form: CacheFormat, settings: str = "", mode: Mode = "plain"
) -> Bundle:
    cached = with_settings(DEFAULT, [settings] if settings else [])
    node = next(node for node in analysed(name).nodes if node.legal and node.text == text)
    options = configured(cached, mode=mode, form=form)
    emission = rewritten(analysed(name), node, options, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def changed(made: Bundle, change: Callable[[str], str]) -> Bundle:
    files = {file: change(text) for file, text in made.files.items()}
    assert files != made.files, "a mutation of nothing is no test"
    return Bundle(made.manifest, files)


@pytest.mark.parametrize(("name", "text"), CASES, ids=[f"{n}-{t}" for n, t in CASES])
def test_laws_2_to_4(gpu: Gpu, name: str, text: str) -> None:
    node = next(node for node in analysed(name).nodes if node.legal and node.text == text)
    with closing(verifier(gpu, name)) as checks:
        verdict = checks.check(node, plain=False)
    assert verdict.algorithms == set(ALL)
    assert verdict.broken == [], verdict.failure or verdict.cause


@pytest.mark.parametrize("settings", ["guard=clamp", "guard=off", "filter=nearest", "age"])
@pytest.mark.parametrize("name", ["o20_not_finite_but_absorbed", "surface_mixed"])
def test_the_frame_itself_is_right_under_every_guard(gpu: Gpu, name: str, settings: str) -> None:
    text = PAYLOADS[name][0]
    node = next(node for node in analysed(name).nodes if node.legal and node.text == text)
    with closing(verifier(gpu, name, settings)) as checks:
        verdict = checks.check(node, plain=False)
    assert not [law for law in verdict.broken if not law.startswith("law 3")]
    # What is brought into range for later frames is no longer what was computed.
    assert bool(verdict.broken) == (settings == "guard=clamp")


HELD = re.compile(r"        sc_store\.w = ")


def test_the_laws_notice_another_value_in_its_place(gpu: Gpu) -> None:
    """As it was before: the texel held what comes nearest."""
    name = "o20_not_finite_but_absorbed"
    worse = "        sc_store = vec4(0.0);\n        sc_store.w = "
    made = changed(
        bundle(name, PAYLOADS[name][0], "rgba32f", mode="proof"),
        lambda text: HELD.sub(worse, text),
    )
    with closing(verifier(gpu, name)) as checks:
        verdict = checks.check(
            next(node for node in analysed(name).nodes if node.id == made.node("id")), plain=False
        )
        verdict.laws["always"].clear()
        judge(checks.references, made, verdict)
    assert "law 2 (3-pass)" in verdict.broken


FILTERS = (
    "filter=bilateral",
    "filter=bilinear",
    "filter=bilinear,fallback",
    "filter=nearest",
    "filter=lanczos2",
    "filter=lanczos2,fallback",
    "filter=mitchell,fallback",
)
SETTINGS = (
    *FILTERS,
    "magnification",
    "depth=linear",
    "depth=linear,filter=mitchell",
    "depth=ndc,filter=bilinear",
    "depth=ndc,filter=nearest",
    "tolerance=akeley-su",
    "ids",
    "guard=clamp",
)
SURFACES = {"surface_spots": "odd", "surface_mixed": "layer(v_position)"}


def reused(gpu: Gpu, name: str, made: Bundle) -> tuple[NDArray[np.float32], int]:
    """The payloads that hits of three frames in motion brought back, and how many pixels missed
    because of what was stored."""
    node = next(node for node in analysed(name).nodes if node.id == made.node("id"))
    places = Layout((node.type,)).read_back
    channels = [channel for channel, discrete in places if not discrete]
    hits, poisoned = [], 0
    with (
        world(gpu, name) as canvas,
        variant(canvas, made, "2-pass", period=64) as runner,
    ):
        runner.draw(0)
        for frame in range(1, 4):
            mask = runner.hit_mask(frame)
            runner.draw(frame)
            hits.append(runner.cache()[mask == made.mask_values["hit"]][:, channels])
            poisoned += int((mask == made.mask_values.get("poison", 99)).sum())
    return np.concatenate(hits), poisoned


@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
@pytest.mark.parametrize("settings", SETTINGS)
def test_no_hit_brings_back_what_is_not_finite(gpu: Gpu, settings: str, form: CacheFormat) -> None:
    name = "surface_spots"
    made = bundle(name, SURFACES[name], form, settings)
    found, poisoned = reused(gpu, name, made)
    assert len(found) > 500
    assert poisoned > 100 or "clamp" in settings
    assert np.isfinite(found).all()


@pytest.mark.parametrize("settings", ["filter=bilateral", "filter=bilinear", "depth=linear"])
@pytest.mark.parametrize("name", ["surface_mixed", "surface_two_texels"])
def test_nor_from_integers_and_from_two_texels(gpu: Gpu, name: str, settings: str) -> None:
    text = PAYLOADS[name][0]
    found, poisoned = reused(gpu, name, bundle(name, text, "rgba32f", settings))
    assert len(found) > 500
    assert poisoned > 100
    assert np.isfinite(found).all()


FILTERED = (
    ("surface_spots", "sin(9.0 * v_position) * cos(5.0 * v_position.yzx)", 0.05),
    ("surface_spots", "cos(5.0 * v_position.yzx)", 0.05),
    ("surface_spots", "wave.x + 0.6", 0.05),
    ("surface_two_texels", "wave.xyzx * 0.5 + 0.5", 0.05),
    ("surface_tiny", "exp2(-125.0 + 6.0 * wave) * (1.5 + wave)", 2.0**-121),
)


@pytest.mark.parametrize(("name", "text", "least"), FILTERED)
def test_the_algorithms_agree_on_what_a_filter_makes(
    gpu: Gpu, name: str, text: str, least: float
) -> None:
    """Between larger numbers a filter finds some below the smallest that is reused: they are no
    poison in any algorithm. Drivers that flush such numbers hide it, so the bound is raised."""
    made = changed(
        bundle(name, text, "rgba32f", mode="proof"),
        lambda source: source.replace("floatBitsToUint(sc_least)", f"floatBitsToUint({least})"),
    )
    verdict = Verdict(made.node("id"), "", "", True)
    with closing(verifier(gpu, name)) as checks:
        judge(checks.references, made, verdict)
    assert all(found.exact for found in verdict.laws["agreeing"].values()), verdict.reasons


WEIGHED = re.compile(r"weights\.([xyzw]) > 0\.0 \? weights\.\1 \* ([abcd]) : vec4\(-0\.0\)")
MARKED = re.compile(r"        sc_store\.w = \S+;\n")


def test_weights_of_zero_are_noticed(gpu: Gpu) -> None:
    name, text = "surface_spots", SURFACES["surface_spots"]
    made = bundle(name, text, "rgba32f")
    worse = changed(made, lambda source: WEIGHED.sub(r"weights.\1 * \2", source))
    assert not np.isfinite(reused(gpu, name, worse)[0]).all()


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("settings", FILTERS)
def test_a_mark_that_is_dropped_is_noticed(gpu: Gpu, settings: str, name: str) -> None:
    made = bundle(name, SURFACES[name], "rgba32f", settings)
    worse = changed(made, lambda source: MARKED.sub("", source))
    assert not np.isfinite(reused(gpu, name, worse)[0]).all()


HALF_FLOATS = (
    "o08_payload_not_finite",
    "o20_not_finite_but_absorbed",
    "infinity_in_a_branch",
    "struct_in_two_texels",
    "surface_spots",
)


def frame(gpu: Gpu, name: str, made: Bundle, algorithm: str, short: bool = False) -> np.ndarray:
    """The first frame of a variant, or of the original."""
    with world(gpu, name) as canvas:
        if algorithm == "original":
            with OriginalRunner(canvas, made) as original:
                return original.image(0)
        options = {"period": 1, "short_reset": short}
        with variant(canvas, made, algorithm, **options) as runner:
            return runner.image(0)


@pytest.mark.parametrize("name", HALF_FLOATS)
def test_three_passes_read_it_back_from_half_floats(gpu: Gpu, name: str) -> None:
    made = bundle(name, PAYLOADS[name][0], "rgba16f")
    image, truth = (frame(gpu, name, made, which) for which in ("3-pass", "original"))
    assert np.array_equal(np.isnan(image), np.isnan(truth))
    known = np.isfinite(truth)
    assert np.abs(image[known] - truth[known]).max() < 0.01


def test_half_floats_hold_no_larger_numbers(gpu: Gpu) -> None:
    """The one exception, and the manifest says so."""
    name = "too_large_for_half"
    made = bundle(name, LARGE, "rgba16f")
    image, truth = (frame(gpu, name, made, which) for which in ("3-pass", "original"))
    light = 3e4 * truth[..., 0] / (1.0 - truth[..., 0])
    assert light.max() > 7e4
    held = np.minimum(light, 65504.0)
    assert image[..., 0] == pytest.approx(held / (held + 3e4), rel=1e-3)
    assert any("65504" in sentence for sentence in made.manifest.relies_on)
    wide = bundle(name, LARGE, "rgba32f")
    assert not any("65504" in sentence for sentence in wide.manifest.relies_on)
    assert frame(gpu, name, wide, "3-pass") == pytest.approx(truth, rel=1e-6)


def test_the_manifest_says_what_a_reset_shows(gpu: Gpu) -> None:
    name = "surface_spots"
    made = bundle(name, PAYLOADS[name][0], "rgba16f")
    said = " ".join(made.manifest.reset)
    assert "and the image is the original's" not in said
    assert "rgba16f rounds it" in said
    two, three = (frame(gpu, name, made, which) for which in ("2-pass", "3-pass"))
    assert not np.array_equal(two, three, equal_nan=True)
    assert np.array_equal(two, frame(gpu, name, made, "3-pass", short=True), equal_nan=True)
