"""The targets of an example's code: what is made at its top, and what passes call it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from msgspec import UNSET

from shadercache.caching.algorithms import PARKED
from shadercache.gpu.color_targets import ColorTarget, first_seen, output_kind
from shadercache.manifest.kinds import TargetName
from shadercache.manifest.model import Manifest
from shadercache.manifest.pass_model import PassEntry
from shadercache.report.hand_over.example.code_lines import WIDEST, spread
from shadercache.report.hand_over.handed_shaders import HandedShader

_KINDS = {"16f": "f2", "32f": "f4", "32ui": "u4"}
_INTEGERS = {"int": "i4", "uint": "u4"}
_VARIABLES = {
    **{"cache": "current", "cache-2": "current_2"},
    **{"previous-cache": "previous", "previous-cache-2": "previous_2"},
    **{"current-cache": "current", "current-cache-2": "current_2"},
}


class _CacheLayer(NamedTuple):
    """A texture of a cache, and what it is cleared to."""

    form: str
    clear: tuple[float, ...]

    @property
    def channels(self) -> int:
        return len(self.form.rstrip("0123456789fui"))

    def made(self, size: str) -> str:
        kind = _KINDS[self.form[self.channels :]]
        return f'texture({size}, {self.channels}, "{kind}")'

    def cleared(self, name: str) -> str:
        """The code that does it: what glClear does to integers is undefined."""
        if self.form.endswith("ui"):
            texel = ", ".join(str(int(value)) for value in self.clear[: self.channels])
            return f"{name}.write(np.tile(np.uint32([{texel}]), {name}.width * {name}.height))"
        texel = ", ".join(map(repr, self.clear)) if any(self.clear) else ""
        return f"framebuffer(None, {name}).clear({texel})"


def variable(name: str) -> str:
    """The variable of a target, or of what is read."""
    return _VARIABLES.get(name, name.replace("-", "_"))


@dataclass(frozen=True, eq=False)
class ExampleTargets:
    """The targets that all shaders of a scene share."""

    shaders: Sequence[HandedShader]

    @property
    def manifest(self) -> Manifest:
        """One that tells of the cache, which is the same in all."""
        return next(shader.variant for shader in self.shaders if shader.variant)

    @property
    def divisor(self) -> int:
        """How many times smaller than the picture the cache is, in each direction."""
        return self.manifest.targets["cache"].divisor

    @property
    def colors(self) -> dict[str, ColorTarget]:
        """The targets of outputs, by their names."""
        outputs = (output for shader in self.shaders for output in shader.manifest.outputs)
        return {
            name: ColorTarget(name, *output_kind(output.type), output.output)
            for output in outputs
            for name in output.targets
        }

    @property
    def shown(self) -> ColorTarget:
        """The one that people look at."""
        colors = list(self.colors.values())
        return colors[first_seen(colors)]

    @property
    def two(self) -> bool:
        """Has a cache two textures?"""
        return self.manifest.cache.second is not UNSET

    @property
    def marks(self) -> bool:
        """Is there a depth buffer of marks?"""
        return any(one.depth.buffer == "marks" for shader in self.shaders for one in shader.passes)

    def lines(self) -> list[str]:
        """What makes them."""
        size = "SMALL" if self.divisor > 1 else "SIZE"
        targets = {
            variable(name): f'texture(SIZE, {color.stored}, "{_kind(color)}")'
            for name, color in self.colors.items()
        }
        depths = {"depth": "SIZE", "small_depth": "SMALL", "marks": "SIZE"}
        wanted = ["depth", *["small_depth"] * (self.divisor > 1), *["marks"] * self.marks]
        buffers = {name: f"ctx.depth_renderbuffer({depths[name]})" for name in wanted}
        made = _assigned({**targets, **buffers})
        layers = [layer.made(size) for layer in self._layers]
        one = f"({', '.join(layers)})" if self.two else layers[0]
        made.append(f"caches = [{one} for _ in range(2)]  # they swap")
        for shader in self.shaders:
            if self._parked(shader):
                lines = spread(f"{self.parked(shader)} = {{", self._parked(shader), "}")
                made += [] if lines[0] in made else lines
        return made

    def parked(self, shader: HandedShader) -> str:
        """The variable of what a shader parks."""
        different = list(dict.fromkeys(filter(None, map(self._parked, self.shaders))))
        at = different.index(self._parked(shader)) + 1
        return f"{PARKED}_{at}" if len(different) > 1 else PARKED

    def attached(self, shader: HandedShader, entry: PassEntry) -> list[str]:
        """What is bound at the colour attachments of a pass."""
        names = [variable(name) for name in entry.targets if not name.startswith(PARKED)]
        if len(names) < len(entry.targets):
            names.append(f"*{self.parked(shader)}.values()")
        return names

    def swapped(self) -> str:
        """What the caches of a frame are called."""
        if self.two:
            return "((previous, previous_2), (current, current_2))"
        return "(previous, current)"

    def cleared(self) -> list[str]:
        """What clears the picture and its depth."""
        floats = [variable(name) for name, one in self.colors.items() if one.base == "float"]
        lines = [f"framebuffer({', '.join(['depth', *floats])}).clear()"]
        for name, color in self.colors.items():
            if color.base != "float":
                lines.append(
                    f"{variable(name)}.write(bytes({4 * color.stored} * SIZE[0] * SIZE[1]))"
                )
        return lines

    def cleared_caches(self) -> list[str]:
        """What clears the cache of a frame, or both where ``reset`` says so."""
        lines = ["framebuffer(small_depth).clear()"] if self.divisor > 1 else []
        lines.append("for held in caches if reset else caches[1:]:")
        names = ["held[0]", "held[1]"] if self.two else ["held"]
        cleared = (one.cleared(name) for one, name in zip(self._layers, names, strict=True))
        return [*lines, *(f"    {line}" for line in cleared)]

    @property
    def _layers(self) -> list[_CacheLayer]:
        cache = self.manifest.cache
        first = _CacheLayer(cache.format, cache.clear)
        if cache.second is UNSET:
            return [first]
        return [first, _CacheLayer(cache.second.format, cache.second.clear)]

    def _parked(self, shader: HandedShader) -> tuple[str, ...]:
        """The textures that a shader parks in, by the uniforms that read them, as code."""
        if shader.variant is None:
            return ()
        return tuple(
            f'"{_sampler(shader.variant, name)}": {_CacheLayer(target.format, ()).made("SIZE")}'
            for name, target in shader.variant.targets.items()
            if name.startswith(PARKED) and target.format is not None
        )


def _assigned(variables: Mapping[str, str]) -> list[str]:
    """Variables with what they are, as many on a line as fit."""
    lines, names = [""], list[str]()
    for name in variables:
        longer = [*names, name]
        line = f"{', '.join(longer)} = {', '.join(variables[one] for one in longer)}"
        if len(line) > WIDEST and names:
            lines.append("")
            longer, line = [name], f"{name} = {variables[name]}"
        lines[-1], names = line, longer
    return lines


def _sampler(manifest: Manifest, parked: TargetName) -> str:
    """The uniform that reads what is parked."""
    return next(one.name for one in manifest.uniforms if one.role == parked)


def _kind(color: ColorTarget) -> str:
    # As the harness has them: 8 bits for what is shown, halves for what else there is.
    floats = "f1" if color.name == "color" else "f2"
    return _INTEGERS.get(color.base, floats)
