"""Would a sweep disturb its times if the next variants were compiled meanwhile?

``python -m bench.overlap [SCENE]`` times the original while another process compiles variants, and
while that process is stopped, in turns. It also tells what share of a trial compiling is, which is
all that could be saved.
"""

from __future__ import annotations

import argparse
import os
import signal
from functools import partial
from multiprocessing import Process
from pathlib import Path
from time import perf_counter, sleep

from shadercache.caching.configuration import Configuration, by_every_algorithm
from shadercache.cli.scenes import find_scene
from shadercache.compiler import rewrite
from shadercache.gpu.clock import pick_clock
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.statistics import paired_ratio
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene

TURNS, FRAMES = 20, 6


def main() -> None:
    """Read the command line and compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", nargs="?", default="dragon")
    parser.add_argument("--size", type=int, default=512)
    given = parser.parse_args()
    path = find_scene(given.scene)
    print(f"compiling the variants of a node takes {seconds_to_compile(path) * 1e3:.0f} ms")
    idle, busy = times(path, given.size)
    ratio = paired_ratio(busy, idle)
    print(
        f"{os.cpu_count()} cores: a frame takes {ratio.median:.2f}x "
        f"[{ratio.low:.2f}-{ratio.high:.2f}] as long while another process compiles"
    )


def seconds_to_compile(path: Path) -> float:
    """What it takes to write the variants of one node, by every algorithm."""
    _, analysis = open_scene(path)
    nodes = [node.id for node in analysis.nodes if node.offered][:8]
    begun = perf_counter()
    for node in nodes:
        rewrite(analysis, by_every_algorithm(Configuration((node,))))
    return (perf_counter() - begun) / len(nodes)


def compile_for_ever(path: Path) -> None:
    """What the other process does."""
    while True:
        seconds_to_compile(path)


def times(path: Path, size: int) -> tuple[list[float], list[float]]:
    """Seconds of frames with the other process stopped, and with it at work."""
    other = Process(target=compile_for_ever, args=(path,), daemon=True)
    # Before OpenGL is opened: a forked child would share the driver's state.
    other.start()
    assert other.pid is not None
    sleep(5.0)  # it has read the scene
    idle: list[float] = []
    busy: list[float] = []
    scene, analysis = open_scene(path)
    linker = Linker(scene, analysis)
    with (
        open_context() as gpu,
        RenderScene(gpu, linker.scene, (size, size)) as world,
        OriginalRunner(world, *linker.originals()) as runner,
    ):
        clock = pick_clock(gpu)
        runner.draw(0)
        for _ in range(TURNS):
            for kept, sent in ((idle, signal.SIGSTOP), (busy, signal.SIGCONT)):
                os.kill(other.pid, sent)
                sleep(0.05)
                kept += [clock.time(partial(runner.draw, frame)) for frame in range(FRAMES)]
    other.kill()
    return idle, busy


if __name__ == "__main__":
    main()
