"""A rewritten node or set of nodes as an engine sees it: the manifest and the files it names.

This is all the harness knows about a variant; it holds no knowledge of the algorithms.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from msgspec import UNSET

from shadercache import foreign_files as foreign
from shadercache.caching.configuration import DEFAULT_EPSILON, Configuration, Mode
from shadercache.caching.settings import with_settings
from shadercache.diagnostics import UsageError, input_error, usage_error
from shadercache.manifest.codec import decode, unusable
from shadercache.manifest.interface import InputEntry
from shadercache.manifest.model import AnyManifest, Manifest, NeededManifest
from shadercache.manifest.pass_model import NeededEntry, PassEntry
from shadercache.source import Source

_GLSL = Path(__file__).parent / "glsl"
_DEPTH_TESTS = {"less": "<", "lequal": "<="}
_VERSION_LINE = re.compile(r"^\s*#\s*version\b.*$", re.MULTILINE)


@dataclass(frozen=True, eq=False)
class PassSpec:
    """One draw of all objects, or of one triangle ``over_screen`` for all of them.

    ``depth_test`` is ``<`` or ``<=``; targets stand at their index.

    ``looks``: does it look up what the last frame stored? ``inputs``: what it declares of the
    user's, and the twins.
    """

    name: str
    vertex: Source
    fragment: Source
    targets: tuple[str, ...]
    depth_test: str
    depth_write: bool
    on_reset: bool
    looks: bool = False
    over_screen: bool = False
    inputs: tuple[InputEntry, ...] = ()


@dataclass(frozen=True)
class CacheSpec:
    """Formats of a cache's textures (one, or two), what each is cleared to, and their filter."""

    formats: tuple[str, ...]
    clear: tuple[tuple[float, ...], ...]
    filter: str


