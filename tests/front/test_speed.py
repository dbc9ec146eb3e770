"""The parser answers at once. The limits are loose: they find what became slow, not a slow day."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from shadercache.emit.printer import print_module
from shadercache.front import grammar
from shadercache.front.parse import parse
from shadercache.source import Source

LANGUAGE = (Path(__file__).parent / "shaders" / "language.frag").read_text()


def best(action: Callable[[], object]) -> float:
    """The shortest of three runs, in seconds."""
    times = []
    for _ in range(3):
        begin = time.perf_counter()
        action()
        times.append(time.perf_counter() - begin)
    return min(times)


def test_35_kilobytes_take_a_tenth_of_a_second() -> None:
    functions = LANGUAGE[LANGUAGE.index("float prototype") :]
    source = Source("long", LANGUAGE + functions * 11)
    assert len(source.text) > 30_000
    module = parse(source)
    assert best(lambda: parse(source)) < 0.3  # Measured: 0.04.
    assert best(lambda: print_module(module)) < 0.1  # Measured: 0.005.


def test_the_saved_parser_is_loaded_in_30_milliseconds() -> None:
    parse(Source("first", LANGUAGE))

    def load() -> None:
        grammar.load_parser.cache_clear()
        grammar.load_parser()

    if grammar.user_cache_folder() is not None:
        assert best(load) < 0.1  # Measured: 0.01; making it takes 0.2.
