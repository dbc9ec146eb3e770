"""Work spread over a Dask cluster."""

from __future__ import annotations

import gc
import os
import signal
from pathlib import Path

import pytest

from shadercache import cluster
from shadercache.cluster import open_cluster, spread
from shadercache.diagnostics import UsageError
from shadercache.processes import LostTaskError

distributed = pytest.importorskip("distributed")


def fragile(number: int, folder: str, deaths: int) -> int:
    """Number 1 takes its process along, so many times."""
    if number == 1:
        marks = Path(folder)
        count = len(list(marks.iterdir()))
        if count < deaths:
            (marks / str(count)).touch()
            os.kill(os.getpid(), signal.SIGKILL)
    return 10 * number


@pytest.mark.slow
def test_tasks_of_dead_processes_are_given_to_others(tmp_path: Path) -> None:
    once, always = tmp_path / "once", tmp_path / "always"
    once.mkdir()
    always.mkdir()
    with open_cluster("local:2") as client:
        for folder, deaths in ((once, 1), (always, 99)):
            tasks = [(number, str(folder), deaths) for number in range(4)]
            found = dict(spread(client, fragile, tasks))
            lost = found.pop(1)
            assert found == {0: 0, 2: 20, 3: 30}
            assert lost == 10 if deaths == 1 else isinstance(lost, LostTaskError)


@pytest.mark.parametrize(
    "address", ("tcp://127.0.0.1:1", "nonsense", "local:0", "local:65", "local:x", "")
)
def test_there_is_no_cluster(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 0.2)
    with pytest.raises(UsageError, match="SC036"), open_cluster(address):
        pass
    # None is left to the garbage collector, which would close it while another one starts.
    left = [one for one in gc.get_objects() if isinstance(one, distributed.Client)]
    assert {one.status for one in left} <= {"closed"}


@pytest.mark.parametrize(
    ("workers", "said"), [({}, "no workers"), ({"tcp://host:1": {"nthreads": 4}}, "4 threads")]
)
def test_workers_that_will_not_do(workers: dict[str, dict[str, int]], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        cluster._check_workers("tcp://host:8786", workers)
    cluster._check_workers("tcp://host:8786", {"tcp://host:1": {"nthreads": 1}})


def test_the_missing_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(cluster, "import_module", missing)
    with pytest.raises(UsageError, match="SC031") as caught, open_cluster("local:2"):
        pass
    assert "shadercache[cluster]" in str(caught.value)
