"""A runner that knows nothing but the manifest draws the same bits as the harness."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from laws.slices import amount, seed
from manifests import plain
from runner import independent_runner
from runner.canvas import Canvas
from runner.independent_runner import IndependentRunner, Turn, draw_together

from shadercache.caching.algorithms import NAMES, PARKED, USUAL
from shadercache.caching.configuration import PayloadRate
from shadercache.caching.settings import with_settings
from shadercache.compiler import Emission, analyse
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene, read_shaders
from shadercache.manifest.codec import encode
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.drawable import Drawable
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import Values
from shadercache.scene.description import load_scene
from shadercache.scene.mesh import load_mesh
from tests.configured import DEFAULT, drawn_by, rewritten, variant
from tests.torus.mesh import EMISSION

pytestmark = pytest.mark.xdist_group("gl")


def test_it_imports_nothing_of_shadercache() -> None:
    for path in Path(independent_runner.__file__).parent.glob("*.py"):
        text = path.read_text(encoding="utf-8")
        assert "import shadercache" not in text
        assert "from shadercache" not in text
        assert len(text.splitlines()) < 150


def agree(
    world: RenderScene, bundle: Bundle, folder: Path, algorithm: str, form: str | None
) -> bool:
    """Whether both runners draw the same six frames."""
    scene, mesh = world.scene, world.drawables[0].mesh
    other = IndependentRunner(
        world.gpu.ctx,
        folder,
        algorithm,
        world.size,
        {name: mesh.arrays[array] for name, array in scene.common.inputs.attributes.items()},
        mesh.index,
        {name: world.drawables[0].texture(name) for name in scene.common.inputs.textures},
        form,
        scene.common.cull,
    )
    with variant(world, bundle, algorithm, period=5, block=4, form=form) as runner:
        for frame in range(6):
            values = values_of(world.drawables[0].values(frame))
            expected = runner.image(frame)
            assert expected.any(), "an empty picture proves nothing"
            if other.draw(frame, values, 5, 4).tobytes() != expected.tobytes():
                return False
    return True


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_same_bits_for_a_manifest_by_hand(
    world: RenderScene, bundle: Bundle, algorithm: str, form: str
) -> None:
    assert agree(world, bundle, EMISSION, algorithm, form)


@pytest.mark.parametrize("name", ["orbit", "scroll"])
def test_same_bits_full_screen(gpu: Gpu, tmp_path: Path, name: str) -> None:
    """What to draw, and where payloads are, stands in the manifest; no mesh is given."""
    path = Path(__file__).parent.parent / "laws" / "full_screen" / f"{name}.frag"
    for mapping in ("screen", "user"):
        scene, analysis = open_scene(path, mapping=mapping)
        nodes = [node for node in analysis.nodes if node.offered]
        folder = tmp_path / mapping
        folder.mkdir()
        write(rewritten(analysis, nodes[1], algorithms=NAMES), folder)
        bundle = load_bundle(folder)
        with RenderScene(gpu, scene, (96, 64), "rgba32f") as world:
            for algorithm in bundle.algorithms:
                assert agree(world, bundle, folder, algorithm, None), (mapping, algorithm)


def write(emission: Emission, folder: Path) -> None:
    for file, text in emission.files.items():
        (folder / file).write_text(text)
    (folder / "manifest.json").write_text(encode(emission.manifest))


def corpus_scenes() -> list[str]:
    """Those of one object: the manifest says how one is drawn, and nothing of a scene."""
    paths = sorted(data_path("corpus").glob("*/scene.toml"))
    return [path.parent.name for path in paths if not load_scene(path).objects]


@pytest.mark.parametrize("name", corpus_scenes())
def test_same_bits_for_what_the_compiler_writes(gpu: Gpu, tmp_path: Path, name: str) -> None:
    scene = load_scene(data_path("corpus", name))
    analysis = analyse(*read_shaders(scene))
    offered = [node for node in analysis.nodes if node.offered]
    # The seed picks the nodes, so that in time all are seen; a failure names its node.
    chosen = random.Random(seed()).sample(offered, amount(1, 3))
    mesh = load_mesh(scene.small.common.mesh)
    with RenderScene(gpu, scene, (96, 96), "rgba32f", mesh) as world:
        for number, node in enumerate(chosen):
            emission = rewritten(analysis, node, algorithms=NAMES)
            folder = tmp_path / str(number)
            folder.mkdir()
            write(emission, folder)
            bundle = load_bundle(folder)
            for algorithm in bundle.algorithms:
                assert agree(world, bundle, folder, algorithm, None), (node.id, algorithm)


@pytest.mark.parametrize(
    "settings",
    [
        "age=on",
        "refresh=tiled,age=on",
        "refresh=surface",
        "refresh=none,age=on",
        "filter=carried",
        "filter=carried,age=on",
    ],
)
def test_same_bits_for_other_options(gpu: Gpu, tmp_path: Path, settings: str) -> None:
    scene, analysis = open_scene(data_path("corpus", "trashcan", "scene.toml"))
    node = next(node for node in analysis.nodes if node.offered)
    write(rewritten(analysis, node, with_settings(DEFAULT, [settings]), NAMES), tmp_path)
    bundle = load_bundle(tmp_path)
    with RenderScene(gpu, scene, (64, 64), "rgba32f") as world:
        for algorithm in bundle.algorithms:
            assert agree(world, bundle, tmp_path, algorithm, None), algorithm


@pytest.mark.parametrize("settings", ["adaptive=0.02", "age=on,ids=on", "guard=off"])
def test_same_bits_for_parked_misses(gpu: Gpu, tmp_path: Path, settings: str) -> None:
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    node = analysis.node(scene.nodes["whole noise"])
    chosen = with_settings(DEFAULT, [settings])
    write(rewritten(analysis, node, chosen, [PARKED]), tmp_path)
    with RenderScene(gpu, scene, (64, 64), "rgba32f") as world:
        assert agree(world, load_bundle(tmp_path), tmp_path, PARKED, None)


@pytest.mark.parametrize(
    ("rate", "size"), [("half", (64, 48)), ("half", (61, 47)), ("quarter", (61, 47))]
)
def test_same_bits_at_a_fraction_of_the_rate(
    gpu: Gpu, tmp_path: Path, rate: PayloadRate, size: tuple[int, int]
) -> None:
    """The manifest says how large the cache is, and how pixels find their texels."""
    scene, analysis = open_scene(data_path("corpus", "trashcan", "scene.toml"))
    node = next(node for node in analysis.nodes if node.offered)
    write(rewritten(analysis, node, replace(DEFAULT, payload_rate=rate)), tmp_path)
    bundle = load_bundle(tmp_path)
    assert bundle.algorithms == ("3-pass",)
    with RenderScene(gpu, scene, size, "rgba32f") as world:
        assert agree(world, bundle, tmp_path, "3-pass", None)


@pytest.mark.parametrize(
    ("algorithm", "rate"), [*((name, "full") for name in NAMES), ("3-pass", "half")]
)
def test_same_bits_for_several_objects(
    gpu: Gpu, scene_folder: Path, tmp_path: Path, algorithm: str, rate: PayloadRate
) -> None:
    """By two shaders, of two periods, one that is hidden for a while and one that is not cached:
    they share caches and depth, and the manifests say how."""
    scene, analysis = open_scene(scene_folder / "objects" / "scene.toml")
    # A number beside the object's own leaves room in one texture, as the other shader's node does.
    node = next(node for node in analysis.nodes if node.legal and str(node.type) == "float")
    options = with_settings(replace(DEFAULT, payload_rate=rate), ["ids=on"])
    every = NAMES if rate == "full" else USUAL
    emission = rewritten(analysis, node, options, every, unprofitable=True)
    bundle = Bundle(emission.manifest, emission.files)
    with (
        RenderScene(gpu, scene, (96, 80), "rgba32f") as world,
        variant(world, bundle, algorithm, period=5, block=4) as runner,
    ):
        canvas = Canvas(gpu.ctx, world.size, plain(bundle.manifest))
        others: list[tuple[Drawable, Any]] = []
        linked = drawn_by(scene, bundle, algorithm)
        for drawable, item in zip(world.drawables, linked, strict=True):
            own = item.bundle
            folder = tmp_path / drawable.scene_object.name
            folder.mkdir()
            write(Emission(dict(own.files), own.manifest), folder)
            attributes = {
                name: drawable.mesh.arrays[array]
                for name, array in drawable.scene_object.inputs.attributes.items()
            }
            assert own.cache == bundle.cache
            how = algorithm if drawable.scene_object.caching.on else "original"
            made = IndependentRunner(
                *(gpu.ctx, folder, how, world.size, attributes, drawable.mesh.index, {}),
                cull=drawable.scene_object.cull,
                canvas=canvas,
                number=drawable.number,
            )
            others.append((drawable, made))
        for frame in range(8):
            expected = runner.image(frame).copy()
            turns = [
                Turn(
                    other,
                    values_of(drawable.values(frame)) if drawable.is_there(frame) else None,
                    min(drawable.scene_object.caching.period or 5, 5),
                    drawable.scene_object.caching.block or 4,
                )
                for drawable, other in others
            ]
            assert expected.any(), "an empty picture proves nothing"
            assert draw_together(frame, turns).tobytes() == expected.tobytes(), frame


def values_of(found: Values) -> dict[str, object]:
    """Uniforms as moderngl takes them."""
    made: dict[str, object] = {}
    for name, numbers in found.items():
        flat = tuple(map(float, numbers))
        rows = [flat[at : at + 16] for at in range(0, len(flat), 16)]
        is_table = len(flat) > 16 and len(flat) % 16 == 0
        made[name] = rows if is_table else flat if len(flat) > 1 else flat[0]
    return made
