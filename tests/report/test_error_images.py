"""Errors as pictures: their scale, their sign, their legend."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.shown import Picture
from shadercache.report.error_images import absolute_error, scale_of, signed_error

HEIGHT, WIDTH = 40, 300
GREY: Picture = np.full((HEIGHT, WIDTH, 3), 100, np.uint8)


def off_by(levels: int) -> Picture:
    return (GREY + np.int32(levels)).astype(np.uint8)


@pytest.mark.parametrize(
    ("levels", "scale"), [(0, 100), (1, 100), (2, 100), (3, 50), (12, 20), (51, 5), (130, 1)]
)
def test_the_scale_is_the_largest_that_fits(levels: int, scale: int) -> None:
    assert scale_of(GREY, off_by(levels)) == scale


def test_few_values_that_are_far_off_do_not_decide() -> None:
    image = off_by(2)
    image[0, :10] = 255
    assert scale_of(GREY, image) == 100


def test_errors_have_their_size() -> None:
    image = GREY.copy()
    image[:, 100:200, 0] += 10
    image[:, 200:, 1] -= 10
    assert scale_of(GREY, image) == 20
    size, signed = absolute_error(GREY, image)[:HEIGHT], signed_error(GREY, image)[:HEIGHT]
    assert size[0, 0].tolist() == [0, 0, 0] and signed[0, 0].tolist() == [128, 128, 128]
    assert size[0, 150].tolist() == [200, 0, 0] and signed[0, 150].tolist() == [228, 128, 128]
    assert size[0, 250].tolist() == [0, 200, 0] and signed[0, 250].tolist() == [128, 28, 128]


def test_what_is_too_large_is_clipped() -> None:
    image = GREY.copy()
    image[0, 0], image[0, 1] = 255, 0
    assert scale_of(GREY, image) == 100
    signed = signed_error(GREY, image)
    assert signed[0, 0].tolist() == [255] * 3 and signed[0, 1].tolist() == [0] * 3
    assert absolute_error(GREY, image)[0, 0].tolist() == [255] * 3


def test_there_is_a_legend_below() -> None:
    for shown in (absolute_error(GREY, off_by(3)), signed_error(GREY, off_by(3))):
        assert shown.shape[0] > HEIGHT + 10 and shown.shape[1] == WIDTH
