"""S20: the suite runs on whatever renderer there is; which one that is, and what is skipped."""

from __future__ import annotations

from pathlib import Path

from shadercache.gpu.context import Gpu

from .criteria import Criteria, stress_number

SOFTWARE = ("llvmpipe", "softpipe", "swrast")


def test_the_renderer_is_named(gpu: Gpu, stress: Criteria) -> None:
    """Nothing in the suite asks for a renderer, so another one needs no change."""
    stress.tell("renderer", f"{gpu.renderer}, {gpu.version}")
    stress.tell("kind", "software" if gpu.renderer.startswith(SOFTWARE) else "hardware")
    texts = {
        file.name: file.read_text(encoding="utf-8")
        for file in Path(__file__).parent.glob("test_s*.py")
        if stress_number(file) != 20
    }
    asking = [name for name, text in texts.items() if any(word in text for word in SOFTWARE)]
    stress.demand("tests that ask for a renderer", str(asking), "none", not asking)
