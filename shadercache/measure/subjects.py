"""What takes turns in a measurement: variants, originals, and whatever else can be drawn."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Protocol

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.linking.linker import Linker
from shadercache.render.bundle import Bundle, LinkedObject
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner


class Subject(Protocol):
    """Something that is drawn in turns with others. ``label`` names it in tables."""

    label: str

    def prepare(self, world: RenderScene) -> None:
        """Compile what it draws with, and take what it needs of the GPU."""

    def draw(self, frame: int) -> None:
        """Draw a frame into the world's colour target.

        Frames come in order, from 0. A 0 begins anew: what came before is to be forgotten.
        """

    def release(self) -> None:
        """Give everything back."""


class OriginalSubject:
    """The unchanged shaders."""

    def __init__(self, label: str, *bundles: Bundle) -> None:
        """Args: ``bundles`` are one for all objects, or as many."""
        self.label, self._bundles = label, bundles
        self._runner: OriginalRunner | None = None

    def prepare(self, world: RenderScene) -> None:
        """Raises as ``OriginalRunner``."""
        self._runner = OriginalRunner(world, *self._bundles)

    def draw(self, frame: int) -> None:
        """Draw a frame."""
        assert self._runner is not None
        self._runner.draw(frame)

    def release(self) -> None:
        """Give the programs back."""
        if self._runner is not None:
            self._runner.release()


@dataclass(frozen=True, slots=True)
class PayloadFacts:
    """What is known of a payload before it is measured.

    ``equal``: for how many nodes of the same value it stands, itself included. ``static_ratio``:
    P/T by static costs.
    """

    equal: int = 1
    static_ratio: float | None = None


UNKNOWN = PayloadFacts()


class VariantSubject:
    """Objects drawn by their assignment. Subjects of one label are of one payload."""

    def __init__(
        self,
        label: str,
        configuration: Configuration,
        objects: Sequence[LinkedObject],
        assignment: Assignment | None = None,
        facts: PayloadFacts = UNKNOWN,
    ) -> None:
        """Args:
        configuration: that of the scene's own shader.
        objects: as ``Linker.link`` gives them; one stands for all.
        """
        self.label, self.configuration, self.objects = label, configuration, tuple(objects)
        self.assignment, self.facts = assignment, facts
        self._runner: VariantRunner | None = None

    @property
    def bundle(self) -> Bundle:
        """The programs of the scene's own shader."""
        nodes = self.configuration.nodes
        # Objects with shaders of their own cache nodes of those.
        of_scene = (
            linked.bundle
            for linked in self.objects
            if linked.configuration is not None and linked.configuration.nodes == nodes
        )
        return next(of_scene, self.objects[0].bundle)

    @property
    def runner(self) -> VariantRunner:
        """What draws it, once it is prepared."""
        assert self._runner is not None
        return self._runner

    def prepare(self, world: RenderScene) -> None:
        """Raises as ``VariantRunner``."""
        # As an engine would draw the frame after a reset: by the shortest way.
        self._runner = VariantRunner(world, *self.objects, short_reset=True)

    def draw(self, frame: int) -> None:
        """Draw a frame."""
        self.runner.draw(frame)

    def release(self) -> None:
        """Give programs and caches back."""
        if self._runner is not None:
            self._runner.release()

    def with_originals(self, world: RenderScene, names: Collection[str]) -> VariantSubject:
        """The same, but some objects are drawn by their originals."""
        if not names:
            return self
        many = self.objects * len(world.drawables) if len(self.objects) == 1 else self.objects
        objects = [
            LinkedObject(linked.bundle) if drawable.scene_object.name in names else linked
            for drawable, linked in zip(world.drawables, many, strict=True)
        ]
        assignment = self.assignment and self.assignment.with_originals(names)
        return VariantSubject(self.label, self.configuration, objects, assignment, self.facts)

    def at_rest(self, period: int) -> tuple[LinkedObject, ...] | None:
        """Its objects by the algorithm that has a pass for hits alone, refreshed that rarely.

        None where no algorithm has such a pass.
        """
        hit_pass = self.bundle.hit_pass
        if hit_pass is None:
            return None
        return tuple(
            LinkedObject(linked.bundle, linked.configuration.with_refresh(period)).by(hit_pass[0])
            if linked.configuration is not None
            else linked
            for linked in self.objects
        )


def subjects_of(
    linker: Linker, label: str, configurations: Sequence[Configuration], equal: int = 1
) -> list[VariantSubject]:
    """A subject for each configuration of one payload whose algorithm fits it.

    Raises as :meth:`Linker.link` and :meth:`Linker.require_cached`.
    """
    linker.require_cached()
    nodes = linker.analysis.nodes_of("+".join(configurations[0].nodes))
    facts = PayloadFacts(equal, linker.analysis.static_ratio(nodes))
    subjects = []
    for configuration in configurations:
        # What fits depends on the payload rate, and on the algorithm where it is not usual.
        if configuration.algorithm in linker.fitting(configuration):
            assignment = linker.assign(configuration)
            objects = linker.link(assignment)
            subjects.append(VariantSubject(label, configuration, objects, assignment, facts))
    return subjects
