"""Verify the nodes of the corpus by every algorithm, and keep the results.

Every legal node of the two scenes of the paper's kind; of those with several objects one of each
value that is offered. ``python -m tests.verify_all [-j N] [--scene NAME] [--resume]`` writes
``bench/results/<machine>/verify-<scene>.json``, from time to time while it works and whole each
time; what an interrupted run found, ``--resume`` keeps. Exit status 1 if a law is broken.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import shadercache
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.value_numbering import one_of_each
from shadercache.caching.configuration import Configuration
from shadercache.cli.progress import progress
from shadercache.compiler import Analysis
from shadercache.diagnostics import DiagnosticError
from shadercache.files import write_bytes
from shadercache.gpu.context import open_context
from shadercache.linking.cache_settings import configured
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.result_files import environment, machine_name
from shadercache.paths import data_path
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.object_inputs import Rows
from shadercache.verify.parallel import VerifiedScene, verify_in_parallel
from shadercache.verify.verdict import MAX_TIES, Difference, Verdict, worst_of
from shadercache.verify.verifier import Verifier
from tests.configured import DEFAULT

SCHEMA_VERSION = 1
WHOLE = ("dragon", "trashcan")
"""Scenes of which every legal node is verified."""

SCENES = (*WHOLE, "heroine", "colonnade", "chess", "meadow")
RESULTS = Path(__file__).resolve().parent.parent / "bench" / "results"

SAVE_SECONDS = 20.0
"""Pause between two writings of the file: what a run can lose."""

Row = dict[str, Any]


@dataclass
class Report:
    """What is known of a scene. ``rows`` maps node ids to rows; ``head`` is what they rest on."""

    path: Path
    head: dict[str, Any]
    every: Sequence[Candidate]
    chosen: Sequence[Candidate]
    cached: Configuration = DEFAULT
    rows: dict[str, Row] = field(default_factory=dict)
    saved: float = 0.0

    @property
    def left(self) -> list[str]:
        """The ids of nodes without a row."""
        return [node.id for node in self.chosen if node.id not in self.rows]

    @property
    def broken(self) -> list[str]:
        """What is broken: node ids, and ``law 1``."""
        found = [] if self.head["law_1"] == "exact" else ["law 1"]
        return found + [node for node, row in self.rows.items() if "broken" in row]

    def add(self, verdict: Verdict) -> None:
        """Take a verdict; write the file if the last time was long ago."""
        self.rows[verdict.node] = row_of(verdict)
        if time.monotonic() - self.saved > SAVE_SECONDS:
            self.save()

    def save(self) -> None:
        """Write the file, rows in the order of the shader's nodes, one to a line."""
        ordered = [self.rows[node.id] for node in self.chosen if node.id in self.rows]
        head = json.dumps(self.head | {"counts": self.counts()}, indent=1).removesuffix("\n}")
        rows = ",\n".join(f"  {json.dumps(row, ensure_ascii=False)}" for row in ordered)
        write_bytes(self.path, f'{head},\n "nodes": [\n{rows}\n ]\n}}\n'.encode())
        self.saved = time.monotonic()

    def counts(self) -> dict[str, int]:
        """How many nodes are legal, verified, exact, ... so far."""
        rows = self.rows.values()
        return {
            "legal": sum(node.legal for node in self.every),
            "offered": sum(node.offered for node in self.every),
            "chosen": len(self.chosen),
            "verified": len(rows),
            "exact in proof mode": sum("broken" not in row for row in rows),
            "broken": sum("broken" in row for row in rows),
            "without 1-pass": sum("without" in row for row in rows),
            "plain mode changes bits": sum("plain" in row for row in rows),
        }


def row_of(verdict: Verdict) -> Row:
    """A node's row; what is as it should be is left out.

    ``plain``: largest difference that plain mode makes under law 2, its 99.9th percentile, and the
    share of changed pixels, each the worst of the algorithms.
    """
    row: Row = {"id": verdict.node, "path": verdict.path}
    if not verdict.profitable:
        row["unprofitable"] = True
    if verdict.refused:
        row["without"] = sorted(verdict.refused)
    if verdict.broken:
        row["text"] = verdict.text
        row["broken"] = {law: _figures(found) for law, found in verdict.inexact.items()}
    if verdict.failure:
        row["failure"] = verdict.failure
    worst = worst_of(verdict.plain.values())
    if not worst.exact:
        row["plain"] = _figures(worst)
    return row


def _figures(found: Difference) -> list[float | None]:
    """Three digits of each figure; JSON has no infinity, so that is null."""
    figures = (found.maximum, found.p999, found.changed)
    return [float(f"{value:.3g}") if value < float("inf") else None for value in figures]


