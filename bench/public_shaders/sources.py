"""The collections: where each package keeps its shaders, and how its host puts them together."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path

from bench.public_shaders.collection import Shader, Stage, distinct, evenly
from bench.public_shaders.packages import FetchError, debian_package, npm_package

HERE = Path(__file__).parent
STAGES: dict[str, Stage] = {"vert": "vertex", "frag": "fragment"}

FAMILY_LIMIT = 40
"""Shaders taken from one folder of piglit: its generated families have thousands that are alike."""


def three_shaders(folder: Path) -> list[Shader]:
    """What three.js hands to WebGL, assembled by its own code, which runs under node."""
    if shutil.which("node") is None:
        raise FetchError("node is needed to assemble the shaders of three, and it is not installed")
    script = [str(HERE / "three_programs.mjs"), str(npm_package("three", folder))]
    done = subprocess.run(["node", *script], capture_output=True, text=True, check=False)
    if done.returncode:
        raise FetchError(f"the shaders of three cannot be assembled: {done.stderr.strip()}")
    found = (
        Shader(f"three/{item['name']}", STAGES[item["stage"]], item["text"])
        for item in json.loads(done.stdout)
    )
    return list(distinct(found))


def transition_shaders(folder: Path) -> list[Shader]:
    """Each transition in its host's prelude, as GLSL ES 1.00 and as desktop 3.30."""
    package = npm_package("gl-transitions", folder)
    hosts = {path.stem: path.read_text() for path in sorted((HERE / "hosts").glob("*.frag"))}
    transitions = json.loads((package / "gl-transitions.json").read_text(encoding="utf-8"))
    return [
        Shader(f"{host}/{item['name']}", "fragment", prelude.replace("TRANSITION", item["glsl"]))
        for host, prelude in hosts.items()
        for item in transitions
    ]


def piglit_shaders(folder: Path, limit: int | None = FAMILY_LIMIT) -> list[Shader]:
    """The vertex and fragment shaders of piglit, from files and from tests of both stages.

    Of each folder and stage ``limit`` shaders at most, evenly spread over its names.
    """
    root = next(debian_package("piglit", folder).rglob("generated_tests")).parent
    families: dict[tuple[Path, Stage], list[Shader]] = defaultdict(list)
    for path in sorted(root.rglob("*")):
        for shader in _piglit_file(path, f"piglit/{path.relative_to(root)}"):
            families[path.parent, shader.stage].append(shader)
    chosen: list[Shader] = []
    for family in families.values():
        chosen += evenly(list(distinct(family)), limit)
    return list(distinct(chosen))


def _piglit_file(path: Path, name: str) -> Iterator[Shader]:
    match path.suffix:
        case ".vert" | ".frag":
            yield Shader(name, STAGES[path.suffix[1:]], _text(path).replace("\r\n", "\n"))
        case ".shader_test":
            yield from _shader_test(_text(path), name)


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")


_SECTION = re.compile(r"^\[([^\]\n]+)\][^\n]*\n", re.MULTILINE)
_REQUIRED = re.compile(r"^GLSL( ES)? >= (\d+)\.(\d+)", re.MULTILINE)


def _shader_test(text: str, name: str) -> Iterator[Shader]:
    """The shaders in a test. One without #version has the version that the test requires."""
    parts = _SECTION.split(text)
    if "shader include" in parts:
        return
    required = _REQUIRED.search(text)
    es, major, minor = required.groups() if required else (None, "1", "10")
    number = int(major) * 100 + int(minor.ljust(2, "0"))
    version = f"#version {number}{' es' if es and number > 100 else ''}\n"
    seen: dict[str, int] = defaultdict(int)
    for title, body in zip(parts[1::2], parts[2::2], strict=True):
        stage: Stage
        match title:
            case "vertex shader":
                stage = "vertex"
            case "fragment shader":
                stage = "fragment"
            case _:
                continue
        seen[title] += 1
        number_of = f".{seen[title]}" if seen[title] > 1 else ""
        yield Shader(name + number_of, stage, body if "#version" in body else version + body)


COLLECTIONS: dict[str, Callable[[Path], list[Shader]]] = {
    "three": three_shaders,
    "gl-transitions": transition_shaders,
    "piglit": piglit_shaders,
}
