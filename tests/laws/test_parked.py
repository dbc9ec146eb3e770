"""Laws 1 to 4 for parked misses beside two passes: shaders of every kind that the laws know.

Of each some nodes, others each night. Where misses cannot be parked, a sentence says why.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import closing
from pathlib import Path

import pytest
from laws import test_conditions, test_full_screen, test_versions
from laws.slices import VARIABLE, amount, day_slice, nodes_of_day, seed
from laws.test_mutations import HITS_DISABLED, Replace, broken

from shadercache.analysis.candidates import Candidate
from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.cache_settings import configured
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.scene.description import Scene
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.cases.cases import analysed, told
from tests.cases.scenery import scene_of
from tests.cases.test_cases import CACHEABLE
from tests.configured import PROOF, rewritten
from tests.configured import configured as with_options

pytestmark = pytest.mark.xdist_group("parked")

BOTH = ("2-pass", "parked")
SIZE = (64, 64)


def verdicts(
    gpu: Gpu,
    opened: tuple[Scene, Analysis],
    nodes: Iterable[Candidate],
    configuration: Configuration | None = None,
    size: tuple[int, int] = SIZE,
) -> list[Verdict]:
    with closing(Verifier(gpu, opened, size, configuration=configuration)) as verifier:
        verifier.algorithms = BOTH
        return [verifier.check(node, plain=False) for node in nodes]


def assert_sound(found: Iterable[Verdict]) -> None:
    for verdict in found:
        message = f"{verdict.node}: {verdict.reasons}; {VARIABLE}={seed()} repeats this"
        assert not verdict.broken, message
        assert set(BOTH) == verdict.algorithms | set(verdict.refused)


@pytest.mark.parametrize("name", ["dragon", "trashcan", "heroine", "colonnade", "chess", "meadow"])
def test_the_corpus(name: str, gpu: Gpu) -> None:
    scene, analysis = open_scene(data_path("corpus", name, "scene.toml"))
    legal = [node for node in analysis.nodes if node.legal]
    nodes = nodes_of_day(legal, scene.nodes, seed(), amount(1, 12))
    cached = configured(scene, Configuration(), None)
    with closing(Verifier(gpu, (scene, analysis), configuration=cached)) as verifier:
        verifier.algorithms = BOTH
        found = [verifier.check(node) for node in nodes]
    assert_sound(found)
    named = [verdict for verdict in found if verdict.node in scene.nodes.values()]
    # Fifty fetches of the trash can's would have to be parked; poppies are told apart.
    for verdict in named:
        assert ("parked" in verdict.refused) == (name in ("trashcan", "meadow")), verdict.refused


CASES = CACHEABLE[seed() % 6 :: amount(6, 1)]


@pytest.mark.parametrize("name", CASES)
def test_traps(name: str, gpu: Gpu, cases_folder: Path) -> None:
    opened = scene_of(name, cases_folder), analysed(name)
    legal = [node for node in told(name, opened[1]) if node.legal]
    assert_sound(verdicts(gpu, opened, day_slice(legal, seed(), amount(1, 4)), size=(40, 40)))


@pytest.mark.parametrize("name", test_conditions.SHADERS)
def test_conditions_and_discards(name: str, gpu: Gpu) -> None:
    opened = test_conditions.load(name)
    nodes = [node for node in opened[1].nodes if node.legal and "noise(" in node.text]
    assert_sound(verdicts(gpu, opened, day_slice(nodes, seed(), amount(2, 50))))


@pytest.mark.parametrize("name", test_versions.VERSIONS)
def test_older_versions(name: str, gpu: Gpu) -> None:
    opened = test_versions.load(name)
    nodes = [node for node in opened[1].nodes if node.legal]
    assert_sound(verdicts(gpu, opened, day_slice(nodes, seed(), amount(2, 50))))


@pytest.mark.parametrize("name", test_full_screen.MAPPINGS)
def test_full_screen_shaders(name: str, gpu: Gpu) -> None:
    path, mapping = test_full_screen.FOLDER / f"{name}.frag", test_full_screen.MAPPINGS[name]
    opened = open_scene(path, test_full_screen.reading(name), mapping)
    nodes = [node for node in opened[1].nodes if node.legal]
    assert_sound(verdicts(gpu, opened, day_slice(nodes, seed(), amount(2, 12))))


@pytest.mark.parametrize(
    "text",
    [
        "adaptive=0.02",
        "age,ids",
        "filter=carried",
        "filter=carried,age",
        "fetches=level",
        "ids,mask,magnification,filter=bilinear",
        "guard=clamp",
    ],
)
def test_options_of_the_cache(text: str, gpu: Gpu) -> None:
    opened = open_scene(data_path("corpus", "dragon", "scene.toml"))
    words = {key: value or True for key, _, value in (x.partition("=") for x in text.split(","))}
    node = opened[1].node(opened[0].nodes["whole noise"])
    found = verdicts(gpu, opened, [node], with_options(**words))
    assert_sound(found)
    assert found[0].algorithms == set(BOTH)


UNMARKED = Replace("bool missed = texel.w == sc_missed_depth;", "bool missed = false;", "mark")
UNPARKED = Replace("v_position.xyz = uintBitsToFloat(", "v_position.xyz = 0.5 * vec3(", "fix-up")
SHADED_TWICE = Replace("missed ? 0.75 + float(texel.x) / 8192.0 : 1.0", "0.75 + 1.0 / 8192.0")


@pytest.mark.parametrize(
    ("change", "laws"),
    [
        (UNMARKED, {"law 2 (parked)", "law 3 (parked)", "law 4 (parked)"}),
        (UNPARKED, {"law 2 (parked)", "law 3 (parked)", "law 4 (parked)"}),
        (SHADED_TWICE, {"law 4 (parked)"}),
        (HITS_DISABLED, {"law 3 (parked)"}),
    ],
    ids=["unmarked", "unparked", "shaded-twice", "hits-disabled"],
)
def test_the_laws_notice_what_is_broken(gpu: Gpu, change: Replace, laws: set[str]) -> None:
    opened = open_scene(data_path("corpus", "dragon", "scene.toml"))
    node = opened[1].node(opened[0].nodes["whole noise"])
    emission = rewritten(opened[1], node, PROOF, BOTH, unprofitable=True)
    with closing(Verifier(gpu, opened, SIZE)) as verifier:
        bundle = Bundle(emission.manifest, emission.files)
        assert not broken(verifier, bundle)
        assert laws <= set(broken(verifier, change.bundle(bundle)))
