"""Tests on pairs of texts: files of cases, each a shader and what becomes of it.

A file begins with what all of its shaders begin with. Then come the cases: a title, what is to be
known, a shader, and its outcome, which ``./dev goldens`` writes::

    //// An output that is read becomes a variable.
    //// wanted: store
    void main() {
        color = vec4(u_a);
        store = color;
    }
    //// becomes
    ...

Where there is a ``//// vertex``, a vertex shader follows.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

MARK = re.compile(r"^//// (.*)\n", re.MULTILINE)


@dataclass
class Case:
    """A shader, its vertex shader if it has one, and what is to be known, in order."""

    shader: str = ""
    vertex: str = ""
    about: list[tuple[str, str]] = field(default_factory=list)


def anew(text: str, outcome: Callable[[Case], str]) -> str:
    """The text of a file of cases, with the outcome of each."""
    head, *parts = MARK.split(text)
    written = [head]
    case = Case()
    for mark, body in zip(parts[::2], parts[1::2], strict=True):
        if mark == "becomes":
            body, case = f"{outcome(case)}\n", Case()
        elif mark == "vertex":
            case.vertex = body
        else:
            case.shader = head + body
            case.about += [(key, value) for key, value in [mark.partition(": ")[::2]] if value]
        written += f"//// {mark}\n", body
    return "".join(written).rstrip("\n") + "\n"
