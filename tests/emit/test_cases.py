"""Programs of nodes: a shader of ``cases/``, and the parts that matter of what is emitted for it.

What a case (:mod:`tests.pairs`) says of itself: ``node`` is the text of the node, ``path`` the end
of its call path; ``shows`` names a file and the declarations of it to look at, or none for the
whole file; ``by`` are algorithms. The other words are those of :func:`tests.configured.configured`.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import Golden
from emit.test_programs import check_programs
from pairs import Case, anew
from shaders import VERTEX, find

from shadercache.caching.algorithms import USUAL
from shadercache.compiler import Analysis, analyse, emit_original
from shadercache.emit.printer import print_node
from shadercache.front.parse import parse
from shadercache.front.read_options import ReadOptions
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.transform.reachable import declared_names
from shadercache.valid.validate import validate
from tests.configured import configured, rewritten

CASES = Path(__file__).with_name("cases")


def emitted(case: Case) -> str:
    about = {key: value for key, value in case.about if key != "shows"}
    options = ReadOptions(unroll=bool(about.pop("unroll", "")))
    vertex = case.vertex or VERTEX
    analysis = analyse(Source("test.frag", case.shader), Source("test.vert", vertex), options)
    files = _files(analysis, about, vertex is VERTEX)
    shown = (value.split() for key, value in case.about if key == "shows")
    return "\n".join(_part(files[file], names) for file, *names in shown)


def _files(analysis: Analysis, about: dict[str, str], plain: bool) -> dict[str, str]:
    text, path = about.pop("node", ""), about.pop("path", None)
    algorithms = about.pop("by", " ".join(USUAL)).split()
    if not text:
        return emit_original(analysis, about["mode"]).files  # type: ignore[arg-type]
    node, options = find(analysis, text, path), configured(**about)
    emission = rewritten(analysis, node, options, algorithms, unprofitable=True)
    if plain:  # of interface blocks not every member is used
        check_programs(emission)
    for name, text in emission.files.items():
        stage: Stage = "vertex" if name.endswith(".vert") else "fragment"
        validate(parse(Source(name, text)), Source(name, text), stage)
    return emission.files


def _part(text: str, names: list[str]) -> str:
    if not names:
        return text
    decls = parse(Source("", text)).decls
    shown = (decl for decl in decls if not set(names).isdisjoint(declared_names(decl)))
    return "".join(f"{print_node(decl)}\n" for decl in shown)


@pytest.mark.parametrize("path", sorted(CASES.iterdir()), ids=lambda path: path.stem)
def test_cases(path: Path, golden: Golden) -> None:
    golden(path, anew(path.read_text(encoding="utf-8"), emitted))
