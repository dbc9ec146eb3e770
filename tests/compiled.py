"""What compilers say of emitted programs: glslang, and the driver of this machine."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manifests import plain

if TYPE_CHECKING:
    from shadercache.compiler import Emission
    from shadercache.gpu.context import Gpu

Pair = tuple[str, str]


def pairs_of(emission: Emission[Any]) -> list[Pair]:
    """The texts of vertex and fragment shader of every program of an emission."""
    manifest = plain(emission.manifest)
    passes: list[Any] = [item for v in manifest.get("variants", ()) for item in v["passes"]]
    passes += [manifest[name] for name in ("original", "payload", "debug") if name in manifest]
    return [(emission.files[p["vertex"]], emission.files[p["fragment"]]) for p in passes]


def without_heading(text: str) -> str:
    """A program without the comment that names its node: two that differ in it are one."""
    return "\n".join(line for line in text.split("\n") if not line.startswith("// shadercache:"))


def errors_of_reference(pairs: Iterable[Pair], folder: Path) -> list[str]:
    """What glslang says against the programs, shader by shader; nothing where it is missing."""
    command = shutil.which("glslangValidator")
    if command is None:
        return []
    files: dict[str, str] = {}
    for vertex, fragment in pairs:
        files.setdefault(without_heading(vertex), f"{len(files)}.vert")
        files.setdefault(without_heading(fragment), f"{len(files)}.frag")
    for text, name in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    line = [command, "-C", *files.values()]
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False)
    return list(_errors(done.stdout, {name: text for text, name in files.items()}))


def _errors(said: str, texts: dict[str, str]) -> Iterator[str]:
    name = ""
    for line in said.splitlines():
        if line in texts:
            name = line
        elif line.startswith("ERROR: 0:"):
            yield f"{line}\n{texts.get(name, '')}"


def errors_of_driver(gpu: Gpu, pairs: Iterable[Pair]) -> list[str]:
    """What the driver says against the programs, compiled and linked."""
    import moderngl

    found: list[str] = []
    for vertex, fragment in dict.fromkeys(
        (without_heading(a), without_heading(b)) for a, b in pairs
    ):
        try:
            gpu.ctx.program(vertex_shader=vertex, fragment_shader=fragment).release()
        except moderngl.Error as error:
            found.append(f"{error}\n{vertex}\n{fragment}")
    return found
