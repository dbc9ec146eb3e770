"""A rewritten node or set of nodes as an engine sees it: the manifest and the files it names.

This is all the harness knows about a variant; it holds no knowledge of the algorithms.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from shadercache import foreign_files as foreign
from shadercache.caching.configuration import DEFAULT_EPSILON, Configuration, Mode
from shadercache.caching.settings import with_settings
from shadercache.diagnostics import InputError, UsageError, input_error, usage_error
from shadercache.source import Source

SCHEMA_VERSION = 2

_GLSL = Path(__file__).parent / "glsl"
_DEPTH_TESTS = {"less": "<", "lequal": "<="}
_VERSION_LINE = re.compile(r"^\s*#\s*version\b.*$", re.MULTILINE)


@dataclass(frozen=True, eq=False)
class PassSpec:
    """One draw of all objects. ``depth_test`` is ``<`` or ``<=``; targets stand at their index.

    ``looks``: does it look up what the last frame stored?
    """

    name: str
    vertex: Source
    fragment: Source
    targets: tuple[str, ...]
    depth_test: str
    depth_write: bool
    on_reset: bool
    looks: bool = False


@dataclass(frozen=True)
class CacheSpec:
    """Formats of a cache's textures (one, or two), what each is cleared to, and their filter."""

    formats: tuple[str, ...]
    clear: tuple[tuple[float, ...], ...]
    filter: str


