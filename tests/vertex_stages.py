"""Pairs of vertex and fragment shaders in a folder of test files, and the scene they are drawn in.

A folder holds ``*.vert`` files. ``name.frag`` goes with ``name.vert``, the folder's ``es.frag``
with other shaders of GLSL ES, and its ``o*.frag`` with all the rest.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.compiler import Analysis, Emission, analyse
from shadercache.front.parse import parse
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import with_new_names
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.scenery import ring
from tests.configured import configured, rewritten, variant

REPORTS = Path(__file__).parent / "reports"
SIZE = (64, 64)
NEVER = 65535


def names(folder: Path) -> list[str]:
    """The vertex shaders of a folder."""
    return sorted(path.stem for path in folder.glob("*.vert"))


def fragment_of(folder: Path, name: str) -> Path:
    """The fragment shader that goes with a vertex shader."""
    own = folder / f"{name}.frag"
    if own.is_file():
        return own
    es = " es" in (folder / f"{name}.vert").read_text("utf-8").partition("//")[0]
    return folder / "es.frag" if es else next(iter(sorted(folder.glob("o*.frag"))))


def sources(folder: Path, name: str) -> tuple[Source, Source]:
    """Fragment and vertex shader."""
    paths = fragment_of(folder, name), folder / f"{name}.vert"
    return tuple(Source(path.name, path.read_text("utf-8")) for path in paths)


def analysed(folder: Path, name: str, reading: ReadOptions | None = None) -> Analysis:
    """The analysis of a pair."""
    return analyse(*sources(folder, name), reading)


def without_position(emission: Emission) -> Iterator[str]:
    """The vertex shaders that declare the position of the last frame and do not assign it."""
    for name, text in emission.files.items():
        if not name.endswith(".vert"):
            continue
        module = parse(Source(name, text))
        variables = [decl for decl in module.decls if isinstance(decl, n.VarDecl)]
        declared = {item.name for decl in variables for item in decl.declarators}
        written = EffectTable(module).summary("main").writes
        for own in declared:
            if own.startswith("sc") and own.endswith("_previous") and own not in written:
                yield name


def made_scene(folder: Path, target: Path) -> Path:
    """A copy of a folder with its mesh made."""
    shutil.copytree(folder, target)
    np.savez(target / "ring.npz", **ring())
    return target


def scene_of(folder: Path, name: str, analysis: Analysis) -> Scene:
    """The scene of a made folder with one of its pairs."""
    paths = fragment_of(folder, name), folder / f"{name}.vert"
    scene = altered(load_scene(folder), fragment=paths[0], vertex=paths[1])
    return with_new_names(scene, analysis.renamed)


def hit_rate(gpu: Gpu, scene: Scene, analysis: Analysis, text: str) -> float:
    """Share of the visible pixels whose payload is found again after a frame of motion."""
    node = next(node for node in analysis.nodes if node.text == text)
    emission = rewritten(analysis, node, configured(form="rgba32f"))
    bundle = Bundle(emission.manifest, emission.files)
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        variant(world, bundle, "2-pass", period=NEVER) as runner,
    ):
        runner.draw(0)
        mask = runner.hit_mask(1)
    return float((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())


def check_laws(gpu: Gpu, scene: Scene, analysis: Analysis, node: Candidate) -> None:
    """Laws 2 to 4 hold for a value of a scene, of which something is to be seen."""
    with closing(Verifier(gpu, (scene, analysis), (40, 40))) as verifier:
        verdict = verifier.check(node, plain=False)
        assert verifier.references.covered[0].mean() > 0.1
    assert not verdict.broken, verdict.failure
