"""Which context is asked for on each system; here its answers are substituted."""

from __future__ import annotations

import sys
from typing import Any

import moderngl
import pytest

from shadercache.diagnostics import GraphicsError
from shadercache.gpu.context import APT_LINE, open_context


def refused(monkeypatch: pytest.MonkeyPatch, system: str) -> tuple[list[Any], str]:
    """The backends that are tried on a system that has no OpenGL, and what the user is told."""
    asked: list[Any] = []

    def refuse(**settings: Any) -> None:
        assert settings["standalone"]
        asked.append(settings.get("backend"))
        raise Exception("nothing\nhere")

    monkeypatch.setattr(moderngl, "create_context", refuse)
    monkeypatch.setattr(sys, "platform", system)
    with pytest.raises(GraphicsError) as caught:
        open_context()
    return asked, str(caught.value)


@pytest.mark.parametrize("system", ["linux", "freebsd14"])
def test_egl_needs_no_screen(monkeypatch: pytest.MonkeyPatch, system: str) -> None:
    asked, told = refused(monkeypatch, system)
    assert asked == ["egl", None]
    assert "[SC601]" in told and APT_LINE in told


@pytest.mark.parametrize("system", ["darwin", "win32"])
def test_the_platforms_own(monkeypatch: pytest.MonkeyPatch, system: str) -> None:
    asked, told = refused(monkeypatch, system)
    assert asked == [None]
    assert "[SC601]" in told and "nothing here" in told
    assert APT_LINE not in told and "hint: " in told
