"""Variants of Vulkan GLSL: glslang takes them, and they do what those of OpenGL do."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest
from msgspec import UNSET

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis, Emission, analyse
from shadercache.front.read_options import ReadOptions
from shadercache.manifest.codec import decode, encode
from shadercache.manifest.interface import AttributeInput, StorageBlockInput
from shadercache.manifest.model import Manifest
from shadercache.source import Source
from tests.configured import configured, rewritten
from tests.glslang import needs_glslang, vulkan_errors

FOLDERS = (Path(__file__).with_name("vulkan"), Path(__file__).parent.parent / "reports/vulkan")
PAIRS = sorted(path.with_suffix("") for folder in FOLDERS for path in folder.glob("*.vert"))
SETTINGS = {
    "default": {},
    "carried": {"filter": "carried"},
    "surface": {"refresh": "surface"},
    "adaptive": {"adaptive": "0.05"},
    "half": {"form": "rgba32f", "magnification": "on"},
}


def of(stem: Path, reading: ReadOptions) -> Analysis:
    paths = [stem.with_suffix(suffix) for suffix in (".frag", ".vert")]
    return analyse(
        *(Source(path.name, path.read_text(encoding="utf-8")) for path in paths), reading
    )


def in_vulkan(name: str) -> Analysis:
    return of(FOLDERS[0] / name, ReadOptions(dialect="vulkan"))


def emitted(
    analysis: Analysis, node: Candidate, mode: Mode, **chosen: object
) -> Emission[Manifest]:
    return rewritten(analysis, node, configured(mode=mode, **chosen), NAMES)


def errors(texts: Iterable[tuple[str, str]], folder: Path) -> list[str]:
    """What glslang says of shaders, each with its text; equal ones are judged once."""
    found = []
    for stage, text in dict.fromkeys((Path(name).suffix, text) for name, text in texts):
        file = folder / f"shader{stage}"
        file.write_text(text, encoding="utf-8")
        found += [f"{line}\n{text}" for line in vulkan_errors(file)]
    return found


def spread(nodes: Sequence[Candidate], count: int) -> Sequence[Candidate]:
    """The first, the last, and some between."""
    return nodes[:: max(1, len(nodes) // count)]


@needs_glslang
@pytest.mark.parametrize("stem", PAIRS, ids=lambda stem: stem.name)
def test_glslang_takes_every_pass(stem: Path, tmp_path: Path) -> None:
    analysis = of(stem, ReadOptions(dialect="vulkan"))
    nodes = spread([node for node in analysis.nodes if node.offered], 2)
    asked = [(nodes[0], "proof"), *((node, "plain") for node in (nodes[0], nodes[-1]))]
    texts = [file for node, mode in asked for file in emitted(analysis, node, mode).files.items()]
    assert len(texts) >= 50
    assert not errors(texts, tmp_path)


@needs_glslang
@pytest.mark.parametrize("chosen", SETTINGS)
def test_glslang_takes_what_is_kept_beside_the_payload(chosen: str, tmp_path: Path) -> None:
    analysis = in_vulkan("both")
    node = next(node for node in analysis.nodes if node.text == "noise(v_position.zxy)")
    emission = emitted(analysis, node, "plain", **SETTINGS[chosen])
    assert not errors(emission.files.items(), tmp_path)


def test_a_shader_over_the_screen(tmp_path: Path) -> None:
    text = (
        "#version 310 es\nprecision highp float;\nlayout(location = 0) out vec4 o;\n"
        "layout(set = 0, binding = 0) uniform U { float time; };\n"
        "void main() { vec2 at = gl_FragCoord.xy; o = vec4(exp(sin(at.x) * cos(at.y)) * time); }\n"
    )
    analysis = analyse(Source("screen.frag", text), None, ReadOptions(dialect="vulkan"))
    node = next(node for node in analysis.nodes if node.text.startswith("exp("))
    emission = emitted(analysis, node, "plain")
    assert not errors(emission.files.items(), tmp_path)
    assert "gl_VertexIndex" in emission.files["2-pass.miss.vert"]


def test_they_are_those_of_opengl_but_for_the_places() -> None:
    """The pair is right in both, and the passes of OpenGL are drawn and compared elsewhere."""
    stem = FOLDERS[0] / "both"
    ours, theirs = of(stem, ReadOptions(dialect="vulkan")), of(stem, ReadOptions())
    offered = [node for node in ours.nodes if node.offered]
    assert [node.id for node in offered] == [node.id for node in theirs.nodes if node.offered]
    for node in spread(offered, 4):
        vulkan = emitted(ours, node, "plain")
        opengl = emitted(theirs, theirs.nodes_of(node.id)[0], "plain")
        assert vulkan.files.keys() == opengl.files.keys()
        for name, text in vulkan.files.items():
            # The uniforms are in one block there, whether or not a pass needs them.
            own = {line for line in opengl.files[name].splitlines() if line.startswith("uniform")}
            assert without_places(text) == without_places(opengl.files[name]), name
            assert all(f" {plain.split()[2].rstrip(';')};" in text for plain in own)


def without_places(text: str) -> list[str]:
    """The lines of a shader without the places of what was added, and without added uniforms."""
    text = re.sub(r"layout\([^)]*\) uniform sc_uniforms \{.*?\n\};\n", "", text, flags=re.DOTALL)
    text = re.sub(r"\bgl_VertexIndex\b", "gl_VertexID", text)
    text = re.sub(r"\bgl_InstanceIndex\b", "gl_InstanceID", text)
    text = text.replace("gl_DepthRange.far", "1.0")
    lines = []
    for line in text.splitlines():
        if re.search(r"\bsc_\w+", line):
            line = re.sub(r"^layout\(([^)]*)\) ", _without_own_places, line)
        line = line.partition("//")[0].rstrip()  # a comment goes with what stood below it
        if line and not re.match(r"uniform (int|float|i?vec4) sc_", line):
            lines.append(line)
    return lines


def _without_own_places(match: re.Match[str]) -> str:
    kept = [it for it in match[1].split(", ") if not re.match(r"(set|binding|location) =", it)]
    return f"layout({', '.join(kept)}) " if kept else ""


def test_the_manifest_tells_every_place() -> None:
    analysis = in_vulkan("both")
    node = next(node for node in analysis.nodes if node.text == "noise(v_position.zxy)")
    emission = emitted(analysis, node, "plain", ids=True)
    manifest = emission.manifest
    assert decode(json.loads(encode(manifest)), "manifest.json") == manifest
    block = manifest.uniform_block
    assert block is not UNSET
    assert (block.name, block.set, block.binding) == ("sc_uniforms", 1, 0)
    added = {uniform.role: uniform for uniform in manifest.uniforms}
    assert added["clock"].offset == 48 and added["epsilon"].offset == 76
    assert (added["previous-cache"].binding, added["current-cache"].binding) == (1, 3)
    for uniform in manifest.uniforms:
        assert (uniform.binding is UNSET) == (uniform.type not in ("sampler2D", "usampler2D"))
        assert (uniform.offset is UNSET) != (uniform.binding is UNSET)
        assert uniform.offset is UNSET or uniform.offset < block.size
    assert any("positive height" in text for text in manifest.relies_on)
    assert not any("texture unit" in text for text in manifest.frame)
    hit = emission.files["2-pass.hit.frag"]
    assert "layout(set = 1, binding = 1) uniform sampler2D sc_cache;" in hit
    assert "first_object" in added["object"].name and "firstInstance" in added["object"].meaning
    inputs = {entry.name: entry for entry in manifest.inputs}
    twin = inputs["sc_previous_a_instance"]
    assert isinstance(twin, AttributeInput) and twin.location == 7
    assert inputs["sc_previous_Camera"].set == inputs["sc_previous_Bones"].set == 1
    bindings = [inputs[f"sc_previous_{name}"].binding for name in ("Camera", "Bones")]
    assert len(set(bindings)) == 2 and min(bindings) >= 16


def test_push_constants_have_a_buffer_for_a_twin() -> None:
    analysis = in_vulkan("pushed")
    node = next(node for node in analysis.nodes if node.text.startswith("exp("))
    emission = emitted(analysis, node, "plain")
    inputs = {entry.name: entry for entry in emission.manifest.inputs}
    pushed, twin = inputs["Draw"], inputs["sc_previous_Draw"]
    assert pushed.push_constant and pushed.packing == "std430" and pushed.binding is None
    assert isinstance(twin, StorageBlockInput) and twin.previous_of == "Draw"
    assert [one.offset for one in twin.members] == [one.offset for one in pushed.members] == [0, 64]
    assert (twin.set, twin.packing, twin.size) == (1, "std430", pushed.size)
    text = emission.files["2-pass.hit.vert"]
    assert "readonly buffer sc_previous_Draw" in text and text.count("push_constant") == 1
    assert inputs["SCALE"].constant_id == 4 and inputs["SCALE"].default == "2.0"
    kinds = {entry.name: type(entry).__struct_config__.tag for entry in emission.manifest.inputs}
    assert (kinds["u_picture"], kinds["u_how"]) == ("texture", "sampler state")


def test_indexed_textures_stay_where_they_are_in_proof_mode() -> None:
    """An argument is made a precise local, and there are no locals of textures."""
    text = (
        "#version 400\nuniform sampler2D maps[4]; in vec2 uv; flat in int which; out vec4 o;\n"
        "int pick(int i) { return i & 3; }\n"
        "vec4 of(sampler2D map, vec2 at) { return textureLod(map, at * 3.0, 0.0); }\n"
        "void main() { o = exp(sin(of(maps[pick(which)], uv * uv))) * uv.x; }\n"
    )
    vertex = (
        "#version 400\nin vec3 p; uniform mat4 m; out vec2 uv; flat out int which;\n"
        "void main() { uv = p.xy; which = 1; gl_Position = m * vec4(p, 1.0); }\n"
    )
    analysis = analyse(Source("maps.frag", text), Source("maps.vert", vertex))
    node = next(node for node in analysis.nodes if node.text.startswith("exp("))
    written = "".join(emitted(analysis, node, "proof").files.values())
    assert "sampler2D sc_exact" not in written and "of(maps[pick(which)], sc_exact" in written
