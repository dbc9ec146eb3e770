"""``./dev bench-emit``: how fast variants are written, nodes found and laws checked.

* Emission: milliseconds of processor time for one program (a fragment and a vertex shader) of a
  variant, in plain and in proof mode, over nodes spread evenly over a shader. The shader is
  ``shaders/weathered.frag`` of 300 lines; the dragon and public ones (where ``./dev corpus`` has
  fetched them) stand beside it. Each round begins with a new analysis, so what is kept from node
  to node counts from its beginning.
* Analysis: ``analyse`` and the groups of equal nodes on made shaders of n, 2n, 4n and 8n nodes.
  Time for a node should stay as it is.
* Listing: ``shadercache nodes --json`` of large shaders (:mod:`bench.nodes_speed`).
* Verification: ``shadercache verify`` of ``shaders/lantern.frag`` (100 lines), the values that it
  chooses and every offered one (``--all``), with an empty cache of compiled shaders. Beside the
  wall clock stands the processor time: on a machine that does other work the wall tells little.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from bench.nodes_speed import listing, listing_table, listing_targets
from bench.speed import HERE, PUBLIC, ROOT, Sample, child_seconds, target, time_and_store
from shadercache.caching.configuration import Configuration, Mode, by_every_algorithm
from shadercache.cli.tables import format_table
from shadercache.compiler import Analysis, analyse, rewrite
from shadercache.source import Source

OWN = (HERE / "shaders" / "weathered.frag", ROOT / "corpus" / "dragon" / "dragon.frag")
PUBLIC_NAMES = ("standard.shadowed", "phong.textured", "phong.mirroring")
VERIFIED = HERE / "shaders" / "lantern.toml"
MODES: tuple[Mode, ...] = ("plain", "proof")
STAGES = 8, 16, 32, 64
"""Copies of :data:`PIECE` in the made shaders."""

PIECE = """\
float wave_NUMBER(vec3 p) {
    float bent = sin(p.x * 3.NUMBER + p.y) * cos(p.z - 0.5 * p.x);
    if (p.y > 0.2) {
        bent += dot(p, vec3(0.3, 0.NUMBER, 0.7)) * 0.25;
    }
    return bent * bent + 0.1;
}
"""
HEAD = "#version 330\nin vec3 v_position;\nuniform float u_scale;\nout vec4 f_color;\n"


# --- emission -------------------------------------------------------------------------------------


def shaders() -> Iterator[tuple[Source, Source]]:
    """Fragment and vertex shader of what is rewritten."""
    for path in (*OWN, *(PUBLIC / f"{name}.frag" for name in PUBLIC_NAMES)):
        if path.exists():
            texts = (path.with_suffix(end).read_text("utf-8") for end in (".frag", ".vert"))
            fragment, vertex = (Source(path.stem, text) for text in texts)
            yield fragment, vertex


def emission(nodes: int, rounds: int) -> list[Sample]:
    """Seconds for a program, by shader and mode: one figure for each node, the least of its
    rounds."""
    rows = []
    for fragment, vertex in shaders():
        for mode in MODES:
            times = [_emit(analyse(fragment, vertex), mode, nodes) for _ in range(rounds)]
            seconds = [min(of_node) for of_node in zip(*times, strict=True)]
            about = {"shader": fragment.name, "lines": fragment.text.count("\n"), "mode": mode}
            rows.append(about | {"seconds": seconds})
    return rows


def _emit(analysis: Analysis, mode: Mode, count: int) -> list[float]:
    offered = [node for node in analysis.nodes if node.offered]
    chosen = offered[:: max(1, len(offered) // count)][:count]
    times = []
    for node in chosen:
        begin = time.process_time()
        emission = rewrite(analysis, by_every_algorithm(Configuration((node.id,), mode=mode)))
        # A program is two files, one of each stage.
        times.append((time.process_time() - begin) * 2 / len(emission.files))
    return times


def emission_table(rows: Sequence[Sample]) -> str:
    """Milliseconds for a program; the first of a shader is the one for which nothing is kept."""
    head = ("shader", "lines", "mode", "nodes", "median", "largest", "first")
    lines = []
    for row in rows:
        seconds = row["seconds"]
        times = (statistics.median(seconds), max(seconds), seconds[0])
        about = (row["shader"], str(row["lines"]), row["mode"], str(len(seconds)))
        lines.append((*about, *(f"{1e3 * value:.1f}" for value in times)))
    return format_table(head, lines, right=" ".join(head[1:]))


# --- analysis -------------------------------------------------------------------------------------


def made_shader(pieces: int) -> Source:
    """A shader with as many functions, each called twice, one result used by the next."""
    functions = "".join(PIECE.replace("NUMBER", str(number)) for number in range(pieces))
    calls = "".join(
        f"    p += vec3(wave_{number}(p), wave_{number}(p.yzx) * u_scale, 0.5);\n"
        for number in range(pieces)
    )
    main = f"void main() {{\n    vec3 p = v_position;\n{calls}    f_color = vec4(p, 1.0);\n}}\n"
    return Source(f"made of {pieces}", HEAD + functions + main)


def growth(rounds: int) -> list[Sample]:
    """Seconds for the analysis and for the groups of made shaders: the least of some rounds."""
    rows = []
    for pieces in STAGES:
        samples = [_analysed(made_shader(pieces)) for _ in range(rounds)]
        rows.append({name: min(sample[name] for sample in samples) for name in samples[0]})
    return rows


def _analysed(source: Source) -> Sample:
    begin = time.process_time()
    analysis = analyse(source)
    analysed = time.process_time()
    # Groups are found when they are first asked for.
    nodes, _ = len(analysis.nodes), analysis.groups
    grouped = time.process_time()
    return {"nodes": nodes, "analyse": analysed - begin, "groups": grouped - analysed}


def growth_table(rows: Sequence[Sample]) -> str:
    """Milliseconds; microseconds for a node: constant where time grows with the number of nodes."""
    head = ("nodes", "analyse", "us/node", "groups", "us/node")
    lines = []
    for row in rows:
        cells = [str(row["nodes"])]
        for name in ("analyse", "groups"):
            cells += [f"{1e3 * row[name]:.0f}", f"{1e6 * row[name] / row['nodes']:.1f}"]
        lines.append(cells)
    return format_table(head, lines, right=" ".join(head))


# --- verification ---------------------------------------------------------------------------------


def verification(scene: Path, *which: str) -> Sample:
    """A whole ``shadercache verify``, as a user runs it for the first time.

    ``which``: the options that say of which values.
    """
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "verdicts.json"
        command = [
            sys.executable,
            "-m",
            "shadercache",
            "verify",
            str(scene),
            *which,
            "-o",
            str(output),
        ]
        # Mesa and NVIDIA keep compiled shaders from run to run, in these places.
        caches = {"MESA_SHADER_CACHE_DIR": folder, "__GL_SHADER_DISK_CACHE_PATH": folder}
        load, begin = os.getloadavg()[0], time.perf_counter()
        # It fails where a law is broken, and has a report all the same.
        used, _ = child_seconds(command, cwd=ROOT, env=os.environ | caches, check=False)
        wall = time.perf_counter() - begin
        report = json.loads(output.read_text(encoding="utf-8"))
    return {
        "scene": report["scene"],
        "nodes": report["checked"] + report["equal_to_checked"],
        "left out": report["left_out"],
        "checked": report["checked"],
        "broken": len(report["broken"]),
        "cores": os.cpu_count(),
        "wall seconds": wall,
        "processor seconds": used,
        "load before": load,
    }


def verification_text(sample: Sample) -> str:
    """One sentence."""
    return (
        f"verify {sample['scene']}: {sample['checked']} values of {sample['nodes']} nodes, "
        f"{sample['left out']} left out, {sample['broken']} broken, "
        f"{sample['wall seconds']:.0f} s on {sample['cores']} cores "
        f"(load {sample['load before']:.1f} before), {sample['processor seconds']:.0f} s of "
        "processor time"
    )


def targets(
    emitted: Sequence[Sample], grown: Sequence[Sample], verified: Sequence[Sample]
) -> list[Sample]:
    """What was aimed at and what is reached. Only the shader of 300 lines has a target; those of
    verifying are counted in processor time, shared fairly among the cores."""
    own = {row["mode"]: row["seconds"] for row in emitted if row["shader"] == OWN[0].stem}
    reached = [
        target(f"emission, {mode}, ms a program", 1e3 * statistics.median(own[mode]), 15.0)
        for mode in MODES
    ]
    for name in ("analyse", "groups"):
        first, last = (row[name] / row["nodes"] for row in (grown[0], grown[-1]))
        reached.append(target(f"{name}: time for a node, 8n nodes / n nodes", last / first, 1.5))
    for sample, what, aim in zip(verified, ("verify", "verify --all"), (30.0, 60.0), strict=False):
        share = sample["processor seconds"] / sample["cores"]
        reached.append(target(f"{what}, 100 lines, processor s / cores", share, aim))
    return reached


def _parts(options: argparse.Namespace) -> Sample:
    emitted = emission(options.nodes, options.rounds)
    print(f"{emission_table(emitted)}\n\nprocessor time in ms for a fragment and a vertex shader\n")
    grown = growth(options.rounds)
    print(f"{growth_table(grown)}\n")
    listed = listing(options.rounds)
    print(listing_table(listed))
    ways = () if options.no_verify else ((), ("--all",))
    verified = [verification(VERIFIED, *which) for which in ways]
    for sample in verified:
        print(f"\n{verification_text(sample)}")
    return {
        "emission": emitted,
        "growth": grown,
        "listing": listed,
        "verification": verified,
        "targets": targets(emitted, grown, verified) + listing_targets(listed),
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./dev bench-emit", description=__doc__)
    parser.add_argument("--rounds", type=int, default=3, metavar="N")
    parser.add_argument("--nodes", type=int, default=24, metavar="N", help="nodes of each shader")
    parser.add_argument("--no-verify", action="store_true", help="without the verification")
    return time_and_store(parser, "emit-speed", _parts, arguments)


if __name__ == "__main__":
    sys.exit(main())