def fingerprint(scene: Scene) -> str:
    """Changes when anything that a verdict depends on changes: our code, the scene's files."""
    package = Path(shadercache.__file__).parent
    code = (
        path
        for path in package.rglob("*")
        if path.suffix in (".py", ".glsl", ".vert", ".frag", ".txt")
    )
    files = {*code, *data_path("grammars").glob("*"), scene.path}
    for item in scene.parts:
        given = (item.fragment, item.vertex, item.verify_mesh or item.mesh)
        files |= {path for path in given if path is not None}
        files |= {texture.path for texture in item.inputs.textures.values()}
        files |= {rows.path for rows in item.inputs.animated.values() if isinstance(rows, Rows)}
    digest = hashlib.sha256()
    for path in sorted(files):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def prepare(path: Path, output: Path | None, resume: bool) -> Report:
    """Check law 1, count depth ties, and take over what an earlier run found if ``resume``."""
    scene = load_scene(path)
    scene, analysis = analyse_scene(scene)
    with open_context() as gpu:
        about = environment(gpu)
        with closing(Verifier(gpu, (scene, analysis))) as verifier:
            law_1, ties = verifier.round_trip(), verifier.references.ties
    assert law_1 is not None, "the corpus is in versions that every driver takes"
    head = {
        "schema_version": SCHEMA_VERSION,
        "scene": scene.name,
        "fingerprint": f"{fingerprint(scene)} {about['gl']['version']} {about['gl']['renderer']}",
        "environment": about,
        "law_1": "exact" if law_1.exact else _figures(law_1.found),
        "depth_ties": ties,
    }
    folder = output or RESULTS / machine_name(about)
    report = Report(
        folder / f"verify-{scene.name}.json",
        head,
        analysis.nodes,
        nodes_of(scene, analysis),
        configured(scene, DEFAULT, None),
    )
    if resume:
        report.rows = earlier_rows(report)
    return report


def nodes_of(scene: Scene, analysis: Analysis) -> list[Candidate]:
    """What is verified of a scene."""
    if scene.name in WHOLE:
        return [node for node in analysis.nodes if node.legal]
    return list(one_of_each([node for node in analysis.nodes if node.offered], analysis.groups))


def earlier_rows(report: Report) -> dict[str, Row]:
    """The rows of the report's file, if it was made by this code on this driver."""
    try:
        stored = json.loads(report.path.read_text(encoding="utf-8"))
        if stored["fingerprint"] == report.head["fingerprint"]:
            known = {node.id for node in report.chosen}
            return {row["id"]: row for row in stored["nodes"] if row["id"] in known}
    except (OSError, ValueError, KeyError, TypeError):
        pass
    _say(f"{report.path} holds nothing that could be taken over: starting anew")
    return {}


def verify(path: Path, report: Report, jobs: int, limit: int | None) -> None:
    """Verify what is left of a scene (``limit`` nodes of it at most), and write the file."""
    left = report.left[:limit]
    report.saved = time.monotonic()
    try:
        with progress(f"verifying {report.head['scene']}", len(left)) as advance:

            def keep(verdict: Verdict) -> None:
                report.add(verdict)
                advance(1)
                if verdict.broken:
                    _say(f"{verdict.node} ({verdict.path}): {', '.join(verdict.broken)}")

            at_once = max(1, min(jobs, len(left)))
            scene = VerifiedScene(path, configuration=report.cached)
            verify_in_parallel(scene, left, at_once, heard=keep)
    finally:
        report.save()


def summary(report: Report) -> str:
    """One paragraph for the terminal."""
    counts = report.counts()
    lines = [
        f"{report.head['scene']}: {counts['exact in proof mode']} of {counts['verified']} nodes "
        f"exact in proof mode ({counts['legal']} legal, {counts['offered']} offered, "
        f"{counts['chosen']} to verify)",
        f"  law 1: {report.head['law_1']}; plain mode changes bits of "
        f"{counts['plain mode changes bits']}; {counts['without 1-pass']} cannot be cached in one "
        f"pass",
        f"  {report.path}",
    ]
    if report.head["depth_ties"] > MAX_TIES:
        lines.append(f"  {report.head['depth_ties']:.2%} of the pixels are depth ties, left out")
    if report.left:
        lines.append(f"  {len(report.left)} nodes are left; --resume goes on")
    lines += [f"  BROKEN: {name}" for name in report.broken]
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev verify-all", description=__doc__)
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--scene", action="append", choices=SCENES, help="only this one")
    parser.add_argument("--resume", action="store_true", help="keep what an earlier run found")
    parser.add_argument("--limit", type=int, metavar="N", help="at most N nodes of each scene")
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="for the result files")
    options = parser.parse_args(arguments)
    broken = False
    try:
        for name in options.scene or SCENES:
            path = data_path("corpus", name, "scene.toml")
            report = prepare(path, options.output, options.resume)
            verify(path, report, options.jobs, options.limit)
            print(summary(report), flush=True)
            broken = broken or bool(report.broken)
    except DiagnosticError as error:
        _say(str(error))
        return error.exit_code
    except KeyboardInterrupt:
        _say("interrupted; --resume goes on from here")
        return 130
    return int(broken)


def _say(message: str) -> None:
    print(message, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
