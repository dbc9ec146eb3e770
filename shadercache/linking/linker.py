"""Assignments of a scene compiled: finished programs for each of its objects."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from shadercache.caching.algorithms import NAMES, USUAL, LeftOut
from shadercache.caching.configuration import Assignment, Configuration, Mode, by_every_algorithm
from shadercache.compiler import Analysis, Emission, emit_original, rewrite
from shadercache.diagnostics import InputError, input_error
from shadercache.front.read_options import ReadOptions
from shadercache.linking.recorded_names import check_recorded
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle, LinkedObject
from shadercache.scene.description import Scene, SceneObject


class Linker:
    """Compiles what draws the objects of a scene; each program once.

    ``scene`` has everything under the names that the objects' shaders have for it now.
    """

    def __init__(self, scene: Scene, analysis: Analysis) -> None:
        """Args: ``scene`` and ``analysis`` as ``analyse_scene`` gives them.

        Raises as it does, for objects with shaders of their own, and as ``check_recorded``.
        """
        self.analysis = analysis
        self._own: dict[tuple[Path, Path | None], Analysis] = {}
        self._bundles: dict[tuple[object, ...], Bundle] = {}
        # `analysis_of` needs a scene before that with the aliases can be made.
        self.scene = scene
        named = tuple(
            replace(part, inputs=part.inputs.with_aliases(self.analysis_of(part).renamed))
            if part.own_shader
            else part
            for part in scene.objects
        )
        self.scene = replace(scene, objects=named)
        if scene.recording is not None:
            shaders = {part.name: self.analysis_of(part) for part in scene.parts}
            check_recorded(scene.recording, shaders)

    def require_cached(self) -> None:
        """Raise :class:`InputError` SC542 where no object that the scene's own shader draws may be
        cached: nothing would show what its nodes do."""
        if not any(part.caching.on and not part.own_shader for part in self.scene.parts):
            message = f"in the scene {self.scene.name}, nothing that its shader draws may be cached"
            hint = "leave cached = false out of one of its objects"
            raise input_error("SC542", message, hint)

    def assign(self, configuration: Configuration) -> Assignment:
        """A configuration of the scene's own shader, for all that the scene lets be cached.

        Objects with shaders of their own have the nodes that the scene names for them; a period or
        a block that an object asks for holds for it.
        """
        return Assignment(
            tuple((part.name, self._chosen(part, configuration)) for part in self.scene.parts)
        )

    def link(
        self,
        assignment: Assignment,
        bundle: Bundle | None = None,
        left_out: LeftOut | None = None,
    ) -> tuple[LinkedObject, ...]:
        """The programs of each object, in the scene's order.

        An object with a shader of its own that has no variant by its algorithm is drawn by another.
        ``bundle`` has the programs of the scene's own shader, where they are not to be compiled.
        ``left_out``: what two passes do without.

        Raises:
            InputError, UsageError: as the compiler.
        """
        modes = [chosen.mode for _, chosen in assignment.objects if chosen is not None]
        mode: Mode = modes[0] if modes else "plain"
        linked = []
        for part, (_, chosen) in zip(self.scene.parts, assignment.objects, strict=True):
            given = None if part.own_shader else bundle
            if chosen is None:
                linked.append(LinkedObject(given or self._original(part, mode)))
                continue
            if part.own_shader and chosen.divisor > 1 and not self.fitting(chosen, part):
                linked.append(LinkedObject(self._original(part, mode)))
                continue
            cached = LinkedObject(given or self._variants(part, chosen, left_out), chosen)
            linked.append(cached.by(chosen.algorithm) if part.own_shader else cached)
        return tuple(linked)

    def algorithms(self, configuration: Configuration) -> tuple[str, ...]:
        """Those that fit the configuration's nodes. Raises as :meth:`link`."""
        return self._variants(None, configuration).algorithms

    def fitting(
        self, configuration: Configuration, part: SceneObject | None = None
    ) -> tuple[str, ...]:
        """The same, also where none does: not every payload can be computed at a fraction of the
        rate."""
        try:
            return self._variants(part, configuration).algorithms
        except InputError as error:
            if configuration.payload_rate == "full" or error.diagnostics[0].code != "SC407":
                raise
            return ()

    def reason(self, configuration: Configuration) -> str:
        """Why its algorithm does not fit. Raises as :meth:`fitting`."""
        try:
            return self.refused(configuration)[configuration.algorithm]
        except InputError as error:
            return error.diagnostics[0].message

    def refused(self, configuration: Configuration) -> Mapping[str, str]:
        """Those that do not, and why. Raises as :meth:`link`."""
        return self._variants(None, configuration).refused

    def originals(self, mode: Mode = "plain", bundle: Bundle | None = None) -> tuple[Bundle, ...]:
        """The unchanged shaders of each object; ``bundle`` as in :meth:`link`."""
        return tuple(
            bundle if bundle and not part.own_shader else self._original(part, mode)
            for part in self.scene.parts
        )

    def _chosen(self, part: SceneObject, configuration: Configuration) -> Configuration | None:
        wanted, longest = part.caching, configuration.refresh.period
        if not wanted.on:
            return None
        own = configuration.with_refresh(min(wanted.period or longest, longest), wanted.block)
        if wanted.node is None:
            return own
        return replace(own, nodes=tuple(wanted.node.split("+")), fetches="whole")

    def _variants(
        self,
        part: SceneObject | None,
        configuration: Configuration,
        left_out: LeftOut | None = None,
    ) -> Bundle:
        """Without a part they are the scene's own shader's."""
        analysis = self.analysis if part is None else self.analysis_of(part)
        own = configuration.algorithm
        first = replace(configuration.compiled, algorithm=NAMES[0] if own in USUAL else own)
        # `compiled` leaves out the format, which no program depends on, but the manifest tells it.
        # An id stands for its analysis, since this linker keeps them all alive.
        key = (id(analysis), first, configuration.storage.format, left_out)
        # All that are usual, since the parts of P/T and of the floor are measured on their passes.
        every = by_every_algorithm(configuration) if left_out is None else (configuration,)
        return self._bundle(
            key, lambda: rewrite(analysis, every, unprofitable=True, left_out=left_out)
        )

    def _original(self, part: SceneObject, mode: Mode) -> Bundle:
        analysis = self.analysis_of(part)
        return self._bundle((id(analysis), mode), lambda: emit_original(analysis, mode))

    def _bundle(self, key: tuple[object, ...], emit: Callable[[], Emission[Any]]) -> Bundle:
        if key not in self._bundles:
            emission = emit()
            self._bundles[key] = Bundle(emission.manifest, emission.files)
        return self._bundles[key]

    def analysis_of(self, part: SceneObject) -> Analysis:
        """What the compiler makes of an object's shaders."""
        if not part.own_shader:
            return self.analysis
        shaders = (part.fragment, part.vertex)
        if shaders not in self._own:
            # What else is said of how the scene's shader is read is said of that alone.
            reading = ReadOptions(approximate=self.analysis.reading.approximate)
            self._own[shaders] = analyse_scene(self.scene.alone(part), reading)[1]
        return self._own[shaders]
