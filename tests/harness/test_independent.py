"""A runner that knows nothing but the manifest draws the same bits as the harness."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from shadercache.harness.bundle import Bundle
from shadercache.harness.runner import RunOptions, VariantRunner
from shadercache.harness.stage import Stage

pytestmark = pytest.mark.xdist_group("gl")

RUNNER = Path(__file__).parent.parent / "runner" / "independent_runner.py"


@pytest.fixture(scope="module")
def independent() -> ModuleType:
    spec = importlib.util.spec_from_file_location("independent_runner", RUNNER)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_it_imports_nothing_of_shadercache() -> None:
    text = RUNNER.read_text()
    assert "import shadercache" not in text
    assert "from shadercache" not in text


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
@pytest.mark.parametrize("form", ["rgba16f", "rgba32f"])
def test_same_bits(
    stage: Stage, bundle: Bundle, independent: ModuleType, algorithm: str, form: str
) -> None:
    mesh = stage.mesh
    folder = Path(__file__).parent / "fixtures" / "emission"
    attributes = {name: mesh.arrays[array] for name, array in stage.scene.attributes.items()}
    other = independent.IndependentRunner(
        stage.gpu.ctx, folder, algorithm, stage.size, attributes, mesh.index, {}, form
    )
    with VariantRunner(stage, bundle, algorithm, RunOptions(5, 4, cache_format=form)) as runner:
        for frame in range(6):
            values = {
                name: tuple(map(float, numbers)) if numbers.size > 1 else float(numbers[0])
                for name, numbers in stage.values(frame).items()
            }
            expected = runner.image(frame)
            found = other.draw(frame, values, 5, 4)
            assert np.array_equal(found.view(np.uint32), expected.view(np.uint32))
