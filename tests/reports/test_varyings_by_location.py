"""Varyings match by their locations, whatever their names; one stage alone may have locations."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from vertex_stages import (
    REPORTS,
    analysed,
    check_laws,
    made_scene,
    names,
    scene_of,
    without_position,
)

from shadercache.analysed import unchanged_for
from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.source import Source
from tests.configured import configured, render_variant, rewritten

FOLDER = REPORTS / "varyings_by_location"
NAMES = names(FOLDER)
UNLINKED = ("other_blocks", "block_and_variables")
"""Mesa has no such blocks: the users' own shaders do not link there."""

WHOLE = ("arrays", "structs", "nameless_structs", "crossed", "blocks", "placed_blocks")
WHOLE += ("other_blocks",)
"""Here the normal goes with the position in one variable or block, or comes in its place."""

DRAWN = [name for name in NAMES if name not in UNLINKED]
REFERENCE = "o06_varyings_by_location"
OTHERWISE = ("arrays",)
"""It shows another picture than the rest."""

PER_VERTEX = REPORTS / "per_vertex"


def payload(analysis: Analysis) -> Candidate:
    found = (node for node in analysis.nodes if node.text.startswith("costly("))
    return next(node for node in found if "max(" not in node.text)


@pytest.mark.parametrize("name", NAMES)
def test_it_is_accepted_and_passes_on_only_what_is_read(name: str) -> None:
    analysis = analysed(FOLDER, name)
    emission = rewritten(analysis, payload(analysis))
    assert not list(without_position(emission))
    computed = emission.files["3-pass.payload.vert"]
    assert "unread" not in computed
    if not {name} & set(WHOLE):
        assert "= a_normal" not in computed


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made_scene(FOLDER, tmp_path_factory.mktemp("places") / "scene")


def picture(gpu: Gpu, folder: Path, name: str) -> np.ndarray:
    """What three passes show in their second frame."""
    analysis = analysed(FOLDER, name)
    emission = rewritten(analysis, payload(analysis), configured(form="rgba32f"))
    bundle = Bundle(emission.manifest, emission.files)
    with RenderScene(gpu, scene_of(folder, name, analysis), (48, 48), "rgba32f") as world:
        return render_variant(world, bundle, "3-pass", range(2), period=1)[1]


@pytest.fixture(scope="module")
def reference(gpu: Gpu, folder: Path) -> np.ndarray:
    return picture(gpu, folder, REFERENCE)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", [name for name in DRAWN if name not in OTHERWISE])
def test_each_value_comes_from_its_place(
    name: str, gpu: Gpu, folder: Path, reference: np.ndarray
) -> None:
    found = picture(gpu, folder, name)
    assert reference.std() > 0.05
    assert np.abs(found - reference).max() < 1e-3


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", ["only_outputs", "arrays", "nameless_structs", "crossed"])
def test_laws_2_to_4(name: str, gpu: Gpu, folder: Path) -> None:
    analysis = analysed(FOLDER, name)
    check_laws(gpu, scene_of(folder, name, analysis), analysis, payload(analysis))


def test_what_a_value_depends_on_is_found_through_places() -> None:
    """By the screen, reuse is exact while the attribute does not change that the varying has."""
    fragment, vertex = (
        Source(name, (FOLDER / name).read_text("utf-8"))
        for name in ("crossed.frag", "crossed.vert")
    )
    analysis = analyse(fragment, vertex, mapping="screen")
    assert unchanged_for(analysis, (payload(analysis),)) == ("a_position", "u_mvp")
    normal = next(node for node in analysis.nodes if node.text.startswith("max("))
    assert unchanged_for(analysis, (normal,)) == ("a_normal", "a_position", "u_mvp")


WRONG = {
    "another type at the place": (
        "layout(location = 0) out vec4 a;",
        "layout(location = 0) in vec3 b;",
        "'b' is vec3 here and vec4 in x.vert ('a')",
    ),
    "nothing at the place": (
        "layout(location = 1) out vec3 b;",
        "layout(location = 0) in vec3 b;",
        "x.vert does not write 'b' at location 0",
    ),
    "another component": (
        "layout(location = 0, component = 1) out vec3 a;",
        "layout(location = 0) in vec3 b;",
        "x.vert does not write 'b'",
    ),
    "other members": (
        "layout(location = 0) out struct { vec3 x; } a;",
        "layout(location = 0) in struct { vec3 y; } b;",
        "'b' is  here and  in x.vert ('a')",
    ),
    "an array of another size": (
        "layout(location = 0) out vec3 a[2];",
        "layout(location = 0) in vec3 b[3];",
        "'b' is vec3[3] here and vec3[2] in x.vert ('a')",
    ),
    "neither place nor name": (
        "out vec3 a;",
        "in vec3 b;",
        "x.vert does not write 'b'",
    ),
}


@pytest.mark.parametrize(("out", "into", "message"), WRONG.values(), ids=WRONG.keys())
def test_what_does_not_match_is_told(out: str, into: str, message: str) -> None:
    member = ".y" if "struct" in into else "[1]" if "[" in into else ""
    vertex = f"#version 440\n{out}\nvoid main() {{ gl_Position = vec4(1.0); }}"
    read = f"void main() {{ o = vec4(sin(b{member}), 1.0); }}"
    with pytest.raises(InputError) as caught:
        analyse(
            Source("x.frag", f"#version 440\n{into}\nout vec4 o;\n{read}"), Source("x.vert", vertex)
        )
    assert [(item.code, item.message) for item in caught.value.diagnostics] == [("SC406", message)]


PER_VERTEX_NAMES = sorted(path.name for path in PER_VERTEX.glob("*.frag"))


@pytest.mark.parametrize("name", PER_VERTEX_NAMES)
def test_an_array_over_the_vertices_takes_one_location(name: str) -> None:
    files = PER_VERTEX / name, PER_VERTEX / "arrays.vert"
    sources = [Source(file.name, file.read_text("utf-8")) for file in files]
    if name == "clash.frag":
        with pytest.raises(InputError, match="share the location 1"):
            analyse(*sources)
        return
    analysis = analyse(*sources)
    emission = rewritten(analysis, payload(analysis))
    assert "pervertex" in emission.files["3-pass.payload.frag"]
    assert "v_t = " not in emission.files["3-pass.payload.vert"]
