"""Laws 2 to 5 for a payload of every type: the bits that are stored are the bits that come back."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from laws.ground_truth import body_mesh, body_scene
from laws.test_mutations import Replace, broken
from payloads import DESKTOP, ES, FRAGMENT, PAYLOADS, VERTEX, analysed_payload
from render.test_independent_runner import agree

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.manifest.codec import encode
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, configured, rewritten, variant

pytestmark = pytest.mark.xdist_group("payload-types")

ALL = ("1-pass", "2-pass", "3-pass")
HIT = "2-pass.hit.frag"
CASES = [(name, DESKTOP) for name in PAYLOADS] + [
    (name, ES) for name in ("vec4", "ivec3", "bvec2", "mat2", "Mixed")
]


@pytest.fixture(
    scope="module", params=CASES, ids=[f"{name}{'-es' * (head == ES)}" for name, head in CASES]
)
def case(gpu: Gpu, request: pytest.FixtureRequest) -> Iterator[tuple[Verifier, Candidate]]:
    """The trash can's shape, turning fast, under a shader with such a payload."""
    analysis, node = analysed_payload(*request.param)
    scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
    with closing(Verifier(gpu, (scene, analysis), mesh=mesh)) as made:
        yield made, node


def proof_of(verifier: Verifier, node: Candidate) -> Bundle:
    emission = rewritten(verifier.analysis, node, PROOF, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def test_laws_2_to_4(case: tuple[Verifier, Candidate]) -> None:
    verifier, node = case
    verdict = verifier.check(node)
    assert verdict.broken == [], verdict.failure
    assert verdict.algorithms == set(ALL)
    # Drivers round a mediump number before it becomes an integer, or do not: up to a step here.
    discrete = node.type.bases != {"float"}
    for item in verdict.plain.values():
        assert item.maximum < 1e-5 or (discrete and item.changed < 0.01)


def test_payloads_are_reused_in_motion(case: tuple[Verifier, Candidate]) -> None:
    """Else the laws would hold because everything is computed anew."""
    verifier, node = case
    bundle = proof_of(verifier, node)
    with variant(verifier.references.world, bundle, "2-pass", period=64) as runner:
        for frame in range(3):
            runner.draw(frame)
        mask = runner.hit_mask(3)
    share = (mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum()
    # Where integers change from one pixel to the next, nothing may be reused.
    assert share > (0.8 if node.type.bases == {"float"} else 0.1)


@pytest.mark.parametrize(
    "case", [(name, DESKTOP) for name in ("vec4", "int", "bvec4", "mat2", "Mixed")], indirect=True
)
def test_a_store_that_loses_the_payload_is_noticed(case: tuple[Verifier, Candidate]) -> None:
    verifier, node = case
    bundle = proof_of(verifier, node)
    store, kind = (
        "sc_store = sc_pack();",
        "uvec" if "uvec4 sc_store" in bundle.files[HIT] else "vec",
    )
    lost = {store: f"{store} sc_store.xyz = {kind}3(0);"}
    if "sc_store_2" in bundle.files[HIT]:
        lost["sc_store_2 = sc_pack_2();"] = f"sc_store_2 = {kind}4(0);"
    for old, new in lost.items():
        mutation = Replace(old, new, "2-pass.miss")
        assert "law 3 (2-pass)" in broken(verifier, mutation.bundle(bundle)), old


@pytest.mark.parametrize("name", ["vec4", "bits", "Mixed"])
def test_an_engine_needs_only_the_manifest(gpu: Gpu, tmp_path: Path, name: str) -> None:
    analysis, node = analysed_payload(name)
    emission = rewritten(analysis, node, unprofitable=True)
    for file, text in emission.files.items():
        (tmp_path / file).write_text(text)
    (tmp_path / "manifest.json").write_text(encode(emission.manifest))
    bundle = load_bundle(tmp_path)
    scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
    with RenderScene(gpu, scene, (96, 96), "rgba32f", mesh) as world:
        for algorithm in ALL:
            assert agree(world, bundle, tmp_path, algorithm, None)
            assert agree(world, bundle, tmp_path, algorithm, "rgba32f")


@pytest.mark.parametrize("name", ["vec3", "vec4", "bits", "Mixed"])
def test_a_run_can_be_taken_up_from_its_cache(gpu: Gpu, name: str) -> None:
    analysis, node = analysed_payload(name)
    emission = rewritten(analysis, node, configured(form="rgba32f"), unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    scene, mesh = body_scene("trashcan", 1.0), body_mesh("trashcan")
    with (
        RenderScene(gpu, scene, (96, 96), "rgba32f", mesh) as world,
        variant(world, bundle, "2-pass") as runner,
        variant(world, bundle, "3-pass") as other,
    ):
        runner.draw(0)
        stored = runner.cache()
        image = runner.image(1).copy()
        other.restore(stored, 0)
        assert other.cache().tobytes() == stored.tobytes()
        assert other.image(1).tobytes() == image.tobytes()


CELLS = "ivec3(floor(4.0 * v_position))"
NO_QUESTION = Replace("return ((a ^ b | a ^ c | a ^ d) & discrete) == uvec4(0u);", "return true;")


@pytest.mark.parametrize("broken_on_purpose", [False, True])
def test_integers_do_not_slide(gpu: Gpu, broken_on_purpose: bool) -> None:
    """Law 5: a motion of less than half a pixel a frame must not carry integers along.

    Without the question whether all four texels agree, a pixel keeps its integer for ever.
    """
    text = FRAGMENT.replace("HEAD", DESKTOP).replace("TYPE", "ivec3").replace("VALUE", CELLS)
    text = text.replace("(USE) * normalize(v_normal).z", "vec3(it & 1)")
    vertex = Source("cells.vert", VERTEX.replace("HEAD", DESKTOP))
    analysis = analyse(Source("cells.frag", text), vertex)
    node = next(node for node in analysis.nodes if node.text == CELLS)
    emission = rewritten(analysis, node, unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    if broken_on_purpose:
        bundle = NO_QUESTION.bundle(bundle)
    wrong, covered = 0, 0
    with (
        RenderScene(
            gpu, body_scene("trashcan", 0.3), (192, 192), "rgba32f", body_mesh("trashcan")
        ) as on,
        OriginalRunner(on, bundle) as original,
        variant(on, bundle, "2-pass") as runner,
    ):
        for frame in range(16):
            expected = original.image(frame).copy()
            found = runner.image(frame)
            wrong += int((found != expected).any(axis=-1).sum())
            covered += int(np.count_nonzero(expected[..., 3]))
    share = wrong / covered
    assert (share > 0.05) if broken_on_purpose else (share < 1e-4), f"{share:.2e}"
