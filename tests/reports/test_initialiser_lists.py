"""Initialiser lists stand only where something is initialised: no other place may get one."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path

import pytest
from compiled import Pair, errors_of_driver, errors_of_reference, pairs_of

from shadercache.caching.configuration import Mode
from shadercache.cli.app import main
from shadercache.compiler import Analysis, analyse, emit_original
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.source import Source
from tests.configured import configured, rewritten

FOLDER = Path(__file__).parent / "initialiser_lists"
NAMES = sorted(path.stem for path in FOLDER.glob("*.frag"))
UNROLLED = ("for_heads", "arrays")
CASES = [(name, False) for name in NAMES] + [(name, True) for name in UNROLLED]
MODES: tuple[Mode, ...] = ("plain", "proof")

LIST_ELSEWHERE = re.compile(r"^\s*(?:[\w.\[\]]+ = )?\{.*;|return \{|\(\{", re.MULTILINE)
"""A list that is assigned, returned, passed, or stands alone as a statement."""


@cache
def analysed(name: str, unroll: bool) -> Analysis:
    files = [FOLDER / f"{name}.frag", FOLDER / f"{name}.vert"]
    sources = [Source(file.name, file.read_text("utf-8")) for file in files if file.exists()]
    return analyse(sources[0], sources[1] if sources[1:] else None, ReadOptions(unroll=unroll))


@cache
def programs(name: str, unroll: bool) -> list[Pair]:
    """Every program of the lists, and of what stands in them or in ``main``'s other values."""
    analysis = analysed(name, unroll)
    emissions = [emit_original(analysis, mode) for mode in MODES]
    for node in analysis.nodes:
        if node.offered and node.instance is not None and node.instance.parent is None:
            emissions += [rewritten(analysis, node, configured(mode=mode)) for mode in MODES]
    return list(dict.fromkeys(pair for emission in emissions for pair in pairs_of(emission)))


@pytest.mark.parametrize(("name", "unroll"), CASES)
def test_no_list_is_offered_as_one(name: str, unroll: bool) -> None:
    nodes = analysed(name, unroll).nodes
    assert not [node.text for node in nodes if node.legal and node.text.startswith("{")]
    assert len({node.id for node in nodes}) == len(nodes)


@pytest.mark.parametrize(("name", "unroll"), CASES)
def test_no_list_stands_elsewhere(name: str, unroll: bool) -> None:
    for pair in programs(name, unroll):
        for text in pair:
            assert not LIST_ELSEWHERE.search(text), text


@pytest.mark.parametrize(("name", "unroll"), CASES)
def test_glslang_takes_every_program(name: str, unroll: bool, tmp_path: Path) -> None:
    assert not errors_of_reference(programs(name, unroll), tmp_path)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize(("name", "unroll"), CASES)
def test_the_driver_takes_every_program(name: str, unroll: bool, gpu: Gpu) -> None:
    assert not errors_of_driver(gpu, programs(name, unroll))


TEXTS = {
    "o02_initialiser_list_is_a_node": (
        *("vec3( rough(uv), uv.x, 1.0 )", "rough(uv)"),
        *("vec2( 1.0, rough(uv.yx) )", "rough(uv.yx)"),
    ),
    "vectors_and_matrices": (
        "vec3( sin(p.x * 3.1 + u_time), exp(sin(p.y * 2.7)), p.x)",
        "mat3x2( vec2( 1, rough(uv).x ), uv, vec2( cell.x, rough(uv.yx).y ) )",
    ),
    "arrays": ("vec2( wave(uv + 1.0), 0.25 )", "wave(uv.yx)"),
    "structs": ("Ray( vec2( wave(uv), uv.x ), float[2]( 1, wave(uv.yx) ) )", "wave(uv * 5.0)"),
    "packed_330": ("PAIR(wave(uv), wave(uv.yx))",),
}


@pytest.mark.parametrize("name", TEXTS)
def test_lists_are_offered_as_constructors(name: str) -> None:
    offered = {node.text for node in analysed(name, False).nodes if node.offered}
    assert offered >= set(TEXTS[name])


@pytest.mark.xdist_group("gl")
def test_the_laws_hold_for_lists(capsys: pytest.CaptureFixture[str]) -> None:
    name = "o02_initialiser_list_is_a_node"
    nodes = [node for node in analysed(name, False).nodes if node.text in TEXTS[name]]
    wanted = [word for node in nodes for word in ("--node", node.id)]
    file = str(FOLDER / f"{name}.frag")
    status = main(["verify", "--mapping", "screen", "-j", "1", "--json", *wanted, file])
    verdicts = json.loads(capsys.readouterr().out)["nodes"]
    assert status == 0
    assert len(verdicts) == len(TEXTS[name])
