"""A small world for numerical tests: one plane that fills the picture, run by the manifest alone.

The plane's clip-space w is ``u_plane . (x, y, 1)`` at the picture's point (x, y), so it may tilt,
come near or lie behind the camera, and its z follows from ``u_depth`` = (A, B): z = A w + B. Each
point of the surface is shown ``u_pan`` pixels from its place at rest. The payload is ``u_value``,
and ``u_spike`` in the pixel of the surface around ``u_spot``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from runner.independent_runner import IndependentRunner

from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.manifest.codec import encode
from shadercache.source import Source
from tests.configured import configured, rewritten

SIZE = 64
"""Edge of the picture in pixels."""

VERTEX = """#version 330
in vec2 a_corner;
uniform vec3 u_plane;
uniform vec2 u_depth;
uniform vec2 u_pan;
out vec2 v_place;
void main() {
    float w = dot(u_plane, vec3(a_corner, 1.0));
    v_place = a_corner * SIZE.0 / 2.0;
    gl_Position = vec4(a_corner + u_pan * 2.0 / SIZE.0, 0.0, 1.0) * w;
    gl_Position.z = u_depth.x * w + u_depth.y;
}
""".replace("SIZE", str(SIZE))

FRAGMENT = """#version 330
in vec2 v_place;
uniform vec3 u_value;
uniform vec2 u_spot;
uniform vec3 u_spike;
out vec4 o_color;
void main() {
    bool there = all(lessThan(abs(v_place - u_spot), vec2(0.5)));
    vec3 value = mix(u_value, u_spike, bvec3(there));
    o_color = vec4(value * 0.5, 1.0);
}
"""

PAYLOAD = "mix(u_value, u_spike, bvec3(there))"

ZERO = (0.0, 0.0, 0.0)


def projection(near: float, far: float) -> tuple[float, float]:
    """``u_depth`` of a perspective projection."""
    return (far + near) / (far - near), -2.0 * far * near / (far - near)


class Plane:
    """A variant of the plane, drawn frame by frame."""

    def __init__(self, runner: IndependentRunner) -> None:
        self.runner = runner
        self.values: dict[str, Any] = {
            "u_plane": (0.0, 0.0, 4.0),
            "u_depth": projection(1.0, 100.0),
            "u_pan": (0.0, 0.0),
            "u_value": (0.25, 0.5, 0.75),
            "u_spot": (1e3, 1e3),
            "u_spike": ZERO,
        }

    def draw(self, frame: int, period: int = 65535, **values: Any) -> NDArray[np.float32]:
        """Draw a frame with some uniforms changed for good; its colours, (h, w, 3)."""
        self.values |= values
        image = self.runner.draw(frame, self.values, period, 4)
        return image[..., :3]

    def cached(self, texture: int = 0) -> NDArray[np.float32]:
        """What the last frame stored in the first or second texture, (h, w, channels)."""
        made = self.runner.canvas.caches[0][texture]
        kind = np.float16 if made.dtype == "f2" else np.float32
        stored = np.frombuffer(made.read(), kind).astype(np.float32)
        return stored.reshape(SIZE, SIZE, -1)

    def overwrite(self, texels: NDArray[np.float32]) -> None:
        """Replace what the last frame stored in the first texture."""
        made = self.runner.canvas.caches[0][0]
        made.write(texels.astype(np.float16 if made.dtype == "f2" else np.float32).tobytes())


@cache
def _runner(
    gpu: Gpu, cached: Configuration, form: CacheFormat, algorithm: str, fragment: str, payload: str
) -> IndependentRunner:
    analysis = analyse(Source("plane.frag", fragment), Source("plane.vert", VERTEX))
    node = next(node for node in analysis.nodes if node.text == payload)
    options = configured(cached, form=form)
    emission = rewritten(analysis, node, options, NAMES, unprofitable=True)
    corners = np.array([[-3.0, -3.0], [9.0, -3.0], [-3.0, 9.0]])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in emission.files.items():
            (folder / file).write_text(text)
        (folder / "manifest.json").write_text(encode(emission.manifest))
        size, index = (SIZE, SIZE), np.array([[0, 1, 2]])
        return IndependentRunner(gpu.ctx, folder, algorithm, size, {"a_corner": corners}, index, {})


def plane(
    gpu: Gpu,
    cached: Configuration,
    form: CacheFormat = "rgba32f",
    algorithm: str = "2-pass",
    numbers: Mapping[str, float] | None = None,
    fragment: str = FRAGMENT,
    payload: str = PAYLOAD,
) -> Plane:
    """The plane with these options; ``numbers`` by role replace the manifest's defaults, and
    another shader with another ``payload`` may paint it."""
    runner = _runner(gpu, cached, form, algorithm, fragment, payload)
    runner.reset()
    for entry in runner.manifest["uniforms"]:
        given = entry.setdefault("given", entry["default"])
        entry["default"] = (numbers or {}).get(entry["role"], given)
    return Plane(runner)
