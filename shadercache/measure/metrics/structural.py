"""SSIM: how alike the structure of two images is (Wang et al. 2004), by scikit-image."""

from __future__ import annotations

import numpy as np

from shadercache.measure.image_error import Floats, Mask

SMALLEST = 11
"""The window is as many pixels wide and high, and an image may not be smaller."""

RADIUS = SMALLEST // 2
"""A pixel's value depends on pixels up to so far away."""

SIGMA = 1.5


def structural_similarity(original: Floats, image: Floats, covered: Mask) -> float | None:
    """The mean SSIM over the covered pixels and the three channels: 1 for equal images, else less.

    On display-encoded images (h, w, 3) in 0-1 (the data range is 1), with the Gaussian weights of
    the paper. Windows of covered pixels reach what is not covered. None of images that are smaller
    than the window, or where nothing is covered. Needs scikit-image.
    """
    if min(original.shape[:2]) < SMALLEST or not covered.any():
        return None
    from skimage import metrics

    _, similarity = metrics.structural_similarity(
        original,
        image,
        data_range=1.0,
        channel_axis=2,
        # With these three and a data range, scikit-image's SSIM is that of the paper.
        gaussian_weights=True,
        sigma=SIGMA,
        use_sample_covariance=False,
        full=True,
    )
    return float(np.mean(similarity[covered], dtype=np.float64))
