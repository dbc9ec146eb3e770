"""A rewritten node or set of nodes as an engine sees it: the manifest and the files it names.

This is all the harness knows about a variant; it holds no knowledge of the algorithms.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from msgspec import UNSET, structs

from shadercache import foreign_files as foreign
from shadercache.caching.algorithms import PARKED, USUAL
from shadercache.caching.configuration import DEFAULT_EPSILON, DIVISORS, Configuration
from shadercache.caching.settings import with_settings
from shadercache.diagnostics import input_error, usage_error
from shadercache.gpu.color_targets import ColorTarget, output_kind
from shadercache.manifest.codec import decode, unusable
from shadercache.manifest.interface import declared_of
from shadercache.manifest.model import AnyManifest, Manifest, NeededManifest
from shadercache.manifest.pass_model import PassEntry
from shadercache.render.depth_spec import DepthSpec, depth_spec
from shadercache.render.pass_spec import NeededPass, PassSpec
from shadercache.scene.object_inputs import root_of
from shadercache.source import Source

_CONSTANT = Path(__file__).parent / "glsl" / "constant.frag"
RATES = {divisor: rate for rate, divisor in DIVISORS.items()}
"""Payload rates by their divisors."""

_VERSION_LINE = re.compile(r"^\s*#\s*version\b.*$", re.MULTILINE)


@dataclass(frozen=True)
class CacheSpec:
    """Formats of a cache's textures (one, or two), what each is cleared to, and their filter;
    ``divisor``: how many times smaller than the picture they are, in each direction.

    ``extras``: what a cache read back holds beside payloads and depth (``object``, ``age``), and in
    which channel. Objects share a cache only where these are the same: one would take the other's
    payload for a number otherwise.
    """

    formats: tuple[str, ...]
    clear: tuple[tuple[float, ...], ...]
    filter: str
    extras: tuple[tuple[str, int], ...] = ()
    divisor: int = 1

    @property
    def age_channel(self) -> int | None:
        """The channel of the payload's age, if it is kept."""
        return dict(self.extras).get("age")


@dataclass(frozen=True, slots=True)
class Naming:
    """What the manifest says of the uniforms it added: roles and originals of twins by name;
    numbers by role, those of a reset in ``on_reset``."""

    roles: Mapping[str, str] = field(default_factory=dict)
    twins: Mapping[str, str] = field(default_factory=dict)
    defaults: Mapping[str, float] = field(default_factory=dict)
    on_reset: Mapping[str, float] = field(default_factory=dict)

    def original(self, name: str) -> str | None:
        """What a twin, or a part of one, has the last value of; None for other uniforms."""
        whole = root_of(name)
        twin_of = self.twins.get(whole)
        return None if twin_of is None else twin_of + name[len(whole) :]


NO_NAMES = Naming()
"""For programs that hold nothing but the user's own uniforms."""