@dataclass(frozen=True, eq=False)
class Bundle:
    """A manifest with its files (name -> text).

    Properties raise InputError SC021 where the manifest is of an original alone and has no such
    part, and SC022 for a file it names that is not there.
    """

    manifest: AnyManifest
    files: Mapping[str, str]

    @property
    def has_variants(self) -> bool:
        """Is anything cached, so that there is more than the original?"""
        return isinstance(self.manifest, Manifest)

    def node(self, key: Literal["id", "path", "text", "type"]) -> str:
        """What the manifest says of the cached nodes.

        Of several the ids are joined as on the command line, ``a+b``, the rest by ``" | "``.
        """
        found = [str(getattr(node, key)) for node in self._told.nodes]
        return ("+" if key == "id" else " | ").join(found)

    @property
    def mode(self) -> Mode:
        """``plain`` or ``proof``."""
        return self.manifest.mode

    @cached_property
    def configuration(self) -> Configuration:
        """What the manifest says of how its variants are made and run, by its first algorithm."""
        plain = Configuration(mode=self.mode)
        if not self.has_variants:
            return plain
        cache = self._told.cache
        found = with_settings(plain, [f"{key}={word}" for key, word in cache.options.items()])
        return replace(
            found,
            nodes=tuple(node.id for node in self._told.nodes),
            algorithm=self.algorithms[0],
            hit_test=replace(found.hit_test, epsilon=self.defaults.get("epsilon", DEFAULT_EPSILON)),
            storage=replace(
                found.storage, format="rgba16f" if cache.format == "rgba16f" else "rgba32f"
            ),
        )

    @cached_property
    def algorithms(self) -> tuple[str, ...]:
        """The algorithms there are variants by."""
        return tuple(variant.algorithm for variant in self._told.variants)

    @cached_property
    def refused(self) -> dict[str, str]:
        """The algorithms there cannot be variants by, and why."""
        return {item.algorithm: item.reason for item in self._told.refused}

    def passes(self, algorithm: str) -> tuple[PassSpec, ...]:
        """The passes of a variant, in order.

        Raises:
            UsageError: SC026, the manifest has no such variant.
        """
        for variant in self._told.variants:
            if variant.algorithm == algorithm:
                return tuple(map(self._pass, variant.passes))
        raise _no_variant(self, algorithm)

    @cached_property
    def reset_pass(self) -> PassSpec | None:
        """The pass that alone draws a frame after a reset and looks nothing up, if there is one."""
        drawn = [[spec for spec in self.passes(name) if spec.on_reset] for name in self.algorithms]
        return next((specs[0] for specs in drawn if len(specs) == 1 and not specs[0].looks), None)

    @cached_property
    def hit_pass(self) -> tuple[str, str] | None:
        """The algorithm, and its pass, that shades hits and nothing else, if there is one."""
        for name in self.algorithms:
            for spec in self.passes(name):
                if spec.looks and not spec.on_reset and "color" in spec.targets:
                    return name, spec.name
        return None

    @cached_property
    def original(self) -> PassSpec:
        """The unchanged shader."""
        if isinstance(self.manifest, NeededManifest):
            raise unusable("it tells of no original")
        return self._pass(self.manifest.original)

    @cached_property
    def payload(self) -> PassSpec:
        """The payload alone, drawn like the original: what computing it costs."""
        return self._pass(self._told.payload)

    @cached_property
    def debug(self) -> PassSpec:
        """The program that tells hits from misses."""
        return self._pass(self._told.debug)

    @cached_property
    def mask_values(self) -> dict[str, int]:
        """What the debug program writes for each outcome: hit, refresh, outside, depth."""
        return {str(outcome): value for outcome, value in self._told.debug.values.items()}

    @cached_property
    def needed(self) -> PassSpec:
        """The program that tells which pixels have payloads (1), do without (2), or have some that
        a guard keeps from being reused (3)."""
        return self._pass(self._needed)

    @property
    def needed_by_some(self) -> bool:
        """Are there pixels that may do without payloads?"""
        return self._needed.by_some

    @cached_property
    def geometry(self) -> PassSpec:
        """The original's vertex work under a fragment shader that only writes one colour.

        The manifest's own ``geometry`` entry if it has one, else made from the original.
        """
        if isinstance(self.manifest, Manifest) and self.manifest.geometry is not UNSET:
            return self._pass(self.manifest.geometry)
        return self.coverage

    @cached_property
    def coverage(self) -> PassSpec:
        """The original's vertex shader with a fragment shader that writes 1/4 everywhere."""
        vertex = self.original.vertex
        version = _VERSION_LINE.search(vertex.text)
        text = (_GLSL / "constant.frag").read_text(encoding="utf-8")
        if version is not None:
            text = _VERSION_LINE.sub(version[0].strip(), text, count=1)
        fragment = Source("constant.frag", text)
        return PassSpec(
            "geometry", vertex, fragment, ("color",), "<", True, False, inputs=self.original.inputs
        )

    @cached_property
    def cache(self) -> CacheSpec:
        """How the cache textures are made."""
        cache = self._told.cache
        textures = (cache,) if cache.second is UNSET else (cache, cache.second)
        formats = tuple(texture.format for texture in textures)
        return CacheSpec(formats, tuple(texture.clear for texture in textures), cache.filter)

    @property
    def refreshes(self) -> bool:
        """Is anything recomputed on purpose, so that a period of 1 means everything, always?"""
        refresh = self.configuration.refresh
        return refresh.schedule != "none" or refresh.age

    @cached_property
    def age_channel(self) -> int | None:
        """The channel of a cache read back that holds the payload's age, if one does."""
        cache = self._told.cache
        held = [cache.channels.extras]
        if cache.second is not UNSET:
            held.append(cache.second.channels.extras)
        for start, extras in zip((0, 4), held, strict=False):
            if extras is not UNSET and "age" in extras:
                return start + "xyzw".index(extras["age"])
        return None

    @cached_property
    def roles(self) -> dict[str, str]:
        """Added uniform -> its role: previous-cache, current-cache, clock, period, ..."""
        return {item.name: item.role for item in self._told.uniforms}

    @cached_property
    def defaults(self) -> dict[str, float]:
        """Role -> default value, of the added uniforms that have one."""
        uniforms = self._told.uniforms
        return {item.role: item.default for item in uniforms if item.default is not None}

    @cached_property
    def reset_numbers(self) -> dict[str, float]:
        """Role -> value in the draws of a reset, of the added uniforms that have another then."""
        uniforms = self._told.uniforms
        return {item.role: item.on_reset for item in uniforms if item.on_reset is not UNSET}

    @cached_property
    def twins(self) -> dict[str, str]:
        """Uniform that wants the last frame's value -> the uniform whose value it is."""
        return {twin: name for name, twin in self._told.previous.items()}

    @property
    def _told(self) -> Manifest:
        if not isinstance(self.manifest, Manifest):
            raise unusable("it tells of no variants")
        return self.manifest

    @property
    def _needed(self) -> NeededEntry:
        if not isinstance(self.manifest, NeededManifest):
            raise unusable("it does not tell which pixels have payloads")
        return self.manifest.needed

    def _pass(self, entry: PassEntry) -> PassSpec:
        declared = {*entry.uniforms, *entry.attributes}
        return PassSpec(
            name=entry.name,
            vertex=self._file(entry.vertex),
            fragment=self._file(entry.fragment),
            targets=entry.targets,
            depth_test=_DEPTH_TESTS[entry.depth.test],
            depth_write=entry.depth.write,
            on_reset=entry.on_reset,
            looks="previous-cache" in entry.reads,
            over_screen=entry.draws == "screen",
            inputs=tuple(item for item in self.manifest.inputs if item.name in declared),
        )

    def _file(self, name: str) -> Source:
        if name not in self.files:
            raise input_error("SC022", f"the manifest names the file {name}, which is not there")
        return Source(name, self.files[name])


def load_bundle(folder: Path) -> Bundle:
    """Read ``manifest.json`` and every file beside it that can be a shader.

    Raises:
        InputError: SC020 unreadable, SC021 not a manifest of this version.
    """
    path = folder / "manifest.json"
    try:
        manifest = foreign.read_json(path)
        names = [item for item in sorted(folder.iterdir()) if item.suffix in (".vert", ".frag")]
        files = {item.name: foreign.read_text(item) for item in names}
    except (OSError, ValueError) as error:
        raise input_error("SC020", f"cannot read the manifest {path}: {error}") from None
    return bundle_of(manifest, files, str(path))


def bundle_of(manifest: Any, files: Mapping[str, str], name: str) -> Bundle:
    """A manifest that somebody else wrote, with its files.

    Raises:
        InputError: SC021 not a manifest of this version, or one with something wrong in it.
    """
    return Bundle(decode(manifest, name), files)


def _no_variant(bundle: Bundle, algorithm: str) -> UsageError:
    have = ", ".join(bundle.algorithms) or "none"
    message = f"node {bundle.node('id')} has no {algorithm} variant here"
    return usage_error("SC026", message, hint=f"there are: {have}")
