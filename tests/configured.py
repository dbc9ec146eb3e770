"""Configurations, variants and runs in few words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict, replace
from functools import lru_cache
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
from msgspec import UNSET, structs
from numpy.typing import NDArray

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.caching.layout import precision_of
from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis, Emission, rewrite
from shadercache.front.read_options import ReadOptions
from shadercache.linking.linker import Linker
from shadercache.manifest.model import Manifest
from shadercache.render.bundle import Bundle, LinkedObject
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import Scene


def configured(base: Configuration | None = None, **chosen: Any) -> Configuration:
    """A configuration: ``mode``, ``form`` (of texels), ``epsilon``, ``fetches``, ``period`` and
    ``block``; else the settings of ``--cache``, where True is ``on``. None changes nothing."""
    found = base or Configuration()
    given = {key: value for key, value in chosen.items() if value is not None}
    found = found.with_refresh(given.pop("period", None), given.pop("block", None))
    form, epsilon = given.pop("form", None), given.pop("epsilon", None)
    if form is not None:
        found = replace(found, storage=replace(found.storage, format=form))
    if epsilon is not None:
        found = replace(found, hit_test=replace(found.hit_test, epsilon=epsilon))
    plain = {key: given.pop(key) for key in ("mode", "fetches") if key in given}
    words = {True: "on", False: "off"}
    settings = [f"{key}={words.get(word, word)}" for key, word in given.items()]
    return with_settings(replace(found, **plain), settings)


def rewritten(
    analysis: Analysis,
    nodes: Candidate | Sequence[Candidate],
    configuration: Configuration | None = None,
    algorithms: Sequence[str] = USUAL,
    **more: bool,
) -> Emission:
    """The programs of some nodes by these algorithms; ``more`` as ``rewrite`` takes it."""
    together = (nodes,) if isinstance(nodes, Candidate) else tuple(nodes)
    ids = tuple(node.id for node in together)
    base = replace(configuration or Configuration(), nodes=ids)
    return rewrite(analysis, [replace(base, algorithm=name) for name in algorithms], **more)


DEFAULT = Configuration()
PROOF = configured(mode="proof", form="rgba32f")


def bundled(*given: Any, **more: Any) -> Bundle:
    """What :func:`rewritten` makes, as the renderer takes it."""
    emission = rewritten(*given, **more)
    return Bundle(emission.manifest, emission.files)


@lru_cache(maxsize=8)
def linker_of(scene: Scene) -> Linker:
    """For scenes whose own shader's programs are given."""
    # Of the scene's own analysis it asks how other shaders are to be read, and nothing else here.
    return Linker(scene, cast(Analysis, SimpleNamespace(reading=ReadOptions())))


def drawn_by(
    scene: Scene, bundle: Bundle, algorithm: str, **chosen: Any
) -> tuple[LinkedObject, ...]:
    """A scene's objects by a variant of the scene's shader; ``chosen`` as :func:`configured`."""
    found = replace(configured(bundle.configuration, **chosen), algorithm=algorithm)
    linker = linker_of(scene)
    return linker.link(linker.assign(found), in_format(bundle, found.storage.format))


def in_format(bundle: Bundle, form: CacheFormat) -> Bundle:
    """The bundle with a cache whose floats have another precision."""
    manifest = bundle.manifest
    if not isinstance(manifest, Manifest) or bundle.configuration.storage.format == form:
        return bundle
    cache, kind = manifest.cache, form.removeprefix("rgba")
    if cache.format.endswith("ui"):
        return bundle
    second = cache.second
    if second is not UNSET:
        wide = second.format.rstrip("0123456789f") + kind
        second = structs.replace(second, format=wide)
    held = asdict(precision_of(form))
    added = (
        structs.replace(item, default=held[item.role]) if item.role in held else item
        for item in manifest.uniforms
    )
    cache = structs.replace(cache, format=form, second=second)
    changed = structs.replace(manifest, cache=cache, uniforms=tuple(added))
    return Bundle(changed, bundle.files)


def originals(scene: Scene, bundle: Bundle) -> tuple[Bundle, ...]:
    """The unchanged shaders of a scene's objects, the scene's own in the bundle's mode."""
    return linker_of(scene).originals(bundle.configuration.mode, bundle)


def variant(
    world: RenderScene,
    bundle: Bundle,
    algorithm: str,
    moving: bool = True,
    short_reset: bool = False,
    **chosen: Any,
) -> VariantRunner:
    """A run of a variant; ``chosen`` as :func:`configured`."""
    objects = drawn_by(world.scene, bundle, algorithm, **chosen)
    return VariantRunner(world, *objects, moving=moving, short_reset=short_reset)


def render_variant(
    world: RenderScene, bundle: Bundle, algorithm: str, frames: Iterable[int], **chosen: Any
) -> list[NDArray[np.float32]]:
    """A variant's images, (h, w, 4) each, drawn in order from a reset."""
    with variant(world, bundle, algorithm, **chosen) as runner:
        return [runner.image(frame) for frame in frames]
