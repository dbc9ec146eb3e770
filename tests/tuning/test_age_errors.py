"""Errors of periods from errors of ages."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.tuning.age_errors import error_of_period, straying_of

AGES = {0: 0.0, 1: 0.01, 2: 0.02, 3: 0.03, 5: 0.05, 8: 0.08, 13: 0.13}


def test_at_rest_all_ages_are_equally_frequent() -> None:
    squares = np.mean(np.square([0.0, 0.01, 0.02, 0.03]))
    assert error_of_period(AGES, 4, "rmse") == pytest.approx(float(np.sqrt(squares)))
    assert error_of_period(AGES, 4, "flip") == pytest.approx(0.015)
    assert error_of_period(AGES, 1, "rmse") == 0.0


def test_what_strays_is_refreshed_by_chance() -> None:
    """Simulated: each payload has one chance in four, whatever it had before."""
    random = np.random.default_rng(5)
    ages = np.zeros(200_000, np.int64)
    for _ in range(60):
        ages = np.where(random.random(len(ages)) < 0.25, 0, ages + 1)
    constant = dict.fromkeys(range(1, 14), 0.5) | {0: 0.0}
    found = float(np.sqrt(np.mean(np.where(ages > 0, 0.5, 0.0) ** 2)))
    assert error_of_period(constant, 4, "rmse", np.inf) == pytest.approx(found, rel=0.01)
    assert error_of_period(AGES, 1, "rmse", np.inf) == 0.0
    assert error_of_period(AGES, 4, "rmse", np.inf) > 1.5 * error_of_period(AGES, 4, "rmse")


@pytest.mark.parametrize("metric", ["rmse", "flip"])
@pytest.mark.parametrize("straying", [0.0, 0.05, 0.4])
def test_straying_is_found_again(metric: str, straying: float) -> None:
    error = error_of_period(AGES, 6, metric, straying)  # type: ignore[arg-type]
    found = straying_of(AGES, 6, error, metric)  # type: ignore[arg-type]
    assert found == pytest.approx(straying, abs=1e-9)


def test_it_stays_within_what_can_be() -> None:
    assert straying_of(AGES, 6, 0.0, "rmse") == 0.0
    assert straying_of(AGES, 6, 1.0, "rmse") == np.inf
    assert straying_of(dict.fromkeys(AGES, 0.0), 6, 0.1, "rmse") == 0.0
    assert straying_of(AGES, 6, 1.0, "flicker") == 0.0
    with pytest.raises(ValueError, match="no payload is 14 frames old"):
        error_of_period(AGES, 15, "rmse")
