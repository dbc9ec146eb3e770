"""The laws of DESIGN section 4, checked by rendering, node by node.

Everything is drawn small (the laws are about bits, not about looks) in RGBA32F, with a low
resolution stand-in for the mesh where the scene has one. Laws 2 to 4 are decided in proof mode;
what plain mode changes is reported. Pixels where two fragments tie for the front are masked and
counted (law 4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from shadercache.analysis.candidates import Candidate
from shadercache.caching.configuration import Configuration, Mode, by_every_algorithm
from shadercache.caching.layout import Layout
from shadercache.compiler import Analysis, emit_original, rewrite
from shadercache.diagnostics import InputError, input_error
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.user_places import at_home
from shadercache.render.bundle import Bundle
from shadercache.render.drawable import Drawable
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import (
    CoverageRunner,
    OriginalRunner,
    VariantRunner,
    render_original,
)
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh
from shadercache.verify.detail_levels import tells_true_levels
from shadercache.verify.not_finite import told_of
from shadercache.verify.reuse_checks import Look, Reuse
from shadercache.verify.surfaces import Surfaces

Image = NDArray[np.float32]

SIZE = (96, 96)
PERIOD = 4
"""Refresh period of the runs that reuse: short, so that few frames show every phase."""

MOVING = range(4)
RESTING = range(5)
AGEING = range(3 * PERIOD)
ALWAYS = range(3)

DEPTH = 3
"""The channel of a cache that holds 1/w."""

MAX_TIES = 1e-4
"""Share of pixels with depth ties above which a scene is reported (law 4)."""


@dataclass(frozen=True, slots=True)
class Difference:
    """How far an image is from the reference, in display units: largest, 99.9th percentile, and
    share of changed pixels, over covered pixels."""

    maximum: float = 0.0
    p999: float = 0.0
    changed: float = 0.0

    @property
    def exact(self) -> bool:
        """The same bits everywhere (an image that is not finite never is)."""
        return self.changed == 0.0

    def __str__(self) -> str:
        if not np.isfinite(self.maximum):
            return f"{self.changed:.2%} of the pixels differ, some of which are not finite"
        return f"{self.changed:.2%} of the pixels differ, by up to {self.maximum:.2g}"

    def worst(self, other: Difference) -> Difference:
        """The larger of each figure."""
        return Difference(
            max(self.maximum, other.maximum),
            max(self.p999, other.p999),
            max(self.changed, other.changed),
        )


@dataclass(slots=True)
class Verdict:
    """The laws for one node, or for several cached together. Keys of the dictionaries are
    algorithms (``2-pass``).

    ``node`` and what follows it is of all nodes, joined as :meth:`Bundle.node` does it. ``cause``:
    what of the payload is not finite, where a law is broken.
    ``refused`` holds the algorithms that the compiler does not offer for the node, and why;
    ``ages``: the greatest age in frames that a payload reached at a period of :data:`PERIOD`, where
    the cache keeps ages. ``failure`` says why a variant could not be drawn at all, where one could
    not. ``faults``: of laws that do not hold by what is reused, what was expected and what was
    found, in a sentence.
    """

    node: str
    path: str
    text: str
    profitable: bool
    cause: str = ""
    always: dict[str, Difference] = field(default_factory=dict)
    resting: dict[str, Difference] = field(default_factory=dict)
    agreeing: dict[str, Difference] = field(default_factory=dict)
    plain: dict[str, Difference] = field(default_factory=dict)
    ages: dict[str, float] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)
    failure: str = ""
    faults: dict[str, str] = field(default_factory=dict)

    @property
    def broken(self) -> list[str]:
        """The laws that do not hold, as ``law 2 (1-pass)``; with a failure, that none does."""
        return list(self._reasons())

    @property
    def reasons(self) -> list[str]:
        """A sentence for each broken law: what was expected, and what was found."""
        return [f"{law}: {'; '.join(words)}" for law, words in self._reasons().items()]

    def to_json(self) -> dict[str, Any]:
        """Plain data, with the list of broken laws."""
        return asdict(self) | {"broken": self.broken, "reasons": self.reasons}

    def _reasons(self) -> dict[str, list[str]]:
        """Broken law -> what is wrong."""
        laws = (("law 2", self.always), ("law 3", self.resting), ("law 4", self.agreeing))
        found: dict[str, list[str]] = {}
        if self.failure:
            found["cannot be drawn"] = [self.failure]
        for law, by_name in laws:
            for name, difference in by_name.items():
                words = [str(difference)] if not difference.exact else []
                if f"{law} ({name})" in self.faults:
                    words.append(self.faults[f"{law} ({name})"])
                if words:
                    found[f"{law} ({name})"] = words
        for name, age in self.ages.items():
            if not age <= PERIOD:
                found[f"law 7 ({name})"] = [f"a payload is {age:g} frames old, {PERIOD} expected"]
        return found


def difference(image: Image, reference: Image, covered: NDArray[np.bool_]) -> Difference:
    """Compare colours bit by bit where ``covered``; NaN equals NaN of the same bits only."""
    one, other = image[covered], reference[covered]
    changed = (one.view(np.uint32) != other.view(np.uint32)).any(axis=-1)
    if not changed.any():
        return Difference()
    share = float(changed.mean())
    if not (np.isfinite(one).all() and np.isfinite(other).all()):
        return Difference(np.inf, np.inf, share)
    apart = np.abs(one.astype(np.float64) - other).max(axis=-1)
    return Difference(float(apart.max()), float(np.percentile(apart, 99.9)), share)


class Verifier:
    """Checks nodes of one scene; the originals are rendered once for all of them."""

    def __init__(
        self,
        gpu: Gpu,
        scene: Scene,
        analysis: Analysis,
        size: tuple[int, int] = SIZE,
        mesh: Mesh | None = None,
        configuration: Configuration | None = None,
    ) -> None:
        """Render the originals. Raises as ``RenderScene`` and ``BoundPass``.

        ``configuration``: how variants look up, store and refresh; its nodes, algorithm, mode,
        format and refresh period are the verifier's own. Proof mode takes whole fetches where the
        driver tells other levels than it fetches at.
        """
        self.analysis = analysis
        chosen = configuration or Configuration()
        self.configuration = replace(chosen, storage=replace(chosen.storage, format="rgba32f"))
        self.linker = Linker(scene, analysis)
        self.world = RenderScene(gpu, self.linker.scene, size, "rgba32f", mesh, small=True)
        with at_home(analysis):
            self._moving = {mode: self._original(mode) for mode in ("plain", "proof")}
        with CoverageRunner(self.world, *self.linker.originals("proof")) as runner:
            ties = [runner.ties(frame) for frame in MOVING]
            self.covered = [
                runner.coverage(frame) & ~tie for frame, tie in zip(MOVING, ties, strict=True)
            ]
        self.ties = float(np.mean(ties))
        self._surfaces: Surfaces | None = None
        self._proven: set[tuple[Drawable, str]] = set()

    def round_trip(self) -> Difference | None:
        """Law 1: the printed shader renders the bits of the user's own text.

        ``None`` where there is nothing to compare with: the text does not stand alone, or it was
        raised and reads the state of the fixed-function pipeline, or the driver does not take its
        version.
        """
        analysis = self.analysis
        written = emit_original(analysis, "plain")
        text = analysis.written
        found = Difference()
        if analysis.reads_fixed_function or text is None:
            return None
        files = {"original.vert": analysis.vertex_source.text, "original.frag": text}
        try:
            bundle = Bundle(written.manifest, files)
            runner = OriginalRunner(self.world, *self.linker.originals(bundle=bundle))
        except InputError:
            return None
        with runner:
            for frame in MOVING:
                image = runner.image(frame)
                reference = self._moving["plain"][frame]
                found = found.worst(difference(image, reference, self.covered[frame]))
        return found

    def check(self, node: Candidate | Sequence[Candidate], plain: bool = True) -> Verdict:
        """Laws 2 to 4 and 7 for one node in proof mode, and what plain mode changes if ``plain``.

        Several nodes are cached together; raises InputError where they cannot be. A variant that
        the driver turns down breaks the laws; it does not end the verifying.
        """
        if not self.covered[0].any():
            raise input_error("SC612", "the object covers no pixel, so no law can be checked")
        nodes = (node,) if isinstance(node, Candidate) else tuple(node)
        self.analysis.require_all(nodes, unprofitable=True)
        verdict = Verdict(
            "+".join(item.id for item in nodes),
            " | ".join(item.path for item in nodes),
            " | ".join(item.text for item in nodes),
            all(item.offered for item in nodes),
        )
        try:
            self._check_modes(nodes, verdict, plain)
        except InputError as error:
            verdict.failure = str(error)
        return verdict

    def _check_modes(self, nodes: Sequence[Candidate], verdict: Verdict, plain: bool) -> None:
        bundle = self._rewritten(nodes, "proof")
        verdict.refused.update(bundle.refused)
        self.check_bundle(bundle, verdict)
        if verdict.broken:
            verdict.cause = self._cause(nodes, bundle)
        if plain:
            shipped = self._rewritten(nodes, "plain")
            for name in shipped.algorithms:
                verdict.plain[name] = self._changed(shipped, name)

    def _cause(self, nodes: Sequence[Candidate], bundle: Bundle) -> str:
        """What of the payload is not finite in the first frame, in words."""
        layout = Layout(tuple(item.type for item in nodes))
        with self._run(bundle, bundle.algorithms[0], period=1) as runner:
            runner.draw(0)
            guard = self.configuration.storage.guard
            return told_of(runner.cache(), self.covered[0], layout, guard)

    def check_bundle(self, bundle: Bundle, verdict: Verdict) -> None:
        """Laws 2 to 4 for a proof-mode bundle, and 7 where it keeps ages, into ``verdict``."""
        first: list[tuple[Image, Image]] = []
        reuse = self._reuse(bundle)
        for name in bundle.algorithms:
            verdict.always[name] = self._always(bundle, name)
            verdict.resting[name], fault = self._resting(bundle, name, reuse)
            run, moving_fault = self._reusing(bundle, name, reuse)
            for law, words in (("law 3", fault), ("law 4", moving_fault)):
                if words:
                    verdict.faults[f"{law} ({name})"] = words
            first = first or run
            verdict.agreeing[name] = self._agreement(run, first)
            if bundle.age_channel is not None:
                verdict.ages[name] = self._oldest(bundle, name, bundle.age_channel)

    def close(self) -> None:
        """Free everything on the GPU."""
        self.world.release()

    def _original(self, mode: Mode) -> list[Image]:
        return render_original(self.world, self.linker.originals(mode), MOVING)

    def _run(
        self, bundle: Bundle, algorithm: str, period: int = PERIOD, moving: bool = True
    ) -> VariantRunner:
        """A run of a bundle's variant, with the other objects' own."""
        chosen = replace(bundle.configuration, algorithm=algorithm).with_refresh(period)
        objects = self.linker.link(self.linker.assign(chosen), bundle)
        return VariantRunner(self.world, *objects, moving=moving)

    def _rewritten(self, nodes: Sequence[Candidate], mode: Mode) -> Bundle:
        exact = self.configuration.fetches == "level" and tells_true_levels(self.world.gpu)
        chosen = replace(
            self.configuration,
            nodes=tuple(node.id for node in nodes),
            mode=mode,
            fetches=self.configuration.fetches if mode == "plain" or exact else "whole",
        )
        emission = rewrite(self.analysis, by_every_algorithm(chosen), unprofitable=True)
        return Bundle(emission.manifest, emission.files)

    def _always(self, bundle: Bundle, name: str) -> Difference:
        """Law 2: with everything refreshed in every frame a variant is the original."""
        found = Difference()
        with self._run(bundle, name, period=1) as runner:
            for frame in ALWAYS:
                if not bundle.refreshes:
                    runner.reset("cut")
                image = runner.image(frame)
                reference = self._moving["proof"][frame]
                found = found.worst(difference(image, reference, self.covered[frame]))
        return found

    def _changed(self, bundle: Bundle, name: str) -> Difference:
        """What plain mode changes: a reset in every frame draws the passes that compute, and not
        those that would find nothing to reuse (compiling these takes a third of the time)."""
        found = Difference()
        with self._run(bundle, name, period=1) as runner:
            for frame in ALWAYS:
                runner.reset("cut")
                image = runner.image(frame)
                reference = self._moving["plain"][frame]
                found = found.worst(difference(image, reference, self.covered[frame]))
        return found

    def _resting(self, bundle: Bundle, name: str, reuse: Reuse) -> tuple[Difference, str]:
        """Law 3: while nothing moves a variant is the original, however often it reuses; and it
        reuses all that is not due. What it reuses that it should not, or does not, in words."""
        found = Difference()
        with self._run(bundle, name, moving=False) as runner:
            masks = []
            for frame in RESTING:
                if frame > 0:
                    masks.append(runner.hit_mask(frame))
                image = runner.image(frame)
                found = found.worst(difference(image, self._moving["proof"][0], self.covered[0]))
            return found, reuse.rest_fault(runner, masks, RESTING.stop)

    def _reusing(
        self, bundle: Bundle, name: str, reuse: Reuse
    ) -> tuple[list[tuple[Image, Image]], str]:
        """Colour and cache of each frame of a short run in motion, and what is wrong with what it
        reuses there, in words."""
        made: list[tuple[Image, Image]] = []
        looks: list[Look] = []
        fault = ""
        with self._run(bundle, name) as runner:
            for frame in MOVING:
                look = reuse.look(runner, frame) if frame > 0 else None
                if look is not None:
                    looks.append(look)
                    fault = fault or reuse.previous_fault(runner, frame)
                made.append((runner.image(frame), runner.cache()))
            return made, fault or reuse.motion_fault(runner, looks)

    def _reuse(self, bundle: Bundle) -> Reuse:
        if self._surfaces is None:
            self._surfaces = Surfaces(self.world, self.linker.originals("proof"))
        about = (self.world, self.analysis, bundle, self._surfaces, self.covered, PERIOD)
        return Reuse(*about, self._proven)

    def _oldest(self, bundle: Bundle, name: str, channel: int) -> float:
        """Law 7: the greatest age that is stored in a run in motion."""
        with self._run(bundle, name) as runner:
            ages = []
            for frame in AGEING:
                runner.draw(frame)
                cache = runner.cache()
                ages.append(np.max(cache[..., channel][cache[..., DEPTH] > 0.0], initial=0.0))
        return float(max(ages))

    def _agreement(
        self, run: list[tuple[Image, Image]], first: list[tuple[Image, Image]]
    ) -> Difference:
        """Law 4: the algorithms agree on colour and cache. Equal caches before a frame follow
        from equal caches after the one before."""
        found = Difference()
        for covered, (color, cache), (color_1, cache_1) in zip(
            self.covered, run, first, strict=True
        ):
            found = found.worst(difference(color, color_1, covered))
            found = found.worst(difference(cache, cache_1, covered))
        return found
