"""What a value decides is found through calls, globals and control, and no more is refused.

Each shader says in its second line what must be said of ``costly(v_position)``. Whatever else may
be cached holds the laws.
"""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.scene.description import load_scene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.cases import FOLDER as CASES

FOLDER = Path(__file__).with_name("flows")
REPORTED = sorted(path.stem for path in FOLDER.glob("o*.frag"))
BUSY = sorted(path.stem for path in FOLDER.glob("busy_*.frag"))
NAMES = sorted(path.stem for path in FOLDER.glob("*.frag") if path.stem not in REPORTED + BUSY)
VALUE = "costly(v_position)"
NOISE = "sin(exp(v_p.x) * 9.0) * cos(exp(v_p.y) * 7.0)"


def load(name: str) -> Analysis:
    path = FOLDER / f"{name}.frag"
    fragment = Source(path.name, path.read_text(encoding="utf-8"))
    vertex = Source("shader.vert", (CASES / "shader.vert").read_text(encoding="utf-8"))
    return analyse(fragment, vertex)


def verdicts(analysis: Analysis, *texts: str) -> set[str]:
    found = [node for node in analysis.nodes if node.text in texts]
    assert found
    return {node.refusal.code.code if node.refusal else "offered" for node in found}


@pytest.mark.parametrize("name", NAMES)
def test_what_the_value_decides_is_told(name: str) -> None:
    second = (FOLDER / f"{name}.frag").read_text(encoding="utf-8").splitlines()[1]
    wanted = second.removeprefix("// ").partition(":")[0]
    assert verdicts(load(name), VALUE) == {wanted}


@pytest.mark.parametrize("name", REPORTED)
def test_reported_shaders_are_refused(name: str) -> None:
    fragment = Source(f"{name}.frag", (FOLDER / f"{name}.frag").read_text(encoding="utf-8"))
    code = "SC316" if "discard" in name else "SC315"
    texts = (NOISE, NOISE.replace("v_p", "p"))
    assert verdicts(analyse(fragment), *texts) == {code}


@pytest.mark.parametrize("name", BUSY)
def test_initialisers_that_do_something_are_refused(name: str) -> None:
    with pytest.raises(InputError, match="SC424"):
        load(name)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", NAMES)
def test_what_else_may_be_cached_holds_the_laws(name: str, gpu: Gpu, cases_folder: Path) -> None:
    analysis = load(name)
    scene = altered(
        load_scene(cases_folder),
        fragment=FOLDER / f"{name}.frag",
        vertex=cases_folder / "shader.vert",
    )
    nodes = [node for node in analysis.nodes if node.offered]
    with closing(Verifier(gpu, (scene, analysis), (40, 40))) as verifier:
        assert (found := verifier.round_trip()) is not None
        assert found.exact
        every = [verifier.check(node, plain=False) for node in nodes]
    broken = {item.text: item.failure or item.broken for item in every if item.broken}
    assert not broken
