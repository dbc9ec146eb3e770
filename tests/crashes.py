"""A test that crashes its worker process (a driver may) is one red test, and the others still run.

pytest-xdist 3.8 hands the crashed test out again, to crash the next worker. It also hands out
groups of which nothing is left, for whose end a worker then waits for ever, and gives work to
workers that have not collected yet, which ends the run in an internal error.
"""

from __future__ import annotations

from contextlib import suppress

import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadGroupScheduling
from xdist.workermanage import WorkerController


class CrashesAreFailures(LoadGroupScheduling):
    """Groups of tests as ``--dist loadgroup`` makes them; what crashed does not run again."""

    def remove_node(self, node: WorkerController) -> str | None:
        """Take back the work of a worker that ended. Returns the test that it crashed in."""
        workload = self.assigned_work.pop(node)
        units = [unit for unit in workload.values() if not all(unit.values())]
        if not units:
            return _last(workload) if not hasattr(node, "workeroutput") else None
        crashed = next(name for name, done in units[0].items() if not done)
        units[0][crashed] = True
        left = {scope: unit for scope, unit in workload.items() if not all(unit.values())}
        self.workqueue.update(left)
        for other in self.assigned_work:
            self._reschedule(other)
        return crashed

    def _reschedule(self, node: WorkerController) -> None:
        if node not in self.registered_collections:
            return
        # Two may crash at once: what was handed to the second comes back with its own end.
        with suppress(OSError):
            super()._reschedule(node)


def _last(workload: dict[str, dict[str, bool]]) -> str | None:
    """The test that a worker had run when it crashed behind it: in its teardown, or at exit."""
    return next(reversed([name for unit in workload.values() for name in unit]), None)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> CrashesAreFailures | None:
    """Take the place of the scheduler that ``--dist loadgroup`` names."""
    return CrashesAreFailures(config, log) if config.getvalue("dist") == "loadgroup" else None
