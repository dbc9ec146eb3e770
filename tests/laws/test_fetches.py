"""What one pass does ahead of its branch with the fetches of a payload: two forms."""

from __future__ import annotations

import re
from contextlib import closing
from pathlib import Path

import pytest
from laws.test_mutations import broken

from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.scene.description import Scene, load_scene
from shadercache.source import Source
from shadercache.transform.hoist_fetches import FetchForm
from shadercache.verify.detail_levels import tells_true_levels
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.scenery import make_scene
from tests.configured import PROOF, configured, rewritten
from tests.shaders import find

pytestmark = pytest.mark.xdist_group("fetches")

SHADER = Path(__file__).with_name("fetches") / "fetches.frag"
SIZE = (64, 64)
VALUES = (
    "sqrt(sum * 0.3)",
    "base.rgb * texture(u_map, at + base.xy * 0.1, more).a",
    "detail * 0.1",
)


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory) -> tuple[Scene, Analysis]:
    folder = make_scene(tmp_path_factory.mktemp("fetches") / "cases")
    return analyse_scene(altered(load_scene(folder), fragment=SHADER))


def verdicts(gpu: Gpu, opened: tuple[Scene, Analysis], fetches: FetchForm) -> list[Verdict]:
    scene, analysis = opened
    with closing(
        Verifier(gpu, (scene, analysis), SIZE, configuration=configured(fetches=fetches))
    ) as verifier:
        return [verifier.check(find(analysis, text), plain=False) for text in VALUES]


@pytest.mark.parametrize("fetches", ["whole", "level"])
def test_laws_2_to_4(gpu: Gpu, opened: tuple[Scene, Analysis], fetches: FetchForm) -> None:
    for verdict in verdicts(gpu, opened, fetches):
        assert verdict.algorithms == {"1-pass", "2-pass", "3-pass"}
        assert not verdict.broken and not verdict.failure, verdict.text


def test_levels_are_proven_where_the_driver_tells_its_own(
    gpu: Gpu, opened: tuple[Scene, Analysis]
) -> None:
    """The filter of the scene is the trilinear one, for which llvmpipe 25.0 tells others."""
    scene, analysis = opened
    emission = rewritten(
        analysis,
        find(analysis, VALUES[0]),
        configured(PROOF, fetches="level"),
    )
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        found = broken(verifier, Bundle(emission.manifest, emission.files))
    assert tells_true_levels(gpu) == (not found)


def test_a_wrong_level_is_noticed(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    scene, analysis = opened
    options = configured(PROOF, fetches="level")
    emission = rewritten(analysis, find(analysis, VALUES[0]), options)
    text = emission.files["1-pass.frag"]
    changed, count = re.subn(r"(textureLod\([^;]*), sc_fetch_\d\)", r"\1, 0.5)", text)
    assert count
    bundle = Bundle(emission.manifest, emission.files | {"1-pass.frag": changed})
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        assert "law 2 (1-pass)" in broken(verifier, bundle)


@pytest.mark.parametrize(
    ("fetches", "ahead", "behind"),
    [
        ("whole", r"(sc_fetch_\d) = texture\(u_map, at \* 1\.7\);", "vec4 base = {};"),
        (
            "level",
            r"(sc_fetch_\d) = textureQueryLod\(u_map, at \* 1\.7\)\.y;",
            "vec4 base = textureLod(u_map, at * 1.7, {});",
        ),
    ],
)
def test_texts(opened: tuple[Scene, Analysis], fetches: FetchForm, ahead: str, behind: str) -> None:
    _, analysis = opened
    node = find(analysis, VALUES[0])
    emission = rewritten(analysis, node, configured(fetches=fetches), ("1-pass",))
    text = emission.files["1-pass.frag"]
    found = re.search(ahead, text)
    assert found and behind.format(found[1]) in text
    assert "textureOffset(u_map" in text.split("sc_fetch_ahead()")[0]
    assert ("#version 400" in text) == (fetches == "level")
    relies = " ".join(emission.manifest.relies_on)
    assert ("isotropic" in relies) == (fetches == "level")


ES = """#version 300 es
precision highp float;
uniform sampler2D u_map;
in vec2 v_uv;
out vec4 o_color;
void main() { o_color = vec4(sin(texture(u_map, v_uv).r * 9.0)); }
"""
LATER = """#version 330
uniform sampler2D u_map;
uniform float sample;
in vec2 v_uv;
out vec4 o_color;
void main() { o_color = vec4(sin(texture(u_map, v_uv).r * sample)); }
"""


@pytest.mark.parametrize(
    ("text", "code"), [(ES, "SC419"), (LATER, "SC408")], ids=["no query", "a later keyword"]
)
def test_where_levels_cannot_be_asked_for(text: str, code: str) -> None:
    version, _ = text.split("\n", 1)
    vertex = (
        f"{version}\nout vec2 v_uv;\nvoid main() {{ v_uv = vec2(0.0); gl_Position = vec4(1.0); }}"
    )
    analysis = analyse(Source("a.frag", text), Source("a.vert", vertex))
    node = next(item for item in analysis.nodes if item.offered)
    rewritten(analysis, node)
    with pytest.raises(InputError, match=code):
        rewritten(analysis, node, configured(fetches="level"))
