"""Law 1 where raising changes what a ``discard`` does to loops: still to the bit, and not blind."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from dataclasses import replace

import pytest

from shadercache import compiler
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import replace_expressions
from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.sema.infer import infer
from shadercache.source import Source
from shadercache.transform.versions.raise_version import Raised, StageTree
from shadercache.verify import round_trip
from shadercache.verify.verifier import Verifier
from tests.generated.dialects import DIALECTS
from tests.generated.suite import REGRESSIONS
from tests.generated.world import SIZE, ring, scene

pytestmark = pytest.mark.xdist_group("gl")

OLDER = ("es100", "gl120")


def opened(name: str, gpu: Gpu) -> Verifier:
    text = (REGRESSIONS / f"{name}-discard-before-loop.frag").read_text(encoding="utf-8")
    vertex = Source("made.vert", DIALECTS[name].vertex)
    return Verifier(gpu, (scene(), analyse(Source("made.frag", text), vertex)), SIZE, ring())


def halved(module: n.Module) -> n.Module:
    """The same shader with a constant of its loop changed."""

    def half(_: n.Expr, node: n.Expr) -> n.Expr:
        changes = isinstance(node, n.Literal) and node.text == "3.0"
        return replace(node, text="1.5") if changes else node

    return replace_expressions(module, half)


@pytest.mark.parametrize("name", OLDER)
def test_it_holds(name: str, gpu: Gpu) -> None:
    with closing(opened(name, gpu)) as verifier:
        found = verifier.round_trip()
        assert found is not None
        assert found.exact, found


@pytest.mark.parametrize("name", OLDER)
def test_what_is_raised_wrongly_is_noticed(
    name: str, gpu: Gpu, monkeypatch: pytest.MonkeyPatch
) -> None:
    raise_versions = compiler.raise_versions

    def wrongly(trees: Sequence[StageTree], stem: str) -> list[Raised]:
        found: list[Raised] = []
        for raised, tree in zip(raise_versions(trees, stem), trees, strict=True):
            module = halved(raised.module)
            facts = infer(module, tree.source, tree.stage)
            found.append(replace(raised, module=module, facts=facts))
        return found

    monkeypatch.setattr(compiler, "raise_versions", wrongly)
    with closing(opened(name, gpu)) as verifier:
        found = verifier.round_trip()
        assert found is not None
        assert not found.exact


@pytest.mark.parametrize("name", OLDER)
def test_what_is_printed_wrongly_is_noticed(
    name: str, gpu: Gpu, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The print in the older version alone, which a driver that unrolls no loop never looks at."""
    with closing(opened(name, gpu)) as verifier:
        references = verifier.references
        text = verifier.analysis.fragment.text
        own = round_trip._drawn(references, text)
        good = round_trip._in_two_steps(references, text, own)
        print_module = round_trip.print_module
        monkeypatch.setattr(round_trip, "print_module", lambda module: print_module(halved(module)))
        bad = round_trip._in_two_steps(references, text, own)
    assert good is not None
    assert good.exact, good
    assert bad is not None
    assert not bad.exact
