"""One pass of the manifest bound to an object: its program, and where each input comes from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import moderngl
import numpy as np
from msgspec import UNSET

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.gpu.cache_textures import CachePair
from shadercache.gpu.programs import Uniform
from shadercache.gpu.textures import GlTexture, texture_kind
from shadercache.gpu.uniform_blocks import blocks_of
from shadercache.manifest.interface import UniformInput
from shadercache.render.bundle import PassSpec
from shadercache.render.drawable import Drawable
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import Values, root_of
from shadercache.source import Source

CACHE_ROLES = ("previous-cache", "current-cache", "previous-cache-2", "current-cache-2")
CACHE_TARGETS = ("cache", "cache-2")
NUMBER_ROLES = (
    *("clock", "period", "block", "epsilon", "object", "mask", "unit", "magnification"),
    *("resolution", "limit", "least", "reset", "viewport", "previous-viewport"),
)


@dataclass(frozen=True, slots=True)
class FrameInputs:
    """What the passes of one frame read: this and the last frame's uniforms, numbers by role.

    ``viewport``: left, bottom, width and height of what is drawn into, in pixels.
    """

    now: Values
    before: Values
    numbers: Values
    viewport: tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class Naming:
    """How the manifest names what it added: uniform -> role, twin -> original uniform."""

    roles: Mapping[str, str]
    twins: Mapping[str, str]

    def original(self, name: str) -> str | None:
        """What a twin, or a part of one, has the last value of; None for other uniforms."""
        whole = root_of(name)
        found = self.twins.get(whole)
        return None if found is None else found + name[len(whole) :]


NO_NAMES = Naming({}, {})
"""For programs that hold nothing but the user's own uniforms."""


