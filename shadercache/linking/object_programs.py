"""The programs of objects that have shaders of their own, beside the one that is looked at."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from shadercache.compiler import Analysis, emit_original, rewrite
from shadercache.linking.scene_shaders import analyse_scene, with_aliases
from shadercache.options import Options
from shadercache.render.bundle import Bundle
from shadercache.scene.description import SceneObject


class ObjectPrograms:
    """Compiles them when first wanted, once for each shader and set of options.

    It is what :class:`render.object_bundles.ObjectBundles` asks for.
    """

    def __init__(self) -> None:
        self._analyses: dict[tuple[Path, Path | None], Analysis] = {}
        self._bundles: dict[tuple[object, ...], Bundle] = {}

    def named(self, item: SceneObject) -> SceneObject:
        """The object with everything also under the names that its shaders have for it now.

        Raises as :func:`analyse_scene`.
        """
        if not item.own_shader:
            return item
        return replace(item, scene=with_aliases(item.scene, self._analysis(item).renamed))

    def bundle(self, item: SceneObject, like: Bundle) -> Bundle:
        """The object's programs, made by the options of ``like``, the scene's own.

        Where nothing is cached of the object, or ``like`` holds no variants, it has its original.

        Raises:
            InputError, UsageError: as the compiler, for the object's shaders and its node.
        """
        if not item.own_shader:
            return like
        node = item.node if item.cached and "variants" in like.manifest else None
        options = like.options
        key = (item.scene.fragment, item.scene.vertex, node, options)
        if key not in self._bundles:
            self._bundles[key] = self._compiled(item, node, options)
        return self._bundles[key]

    def _compiled(self, item: SceneObject, node: str | None, options: Options) -> Bundle:
        analysis = self._analysis(item)
        if node is None:
            emission = emit_original(analysis, options.mode)
        else:
            emission = rewrite(analysis, analysis.nodes_of(node), options, unprofitable=True)
        return Bundle(emission.manifest, emission.files)

    def _analysis(self, item: SceneObject) -> Analysis:
        shaders = (item.scene.fragment, item.scene.vertex)
        if shaders not in self._analyses:
            self._analyses[shaders] = analyse_scene(item.scene)[1]
        return self._analyses[shaders]
