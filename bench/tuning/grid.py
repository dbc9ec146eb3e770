"""Every configuration of a grid, drawn once: what the search's choices are compared with.

``python -m bench.tuning.grid SCENE`` draws the values that save anything by static costs, each with
the main choices of the search at nine periods, on the scene's small meshes, and writes
``bench/results/<machine>/tuning/grid-<scene>.json``. What may be a choice at all is drawn at twice
the speed as well, since bounds hold there too. What an interrupted run has drawn is kept.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from shadercache.caching.configuration import Configuration, Filter
from shadercache.cli.progress import progress
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.context import open_context
from shadercache.linking.cache_settings import configured
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.result_files import environment, machine_name, plain, write_json
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER
from shadercache.scene.description import load_scene
from shadercache.tuning.groups import ShaderGroup, assignment_of, groups_of
from shadercache.tuning.laboratory import Drawn, Laboratory, Run
from shadercache.tuning.space import Space
from shadercache.tuning.trials import AGES
from shadercache.tuning.values import Pool, Value, pool_of

SCENES = ("dragon", "trashcan", "chess", "heroine", "colonnade", "meadow")
SPACE = Space(
    algorithms=("2-pass", "parked", "3-pass"),
    periods=(2, 3, 4, 6, 8, 12, 16, 24, 32),
    filters=("bilateral", "carried"),
    blocks=(4,),
    formats=("rgba16f",),
    adaptive=(),
)
MOST_VALUES = 30
"""Of a scene, so that its grid has at most 2,000 configurations."""

SIZE = 256
FRAMES = 36
LAST = tuple(range(30, FRAMES))
LARGEST = 0.02
"""The largest bound that choices are compared at."""

RESULTS = Path(__file__).resolve().parent.parent / "results"


@dataclass(frozen=True)
class Grid:
    """A scene's families: the first shader's values with every kind of the space."""

    linker: Linker
    group: ShaderGroup
    values: tuple[Value, ...]
    base: Configuration

    @classmethod
    def of(cls, name: str) -> Grid:
        """The grid of a corpus scene, on its small meshes."""
        scene = load_scene(Path(data_path("corpus", name, "scene.toml"))).small
        linker = Linker(*analyse_scene(scene))
        group = groups_of(linker)[0]
        pool = pool_of(group, linker.scene)
        alike = (one for same in pool.alike.values() for one in same)
        base = configured(linker.scene, Configuration(), None)
        values = {value.ids: value for value in (*pool.values, *alike)}
        return cls(linker, group, tuple(values.values())[:MOST_VALUES], base)

    @property
    def pool(self) -> Pool:
        """The values that a search may choose from."""
        whole = pool_of(self.group, self.linker.scene)
        known = {value.ids for value in self.values}
        alike = {
            value: tuple(one for one in same if one.ids in known)
            for value, same in whole.alike.items()
        }
        return Pool(tuple(one for one in whole.values if one.ids in known), alike)

    @property
    def families(self) -> Iterator[Configuration]:
        """Each value with each kind."""
        for value in self.values:
            first = replace(SPACE.first(self.base), nodes=value.ids)
            yield first
            yield from SPACE.main(first, not value.changes)
            yield replace(first, algorithm="parked", filter=Filter("carried"))


def periods_of(family: Configuration) -> tuple[int, ...]:
    """The periods of a family; payloads at a fraction of the rate have a use at 1."""
    return (1, *SPACE.periods) if family.divisor > 1 else SPACE.periods


def draw(grid: Grid, laboratory: Laboratory, family: Configuration) -> dict[str, Any]:
    """A family at every period, and without refreshes, in turns."""
    periods = (NEVER, *periods_of(family))
    wanted = [
        assignment_of(grid.linker.scene, {grid.group: family.with_refresh(period)})
        for period in periods
    ]
    run = Run(FRAMES, tuple(sorted({*AGES, *LAST})), hits=True)
    never, *drawn = laboratory.draw(wanted, run)
    count = len(run.compared)
    ages = dict(zip(run.compared, never.errors, strict=True))
    return {
        "configuration": family.to_json(),
        "original": never.original,
        "hits": never.hit_rates[1:],
        "never": {"share": never.share, "errors": [ages[age] for age in AGES]},
        "periods": {
            period: _row(one, count) for period, one in zip(periods[1:], drawn, strict=True)
        },
    }


def hasten(grid: Grid, laboratory: Laboratory, row: dict[str, Any]) -> None:
    """Add the errors at twice the speed, on frames behind the others, of what is faster than the
    original and near enough at the usual speed."""
    family = Configuration.from_json(row["configuration"])
    wanted = {
        int(period): one
        for period, one in row.get("periods", {}).items()
        if one["share"] < 1.0 and one["worst"] <= LARGEST and "hasty" not in one
    }
    assignments = [
        assignment_of(grid.linker.scene, {grid.group: family.with_refresh(period)})
        for period in wanted
    ]
    if not wanted:
        return
    drawn = laboratory.draw(assignments, Run(FRAMES, LAST, start=FRAMES, step=2))
    for one, found in zip(wanted.values(), drawn, strict=True):
        one["hasty"] = found.worst


def _row(drawn: Drawn, count: int) -> dict[str, float]:
    last = drawn.errors[count - len(LAST) :]
    return {
        "share": drawn.share,
        "low": 1.0 / drawn.speedup.high,
        "high": 1.0 / drawn.speedup.low,
        "worst": max(last),
    }


def main() -> None:
    """Draw the grids that are asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--size", type=int, default=SIZE)
    asked = parser.parse_args()
    for name in asked.scenes:
        _gather(name, asked.size)


def _gather(name: str, size: int) -> None:
    grid = Grid.of(name)
    families = list(grid.families)
    with open_context() as gpu, RenderScene(gpu, grid.linker.scene, (size, size)) as world:
        where = environment(gpu)
        path = RESULTS / machine_name(where) / "tuning" / f"grid-{name}.json"
        known = _known(path, size)
        with Laboratory(world, grid.linker) as laboratory, progress(name, len(families)) as advance:
            rows = []
            for family in families:
                row = known.get(json.dumps(family.to_json(), sort_keys=True))
                rows.append(row or _drawn(grid, laboratory, family))
                hasten(grid, laboratory, rows[-1])
                advance(1)
                report = {"environment": where, "size": size, "frames": FRAMES, "families": rows}
                write_json(path, plain(report))
    drawn = [row for row in rows if "periods" in row]
    count = sum(len(row["periods"]) for row in drawn)
    print(f"{name}: {count} configurations, {len(rows) - len(drawn)} families not drawn: {path}")


def _drawn(grid: Grid, laboratory: Laboratory, family: Configuration) -> dict[str, Any]:
    try:
        return draw(grid, laboratory, family)
    except DiagnosticError as error:
        return {"configuration": family.to_json(), "why": error.diagnostics[0].message}


def _known(path: Path, size: int) -> dict[str, Any]:
    """What an earlier run has drawn."""
    if not path.is_file():
        return {}
    report = json.loads(path.read_text(encoding="utf-8"))
    rows = report["families"] if report["size"] == size else []
    return {json.dumps(row["configuration"], sort_keys=True): row for row in rows}


if __name__ == "__main__":
    main()
