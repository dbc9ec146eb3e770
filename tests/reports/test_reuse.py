"""``verify`` demands hits: what is broken on purpose here, it has to notice on users' shaders."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.settings import with_settings
from shadercache.cli.app import main
from shadercache.gpu.cache_textures import CachePair
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bound_pass import FrameInputs
from shadercache.render.bundle import Bundle
from shadercache.render.draw_items import DrawItem, RunInputs
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.cases.scenery import ring
from tests.configured import DEFAULT

pytestmark = pytest.mark.xdist_group("gl")

FOLDER = Path(__file__).with_name("reuse")
SHADERS = ("turning", "block", "striped", "torn", "old")
ALL = ("1-pass", "2-pass", "3-pass")

Edit = Callable[[str, str], str]
"""A file's name and text -> its text, broken."""


def scene_of(shader: str, folder: Path) -> Path:
    """The shader on a ring that turns."""
    for ending in ("frag", "vert"):
        shutil.copy(FOLDER / f"{shader}.{ending}", folder)
    np.savez(folder / "ring.npz", **ring())
    text = (FOLDER / "scene.toml").read_text(encoding="utf-8")
    for word, ending in (("FRAGMENT", "frag"), ("VERTEX", "vert")):
        text = text.replace(word, f"{shader}.{ending}")
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


class Judge:
    """Verifies the node of a shader that is marked there."""

    def __init__(self, gpu: Gpu, scene: Path, cache: str = "") -> None:
        made, analysis = open_scene(scene)
        options = with_settings(DEFAULT, [cache] if cache else [])
        self.verifier = Verifier(gpu, (made, analysis), (48, 48), configuration=options)
        marked = next(line for line in analysis.fragment.text.splitlines() if "// the node" in line)
        wanted = re.split(r" \+?= ", marked)[1].partition(";")[0]
        self.node = next(node for node in analysis.nodes if node.legal and node.text == wanted)

    def verdict(self, edit: Edit | None = None) -> Verdict:
        """What ``verify`` says of the node, with all emitted files edited."""
        with pytest.MonkeyPatch.context() as patch:
            if edit is not None:
                patch_files(patch, edit)
            return self.verifier.check(self.node, plain=False)

    def close(self) -> None:
        self.verifier.close()


def patch_files(patch: pytest.MonkeyPatch, edit: Edit) -> None:
    """Break what the compiler emits of variants. One file at least must become another."""
    rewritten = Verifier.rewritten

    def broken(verifier: Verifier, nodes: object, mode: object) -> Bundle:
        bundle = rewritten(verifier, nodes, mode)  # type: ignore[arg-type]
        files = {name: edit(name, text) for name, text in bundle.files.items()}
        assert files != bundle.files
        return Bundle(bundle.manifest, files)

    patch.setattr(Verifier, "rewritten", broken)


@pytest.fixture(scope="module", params=SHADERS)
def judge(
    gpu: Gpu, request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Judge]:
    scene = scene_of(request.param, tmp_path_factory.mktemp(request.param))
    with closing(Judge(gpu, scene)) as made:
        yield made


def twins_swapped(name: str, text: str) -> str:
    """The previous position is made of the uniforms of now."""
    lines = [
        line
        if line.startswith(("uniform", "layout", "}"))
        else re.sub(r"\bsc_previous_(u_\w+|camera)", r"\1", line)
        for line in text.splitlines(keepends=True)
    ]
    return "".join(lines) if name.endswith(".vert") else text


def twins_undefined(name: str, text: str) -> str:
    return text.replace("    sc_vertex_previous();\n", "")


def hits_disabled(name: str, text: str) -> str:
    return text.replace("    return sc_hit;\n", "    return 4;\n")


def hits_of_variants_disabled(name: str, text: str) -> str:
    """The program that shows hits still says that there are some."""
    return text if name.startswith("hit-mask") else hits_disabled(name, text)


def hits_of_one_disabled(name: str, text: str) -> str:
    return hits_disabled(name, text) if name.startswith("3-pass") else text


def store_dropped(name: str, text: str) -> str:
    return text.replace("    sc_store = sc_pack();\n", "")


def hits_not_stored(name: str, text: str) -> str:
    return store_dropped(name, text) if "hit" in name or "reuse" in name else text