@dataclass(frozen=True, eq=False)
class Bundle:
    """A manifest with its files (name -> text).

    Properties raise InputError SC021 where the manifest is of an original alone and has no such
    part, and SC022 for a file it names that is not there.
    """

    manifest: AnyManifest
    files: Mapping[str, str]
    enlarged: int = 1
    """How many times larger than meant is the cache, in each direction? (:meth:`enlarge`)"""

    @property
    def has_variants(self) -> bool:
        """Is anything cached, so that there is more than the original?"""
        return isinstance(self.manifest, Manifest)

    @property
    def _variants(self) -> Manifest:
        if not isinstance(self.manifest, Manifest):
            raise unusable("it tells of no variants")
        return self.manifest

    @property
    def mapping(self) -> Literal["surface", "screen", "user"]:
        """Where the variants find what the last frame stored."""
        return self._variants.mapping.kind

    def node(self, key: Literal["id", "path", "text", "type"]) -> str:
        """What the manifest says of the cached nodes.

        Of several the ids are joined as on the command line, ``a+b``, the rest by ``" | "``.
        """
        words = [str(getattr(node, key)) for node in self._variants.nodes]
        return ("+" if key == "id" else " | ").join(words)

    @cached_property
    def configuration(self) -> Configuration:
        """What the manifest says of how its variants are made and run, by its first algorithm."""
        plain = Configuration(mode=self.manifest.mode)
        if not self.has_variants:
            return plain
        cache = self._variants.cache
        said = with_settings(plain, [f"{key}={word}" for key, word in cache.options.items()])
        epsilon = self.naming.defaults.get("epsilon", DEFAULT_EPSILON)
        # rgba32ui follows from integers in the payload, and holds the bits of rgba32f.
        form: Literal["rgba16f", "rgba32f"] = "rgba16f" if cache.format == "rgba16f" else "rgba32f"
        return replace(
            said,
            nodes=tuple(node.id for node in self._variants.nodes),
            algorithm=self.algorithms[0],
            hit_test=replace(said.hit_test, epsilon=epsilon),
            storage=replace(said.storage, format=form),
            payload_rate=RATES[self.cache.divisor],
        )

    @cached_property
    def algorithms(self) -> tuple[str, ...]:
        """The algorithms there are variants by."""
        return tuple(variant.algorithm for variant in self._variants.variants)

    @cached_property
    def refused(self) -> dict[str, str]:
        """The algorithms there cannot be variants by, and why."""
        return {refusal.algorithm: refusal.reason for refusal in self._variants.refused}

    def passes(self, algorithm: str) -> tuple[PassSpec, ...]:
        """The passes of a variant, in order.

        Raises:
            UsageError: SC026, the manifest has no such variant.
        """
        for variant in self._variants.variants:
            if variant.algorithm == algorithm:
                return tuple(map(self._drawing, variant.passes))
        reason = self.refused.get(algorithm)
        message = f"node {self.node('id')} has no {algorithm} variant here"
        message += f": {reason}" if reason else ""
        raise usage_error("SC026", message, f"there are: {', '.join(self.algorithms) or 'none'}")

    def enlarge(self) -> Bundle:
        """The same programs with a texel for each pixel, where the cache is a fraction of the
        picture: what they draw then is what a variant at the full rate draws."""
        divisor = self.cache.divisor
        if divisor == 1:
            return self
        targets = {
            name: structs.replace(target, divisor=1)
            for name, target in self._variants.targets.items()
        }
        manifest = structs.replace(self._variants, targets=targets)
        return Bundle(manifest, self.files, enlarged=divisor)

    @property
    def apart(self) -> bool:
        """Have passes into the cache a depth of their own?"""
        return self.enlarged > 1 or self.cache.divisor > 1

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
                # One pass looks up as well, but a reset draws it: it computes what it misses.
                if spec.looks and not spec.on_reset and "color" in spec.targets:
                    return name, spec.name
        return None

    @cached_property
    def original(self) -> PassSpec:
        """The unchanged shader."""
        if isinstance(self.manifest, NeededManifest):
            raise unusable("it tells of no original")
        return self._drawing(self.manifest.original)

    @cached_property
    def payload(self) -> PassSpec:
        """The payload alone, drawn like the original: what computing it costs."""
        if self._variants.payload is UNSET:
            raise unusable("it tells of no program for the payload alone")
        return self._pass(self._variants.payload)

    @cached_property
    def debug(self) -> PassSpec:
        """The program that tells hits from misses."""
        return self._pass(self._variants.debug)

    @cached_property
    def mask_values(self) -> dict[str, int]:
        """What the debug program writes for each outcome: hit, refresh, outside, depth."""
        return {str(outcome): value for outcome, value in self._variants.debug.values.items()}

    @cached_property
    def needed(self) -> NeededPass:
        """The program that tells pixels with payloads from those without."""
        if not isinstance(self.manifest, NeededManifest):
            raise unusable("it does not tell which pixels have payloads")
        return NeededPass(self._pass(self.manifest.needed), self.manifest.needed.by_some)

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
        # In GLSL ES both stages of a program must be of one version.
        version = _VERSION_LINE.search(vertex.text)
        text = _CONSTANT.read_text(encoding="utf-8")
        if version is not None:
            text = _VERSION_LINE.sub(version[0].strip(), text, count=1)
        fragment = Source(_CONSTANT.name, text)
        return PassSpec("geometry", vertex, fragment, inputs=self.original.inputs)

    @cached_property
    def cache(self) -> CacheSpec:
        """How the cache textures are made."""
        cache = self._variants.cache
        formats: list[str] = [cache.format]
        clear, extras = [cache.clear], [cache.channels.extras]
        if cache.second is not UNSET:
            formats.append(cache.second.format)
            clear.append(cache.second.clear)
            extras.append(cache.second.channels.extras)
        places = (
            # The first texel has four channels always: the last one is the depth.
            (kept, 4 * texel + "xyzw".index(channel))
            for texel, held in enumerate(extras)
            if held is not UNSET
            for kept, channel in held.items()
        )
        divisor = self._variants.targets["cache"].divisor
        return CacheSpec(tuple(formats), tuple(clear), cache.filter, tuple(places), divisor)

    @cached_property
    def naming(self) -> Naming:
        """The uniforms that were added."""
        added = self._variants.uniforms
        return Naming(
            {uniform.name: uniform.role for uniform in added},
            {twin: name for name, twin in self._variants.previous.items()},
            {uniform.role: uniform.default for uniform in added if uniform.default is not None},
            {uniform.role: uniform.on_reset for uniform in added if uniform.on_reset is not UNSET},
        )

    @cached_property
    def _parked(self) -> dict[str, str]:
        """The formats of what is parked."""
        targets = self.manifest.targets if isinstance(self.manifest, Manifest) else {}
        return {
            name: target.format
            for name, target in targets.items()
            if name.startswith(PARKED) and target.format is not None
        }

    def _depth(self, entry: PassEntry, divisor: int) -> DepthSpec:
        apart = divisor > 1 or (self.enlarged > 1 and "color" not in entry.targets)
        return depth_spec(entry.depth, apart)

    def _drawing(self, entry: PassEntry) -> PassSpec:
        """A pass that draws the user's outputs, or none of them."""
        spec = self._pass(entry)
        return replace(spec, colors=self.colors) if "color" in spec.targets else spec

    def _pass(self, entry: PassEntry) -> PassSpec:
        divisor = self._divisor(entry)
        return PassSpec(
            name=entry.name,
            vertex=self._file(entry.vertex),
            fragment=self._file(entry.fragment),
            targets=entry.targets,
            depth=self._depth(entry, divisor),
            on_reset=entry.on_reset,
            looks="previous-cache" in entry.reads,
            draws=entry.draws,
            parked=self._parked,
            divisor=divisor,
            inputs=declared_of(self.manifest.inputs, entry.uniforms, entry.attributes),
        )

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """The user's name of what is drawn into each of ``colors``."""
        outputs = () if isinstance(self.manifest, NeededManifest) else self.manifest.outputs
        return tuple(
            f"{output.output}[{at}]" if "[" in output.type else output.output
            for output in outputs
            for at, _ in enumerate(output.targets)
        )

    @cached_property
    def colors(self) -> tuple[ColorTarget, ...]:
        """The targets of the user's outputs."""
        outputs = () if isinstance(self.manifest, NeededManifest) else self.manifest.outputs
        return tuple(
            ColorTarget(name, *output_kind(output.type), output.output)
            for output in outputs
            for name in output.targets
        )

    def _divisor(self, entry: PassEntry) -> int:
        """How many times smaller than the picture the targets of a pass are."""
        targets = self.manifest.targets if isinstance(self.manifest, Manifest) else {}
        return max((targets[name].divisor for name in entry.targets if targets), default=1)

    def _file(self, name: str) -> Source:
        if name not in self.files:
            raise input_error("SC022", f"the manifest names the file {name}, which is not there")
        return Source(name, self.files[name])


