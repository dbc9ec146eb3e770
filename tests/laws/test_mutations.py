"""A law's test must be able to fail: programs broken on purpose, and which law notices.

What moves a discard ahead of the derivatives is not among them: llvmpipe computes derivatives
behind a discard all the same. The order is checked in the emitted text, by the tests of emit/.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass

import pytest
from laws.ground_truth import (
    VERTEX,
    TrueFrame,
    body_mesh,
    body_scene,
    bundle_of,
    true_frames,
)
from laws.look_ups import LawFive
from manifests import plain
from msgspec import convert

from shadercache.caching.outcomes import SPREAD
from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.manifest.model import Manifest
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.source import Source
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, configured, rewritten

pytestmark = pytest.mark.xdist_group("law5")

ALL = ("1-pass", "2-pass", "3-pass")

FRAGMENT = """#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec3 bands = sin(9.0 * v_position) * cos(5.0 * v_position.yzx);
    o_color = vec4(0.5 + 0.5 * bands * normalize(v_normal).z, 1.0);
}
"""


@dataclass(frozen=True)
class Replace:
    """Puts ``new`` for ``old`` wherever it stands in files whose name has ``where`` in it."""

    old: str
    new: str
    where: str = ""

    def bundle(self, bundle: Bundle) -> Bundle:
        """The broken bundle. The text must be there, or the test would be no test."""
        assert any(self.old in text for name, text in bundle.files.items() if self.where in name)
        files = {
            name: self(text) if self.where in name else text for name, text in bundle.files.items()
        }
        return Bundle(bundle.manifest, files)

    def __call__(self, text: str) -> str:
        return text.replace(self.old, self.new)


TWINS_SWAPPED = Replace("_vec4(sc_previous_u_modelViewProjection,", "_vec4(u_modelViewProjection,")
TWINS_SWAPPED_PLAIN = Replace(
    "sc_previous_u_modelViewProjection *", "u_modelViewProjection *", ".vert"
)
"""The same in plain mode, where products with matrices are not written out."""

HITS_DISABLED = Replace("    return sc_hit;\n", "    return 4;\n")
HITS_UNMARKED = Replace("    sc_moved = marked;\n    return sc_hit;\n", "    return 4;\n")
"""The same for the passes of the variants, where a miss must not look like a marked hit."""

REFRESH_INVERTED = Replace(
    "return phase == 0 || phase == sc_period;", "return !(phase == 0 || phase == sc_period);"
)
DEPTHS_IGNORED = Replace("bool agrees = one_surface && ", "bool agrees = true || one_surface && ")
NOTHING_STORED = Replace("vec4(sc_payload, ", "vec4(vec3(0.0), ")


@pytest.fixture(scope="module")
def verifier(gpu: Gpu) -> Iterator[Verifier]:
    """The trash can's shape under a shader that compiles fast."""
    analysis = analyse(Source("bands.frag", FRAGMENT), Source("bands.vert", VERTEX))
    scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
    with closing(Verifier(gpu, (scene, analysis), mesh=mesh)) as made:
        yield made


