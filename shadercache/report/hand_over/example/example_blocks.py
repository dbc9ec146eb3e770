"""Blocks of an example's code that scenes of one object and of several share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files

from shadercache.diagnostics import shortened
from shadercache.gpu.fractions import divided_size
from shadercache.manifest.interface import InputEntry, UniformBlockInput, UniformInput
from shadercache.report.hand_over.example.code_lines import WIDEST, spread
from shadercache.report.hand_over.example.example_data import ExampleData
from shadercache.report.hand_over.example.example_passes import added_values
from shadercache.report.hand_over.example.example_targets import ExampleTargets, variable
from shadercache.report.hand_over.example.example_textures import texture_table
from shadercache.report.hand_over.example.example_values import declared, twin_names
from shadercache.report.hand_over.frame_order import PassStep, steps_of
from shadercache.report.hand_over.handed_shaders import HandedShader
from shadercache.scene.description import Scene

_SEAMLESS = "ctx.enable_direct(0x884F)  # GL_TEXTURE_CUBE_MAP_SEAMLESS"


def template(name: str) -> str:
    """The text of a template of this package."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


@dataclass(frozen=True, eq=False)
class ExampleBlocks:
    """What the shaders of a scene and its data decide of the text; ``note``: a line of it."""

    scene: Scene
    shaders: Sequence[HandedShader]
    data: ExampleData
    note: str = ""

    @cached_property
    def targets(self) -> ExampleTargets:
        """The targets of all passes."""
        return ExampleTargets(self.shaders)

    @cached_property
    def steps(self) -> list[PassStep]:
        """The passes of a frame, in order."""
        return steps_of(self.shaders)

    @cached_property
    def cached(self) -> HandedShader:
        """The first shader that is cached."""
        return next(shader for shader in self.shaders if shader.variant)

    @cached_property
    def added(self) -> dict[str, str]:
        """What the added uniforms are set to, as code."""
        return added_values(self.shaders, self.scene)

    @cached_property
    def inputs(self) -> dict[str, InputEntry]:
        """What programs declare of what the engine gives, and the twins."""
        return {
            entry.name: entry
            for shader in self.shaders
            for entry in shader.inputs
            if entry.name in declared(shader)
        }

    @cached_property
    def twins(self) -> dict[str, str]:
        """Twin -> what it is that of, of all that has values."""
        names = {
            key.rpartition("/")[2]
            for key in self.data.arrays
            if key.startswith(("values/", "moving/"))
        }
        return {
            twin: name
            for shader in self.shaders
            for twin, name in twin_names(shader, sorted(names)).items()
        }

    @cached_property
    def blocks(self) -> list[str]:
        """The uniform blocks, twins among them."""
        inputs = self.inputs.values()
        return [entry.name for entry in inputs if isinstance(entry, UniformBlockInput)]

    @property
    def arrays(self) -> bool:
        """Are there arrays among the uniforms, of which a driver may drop the end?"""
        inputs = self.inputs.values()
        return any(isinstance(entry, UniformInput) and entry.dims for entry in inputs)

    def title(self) -> str:
        """What the example shows."""
        variant = self.cached.variant
        assert variant is not None
        others = len([shader for shader in self.shaders if shader.variant]) - 1
        more = f", and {others} more" if others else ""
        head = f"{variant.source.fragment.name} with "
        tail = f" cached ({variant.variants[0].algorithm}){more}, in moderngl."
        text = " ".join(" + ".join(node.text for node in variant.nodes).split())
        text = text.replace("\\", "/").replace('"', "'")
        return head + shortened(text, max(WIDEST - 4 - len(head + tail), 20)) + tail

    def about(self) -> str:
        """What else is to be known of it, on lines of a docstring."""
        shrunk = {key: one.shrunk for key, one in self.data.textures.items() if one.shrunk > 1}
        told = [f"{key} is {times} times smaller than yours" for key, times in shrunk.items()]
        small = f"\nTo keep example.npz small {', '.join(told)}, in each direction." if told else ""
        return self.note + small

    def constants(self, code: str) -> list[str]:
        """Sizes, and the numbers that ``code`` has; behind the folder and the number of frames."""
        size, divisor = self.data.size, self.targets.divisor
        lines = [f"SIZE = Path(__file__).parent, {self.data.frames}, {size}"]
        if divisor > 1:
            lines = [f"{lines[0]}, {divided_size(size, divisor)}".replace("SIZE", "SIZE, SMALL")]
        chosen = self.cached.configuration.refresh
        if "BLOCK" in code:
            numbers = f"PERIOD, BLOCK = {chosen.period}, {chosen.block}"
            lines.append(f"{numbers}  # frames between refreshes; the edge of squares in pixels")
        elif "PERIOD" in code:
            lines.append(f"PERIOD = {chosen.period}  # frames between refreshes")
        resets = ", ".join(map(str, self.data.resets))
        if resets != "0":
            lines.append(f"RESETS = {{{resets}}}  # frames that reuse nothing: the first, and cuts")
        return lines

    @property
    def resets(self) -> str:
        """Does a frame reuse nothing? As code."""
        return "frame == 0" if self.data.resets == (0,) else "frame in RESETS"

    def context(self) -> list[str]:
        """The state that is the same in all draws."""
        culls = {part.cull for part in self.scene.parts}
        flags = " | moderngl.CULL_FACE" if culls == {True} else ""
        lines = [f"ctx.enable_only(moderngl.DEPTH_TEST{flags})"]
        cubes = any(texture.what == "faces" for texture in self.data.textures.values())
        return [*lines, *[_SEAMLESS] * cubes]

    def textures(self) -> list[str]:
        """The engine's textures."""
        return texture_table(self.data.textures) if self.data.textures else []

    def sampled(self) -> str:
        """What programs may sample, as code."""
        return "(TEXTURES | textures)" if self.data.textures else "textures"

    def binding(self, textures: str, moving: bool) -> list[str]:
        """What gives a program its textures and uniforms; ``moving``: are there values for
        buffers?"""
        names = "(values.keys() - set(MOVING))" if moving else "values.keys()"
        lines = [
            f"for unit, (sampler, texture) in enumerate({textures}.items()):",
            "    if sampler in made:",
            "        texture.use(unit)",
            "        made[sampler].value = unit",
            f"for uniform in {names} & set(made):",
        ]
        if self.arrays:
            lines.append("    size = made[uniform].dimension * made[uniform].array_length")
            return [*lines, "    made[uniform].write(np.ravel(values[uniform])[:size].tobytes())"]
        return [*lines, "    made[uniform].write(values[uniform].tobytes())"]

    def outputs(self) -> str:
        """What places outputs that have no place in the text."""
        outputs = self.cached.manifest.outputs
        if len(outputs) == 1:
            return ""
        places = ", ".join(f'"{output.output}": {output.location}' for output in outputs)
        return f", fragment_outputs={{{places}}}"

    def picture(self) -> dict[str, str]:
        """What reads the picture that people look at, and makes bytes of it."""
        shown = self.targets.shown
        kind, made = "uint8", ""
        if shown.base != "float":
            kind, made = "uint32", ".astype(np.uint8)"
        elif shown.name != "color":
            kind, made = "float16", ".clip(0, 255).astype(np.uint8)"
        read = f"np.frombuffer(picture, np.{kind}).reshape(*SIZE[::-1], {shown.stored})"
        if kind == "float16":
            read = f"255 * {read}"
        return {"shown": variable(shown.name), "picture": read, "bytes": made}

    def clears(self) -> list[str]:
        """What a frame begins with."""
        return [*self.targets.cleared(), *self.targets.cleared_caches()]


def filled(lines: Sequence[str], indent: int = 0) -> str:
    """Lines as a block of a template."""
    return "\n".join(" " * indent + line if line else "" for line in lines)


def entries(head: str, table: dict[str, str], tail: str, indent: int = 0) -> list[str]:
    """A dictionary as lines of code."""
    return spread(head, (f'"{key}": {value}' for key, value in table.items()), tail, indent)
