"""Laws 2 to 4 for several nodes in one cache: chosen sets, and random ones, others each night."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import closing
from pathlib import Path
from random import Random

import pytest
from laws.random_sets import random_sets
from laws.slices import VARIABLE, amount, seed
from laws.test_conditions import FOLDER as CONDITIONS
from laws.test_conditions import SHADERS
from laws.test_mutations import Replace, broken
from manifests import plain
from render.test_independent_runner import agree

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene, read_shaders
from shadercache.manifest.codec import encode
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.conditioning import all_too_far
from tests.configured import PROOF, rewritten, variant

pytestmark = pytest.mark.xdist_group("sets")

FOLDER = Path(__file__).with_name("sets")
SIZE = (64, 64)
A_DAY = amount(1, 3)
"""Random sets of each shader."""


def hit_share(gpu: Gpu, scene: Scene, bundle: Bundle) -> float:
    """The share of the covered pixels that reuse what they have, after three frames."""
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        variant(world, bundle, "2-pass", period=64) as runner,
    ):
        for frame in range(3):
            runner.draw(frame)
        mask = runner.hit_mask(3)
    return float((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())


PATHS = {
    "two calls of one function": (
        "marble@1: noise(floor(q * 6.0)) * 0.5",
        "marble@2: noise(floor(q * 6.0)) * 0.5",
    ),
    "two values of one call": (
        "marble@1: sin(q.y * 4.0 + rough)",
        "marble@1: noise(floor(q * 9.0))",
        "marble@2: noise(floor(q * 9.0))",
    ),
    "an argument of the call that leads to the other": (
        "main: noise(floor(n * 5.0))",
        "grain@1: noise(floor(q * 7.0))",
    ),
    "in the other order": (
        "grain@1: noise(floor(q * 7.0))",
        "main: noise(floor(n * 5.0))",
    ),
    "in a call that is an argument of the call to the other": (
        "marble@3: noise(floor(q * 9.0))",
        "grain@2: noise(floor(q * 7.0))",
    ),
    "deep, from first to last": (
        "main: marble(p)",
        "grain@1: a * noise(floor(q * 7.0))",
        "paint@1 > marble: rough",
        "paint@2 > marble: noise(floor(q * 9.0))",
        "main: texture(picture, uv).rgb",
    ),
    "behind and before one that needs it": (
        "paint@2: vec3(marble(q * 2.0), noise(floor(q * 3.0)), 0.4)",
        "main: deep",
        "main: both",
    ),
}

TYPES = {
    "an integer and a struct": (
        "main: int(noise(floor(p * 4.0)) * 9.0)",
        "main: spot(p)",
        "main: noise(n)",
    ),
    "a matrix, a truth and a struct's member": (
        "main: noise(floor(n * 6.0)) > 0.3",
        "main: outerProduct(vec2(noise(floor(n * 2.0)), 1.0), vec2(noise(n), 0.5))",
        "spot: vec2(noise(floor(q * 5.0)), noise(floor(q * 2.0)))",
    ),
    "bits under a condition": (
        "main: floatBitsToUint(noise(floor(p * 8.0))) >> 20",
        "main: vec3(turn * found.place, float(cell) / 9.0)",
    ),
    "under a condition and behind it": (
        "main: noise(floor(p * 8.0))",
        "main: noise(n)",
        "main: lit",
    ),
}

SETS = {
    "paths": PATHS["deep, from first to last"],
    "types": TYPES["under a condition and behind it"],
}


def load(name: str) -> tuple[Scene, Analysis]:
    folder = CONDITIONS if name in SHADERS else FOLDER
    scene = load_scene(CONDITIONS)
    return analyse_scene(altered(scene, fragment=folder / f"{name}.frag"))


def pick(analysis: Analysis, wanted: Iterable[str]) -> list[Candidate]:
    """The nodes that are meant by the end of their call path, and their text."""
    named = {}
    for node in analysis.nodes:
        if node.legal:
            named.setdefault(f"{node.path.removeprefix('main > ')}: {node.text}", node)
    return [named[item] for item in wanted]


def failures(verdicts: Iterable[Verdict]) -> dict[str, object]:
    return {item.text: item.failure or item.broken for item in verdicts if item.broken}


@pytest.mark.parametrize(("name", "sets"), [("paths", PATHS), ("types", TYPES)])
def test_laws_2_to_4_for_chosen_sets(name: str, sets: dict[str, tuple[str, ...]], gpu: Gpu) -> None:
    scene, analysis = load(name)
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        plain = name == "types"  # compiling twice as many programs takes as long again
        chosen = [pick(analysis, wanted) for wanted in sets.values()]
        verdicts = [verifier.check(nodes, plain) for nodes in chosen]
        far = all_too_far(verifier, chosen, verdicts)
    assert not failures(verdicts)
    assert all(item.algorithms == {"1-pass", "2-pass", "3-pass"} for item in verdicts)
    assert not far


def corpus(name: str) -> tuple[Scene, Analysis]:
    scene = load_scene(data_path("corpus", name, "scene.toml"))
    return scene, analyse(*read_shaders(scene))


@pytest.mark.parametrize("name", ["paths", "types", *SHADERS, "dragon", "trashcan"])
def test_laws_2_to_4_for_random_sets(
    name: str, gpu: Gpu, record_property: Callable[[str, object], None]
) -> None:
    day = seed()
    record_property(VARIABLE, day)
    scene, analysis = corpus(name) if name in ("dragon", "trashcan") else load(name)
    legal = [node for node in analysis.nodes if node.legal]
    sets, refused = random_sets(analysis, legal, Random(f"{day} {name}"), A_DAY)
    assert len(sets) == A_DAY, f"{VARIABLE}={day} repeats this"
    assert set(refused) <= {"SC415", "SC416", "SC417"}
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        verdicts = [verifier.check(nodes, plain=False) for nodes in sets]
    assert not failures(verdicts), f"{VARIABLE}={day} repeats this"


@pytest.fixture
def conditional(gpu: Gpu) -> Iterator[tuple[Verifier, Bundle]]:
    """The programs of a set in which one value stands under a condition."""
    scene, analysis = load("types")
    emission = rewritten(analysis, pick(analysis, SETS["types"]), PROOF, unprofitable=True)
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        yield verifier, Bundle(emission.manifest, emission.files)


BROKEN = {
    "a texel is valid although one is lacking": (
        Replace("sc_valid_1 && sc_valid_2 && sc_valid_3 ?", "sc_valid_2 && sc_valid_3 ?", "2-pass"),
        {"law 4 (2-pass)"},
    ),
    "the third pass has none of a texel that lacks one": (
        Replace("sc_valid_2 ?", "sc_valid_1 && sc_valid_2 ?", "3-pass.payload"),
        {"law 2 (3-pass)", "law 4 (3-pass)"},
    ),
    "two payloads change places on a hit": (
        Replace("uintBitsToFloat(sc_texel.y)", "uintBitsToFloat(sc_texel.x)", "2-pass.hit"),
        {"law 3 (2-pass)", "law 4 (2-pass)"},
    ),
    "one payload is not stored": (
        Replace("sc_valid_2 ? floatBitsToUint(sc_payload_2) : 0u", "0u", "2-pass.miss"),
        {"law 3 (2-pass)", "law 4 (2-pass)"},
    ),
}


@pytest.mark.parametrize(("mutation", "laws"), BROKEN.values(), ids=BROKEN.keys())
def test_broken_programs_break_a_law(
    conditional: tuple[Verifier, Bundle], mutation: Replace, laws: set[str]
) -> None:
    verifier, bundle = conditional
    assert laws <= broken(verifier, mutation.bundle(bundle))


@pytest.mark.parametrize(("name", "least"), [("paths", 0.8), ("types", 0.02)])
def test_payloads_are_reused_in_motion(name: str, least: float, gpu: Gpu) -> None:
    """Else the laws would hold because everything is computed anew."""
    scene, analysis = load(name)
    wanted = SETS[name]
    emission = rewritten(analysis, pick(analysis, wanted), PROOF, unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    assert hit_share(gpu, scene, bundle) > least


@pytest.mark.parametrize("name", ["paths", "types"])
def test_an_engine_needs_only_the_manifest(name: str, gpu: Gpu, tmp_path: Path) -> None:
    scene, analysis = load(name)
    emission = rewritten(analysis, pick(analysis, SETS[name]), unprofitable=True)
    for file, text in emission.files.items():
        (tmp_path / file).write_text(text)
    (tmp_path / "manifest.json").write_text(encode(emission.manifest))
    bundle = load_bundle(tmp_path)
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        for algorithm in bundle.algorithms:
            assert agree(world, bundle, tmp_path, algorithm, None)


def test_a_fetch_under_a_condition_takes_one_pass_away_from_a_set() -> None:
    analysis = load("textures")[1]
    wanted = ("texture(picture, uv * 3.0).rgb", "noise(floor(p * 8.0)) * n")
    nodes = pick(analysis, [f"main: {text}" for text in wanted])
    found = plain(rewritten(analysis, nodes, unprofitable=True).manifest)
    assert [item["algorithm"] for item in found["refused"]] == ["1-pass"]
    with pytest.raises(InputError, match=r"' and 'noise.*in one pass.*SC407"):
        rewritten(analysis, nodes, algorithms=("1-pass",), unprofitable=True)


def test_what_few_fragments_compute_costs_the_others_their_hits(gpu: Gpu) -> None:
    """As SC418 says: a texel that lacks one value has none for the next frame."""
    scene, analysis = load("branch")
    always, sometimes = pick(
        analysis, ("main: sin(p.y * 9.0 + frame * 0.7)", "main: noise(floor(p * 6.0))")
    )
    shares = []
    for nodes in ([always], [always, sometimes]):
        emission = rewritten(analysis, nodes, PROOF, unprofitable=True)
        bundle = Bundle(emission.manifest, emission.files)
        assert [item.code for item in emission.notes] == ["SC418"] * (len(nodes) - 1)
        shares.append(hit_share(gpu, scene, bundle))
    assert shares[0] > 0.8 and 0.1 < shares[1] < 0.6 * shares[0]
