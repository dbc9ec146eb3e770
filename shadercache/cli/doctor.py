"""``shadercache doctor``: what this machine offers, and what to install."""

from __future__ import annotations

import json
import shutil
import sys
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
        limits = {name: gpu.ctx.info[name] for name in LIMITS if name in gpu.ctx.info}
        return gpu.describe() | {"clock": pick_clock(gpu).name, "limits": limits}


def _advice(report: dict[str, Any]) -> list[str]:
    """What to install, in whole sentences."""
    from shadercache.gpu.context import APT_LINE

    advice = []
    if report["opengl"] is None:
        advice.append(f"There is no usable OpenGL. On Debian and Ubuntu: sudo {APT_LINE}")
    if report[VALIDATOR] is None:
        advice.append(
            f"{VALIDATOR} is missing; the tests check every written shader with it. "
            "On Debian and Ubuntu: sudo apt-get install -y --no-install-recommends glslang-tools"
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
        ]
    return lines + (["", *report["advice"]] if report["advice"] else [])