@dataclass(frozen=True, eq=False)
class Bundle:
    """A manifest with its files (name -> text).

    Every property raises InputError SC021 where the manifest lacks what it stands for, and SC022
    for a file it names that is not there.
    """

    manifest: Mapping[str, Any]
    files: Mapping[str, str]

    def node(self, key: str) -> str:
        """What the manifest says of the cached nodes: ``id``, ``path``, ``text`` or ``type``.

        Of several the ids are joined as on the command line, ``a+b``, the rest by ``" | "``.
        """
        found = [str(_need(node, key)) for node in _need(self.manifest, "nodes")]
        return ("+" if key == "id" else " | ").join(found)

    @property
    def mode(self) -> str:
        """``plain`` or ``proof``."""
        return str(_need(self.manifest, "mode"))

    @cached_property
    def configuration(self) -> Configuration:
        """What the manifest says of how its variants are made and run, by its first algorithm."""
        mode: Mode = "proof" if self.mode == "proof" else "plain"
        plain = Configuration(mode=mode)
        if "cache" not in self.manifest:
            return plain
        cache = _need(self.manifest, "cache")
        settings = [f"{key}={word}" for key, word in cache.get("options", {}).items()]
        found = with_settings(plain, settings)
        short = str(_need(cache, "format")).endswith("16f")
        return replace(
            found,
            nodes=tuple(self.node("id").split("+")),
            algorithm=self.algorithms[0] if self.algorithms else plain.algorithm,
            hit_test=replace(found.hit_test, epsilon=self.defaults.get("epsilon", DEFAULT_EPSILON)),
            storage=replace(found.storage, format="rgba16f" if short else "rgba32f"),
        )

    @cached_property
    def algorithms(self) -> tuple[str, ...]:
        """The algorithms there are variants by."""
        return tuple(str(_need(variant, "algorithm")) for variant in self._variants())

    def passes(self, algorithm: str) -> tuple[PassSpec, ...]:
        """The passes of a variant, in order.

        Raises:
            UsageError: SC026, the manifest has no such variant.
        """
        for variant in self._variants():
            if _need(variant, "algorithm") == algorithm:
                return tuple(self._pass(entry) for entry in _need(variant, "passes"))
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
        return self._pass(_need(self.manifest, "original"))

    @cached_property
    def payload(self) -> PassSpec:
        """The payload alone, drawn like the original: what computing it costs."""
        return self._pass(_need(self.manifest, "payload"))

    @cached_property
    def debug(self) -> PassSpec:
        """The program that tells hits from misses."""
        return self._pass(_need(self.manifest, "debug"))

    @cached_property
    def mask_values(self) -> dict[str, int]:
        """What the debug program writes for each outcome: hit, refresh, outside, depth."""
        return dict(_need(self.manifest, "debug", "values"))

    @cached_property
    def needed(self) -> PassSpec:
        """The program that tells which pixels have payloads (1), do without (2), or have some that
        a guard keeps from being reused (3)."""
        return self._pass(_need(self.manifest, "needed"))

    @property
    def needed_by_some(self) -> bool:
        """Are there pixels that may do without payloads?"""
        return bool(_need(self.manifest, "needed", "by_some"))

    @cached_property
    def geometry(self) -> PassSpec:
        """The original's vertex work under a fragment shader that only writes one colour.

        The manifest's own ``geometry`` entry if it has one, else made from the original.
        """
        if "geometry" in self.manifest:
            return self._pass(self.manifest["geometry"])
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
        return PassSpec("geometry", vertex, fragment, ("color",), "<", True, False)

    @cached_property
    def cache(self) -> CacheSpec:
        """How the cache textures are made."""
        cache = _need(self.manifest, "cache")
        textures = [cache, cache["second"]] if "second" in cache else [cache]
        formats = tuple(str(_need(texture, "format")) for texture in textures)
        clear = tuple(tuple(map(float, _need(texture, "clear"))) for texture in textures)
        return CacheSpec(formats, clear, str(_need(cache, "filter")))

    @property
    def refreshes(self) -> bool:
        """Is anything recomputed on purpose, so that a period of 1 means everything, always?"""
        refresh = self.configuration.refresh
        return refresh.schedule != "none" or refresh.age

    @cached_property
    def age_channel(self) -> int | None:
        """The channel of a cache read back that holds the payload's age, if one does."""
        cache = _need(self.manifest, "cache")
        for start, texture in ((0, cache), (4, cache.get("second", {}))):
            name = texture.get("channels", {}).get("extras", {}).get("age")
            if name is not None:
                return start + "xyzw".index(name)
        return None

    @cached_property
    def roles(self) -> dict[str, str]:
        """Added uniform -> its role: previous-cache, current-cache, clock, period, ..."""
        uniforms = _need(self.manifest, "uniforms")
        return {str(_need(entry, "name")): str(_need(entry, "role")) for entry in uniforms}

    @cached_property
    def defaults(self) -> dict[str, float]:
        """Role -> default value, of the added uniforms that have one."""
        entries = _need(self.manifest, "uniforms")
        return {
            str(_need(entry, "role")): float(entry["default"])
            for entry in entries
            if entry.get("default") is not None
        }

    @cached_property
    def reset_numbers(self) -> dict[str, float]:
        """Role -> value in the draws of a reset, of the added uniforms that have another then."""
        entries = _need(self.manifest, "uniforms")
        return {
            str(_need(entry, "role")): float(entry["on_reset"])
            for entry in entries
            if "on_reset" in entry
        }

    @cached_property
    def twins(self) -> dict[str, str]:
        """Uniform that wants the last frame's value -> the uniform whose value it is."""
        return {twin: name for name, twin in _need(self.manifest, "previous").items()}

    def _variants(self) -> list[Mapping[str, Any]]:
        return list(_need(self.manifest, "variants"))

    def _pass(self, entry: Mapping[str, Any]) -> PassSpec:
        test = str(_need(entry, "depth", "test"))
        if test not in _DEPTH_TESTS:
            raise _broken(f"depth test {test!r} is neither less nor lequal")
        return PassSpec(
            name=str(_need(entry, "name")),
            vertex=self._file(_need(entry, "vertex")),
            fragment=self._file(_need(entry, "fragment")),
            targets=tuple(_need(entry, "targets")),
            depth_test=_DEPTH_TESTS[test],
            depth_write=bool(_need(entry, "depth", "write")),
            on_reset=bool(entry.get("on_reset", False)),
            looks="previous-cache" in entry.get("reads", ()),
        )

    def _file(self, name: object) -> Source:
        if not isinstance(name, str) or name not in self.files:
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
        InputError: SC021 not a manifest of this version.
    """
    if not isinstance(manifest, dict) or manifest.get("schema_version") != SCHEMA_VERSION:
        raise _broken(f"{name} is not of schema_version {SCHEMA_VERSION}")
    bundle = Bundle(manifest, files)
    _check_types(bundle)
    return bundle


_PARTS: tuple[tuple[str, Callable[[Bundle], object]], ...] = (
    ("nodes", lambda bundle: bundle.node("id")),
    ("variants", lambda bundle: [bundle.passes(name) for name in bundle.algorithms]),
    ("original", lambda bundle: bundle.original),
    ("payload", lambda bundle: bundle.payload),
    ("debug", lambda bundle: bundle.debug),
    ("debug", lambda bundle: bundle.mask_values),
    ("needed", lambda bundle: bundle.needed),
    ("geometry", lambda bundle: bundle.geometry),
    ("cache", lambda bundle: bundle.cache),
    ("cache", lambda bundle: bundle.configuration),
    ("cache", lambda bundle: bundle.age_channel),
    ("uniforms", lambda bundle: bundle.roles),
    ("uniforms", lambda bundle: bundle.defaults),
    ("uniforms", lambda bundle: bundle.reset_numbers),
    ("previous", lambda bundle: bundle.twins),
)
"""Parts of a manifest, and what is made of them."""


def _check_types(bundle: Bundle) -> None:
    """SC021 where a part of a manifest is of another kind than it has to be; what is missing is
    told when it is asked for."""
    for name, read in _PARTS:
        try:
            if name in bundle.manifest:
                read(bundle)
        except (InputError, UsageError):
            continue
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
            raise _broken(f"its '{name}' is not what it has to be") from None


def _need(entry: Any, *keys: str) -> Any:
    for key in keys:
        if not isinstance(entry, Mapping) or key not in entry:
            raise _broken(f"it lacks {'.'.join(keys)}")
        entry = entry[key]
    return entry


def _broken(reason: str) -> InputError:
    return input_error("SC021", f"the manifest cannot be used: {reason}")


def _no_variant(bundle: Bundle, algorithm: str) -> UsageError:
    have = ", ".join(bundle.algorithms) or "none"
    message = f"node {bundle.node('id')} has no {algorithm} variant here"
    return usage_error("SC026", message, hint=f"there are: {have}")
