"""The shaders of a scene as they are handed over: each with its folder, files and objects."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path

from msgspec import UNSET, structs

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.compiler import rewrite
from shadercache.diagnostics import input_error
from shadercache.linking.linker import Linker
from shadercache.manifest.codec import encode
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import AnyManifest, Manifest, OriginalManifest
from shadercache.manifest.pass_model import AddedUniform, PassEntry
from shadercache.render.bundle import Bundle, LinkedObject
from shadercache.scene.description import SceneObject
from shadercache.source import as_text

MANIFEST = "manifest.json"


@dataclass(frozen=True, eq=False)
class HandedObject:
    """An object of the scene: its number (from 1, each instance has one), and what it is drawn by;
    None: its original."""

    part: SceneObject
    number: int
    configuration: Configuration | None


@dataclass(frozen=True, eq=False)
class HandedShader:
    """A pair of shaders, and the objects that it draws.

    ``folder`` is where its files lie, with a slash at the end, or empty. ``files`` have what an
    engine needs; where nothing is cached that is nothing, and the example alone draws with them.
    """

    title: str
    folder: str
    manifest: Manifest | OriginalManifest
    files: Mapping[str, str]
    objects: tuple[HandedObject, ...]

    @property
    def variant(self) -> Manifest | None:
        """The manifest, if anything is cached."""
        return self.manifest if isinstance(self.manifest, Manifest) else None

    @property
    def configuration(self) -> Configuration:
        """That of the objects; periods and blocks may be their own."""
        chosen = [item.configuration for item in self.objects if item.configuration is not None]
        return chosen[0] if chosen else Configuration()

    @property
    def passes(self) -> tuple[PassEntry, ...]:
        """Those of the variant, in order."""
        return self.variant.variants[0].passes if self.variant else ()

    @property
    def cached(self) -> tuple[HandedObject, ...]:
        """The objects that the variant draws."""
        return tuple(item for item in self.objects if item.configuration is not None)

    @property
    def plain(self) -> tuple[HandedObject, ...]:
        """Those that the original draws."""
        return tuple(item for item in self.objects if item.configuration is None)

    @property
    def added(self) -> tuple[AddedUniform, ...]:
        """The uniforms that were added, the twins apart."""
        return self.variant.uniforms if self.variant else ()

    @property
    def inputs(self) -> tuple[InputEntry, ...]:
        """What the engine gives, and the twins."""
        return self.manifest.inputs

    def on_reset(self, uniform: str) -> bool:
        """Has a pass that a reset draws this uniform?"""
        return any(uniform in one.uniforms for one in self.passes if one.on_reset)

    def written(self) -> dict[str, str]:
        """The files by their path in the folder that is handed over."""
        texts = dict(self.files)
        if self.variant:
            texts[MANIFEST] = encode(self.variant)
        return {self.folder + name: text for name, text in texts.items()}


def manifest_of(shader: HandedShader) -> Manifest:
    """The manifest of a shader that is cached."""
    assert shader.variant is not None
    return shader.variant


def handed_shaders(linker: Linker, assignment: Assignment) -> tuple[HandedShader, ...]:
    """What draws the objects of a scene, compiled for nothing but the chosen algorithms.

    Raises:
        InputError: SC542, nothing is cached; and as ``Linker.link``.
    """
    parts, linked = linker.scene.parts, linker.link(assignment)
    cached = [drawn for drawn in zip(parts, linked, strict=True) if drawn[1].configuration]
    if not cached:
        message = f"in the scene {linker.scene.name}, no object is cached by what was chosen"
        raise input_error("SC542", message)
    # All share one cache: that of the scene's own shader, where that is cached.
    kept = min(cached, key=lambda drawn: drawn[0].own_shader)[1].bundle.cache
    counts = (part.inputs.instances.number for part in parts)
    groups: dict[tuple[object, ...], list[HandedObject]] = {}
    for part, item, number in zip(parts, linked, accumulate(counts, initial=1), strict=False):
        chosen = item.configuration if _shares(item, kept) else None
        groups.setdefault(_pair(part), []).append(HandedObject(part, number, chosen))
    every = [group for objects in groups.values() for group in _by_programs(objects)]
    titles = _titles([group[0].part.fragment for group in every])
    alone = len(every) == 1
    return tuple(
        _handed(linker, title, "" if alone else f"{title}/", group)
        for title, group in zip(titles, every, strict=True)
    )


def _shares(item: LinkedObject, kept: object) -> bool:
    return item.configuration is not None and item.bundle.cache == kept


def _pair(part: SceneObject) -> tuple[object, ...]:
    return part.fragment, part.vertex, part.own_shader


def _by_programs(objects: Sequence[HandedObject]) -> list[list[HandedObject]]:
    """Objects of one pair of shaders, apart where they are cached by different programs; those
    that originals draw stay with the first."""
    groups: dict[tuple[object, ...], list[HandedObject]] = {}
    rest = [item for item in objects if item.configuration is None]
    for item in objects:
        chosen = item.configuration
        if chosen is not None:
            groups.setdefault((chosen.program_key, chosen.storage.format), []).append(item)
    if not groups:
        return [rest]
    first, *others = groups.values()
    ordered = sorted([*first, *rest], key=lambda item: item.number)
    return [ordered, *others]


def _titles(fragments: Sequence[Path]) -> list[str]:
    """A name for each, which can be that of a folder."""
    titles: list[str] = []
    for fragment in fragments:
        stem = re.sub(r"[^\w.-]", "_", as_text(fragment.stem)) or "shader"
        same = sum(title == stem or title.startswith(f"{stem}-") for title in titles)
        titles.append(f"{stem}-{same + 1}" if same else stem)
    return titles


def _handed(
    linker: Linker, title: str, folder: str, objects: Sequence[HandedObject]
) -> HandedShader:
    chosen = next((item for item in objects if item.configuration is not None), None)
    if chosen is None or chosen.configuration is None:
        bundle = linker.originals()[linker.scene.parts.index(objects[0].part)]
        return HandedShader(title, folder, _original(bundle), bundle.files, tuple(objects))
    # Alone, since the linker's bundles have what other algorithms need.
    analysis = linker.analysis_of(chosen.part)
    emission = rewrite(analysis, chosen.configuration, unprofitable=True)
    manifest = _narrowed(emission.manifest, chosen.configuration)
    files = {name: emission.files[name] for name in _files(manifest)}
    return HandedShader(title, folder, manifest, files, tuple(objects))


def _original(bundle: Bundle) -> OriginalManifest:
    manifest: AnyManifest = bundle.manifest
    assert isinstance(manifest, OriginalManifest)
    return manifest


def _narrowed(manifest: Manifest, chosen: Configuration) -> Manifest:
    """The manifest with what an engine needs for this configuration, and its numbers as
    defaults."""
    passes = [*manifest.variants[0].passes, manifest.original, manifest.debug]
    declared = {name for entry in passes for name in entry.uniforms}
    numbers = {"period": chosen.refresh.period, "block": chosen.refresh.block}
    uniforms = tuple(
        structs.replace(one, default=numbers.get(one.role, one.default))
        for one in manifest.uniforms
        if one.name in declared
    )
    source = manifest.source
    return structs.replace(
        manifest,
        payload=UNSET,
        uniforms=uniforms,
        # Where they lay on this machine is nobody's business.
        source=structs.replace(
            source,
            fragment=structs.replace(source.fragment, name=Path(source.fragment.name).name),
            vertex=structs.replace(source.vertex, name=Path(source.vertex.name).name),
        ),
    )


def _files(manifest: Manifest) -> list[str]:
    passes = [*manifest.variants[0].passes, manifest.debug, manifest.original]
    return list(dict.fromkeys(name for one in passes for name in (one.fragment, one.vertex)))
