"""What can be chosen about a cache, as it is written on a command line."""

from __future__ import annotations

import pytest

from shadercache.caching.settings import cache_choices, with_settings, written_settings
from shadercache.diagnostics import UsageError
from tests.configured import DEFAULT


def test_nothing_said_is_the_default() -> None:
    assert with_settings(DEFAULT, []) == DEFAULT


def test_settings_stand_apart_or_with_commas() -> None:
    every = [f"{key}={words[-1]}" for key, words in cache_choices().items() if key != "adaptive"]
    chosen = with_settings(DEFAULT, every)
    assert chosen == with_settings(DEFAULT, [",".join(every)]) != DEFAULT
    written = [f"{key}={word}" for key, word in written_settings(chosen).items()]
    assert with_settings(DEFAULT, written) == chosen


def test_a_bound_is_a_number_above_zero() -> None:
    chosen = with_settings(DEFAULT, ["adaptive=0.05"])
    assert chosen.refresh.adaptive == 0.05 and written_settings(chosen)["adaptive"] == "0.05"
    precise = with_settings(DEFAULT, ["adaptive=0.0123456789"])
    assert written_settings(precise)["adaptive"] == "0.0123456789"
    assert with_settings(chosen, ["adaptive=off"]) == DEFAULT
    assert chosen.program_key == with_settings(DEFAULT, ["adaptive=2"]).program_key
    assert chosen.program_key != DEFAULT.program_key


@pytest.mark.parametrize("other", ["age", "refresh=none"])
def test_adaptive_periods_need_turns_and_no_ages(other: str) -> None:
    with pytest.raises(UsageError, match=r"adaptive does not go with .*SC028"):
        with_settings(DEFAULT, ["adaptive=0.05", other])


@pytest.mark.parametrize(
    "setting",
    [
        "colour=red",
        "refresh=often",
        "refresh",
        "",
        "=",
        ",",
        "adaptive",
        "adaptive=0",
        "adaptive=nan",
        "adaptive=1e300",
        "adaptive=1e-60",
    ],
)
def test_what_is_not_known_is_refused(setting: str) -> None:
    with pytest.raises(UsageError, match=r"cache.*(no option|cannot be)"):
        with_settings(DEFAULT, [setting])