def test_nothing_is_wrong(judge: Judge) -> None:
    verdict = judge.verdict()
    assert not verdict.reasons
    assert verdict.algorithms == set(ALL)


@pytest.mark.parametrize("edit", [twins_swapped, twins_undefined])
def test_wrong_previous_positions_are_noticed(judge: Judge, edit: Edit) -> None:
    verdict = judge.verdict(edit)
    assert {f"law 4 ({name})" for name in ALL} <= set(verdict.broken)
    assert all("last frame" in verdict.faults[f"law 4 ({name})"] for name in ALL)


@pytest.mark.parametrize(
    "edit",
    [hits_disabled, hits_of_variants_disabled, store_dropped, hits_not_stored],
)
def test_missing_hits_are_noticed(judge: Judge, edit: Edit) -> None:
    verdict = judge.verdict(edit)
    wanted = ("2-pass", "3-pass") if edit is hits_not_stored else ALL
    assert {f"law 3 ({name})" for name in wanted} <= set(verdict.broken), verdict.reasons


def test_one_algorithm_without_hits_is_noticed(judge: Judge) -> None:
    verdict = judge.verdict(hits_of_one_disabled)
    assert "law 3 (3-pass)" in verdict.broken
    assert all("3-pass" in law for law in verdict.broken)


def test_uploads_of_the_current_values_are_noticed(
    judge: Judge, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = RunInputs.of

    def wrong(inputs: RunInputs, role: DrawItem, frame: int) -> FrameInputs:
        given = right(inputs, role, frame)
        return replace(given, before=given.now)

    monkeypatch.setattr(RunInputs, "of", wrong)
    assert {f"law 4 ({name})" for name in ALL} <= set(judge.verdict().broken)


def test_caches_that_are_not_swapped_are_noticed(
    judge: Judge, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(CachePair, "swap", lambda pair: None)
    assert {f"law 3 ({name})" for name in ALL} <= set(judge.verdict().broken)


def test_what_was_expected_and_found_is_told(gpu: Gpu, tmp_path: Path) -> None:
    with closing(Judge(gpu, scene_of("turning", tmp_path))) as judge:
        reasons = judge.verdict(hits_disabled).reasons
    assert reasons
    law_3 = next(reason for reason in reasons if reason.startswith("law 3 (2-pass)"))
    found = re.fullmatch(
        r"law 3 \(2-pass\): 0 of ([\d,]+) pixels in 4 frames hit, ([\d,]+) expected "
        r"\(missed: ([\d,]+) by 'depth', ([\d,]+) by 'refresh'\)",
        law_3,
    )
    assert found is not None, law_3
    pixels, expected, missed, due = (int(word.replace(",", "")) for word in found.groups())
    assert pixels == missed + due
    assert expected == 3 * due == 3 * pixels // 4
    assert any(
        reason.startswith("law 4 (2-pass)")
        and re.search(r"\b0 of [\d,]+ pixels that the frame before showed hit, at least", reason)
        for reason in reasons
    )


@pytest.mark.parametrize(
    "cache",
    [
        "filter=nearest",
        "filter=lanczos2,refresh=random",
        "refresh=tiled,guard=off",
        "refresh=none,tolerance=akeley-su",
        "refresh=surface,depth=ndc,filter=bilinear",
        "age=on,ids=on",
    ],
)
def test_options_of_the_cache(gpu: Gpu, tmp_path: Path, cache: str) -> None:
    with closing(Judge(gpu, scene_of("turning", tmp_path), cache)) as judge:
        assert not judge.verdict().reasons
        assert {f"law 3 ({name})" for name in ALL} <= set(
            judge.verdict(hits_of_variants_disabled).broken
        )


@pytest.mark.parametrize(("edit", "status"), [(None, 0), (hits_disabled, 1), (twins_swapped, 1)])
def test_the_command_says_so(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    edit: Edit | None,
    status: int,
) -> None:
    scene = scene_of("turning", tmp_path)
    nodes = [node.id for node in open_scene(scene)[1].nodes if node.text.startswith("sin(9.0")]
    if edit is not None:
        patch_files(monkeypatch, edit)
    assert main(["verify", str(scene), "-j", "1", "--node", nodes[0], "--proof-only"]) == status
    told = capsys.readouterr().out
    assert ("expected" in told) == (edit is hits_disabled)
    assert ("vertices to have been elsewhere" in told) == (edit is twins_swapped)
