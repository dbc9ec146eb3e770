"""What can be chosen about a cache, as it is written on a command line."""

from __future__ import annotations

import pytest

from shadercache.caching.settings import cache_choices, with_settings, written_settings
from shadercache.diagnostics import UsageError
from tests.configured import DEFAULT


def test_nothing_said_is_the_default() -> None:
    assert with_settings(DEFAULT, []) == DEFAULT


def test_settings_stand_apart_or_with_commas() -> None:
    every = [f"{key}={words[-1]}" for key, words in cache_choices().items()]
    chosen = with_settings(DEFAULT, every)
    assert chosen == with_settings(DEFAULT, [",".join(every)]) != DEFAULT
    written = [f"{key}={word}" for key, word in written_settings(chosen).items()]
    assert with_settings(DEFAULT, written) == chosen


@pytest.mark.parametrize("setting", ["colour=red", "refresh=often", "refresh", "", "=", ","])
def test_what_is_not_known_is_refused(setting: str) -> None:
    with pytest.raises(UsageError, match=r"cache.*(no option|cannot be)"):
        with_settings(DEFAULT, [setting])