class BoundPass:
    """A pass that can be drawn. Everything is looked up once, when it is made."""

    def __init__(
        self,
        world: RenderScene,
        drawable: Drawable,
        spec: PassSpec,
        naming: Naming,
        captured: str = "",
    ) -> None:
        """Compile the program and find a source for each of its inputs.

        ``captured``: as in :meth:`Programs.acquire`.

        Raises:
            InputError: SC520 no value for a uniform, SC521 none for an attribute, SC522 none for
                a texture, SC523 a value of a wrong size, SC525 a target or role that is not
                known, SC602 the driver refuses.
        """
        self.name = spec.name
        self.over_screen = spec.over_screen
        self._world = world
        self._drawable = drawable
        self._spec = spec
        self._now: list[tuple[Uniform, str]] = []
        self._before: list[tuple[Uniform, str]] = []
        self._numbers: list[tuple[Uniform, str]] = []
        self._units: list[tuple[Uniform, GlTexture | str]] = []
        self._initialised = {
            item.name
            for item in spec.inputs
            if isinstance(item, UniformInput) and item.default is not UNSET
        }
        self._program = world.programs.acquire(
            spec.vertex, spec.fragment, blocks_of(spec.inputs), captured
        )
        try:
            self._array = drawable.vertex_array(self._program, self.over_screen)
            self._bind(naming)
        except InputError:
            self.release()
            raise
        self._unit_bytes = [np.int32(unit).tobytes() for unit in range(len(self._units))]

    def draw(
        self, inputs: FrameInputs, caches: CachePair | None, depth_test: str | None = None
    ) -> None:
        """Draw the object into the pass's targets; nothing is cleared.

        Args:
            caches: must be given if the pass reads or writes a cache.
            depth_test: a moderngl depth function in place of the manifest's.
        """
        targets = self._targets(caches)
        framebuffer = self._world.targets.framebuffer(targets, self._spec.depth_write)
        framebuffer.viewport = inputs.viewport
        framebuffer.use()
        test = depth_test or self._world.scene.engine.function(self._spec.depth_test)
        self._world.gpu.ctx.depth_func = test
        self._world.set_culling(self._drawable)
        self._load(inputs, caches)
        self._array.render(moderngl.TRIANGLES, 3 if self.over_screen else -1)

    def release(self) -> None:
        """Give the program back."""
        self._world.programs.release(self._program)

    def _load(self, inputs: FrameInputs, caches: CachePair | None) -> None:
        for uniform, name in self._now:
            uniform.write(uniform.encode(inputs.now[name], name))
        for uniform, name in self._before:
            uniform.write(uniform.encode(inputs.before[name], name))
        for uniform, role in self._numbers:
            uniform.write(uniform.encode(inputs.numbers[role], role))
        for unit, (uniform, source) in enumerate(self._units):
            texture = _cache_texture(source, caches) if isinstance(source, str) else source
            texture.use(unit)
            uniform.write(self._unit_bytes[unit])
        self._program.bind_blocks()

    def _targets(self, caches: CachePair | None) -> tuple[moderngl.Texture, ...]:
        made = self._world.targets
        by_name = {"color": made.color}
        if caches is not None:
            by_name |= dict(zip(CACHE_TARGETS, caches.current, strict=False))
        if "mask" in self._spec.targets:
            by_name["mask"] = made.mask
        return tuple(by_name[name] for name in self._spec.targets)

    def _bind(self, naming: Naming) -> None:
        problems: list[Diagnostic] = []
        for target in self._spec.targets:
            if target not in ("color", *CACHE_TARGETS, "mask"):
                problems.append(self._problem("SC525", f"has an unknown target {target!r}"))
        values = self._drawable.values(0)
        for name, uniform in self._program.uniforms.items():
            role = naming.roles.get(name)
            if uniform.sampler is not None:
                problems += self._bind_sampler(uniform, role)
            elif role is not None:
                problems += self._bind_role(uniform, role)
            else:
                problems += self._bind_value(uniform, naming.original(name), values)
        if problems:
            raise InputError(problems)

    def _bind_sampler(self, uniform: Uniform, role: str | None) -> list[Diagnostic]:
        if role is not None:
            if role not in CACHE_ROLES:
                return [self._problem("SC525", f"has a sampler of unknown role {role!r}")]
            self._units.append((uniform, role))
            return []
        texture = self._drawable.texture(uniform.name)
        if texture is None:
            hint = f"in the scene, add [textures.{uniform.name}] with a file"
            return [self._problem("SC522", f"needs the texture {uniform.name}", hint)]
        kind = texture_kind(texture)
        if kind != uniform.sampler:
            message = f"samples {uniform.name} as a {uniform.sampler}, but the scene has a {kind}"
            return [self._problem("SC523", message)]
        self._units.append((uniform, texture))
        return []

    def _bind_role(self, uniform: Uniform, role: str) -> list[Diagnostic]:
        if role not in NUMBER_ROLES:
            return [self._problem("SC525", f"has a uniform of unknown role {role!r}")]
        self._numbers.append((uniform, role))
        return []

    def _bind_value(self, uniform: Uniform, twin: str | None, values: Values) -> list[Diagnostic]:
        name = uniform.name if twin is None else twin
        if name not in values:
            if uniform.name in self._initialised:
                return []
            key = name if root_of(name) == name else f'"{name}"'
            hint = f"in the scene, under [uniforms], add: {key} = ..."
            return [self._problem("SC520", f"needs the uniform {name}", hint)]
        try:
            uniform.encode(values[name], f"{name} of {self._drawable.scene.path}")
        except InputError as error:
            return list(error.diagnostics)
        (self._now if twin is None else self._before).append((uniform, name))
        return []

    def _problem(self, code: str, what: str, hint: str | None = None) -> Diagnostic:
        place = Source(str(self._drawable.scene.path), "")
        return Diagnostic(code, f"{self._spec.fragment.name} {what}", place, hint=hint)


def _cache_texture(role: str, caches: CachePair | None) -> moderngl.Texture:
    assert caches is not None
    textures = caches.previous if role.startswith("previous") else caches.current
    return textures[1 if role.endswith("-2") else 0]
