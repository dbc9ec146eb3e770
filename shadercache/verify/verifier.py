"""The laws of CONTRIBUTING.md, checked by rendering, node by node.

Laws 2 to 4 are decided in proof mode; what plain mode changes is reported.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.vertex_inputs import POSITION
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.layout import Layout, precision_of
from shadercache.compiler import Analysis, rewrite
from shadercache.diagnostics import InputError, input_error
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh
from shadercache.transform.remove_dead import remove_dead
from shadercache.verify.detail_levels import tells_true_levels
from shadercache.verify.laws import judge, refreshed
from shadercache.verify.references import References
from shadercache.verify.round_trip import RoundTrip, round_trip
from shadercache.verify.verdict import Image, Verdict

SIZE = (96, 96)

_LATER = {"miss": "", "clamp": "; guard=clamp has numbers for them later", "off": ""}


class Verifier:
    """Checks nodes of one scene; the originals are rendered once for all of them.

    ``algorithms`` are those that are checked: the usual ones, if no others are set.
    """

    algorithms = USUAL

    def __init__(
        self,
        gpu: Gpu,
        opened: tuple[Scene, Analysis],
        size: tuple[int, int] = SIZE,
        mesh: Mesh | None = None,
        configuration: Configuration | None = None,
    ) -> None:
        """Render the originals. Raises as :class:`References`.

        Args:
            opened: as :func:`open_scene` gives it.
            size: width and height in pixels.
            mesh: drawn in place of the scene's.
            configuration: how variants look up, store and refresh; its nodes, algorithm, mode,
                format and refresh period are the verifier's own.
        """
        chosen = configuration or Configuration()
        self.configuration = replace(chosen, storage=replace(chosen.storage, format="rgba32f"))
        self.references = References(gpu, opened, size, mesh)
        self.analysis = self.references.analysis

    def round_trip(self) -> RoundTrip | None:
        """Law 1: the printed shader renders the bits of the user's own text."""
        return round_trip(self.references)

    def check(self, node: Candidate | Sequence[Candidate], plain: bool = True) -> Verdict:
        """Laws 2 to 4 and 7 for one node in proof mode, and what plain mode changes if ``plain``.

        Several nodes are cached together; raises InputError where they cannot be. A variant that
        the driver turns down breaks the laws; it does not end the verifying.
        """
        self.references.linker.require_cached()
        if not self.references.covered[0].any():
            message = "the object covers no pixel, so no law can be checked"
            raise input_error("SC612", message, _at_far_plane(self.analysis))
        nodes = (node,) if isinstance(node, Candidate) else tuple(node)
        self.analysis.require_all(nodes, unprofitable=True)
        verdict = Verdict(
            "+".join(node.id for node in nodes),
            " | ".join(node.path for node in nodes),
            " | ".join(node.text for node in nodes),
            all(node.offered for node in nodes),
            moving={} if any(node.approximate for node in nodes) else None,
        )
        try:
            bundle = self.rewritten(nodes, "proof")
            verdict.refused.update(bundle.refused)
            cache = judge(self.references, bundle, verdict)
            if cache is not None:
                verdict.cause = self._cause(nodes, cache)
            if plain:
                shipped = self.rewritten(nodes, "plain")
                for name in shipped.algorithms:
                    verdict.plain[name] = refreshed(self.references, shipped, name, "plain")
        except InputError as error:
            if [told.code for told in error.diagnostics] == ["SC407"]:
                verdict.refused.update(dict.fromkeys(self.algorithms, str(error)))
            else:
                verdict.failure = str(error)
        return verdict

    def rewritten(self, nodes: Sequence[Candidate], mode: Mode) -> Bundle:
        """The variants of the nodes."""
        chosen = replace(self.configuration, nodes=tuple(node.id for node in nodes), mode=mode)
        # Proof mode wants bits, so of a driver that tells other levels of detail than it fetches at
        # it takes whole fetches.
        by_level = mode == "proof" and chosen.fetches == "level"
        if by_level and not tells_true_levels(self.references.world.gpu):
            chosen = replace(chosen, fetches="whole")
        wanted = [replace(chosen, algorithm=name) for name in self.algorithms]
        emission = rewrite(self.analysis, wanted, unprofitable=True)
        return Bundle(emission.manifest, emission.files)

    def _cause(self, nodes: Sequence[Candidate], cache: Image) -> str:
        """What of the first frame's payloads is not finite or too small, in words, and the pixel
        where that is first the case; else nothing."""
        layout = Layout(tuple(node.type for node in nodes))
        channels = [channel for channel, discrete in layout.read_back if not discrete]
        covered = self.references.covered[0]
        payloads = cache[covered][:, channels]
        size = np.abs(payloads)
        least = np.float32(precision_of("rgba32f").least)
        kinds = {
            "NaN": np.isnan(payloads),
            "infinite": np.isinf(payloads),
            # Compared as bits: a processor that flushes such numbers finds them equal to zero.
            "below the smallest normal number": (size.view(np.uint32) > 0)
            & (size.view(np.uint32) < least.view(np.uint32)),
        }
        counts = {word: int(marks.any(axis=1).sum()) for word, marks in kinds.items()}
        words = [f"{word} in {count:,}" for word, count in counts.items() if count]
        if not words:
            return ""
        odd = np.any([marks.any(axis=1) for marks in kinds.values()], axis=0)
        # Rows count from the lower left, as gl_FragCoord does.
        y, x = np.argwhere(covered)[int(np.argmax(odd))]
        later = _LATER[self.configuration.storage.guard]
        told = f"the payload is {', '.join(words)} of {int(covered.sum()):,} pixels"
        return f"{told}, the first of them at ({x}, {y}){later}"

    def close(self) -> None:
        """Free everything on the GPU."""
        self.references.release()


def _at_far_plane(analysis: Analysis) -> str | None:
    """What to do about a sky: where depth is cleared, no pass finds its own depth open."""
    if analysis.stage is None:
        return None
    sliced = remove_dead(analysis.stage.module, (POSITION,))
    members = (node.name for node in walk(sliced) if isinstance(node, n.Member))
    if "xyww" not in members:
        return None
    put = "write gl_Position = vec4(p.xy, 0.9999 * p.w, p.w)"
    return f"at the far plane (p.xyww) the passes find depth closed; {put}, just before it"
