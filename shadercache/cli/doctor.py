"""``shadercache doctor``: what this machine offers, and what to install."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Collection
from typing import Annotated, Any

import typer

from shadercache import __version__
from shadercache.diagnostics import GraphicsError

LIMITS = (
    "GL_MAX_TEXTURE_SIZE",
    "GL_MAX_VIEWPORT_DIMS",
    "GL_MAX_COLOR_ATTACHMENTS",
    "GL_MAX_VARYING_VECTORS",
)
VALIDATOR = "glslangValidator"
VALIDATOR_FROM = {
    "win32": "The Vulkan SDK has it: winget install KhronosGroup.VulkanSDK",
    "darwin": "With Homebrew: brew install glslang",
}
"""Where it comes from on other systems than Linux."""

FEATURES = (
    (400, "", "proof mode: 'verify' cannot compare bit for bit ('precise')"),
    (400, "", "fetches ahead of a branch by textureQueryLod"),
    (420, "GL_ARB_shading_language_420pack", "layout(binding = N) in shaders"),
    (420, "GL_ARB_shader_image_load_store", "images"),
    (430, "GL_ARB_explicit_uniform_location", "layout(location = N) of uniforms"),
    (430, "GL_ARB_shader_storage_buffer_object", "storage buffers"),
    (440, "GL_ARB_enhanced_layouts", "layout(component = N), and offsets of members"),
    (450, "GL_ARB_clip_control", "the clip space from zero to one (SC605)"),
)
"""What shadercache can use beyond OpenGL 3.3: since when, and by which extension before."""


def command(
    as_json: Annotated[bool, typer.Option("--json", help="The same as JSON.")] = False,
) -> None:
    """Say which OpenGL there is and what to install.

    Exit status 3 if there is no usable OpenGL.
    """
    failure: GraphicsError | None = None
    report: dict[str, Any] = {
        "shadercache": __version__,
        "python": sys.version.split()[0],
        VALIDATOR: shutil.which(VALIDATOR),
    }
    try:
        report["opengl"] = _opengl()
    except GraphicsError as error:
        failure = error
        report["opengl"] = None
    report["advice"] = _advice(report)
    print(json.dumps(report, indent=1) if as_json else "\n".join(_lines(report)))
    # After the report: it is needed most where there is no OpenGL.
    if failure:
        raise failure


def _opengl() -> dict[str, Any]:
    from shadercache.gpu.clock import pick_clock
    from shadercache.gpu.context import open_context

    with open_context() as gpu:
        ctx = gpu.ctx
        limits = {name: ctx.info[name] for name in LIMITS if name in ctx.info}
        missing = _missing(ctx.version_code, ctx.extensions)
        about = {"clock": pick_clock(gpu).name, "limits": limits, "missing": missing}
        return gpu.describe() | about


def _missing(version: int, extensions: Collection[str]) -> list[str]:
    """What falls away on a driver, a line each. A version is 330, 410 and so on."""
    return [
        f"{what}: needs OpenGL {since // 100}.{since // 10 % 10}"
        for since, extension, what in FEATURES
        if version < since and extension not in extensions
    ]


def _advice(report: dict[str, Any]) -> list[str]:
    """What to install, in whole sentences."""
    from shadercache.gpu.context import what_to_do

    advice = []
    if report["opengl"] is None:
        advice.append(f"There is no usable OpenGL: {what_to_do()}")
    if report[VALIDATOR] is None:
        line = "sudo apt-get install -y --no-install-recommends glslang-tools"
        source = VALIDATOR_FROM.get(sys.platform, f"On Debian and Ubuntu: {line}")
        advice.append(
            f"{VALIDATOR} is missing; 'check' asks it as well, and the tests need it. {source}"
        )
    return advice


def _lines(report: dict[str, Any]) -> list[str]:
    opengl = report["opengl"]
    lines = [
        f"shadercache       {report['shadercache']} on Python {report['python']}",
        f"glslangValidator  {report[VALIDATOR] or 'not found'}",
    ]
    if opengl is None:
        lines.append("OpenGL            none")
    else:
        kind = "software, on the CPU" if opengl["software"] else "hardware"
        lines += [
            f"OpenGL            {opengl['version']}",
            f"renderer          {opengl['renderer']} ({kind})",
            f"vendor            {opengl['vendor']}",
            f"clock             {opengl['clock']}",
            *(f"{name:30} {value}" for name, value in opengl["limits"].items()),
            *(f"missing           {line}" for line in opengl["missing"]),
        ]
    return lines + (["", *report["advice"]] if report["advice"] else [])
