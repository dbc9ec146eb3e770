"""Targets that are a fraction of a picture."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.gpu.fractions import divided, scale_of, spread


@pytest.mark.parametrize("divisor", [1, 2, 4])
@pytest.mark.parametrize("size", [(8, 12), (7, 13), (1, 2)])
def test_every_pixel_has_the_texel_it_lies_in(size: tuple[int, int], divisor: int) -> None:
    viewport = (0, 0, *size)
    columns, rows = divided(viewport, divisor)[2:]
    numbers = np.arange(rows * columns).reshape(rows, columns)
    found = spread(numbers, size)
    assert found.shape == size[::-1]
    scale = scale_of(viewport, divisor)
    for y, x in np.ndindex(*found.shape):
        column, row = int((x + 0.5) * scale[0] + scale[2]), int((y + 0.5) * scale[1] + scale[3])
        assert found[y, x] == numbers[row, column]
