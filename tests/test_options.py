"""What can be chosen about a rewrite, as it is written on a command line."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import UsageError
from shadercache.options import (
    DEFAULT_CACHE,
    CacheOptions,
    cache_choices,
    read_cache_options,
    written_cache_options,
)


def test_nothing_said_is_the_default() -> None:
    assert read_cache_options([]) == DEFAULT_CACHE == CacheOptions()


def test_settings_stand_apart_or_with_commas() -> None:
    every = [f"{key}={words[-1]}" for key, words in cache_choices().items()]
    chosen = read_cache_options(every)
    assert chosen == read_cache_options([",".join(every)]) != DEFAULT_CACHE
    assert read_cache_options([f"{k}={v}" for k, v in written_cache_options(chosen).items()]) == (
        chosen
    )


@pytest.mark.parametrize("setting", ["colour=red", "refresh=often", "refresh", "", "=", ","])
def test_what_is_not_known_is_refused(setting: str) -> None:
    with pytest.raises(UsageError, match=r"cache.*(no option|cannot be)"):
        read_cache_options([setting])
