"""Laws 1 to 4 for shaders with outputs of every kind and number; each output counts."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from manifests import plain
from render.test_independent_runner import agree, write

from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.source import Source
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.configured import PROOF, rewritten
from tests.glslang import needs_glslang, objections

FOLDER = Path(__file__).with_name("outputs")
SHADERS = sorted(path.stem for path in FOLDER.glob("*.frag"))
COSTLY = ("noise", "costly")
ONE_NODE = {
    "array": "noise(p)",
    "functions": "noise(q)",
    "gbuffer": "noise(p)",
    "mixed": "noise(p)",
}
"""Shader -> the value whose programs are tampered with."""


def load(name: str) -> tuple[Scene, Analysis]:
    vertex = FOLDER / f"{name}.vert"
    files = {"fragment": FOLDER / f"{name}.frag"}
    if vertex.exists():
        files["vertex"] = vertex
    return analyse_scene(altered(load_scene(FOLDER), **files))


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", SHADERS)
def test_laws_1_to_4(name: str, gpu: Gpu) -> None:
    scene, analysis = load(name)
    nodes = [
        node for node in analysis.nodes if node.legal and any(word in node.text for word in COSTLY)
    ]
    assert nodes
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        found = verifier.round_trip()
        verdicts = [verifier.check(node) for node in nodes]
    assert found is not None
    assert found.exact
    broken = {item.text: item.failure or item.broken for item in verdicts if item.broken}
    assert not broken
    assert all("2-pass" in item.algorithms for item in verdicts)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", ONE_NODE)
def test_every_output_is_judged(name: str, gpu: Gpu) -> None:
    scene, analysis = load(name)
    node = next(node for node in analysis.nodes if node.offered and node.text == ONE_NODE[name])
    emission = rewritten(analysis, node, PROOF, unprofitable=True)
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        for output in analysis.program.outputs:
            # The shading of hits is all that is changed, and of one output alone.
            file = "2-pass.hit.frag"
            text = emission.files[file]
            at = text.rindex("}")
            wrong = (
                f"{output.name}{'[0]' if output.type.dims else ''} = {_other(output.type.name)};"
            )
            files = emission.files | {file: f"{text[:at]}    {wrong}\n}}\n"}
            verdict = Verdict("", "", "", True)
            judge(verifier.references, Bundle(emission.manifest, files), verdict)
            assert "law 3 (2-pass)" in verdict.broken, output.name


def _other(kind: str) -> str:
    return f"{kind}({'3u' if kind.startswith('u') else '3'})"


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", ["array", "mixed", "float", "uint"])
def test_an_engine_draws_the_same(name: str, gpu: Gpu, tmp_path: Path) -> None:
    scene, analysis = load(name)
    node = next(node for node in analysis.nodes if node.offered and "noise" in node.text)
    write(rewritten(analysis, node, algorithms=NAMES), tmp_path)
    bundle = load_bundle(tmp_path)
    with RenderScene(gpu, Linker(scene, analysis).scene, (96, 64), "rgba32f") as world:
        for algorithm in bundle.algorithms:
            assert agree(world, bundle, tmp_path, algorithm, None), algorithm


def test_the_manifest_tells_outputs_and_targets() -> None:
    analysis = load("array")[1]
    node = next(node for node in analysis.nodes if node.offered and node.text == "noise(p)")
    manifest = plain(rewritten(analysis, node, Configuration(), unprofitable=True).manifest)
    assert manifest["outputs"] == [
        {"output": "o_color", "type": "vec4", "location": 0, "targets": ["color"]},
        {
            "output": "o_layers",
            "type": "vec3[3]",
            "location": 1,
            "targets": ["color-2", "color-3", "color-4"],
        },
        {"output": "o_last", "type": "int", "location": 4, "targets": ["color-5"]},
    ]
    colors = ["color", "color-2", "color-3", "color-4", "color-5"]
    passes = {v["algorithm"]: v["passes"] for v in manifest["variants"]}
    assert passes["2-pass"][0]["targets"] == [*colors, "cache"]
    assert passes["3-pass"][-1]["targets"] == colors
    assert manifest["payload"]["targets"] == ["color"]
    assert any(text.startswith("6 colour attachments") for text in manifest["relies_on"])


@needs_glslang
@pytest.mark.parametrize("name", SHADERS)
def test_the_reference_compiler_takes_every_program(name: str, tmp_path: Path) -> None:
    analysis = load(name)[1]
    node = next(node for node in analysis.nodes if node.offered)
    emission = rewritten(analysis, node, unprofitable=True)
    assert not objections(emission.files.items(), tmp_path)


def analysed(outputs: str, body: str) -> Analysis:
    head = "#version 440\nuniform vec3 p;\n"
    text = f"{head}{outputs}\nvoid main() {{ {body} }}"
    return analyse(Source("shader.frag", text), mapping="screen")


@pytest.mark.parametrize(
    ("outputs", "told"),
    [
        ("", "this has none"),
        ("layout(location = 0) out vec4 a; layout(location = 2) out vec4 b;", "location 1"),
        (
            "layout(location = 0) out vec4 a; layout(location = 0, index = 1) out vec4 b;",
            "second source of blending",
        ),
        ("out vec4 a[9];", "9 render targets"),
        (
            "layout(location = 0) out vec2 a; layout(location = 0, component = 2) out vec2 b;",
            "shares a render target",
        ),
        ("out vec4 a; layout(location = 3) out vec4 b[6];", "location 1"),
    ],
)
def test_what_is_refused(outputs: str, told: str) -> None:
    with pytest.raises(InputError) as raised:
        analysed(outputs, "float x = sin(p.x);")
    (problem,) = raised.value.diagnostics
    assert problem.code == "SC403"
    assert told in problem.message


@pytest.mark.parametrize(
    ("count", "fits"), [(6, set(NAMES)), (7, set(NAMES) - {"parked"}), (8, {"3-pass"})]
)
def test_where_targets_run_out(count: int, fits: set[str]) -> None:
    analysis = analysed(f"out vec4 a[{count}];", "a[1] = vec4(sin(exp(p.x * gl_FragCoord.x)));")
    node = next(node for node in analysis.nodes if node.legal and node.text.startswith("sin"))
    emission = rewritten(analysis, node, algorithms=NAMES, unprofitable=True)
    assert {variant.algorithm for variant in emission.manifest.variants} == fits
    for entry in emission.manifest.refused:
        assert "render targets" in entry.reason or "park" in entry.reason
