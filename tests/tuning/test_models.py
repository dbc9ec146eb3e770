"""Models that are fitted to few points: what they find again, and what they say of themselves."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.tuning.age_errors import error_of_period
from shadercache.tuning.models import fit_error, fit_hits, fit_time, time_of_hits
from shadercache.tuning.static_times import fit_static


def decay(alpha: float, rate: float, period: float) -> float:
    return alpha * (1.0 - float(np.exp(-rate * (period - 1.0))))


@pytest.mark.parametrize("alpha", [1e-4, 0.02, 0.7])
@pytest.mark.parametrize("rate", [0.003, 0.08, 1.5])
def test_an_error_that_follows_the_model_is_found_again(alpha: float, rate: float) -> None:
    periods = (2, 4, 8, 16, 24)
    model = fit_error(periods, [decay(alpha, rate, n) for n in periods])
    assert model.follows and model.goodness.r_squared > 0.9999
    for held_out in (3, 12, 48):
        assert model.at(held_out) == pytest.approx(decay(alpha, rate, held_out), rel=0.02)
    assert model.at(1) == 0.0


def test_intervals_hold_what_noise_hides() -> None:
    periods = np.arange(2, 40)
    truth = np.array([decay(0.02, 0.1, n) for n in periods])
    noisy = truth * np.random.default_rng(3).normal(1.0, 0.02, len(truth))
    model = fit_error(periods.tolist(), noisy.tolist())
    assert model.alpha.low < 0.02 < model.alpha.high
    assert model.rate.low < 0.1 < model.rate.high
    assert model.alpha.high - model.alpha.low < 0.002


def test_two_points_tell_no_interval() -> None:
    model = fit_error((2, 8), (0.001, 0.004))
    assert model.alpha.low == -np.inf and model.rate.high == np.inf


def test_an_error_that_jumps_is_interpolated_and_marked() -> None:
    periods, errors = (2, 4, 8, 16), (0.001, 0.001, 0.02, 0.02)
    model = fit_error(periods, errors)
    assert not model.follows
    assert [model.at(n) for n in periods] == pytest.approx(errors)
    assert 0.001 < model.at(6) < 0.02
    assert model.at(64) == pytest.approx(0.02)  # never down, and on as the last piece goes


def test_an_error_that_is_there_at_once_is_kept() -> None:
    """Payloads at half the rate are never the original's."""
    model = fit_error((1, 2, 4, 8), (0.010, 0.011, 0.0125, 0.015))
    assert not model.follows and model.at(1) == 0.010
    assert model.at(16) == pytest.approx(0.0175)


def test_no_error_at_all() -> None:
    model = fit_error((2, 8), (0.0, 0.0))
    assert model.follows and model.at(64) == 0.0


def test_hits_and_times_are_found_again() -> None:
    periods = (2, 4, 8, 32)
    hits = fit_hits(periods, [0.93 * (1.0 - 1.0 / n) for n in periods])
    assert hits.mu.value == pytest.approx(0.93)
    shares = [hits.at(n) * 0.4 + (1.0 - hits.at(n)) * 1.5 for n in periods]
    model = fit_time(periods[:2], shares[:2], 0.93)
    assert (model.hit.value, model.miss.value) == pytest.approx((0.4, 1.5))
    assert [model.at(n) for n in periods] == pytest.approx(shares)
    one = time_of_hits(shares[3], 32, 0.93, 1.5)
    assert one.hit.value == pytest.approx(0.4)


def test_times_are_never_below_nothing() -> None:
    model = fit_time((2, 32), (1.0, 0.01), 1.0)
    assert model.hit.value == pytest.approx(0.0, abs=1e-6)


def test_times_where_nothing_is_found() -> None:
    assert time_of_hits(1.2, 32, 0.0, 1.3).at(32) == pytest.approx(1.3)


def test_what_cannot_be_fitted() -> None:
    with pytest.raises(ValueError, match="one period"):
        fit_time((4, 4), (1.0, 1.0), 1.0)
    with pytest.raises(ValueError, match="not paired"):
        fit_error((2, 4), (0.1,))
    with pytest.raises(ValueError, match="not paired"):
        fit_hits((), ())


def test_times_of_values_that_were_not_drawn() -> None:
    saved = (0.8, 0.5, 0.2)
    times = [fit_time((2, 32), _shares(0.2 + (1.0 - one)), 0.95) for one in saved]
    known = fit_static(saved, times)
    assert known is not None and known.residual < 1e-9
    assert known.at(0.6, 32) == pytest.approx(_shares(0.2 + 0.4)[1])
    assert fit_static(saved[:2], times[:2]) is None


def _shares(hit: float) -> list[float]:
    rates = [0.95 * (1.0 - 1.0 / n) for n in (2, 32)]
    return [rate * hit + (1.0 - rate) * 1.3 for rate in rates]


AGES = {0: 0.0, 1: 0.01, 2: 0.02, 4: 0.04}


def test_a_period_has_all_its_ages() -> None:
    assert error_of_period(AGES, 1, "rmse") == 0.0
    # Squares of 0, 1, 2 and 3 hundredths; age 3 lies between those that were seen.
    assert error_of_period(AGES, 4, "rmse") == pytest.approx(0.01 * (14 / 4) ** 0.5)
    assert error_of_period(AGES, 4, "psnr") == error_of_period(AGES, 4, "rmse")
    assert error_of_period(AGES, 4, "flip") == pytest.approx(0.015)
    # A quarter loses 0.03 at once, the others gain 0.01.
    assert error_of_period(AGES, 4, "flicker") == pytest.approx(0.01 * (12 / 4) ** 0.5)
    with pytest.raises(ValueError, match="oldest is 4"):
        error_of_period(AGES, 6, "rmse")
