"""One pass of the manifest bound to an object: its program, and where each input comes from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import moderngl
import numpy as np
from msgspec import UNSET
from numpy.typing import NDArray

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.gpu.cache_textures import CachePair
from shadercache.gpu.fractions import Viewport, divided
from shadercache.gpu.textures import GlTexture, texture_kind
from shadercache.gpu.uniform_blocks import Uniform
from shadercache.manifest.interface import UniformInput
from shadercache.render.bundle import Naming
from shadercache.render.drawable import Drawable, When
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import Values
from shadercache.scene.object_inputs import root_of

CACHE_ROLES = ("previous-cache", "current-cache", "previous-cache-2", "current-cache-2")
CACHE_TARGETS = ("cache", "cache-2")


@dataclass(frozen=True, slots=True)
class FrameInputs:
    """What the passes of one frame read: this and the last frame's uniforms, numbers by role.

    ``viewport``: left, bottom, width and height of what is drawn into, in pixels;
    ``previous_viewport`` those of the last frame.
    """

    now: Values
    before: Values
    numbers: Values
    viewport: Viewport
    previous_viewport: Viewport = (0, 0, 0, 0)

    def numbers_of(self, divisor: int) -> Values:
        """The numbers for a pass into targets that are so many times smaller."""
        if divisor == 1 or "viewport" not in self.numbers:
            return self.numbers
        both = {"viewport": self.viewport, "previous-viewport": self.previous_viewport}
        told = {name: np.array(divided(it, divisor), np.float64) for name, it in both.items()}
        return {**self.numbers, **told}


def plain_inputs(
    world: RenderScene, drawable: Drawable, frame: int, jittered: int | None = None
) -> FrameInputs:
    """What a program reads that looks nothing up; ``jittered`` as in ``Drawable.values``."""
    values = drawable.values(frame, jittered)
    return FrameInputs(values, values, object_numbers(drawable), world.viewport(frame))


def object_numbers(drawable: Drawable) -> dict[str, NDArray[np.float64]]:
    """The numbers that are an object's own, by role."""
    return {
        "object": np.array([drawable.number], np.float64),
        "mask": np.array([drawable.scene_object.caching.mask], np.float64),
    }


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
                a texture, SC523 a value of a wrong size, SC525 a role that does not fit, SC602 the
                driver refuses.
        """
        self.name, self.over_screen = spec.name, spec.draws != "objects"
        self.in_groups, self.marks = spec.draws == "groups", not spec.targets
        self._world, self._drawable, self._spec = world, drawable, spec
        self._values: list[tuple[Uniform, Literal["now", "before", "numbers"], str]] = []
        self._units: list[GlTexture | str] = []
        self._samplers: list[tuple[Uniform, bytes]] = []
        self._images: list[GlTexture] = []
        self._storage: list[tuple[moderngl.Buffer, int]] = []
        if spec.colors:
            world.targets.outputs = spec.colors
        self._program = world.programs.acquire(
            spec.vertex, spec.fragment, spec.inputs, captured, spec.locations
        )
        try:
            twins = naming.twins
            self._array = drawable.vertex_array(self._program, twins, self.over_screen)
            self._streams: list[tuple[str, When]] = [
                (twins.get(name, name), "before" if name in twins else "now")
                for name in self._program.attributes
                if twins.get(name, name) in drawable.instances.streams
            ]
            self._bind(naming)
        # There will be no pass by which the caller could give the program back.
        except InputError:
            self.release()
            raise

    def draw(
        self, inputs: FrameInputs, caches: CachePair | None, depth_test: str | None = None
    ) -> None:
        """Draw the object into the pass's targets; nothing is cleared.

        Args:
            caches: must be given if the pass reads or writes a cache.
            depth_test: a moderngl depth function in place of the manifest's.
        """
        targets = self._targets(caches)
        spec, engine = self._spec, self._world.scene.view.engine
        framebuffer = self._world.targets.framebuffer(targets, spec.depth.write, spec.depth.buffer)
        # Views and frames share framebuffers, and may have viewports of their own.
        framebuffer.viewport = divided(inputs.viewport, self._spec.divisor)
        framebuffer.use()
        marks = spec.depth.buffer == "marks"
        own = spec.depth.test if marks else engine.function(spec.depth.test)
        context = self._world.gpu.ctx
        context.depth_func = depth_test or own
        self._world.set_culling(self._drawable)
        self._load(inputs, caches)
        # An offset would move what is drawn, and not the depths that a shader writes.
        offset = marks and any(engine.offset)
        if offset:
            context.polygon_offset = (0.0, 0.0)
        if self.over_screen:
            self._array.render(moderngl.TRIANGLES, 3)
        else:
            self._array.render(moderngl.TRIANGLES, instances=self._drawable.instances.number)
        if offset:
            context.polygon_offset = engine.offset

    def key(self, inputs: FrameInputs) -> tuple[object, ...]:
        """What it reads but for the group's number: draws are of one group where that is equal."""
        values = (
            np.asarray(getattr(inputs, table)[name]).tobytes()
            for _, table, name in self._values
            if name != "group"
        )
        return (self._program, inputs.viewport, *values, *self._units, *self._images)

    def release(self) -> None:
        """Give the program back."""
        self._world.programs.release(self._program)

    def _load(self, inputs: FrameInputs, caches: CachePair | None) -> None:
        tables = {"now": inputs.now, "before": inputs.before}
        tables["numbers"] = inputs.numbers_of(self._spec.divisor)
        for uniform, table, name in self._values:
            uniform.write(uniform.encode(tables[table][name], name))
        for unit, source in enumerate(self._units):
            # Caches swap with each frame, so their textures are found by role in each draw.
            texture = self._texture(source, caches) if isinstance(source, str) else source
            texture.use(unit)
        for unit, image in enumerate(self._images):
            image.bind_to_image(unit, read=True, write=False)
        for uniform, units in self._samplers:
            uniform.write(units)
        for buffer, binding in self._storage:
            buffer.bind_to_storage_buffer(binding)
        for name, when in self._streams:
            self._drawable.streamed(name, when).hold(tables[when][name])
        self._program.bind_blocks()

    def _texture(self, role: str, caches: CachePair | None) -> moderngl.Texture:
        """What a role stands for in this frame."""
        if role in self._spec.parked:
            return self._world.targets.parked(role, self._spec.parked[role])
        return _cache_texture(role, caches)

    def _targets(self, caches: CachePair | None) -> tuple[moderngl.Texture, ...]:
        shared = self._world.targets
        by_name = {"color": shared.color}
        by_name |= {color.name: shared.output(color) for color in self._spec.colors}
        if caches is not None:
            # A cache has one texture or two.
            by_name |= dict(zip(CACHE_TARGETS, caches.current, strict=False))
        if "mask" in self._spec.targets:
            by_name["mask"] = shared.mask_of(self._spec.divisor)
        for name in self._spec.targets:
            if name in self._spec.parked:
                by_name[name] = shared.parked(name, self._spec.parked[name])
        return tuple(by_name[name] for name in self._spec.targets)

    def _bind(self, naming: Naming) -> None:
        problems: list[Diagnostic] = []
        # Names and sizes are the same in all frames, so one of them shows what is missing.
        values = self._drawable.values(0)
        for name, uniform in self._program.uniforms.items():
            try:
                if name in naming.roles:
                    self._bind_role(uniform, naming.roles[name])
                elif uniform.sampler is not None or uniform.image is not None:
                    self._bind_texture(uniform, naming.original(name) or name)
                else:
                    self._bind_value(uniform, naming.original(name), values)
            except InputError as error:
                problems += error.diagnostics
        for name, binding in self._program.storage.items():
            try:
                twin_of = naming.original(name)
                buffer = self._buffer(twin_of or name, "before" if twin_of else "now")
                self._storage.append((buffer, binding))
            except InputError as error:
                problems += error.diagnostics
        if problems:
            raise InputError(problems)

    def _buffer(self, block: str, when: When) -> moderngl.Buffer:
        buffer = self._drawable.storage(block)
        if buffer is None and block in self._drawable.scene_object.inputs.played:
            self._streams.append((block, when))
            target = self._drawable.streamed(block, when).target
            if isinstance(target, moderngl.Buffer):
                return target
        if buffer is None:
            entry = f'{block} = {{ table = "FILE.npz", array = "NAME" }}'
            hint = f"in the scene, under [buffers], add: {entry}"
            raise self._problem("SC526", f"needs the storage buffer {block}", hint)
        return buffer

    def _bind_role(self, uniform: Uniform, role: str) -> None:
        sampled = (*CACHE_ROLES, *self._spec.parked)
        if (role in sampled) != (uniform.sampler is not None):
            hint = f"samplers have one of the roles {', '.join(sampled)}"
            raise self._problem("SC525", f"has {uniform.name} of the role {role}", hint)
        if uniform.sampler is None:
            self._values.append((uniform, "numbers", role))
        else:
            self._sample(uniform, [role])

    def _bind_texture(self, uniform: Uniform, name: str) -> None:
        each = [f"{name}[{at}]" for at in range(uniform.count)] if uniform.is_array else [name]
        found = [self._found(one, uniform, uniform.name != name) for one in each]
        if uniform.image is None:
            self._sample(uniform, found)
        else:  # images have units of their own
            units = np.arange(len(self._images), len(self._images) + len(found), dtype=np.int32)
            self._images += found
            self._samplers.append((uniform, units.tobytes()))

    def _found(self, name: str, uniform: Uniform, is_twin: bool) -> GlTexture:
        texture = self._drawable.texture(name)
        if texture is None and name in self._drawable.scene_object.inputs.played:
            when: When = "before" if is_twin else "now"
            self._streams.append((name, when))
            target = self._drawable.streamed(name, when).target
            texture = target if isinstance(target, moderngl.Texture) else None
        if texture is None:
            key = f'"{name}"' if "[" in name else name
            hint = f"in the scene, add [textures.{key}] with a file"
            raise self._problem("SC522", f"needs the texture {name}", hint)
        kind, wanted = texture_kind(texture), uniform.sampler or uniform.image
        if kind != wanted:
            what = f"samples {name} as a {wanted}, but the scene has a {kind}"
            raise self._problem("SC523", what)
        return texture

    def _sample(self, uniform: Uniform, sources: Sequence[GlTexture | str]) -> None:
        """Texture units, one behind the other, for a sampler or for an array of them."""
        units = np.arange(len(self._units), len(self._units) + len(sources), dtype=np.int32)
        self._units += sources
        self._samplers.append((uniform, units.tobytes()))

    def _bind_value(self, uniform: Uniform, twin_of: str | None, values: Values) -> None:
        name = twin_of or uniform.name
        if name in values:
            # For its error alone, so that a wrong size is told before anything is drawn.
            uniform.encode(values[name], f"{name} of {self._drawable.scene.path}")
            self._values.append((uniform, "before" if twin_of else "now", name))
            return
        # A uniform with an initialiser has that value from linking on (GLSL 4.60 section 4.3.5).
        initialised = (
            entry.name == uniform.name and entry.default is not UNSET
            for entry in self._spec.inputs
            if isinstance(entry, UniformInput)
        )
        if not any(initialised):
            key = name if root_of(name) == name else f'"{name}"'
            hint = f"in the scene, under [uniforms], add: {key} = ..."
            raise self._problem("SC520", f"needs the uniform {name}", hint)

    def _problem(self, code: str, what: str, hint: str | None = None) -> InputError:
        return self._drawable.problem(code, f"{self._spec.fragment.name} {what}", hint)


def _cache_texture(role: str, caches: CachePair | None) -> moderngl.Texture:
    assert caches is not None
    textures = caches.previous if role.startswith("previous") else caches.current
    return textures[1 if role.endswith("-2") else 0]
