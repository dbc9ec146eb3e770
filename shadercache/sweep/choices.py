"""What a sweep is asked for: lists, of which every combination is a trial.

From the command line, or from a TOML file with the same names.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Annotated

import msgspec

from shadercache import foreign_files as foreign
from shadercache.caching.algorithms import ALGORITHMS
from shadercache.caching.configuration import (
    CacheFormat,
    Configuration,
    HitTest,
    PayloadRate,
    Storage,
)
from shadercache.caching.settings import with_settings
from shadercache.diagnostics import input_error, usage_error

MAX_PLAN = 1 << 20
"""Bytes of a file of choices."""

Period = Annotated[int, msgspec.Meta(ge=1, le=65_535)]
# Odd blocks would split the 2 x 2 quads that GPUs shade whole (Sitthi-amorn et al. 2008, 4.2).
Block = Annotated[int, msgspec.Meta(ge=2, le=4096, multiple_of=2)]
Pixels = Annotated[int, msgspec.Meta(ge=1, le=16_384)]
Percent = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]

_BY_WORD = {algorithm.word: algorithm for algorithm in ALGORITHMS}


class Choices(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Lists to combine.

    ``nodes`` are ids, names of the scene's, or sets ``a+b``; none means one node of each value that
    is offered, with ``every_node`` all of them. ``passes`` are words of algorithms. Each text of
    ``cache`` is one alternative, as ``--cache`` takes it. ``size`` is width and height in pixels,
    ``frames`` are drawn and compared in any case; then frames are timed until every ratio is known
    to ``until`` percent (0: not at all), or for ``seconds``. ``perceptual``: also the metrics of
    ``measure.metrics``; ``profile``: also where the frames of two passes go.
    """

    scenes: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    every_node: bool = False
    passes: tuple[str, ...] = tuple(record.word for record in ALGORITHMS if record.usual)
    periods: tuple[Period, ...] = (32,)
    blocks: tuple[Block, ...] = (4,)
    rates: tuple[PayloadRate, ...] = ("full",)
    formats: tuple[CacheFormat, ...] = ("rgba16f",)
    cache: tuple[str, ...] = ("",)
    size: tuple[Pixels, Pixels] = (512, 512)
    frames: Annotated[int, msgspec.Meta(ge=2)] = 24
    until: Percent = 3.0
    seconds: Annotated[float, msgspec.Meta(ge=0.0)] = 30.0
    perceptual: bool = False
    profile: bool = False

    def configurations(self, ids: Sequence[str], several: bool) -> Iterator[Configuration]:
        """Every combination that there is for one payload, algorithms innermost.

        Args:
            several: do objects share the cache? Their numbers are kept then, unless a text says
                ``ids=off``.

        Raises :class:`UsageError` SC028.
        """
        combined = product(
            self.formats, self.cache, self.periods, self.blocks, self.rates, self.passes
        )
        for texels, settings, period, block, rate, word in combined:
            algorithm = _BY_WORD[word]
            if rate != "full" and not algorithm.fraction:
                continue
            base = Configuration(
                tuple(ids), algorithm.name, storage=Storage(texels), payload_rate=rate
            )
            base = replace(base.with_refresh(period, block), hit_test=HitTest(ids=several))
            yield with_settings(base, [settings] if settings else [])


def read_choices(path: Path) -> Choices:
    """The choices of a TOML file. Raises :class:`InputError` SC035, with the path of a mistake."""
    try:
        text = foreign.read_bytes(path, MAX_PLAN).decode()
        if foreign.toml_nesting(text) is not None:
            raise ValueError(f"more than {foreign.MAX_NESTING} brackets are open")
        choices = msgspec.convert(tomllib.loads(text), Choices)
    except (OSError, ValueError) as error:  # msgspec and tomllib raise kinds of ValueError
        raise input_error("SC035", f"cannot read the choices {path}: {error}") from None
    return check_choices(choices)


def check_choices(choices: Choices) -> Choices:
    """The same choices. Raises :class:`UsageError` SC008 where a list is empty or repeats itself,
    or an algorithm is not known."""
    for word in choices.passes:
        if word not in _BY_WORD:
            hint = f"give some of {', '.join(_BY_WORD)}"
            raise usage_error("SC008", f"'{word}' is no algorithm", hint)
    for name in ("scenes", "passes", "periods", "blocks", "rates", "formats", "cache"):
        values = getattr(choices, name)
        if not values and name != "scenes":  # they may be given apart
            raise usage_error("SC008", f"the sweep has no {name}")
        if len(set(values)) < len(values):
            raise usage_error("SC008", f"the sweep has one of its {name} twice")
    slower = [word for word, algorithm in _BY_WORD.items() if algorithm.fraction]
    if "full" not in choices.rates and not set(slower) & set(choices.passes):
        message = "no algorithm of the sweep computes payloads at a fraction of the rate"
        raise usage_error("SC008", message, f"{', '.join(slower)} does")
    return choices
