"""Debug views: false colours, their legend, and names that are not known."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.caching.outcomes import OUTCOMES
from shadercache.diagnostics import UsageError
from shadercache.measure.measurement import Probe
from shadercache.report.debug_views import (
    AGED,
    TOO_OLD,
    YOUNG,
    chosen_views,
    view_names,
    view_picture,
)
from shadercache.report.images import LEGEND, outcome_color

WIDTH = 400


def probe(ages: bool = True) -> Probe:
    """A column for each outcome, and ages from 0 to 40, upwards, at a period of 32."""
    mask = np.zeros((64, WIDTH), np.uint8)
    for place, value in enumerate((0, *OUTCOMES.values())):
        mask[:, place * 20 : (place + 1) * 20] = value
    row = np.linspace(0.0, 40.0, 64, dtype=np.float32)
    return Probe(mask, OUTCOMES, np.repeat(row[:, None], WIDTH, 1) if ages else None, 32)


def test_every_outcome_has_a_colour_of_its_own_and_words() -> None:
    colors = [outcome_color(name, value) for name, value in OUTCOMES.items()]
    assert len({(0, 0, 0), *colors}) == len(OUTCOMES) + 1
    assert set(OUTCOMES) <= set(LEGEND)


def test_all_outcomes_in_one_picture() -> None:
    shown = view_picture("hits", probe())
    assert shown.shape[1] == WIDTH and shown.shape[0] > 64, "the legend stands below"
    for place, (name, value) in enumerate(OUTCOMES.items(), start=1):
        assert tuple(shown[10, place * 20 + 5]) == outcome_color(name, value)
        below = shown[64:].reshape(-1, 3)
        assert (below == outcome_color(name, value)).all(axis=1).sum() > 50, f"no legend of {name}"


def test_one_outcome_stands_out() -> None:
    shown = view_picture("depth", probe())[:64].reshape(-1, 3)
    colors = {tuple(color) for color in np.unique(shown, axis=0)}
    assert colors == {(0, 0, 0), (72, 72, 78), LEGEND["depth"][0]}


def test_ages_from_new_to_too_old() -> None:
    shown = view_picture("age", probe())
    assert tuple(shown[63, 30]) == YOUNG, "row 0 is at the bottom, and new"
    assert tuple(shown[0, 30]) == TOO_OLD
    assert tuple(shown[0, 5]) == (0, 0, 0), "nothing is drawn there"
    aged = 63 - round(32.0 / 40.0 * 63) + 1
    assert np.abs(shown[aged, 30].astype(int) - AGED).max() < 12


def test_names() -> None:
    known = view_names(probe())
    assert known == ("hits", *OUTCOMES, "age")
    assert chosen_views(["all"], probe()) == list(known)
    assert chosen_views(["clip", "outside", "hits"], probe()) == ["outside", "hits"]
    with pytest.raises(UsageError, match="no view 'colour'"):
        chosen_views(["colour"], probe())
    with pytest.raises(UsageError) as error:
        chosen_views(["age"], probe(ages=False))
    assert "age=on" in str(error.value.diagnostics[0].hint)