@pytest.fixture(scope="module")
def proof(verifier: Verifier) -> Bundle:
    nodes = [node for node in verifier.analysis.nodes if node.legal and "sin" in node.text]
    emission = rewritten(verifier.analysis, nodes[0], PROOF, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def broken(verifier: Verifier, bundle: Bundle) -> set[str]:
    verdict = Verdict(bundle.node("id"), bundle.node("path"), bundle.node("text"), True)
    judge(verifier.references, bundle, verdict)
    return set(verdict.broken)


def every(law: int) -> set[str]:
    return {f"law {law} ({algorithm})" for algorithm in ALL}


def test_laws_2_to_4_hold_unchanged(verifier: Verifier, proof: Bundle) -> None:
    assert broken(verifier, proof) == set()


NOTICED = {
    "previous twins swapped": (TWINS_SWAPPED, every(4)),
    "hits disabled": (HITS_DISABLED, every(3) | every(4)),
    "hits disabled in the variants": (HITS_UNMARKED, every(3)),
    "refresh test inverted": (REFRESH_INVERTED, every(2)),
    "payload store dropped": (NOTHING_STORED, every(3) | {"law 2 (3-pass)"}),
    "payload store dropped in two passes only": (
        Replace(NOTHING_STORED.old, NOTHING_STORED.new, "2-pass.miss"),
        {"law 3 (2-pass)", "law 4 (2-pass)"},
    ),
    "payload not carried on by hits": (
        Replace(NOTHING_STORED.old, NOTHING_STORED.new, "2-pass.hit"),
        {"law 3 (2-pass)", "law 4 (2-pass)"},
    ),
    "channels in another order": (Replace("= sc_texel.xyz", "= sc_texel.zyx"), every(3)),
    "misses shaded from the cache": (
        Replace(
            "sc_look_up(sc_texel) != sc_hit",
            "sc_look_up(sc_texel) == 0",
            "2-pass.hit",
        ),
        {"law 2 (2-pass)", "law 4 (2-pass)"},
    ),
    "hits shaded by the original in three passes": (
        Replace(
            "sc_look_up(sc_texel) != sc_hit",
            "sc_look_up(sc_texel) != 0",
            "3-pass.reuse",
        ),
        {"law 4 (3-pass)"},
    ),
}


@pytest.mark.parametrize(("mutation", "laws"), NOTICED.values(), ids=NOTICED.keys())
def test_laws_2_to_4_notice(
    verifier: Verifier, proof: Bundle, mutation: Replace, laws: set[str]
) -> None:
    found = broken(verifier, mutation.bundle(proof))
    assert laws <= found, f"noticed only by {sorted(found)}"


def test_laws_2_to_4_notice_a_wrong_manifest(verifier: Verifier, proof: Bundle) -> None:
    def change(edit: Callable[[Mapping[str, dict[str, object]]], None]) -> set[str]:
        manifest = plain(proof.manifest)
        passes = {
            f"{variant['algorithm']} {item['name']}": item
            for variant in manifest["variants"]
            for item in variant["passes"]
        }
        edit(passes)
        return broken(verifier, Bundle(convert(manifest, Manifest), proof.files))

    depth = {"test": "less", "write": True}
    # Where everything is refreshed the second pass, which is guarded, has drawn the colour.
    assert "law 3 (3-pass)" in change(lambda passes: passes["3-pass shade"].update(depth=depth))
    found = change(lambda passes: passes["2-pass miss"].update(on_reset=False))
    assert {"law 2 (2-pass)", "law 3 (2-pass)"} <= found


def test_a_variant_that_does_not_compile_is_reported(
    verifier: Verifier, proof: Bundle, monkeypatch: pytest.MonkeyPatch
) -> None:
    worse = Replace("sc_payload;", "sc_payload", "3-pass.payload").bundle(proof)
    monkeypatch.setattr(verifier, "rewritten", lambda node, mode: worse)
    verdict = verifier.check(verifier.analysis.node(proof.node("id")))
    assert verdict.broken == ["cannot be drawn"]
    assert "3-pass.payload.frag" in verdict.failure
    assert verdict.algorithms == {"1-pass", "2-pass"}, "what came before stands"


MOTION = "sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;"
BACKWARDS = "sc_current.xy / sc_current.w - sc_previous.xy / sc_previous.w;"

LAW_5 = {
    "previous twins swapped": (TWINS_SWAPPED_PLAIN, ("too far away", "hit rate")),
    "hits disabled": (HITS_DISABLED, ("hit rate",)),
    "refresh test inverted": (REFRESH_INVERTED, ("out of turn", "hit rate")),
    "payload store dropped": (NOTHING_STORED, ("too far away",)),
    "clip test removed": (Replace("        return sc_miss_outside;\n", ""), ("not visible",)),
    "depth test removed": (
        DEPTHS_IGNORED,
        ("too far away", "not visible", "other side"),
    ),
    "depth of another frame stored": (Replace("16.0 / sc_current.w", "16.0"), ("hit rate",)),
    "motion doubled": (Replace(MOTION, f"2.0 * ({MOTION[:-1]});"), ("hit rate",)),
    "motion reversed": (Replace(MOTION, BACKWARDS), ("hit rate",)),
    "half a pixel off": (
        Replace(MOTION, f"{MOTION[:-1]} + 1.0 / vec2(textureSize(sc_cache, 0));"),
        ("too far away",),
    ),
    "one residue refreshed twice": (
        Replace("* uint(sc_period) >>", "* uint(sc_period + 1) >>"),
        ("out of turn",),
    ),
    "larger blocks": (Replace("float(sc_block)", "float(2 * sc_block)"), ("out of turn",)),
}


@pytest.fixture(scope="module")
def turning(gpu: Gpu) -> Iterator[tuple[RenderScene, list[TrueFrame]]]:
    """The dragon turns fast, hides parts of itself, and reaches beyond the frame."""
    scene = body_scene("dragon", 8.0, zoom=2.0)
    with RenderScene(gpu, scene, (192, 192), "rgba32f", body_mesh("dragon")) as world:
        yield world, true_frames(world, range(6))


def test_law_5_holds_unchanged(turning: tuple[RenderScene, list[TrueFrame]]) -> None:
    for carried in (False, True):
        found = LawFive(*turning, carried=carried).findings()
        assert not found.broken, str(found)


@pytest.mark.parametrize(("mutation", "noticed"), LAW_5.values(), ids=LAW_5.keys())
def test_law_5_notices(
    turning: tuple[RenderScene, list[TrueFrame]], mutation: Replace, noticed: tuple[str, ...]
) -> None:
    mutation.bundle(bundle_of("v_position", "rgba32f"))
    found = LawFive(*turning, carried=True, mutation=mutation).findings()
    for words in noticed:
        assert any(words in sentence for sentence in found.broken), str(found)


@pytest.fixture(scope="module")
def passing(gpu: Gpu) -> Iterator[tuple[RenderScene, list[TrueFrame]]]:
    """A sphere passes in front of the dragon."""
    scene, mesh = body_scene("dragon", 5.0, zoom=2.0), body_mesh("dragon", sphere=True)
    with RenderScene(gpu, scene, (192, 192), "rgba32f", mesh) as world:
        yield world, true_frames(world, range(4))


OTHER_BODY = {
    "depth test removed": DEPTHS_IGNORED,
    "depths of single texels not tested": Replace(f"{SPREAD} * sc_epsilon", "1e9"),
}


def test_law_5_holds_with_two_bodies(passing: tuple[RenderScene, list[TrueFrame]]) -> None:
    found = LawFive(*passing).findings()
    assert not found.broken, str(found)


@pytest.mark.parametrize("mutation", OTHER_BODY.values(), ids=OTHER_BODY.keys())
def test_law_5_notices_another_body(
    passing: tuple[RenderScene, list[TrueFrame]], mutation: Replace
) -> None:
    mutation.bundle(bundle_of("v_body", "rgba32f"))
    found = LawFive(*passing, mutation=mutation).findings()
    assert any("another body" in sentence for sentence in found.broken), str(found)


UNGUARDED = Replace("        return sc_miss_old;\n", "")


def test_law_7_notices(verifier: Verifier) -> None:
    nodes = [node for node in verifier.analysis.nodes if node.legal and "sin" in node.text]
    options = configured(PROOF, age=True)
    emission = rewritten(verifier.analysis, nodes[0], options, unprofitable=True)
    guarded = Bundle(emission.manifest, emission.files)
    assert broken(verifier, guarded) == set()
    assert every(7) <= broken(verifier, UNGUARDED.bundle(guarded))