@dataclass(frozen=True, eq=False)
class LinkedObject:
    """The programs of one object, and the configuration it is drawn by; None: its original."""

    bundle: Bundle
    configuration: Configuration | None = None

    def by(self, algorithm: str) -> LinkedObject:
        """The same by an algorithm, or by the last in the table that the object has instead.

        Without any it is drawn by its original.
        """
        have = self.bundle.algorithms if self.bundle.has_variants else ()
        fit = [algorithm, *reversed(USUAL)]
        chosen = next((name for name in fit if name in have), None)
        if self.configuration is None or chosen is None:
            return LinkedObject(self.bundle)
        return LinkedObject(self.bundle, replace(self.configuration, algorithm=chosen))


def load_bundle(folder: Path) -> Bundle:
    """Read ``manifest.json`` and every file beside it that can be a shader.

    Raises:
        InputError: SC020 unreadable, SC021 not a manifest of this version.
    """
    path = folder / "manifest.json"
    try:
        manifest = foreign.read_json(path)
        names = [file for file in sorted(folder.iterdir()) if file.suffix in (".vert", ".frag")]
        files = {file.name: foreign.read_text(file) for file in names}
    except (OSError, ValueError) as error:
        raise input_error("SC020", f"cannot read the manifest {path}: {error}") from None
    return bundle_of(manifest, files, str(path))


def bundle_of(manifest: Any, files: Mapping[str, str], name: str) -> Bundle:
    """A manifest that somebody else wrote, with its files.

    Raises:
        InputError: SC021 not a manifest of this version, or one with something wrong in it.
    """
    return Bundle(decode(manifest, name), files)
