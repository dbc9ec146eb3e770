"""Work spread over processes, some of which die."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from shadercache.processes import AllLostError, LostTaskError, spread

DEADLY = 3


def fragile(number: int, folder: str, deaths: int) -> int:
    """One number takes its process along, so many times."""
    if number == DEADLY and len(list(Path(folder).iterdir())) < deaths:
        (Path(folder) / str(os.getpid())).touch()
        os.abort()
    return 10 * number


def deadly(number: int) -> int:
    """Every number takes its process along."""
    os.abort()


def raising(number: int) -> int:
    """A mistake, which is no death."""
    raise ValueError(number)


def begins(folder: str) -> None:
    """Leave a trace of the process."""
    (Path(folder) / str(os.getpid())).touch()


def begins_badly() -> None:
    """A process that cannot work."""
    raise OSError


def doubled(number: int) -> int:
    return 2 * number


@pytest.mark.parametrize("jobs", [1, 2])
@pytest.mark.parametrize("deaths", [1, 99])
def test_what_a_death_left_is_done(tmp_path: Path, jobs: int, deaths: int) -> None:
    tasks = [(number, str(tmp_path), deaths) for number in range(6)]
    found = dict(spread(jobs, fragile, tasks))
    last = found.pop(DEADLY)
    assert found == {number: 10 * number for number in range(6) if number != DEADLY}
    assert last == 30 if deaths == 1 else isinstance(last, LostTaskError)
    assert len(list(tmp_path.iterdir())) == min(deaths, 2), "it is tried twice"


def test_a_process_begins_once(tmp_path: Path) -> None:
    tasks = [(number,) for number in range(8)]
    found = dict(spread(2, doubled, tasks, begin=partial(begins, str(tmp_path))))
    assert found == {number: 2 * number for number in range(8)}
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize(
    ("work", "begin", "error"),
    [(raising, None, ValueError), (doubled, begins_badly, OSError)],
)
def test_what_is_raised_there_is_raised_here(
    work: Callable[..., int], begin: Callable[[], None] | None, error: type[Exception]
) -> None:
    with pytest.raises(error):
        list(spread(2, work, [(1,), (2,)], begin=begin))


def test_death_after_death_is_given_up() -> None:
    with pytest.raises(AllLostError):
        list(spread(2, deadly, [(number,) for number in range(9)], most_lost=2))


def mostly_deadly(number: int) -> int:
    """All but the first number take their process along."""
    return number if number == 0 else deadly(number)


def test_what_came_is_kept_however_many_die_later() -> None:
    found = dict(spread(1, mostly_deadly, [(number,) for number in range(4)], most_lost=2))
    assert found.pop(0) == 0
    assert len(found) == 3 and all(isinstance(one, LostTaskError) for one in found.values())


def test_nothing_to_do() -> None:
    assert list(spread(2, doubled, [])) == []
