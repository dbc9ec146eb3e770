"""The text of example.py for a scene of several objects: each pass draws those of a shader."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from string import Template

from shadercache.manifest.interface import AttributeInput, SamplerInput
from shadercache.report.hand_over.example.code_lines import INNER, WIDEST, call, spread
from shadercache.report.hand_over.example.example_blocks import (
    ExampleBlocks,
    entries,
    filled,
    template,
)
from shadercache.report.hand_over.example.example_data import ExampleObject, UnfitForExampleError
from shadercache.report.hand_over.example.example_passes import arguments_of, comment_of
from shadercache.report.hand_over.example.example_targets import variable
from shadercache.report.hand_over.example.example_textures import texture_function
from shadercache.report.hand_over.example.own_values import has_own_periods
from shadercache.report.hand_over.frame_order import PassStep
from shadercache.report.hand_over.handed_shaders import HandedShader

_UNLESS = "if not reset:"
MOST_LINES = 120
"""Lines that an example stays below."""

_MOVING = "cache(lambda mesh, name, size: ctx.buffer(reserve=size))"


@dataclass(frozen=True, eq=False)
class SeveralObjects:
    """What the text depends on. ``comments``: does each pass have one?"""

    blocks: ExampleBlocks
    comments: bool

    @property
    def items(self) -> list[ExampleObject]:
        """All objects."""
        objects = self.blocks.data.objects
        return [item for shader in self.blocks.shaders for item in objects[shader]]

    @property
    def culls(self) -> bool:
        """Do objects differ in whether back faces are drawn?"""
        return len({item.given.part.cull for item in self.items}) > 1

    @property
    def goes(self) -> bool:
        """Do objects come and go?"""
        return not self.blocks.data.all_there

    @property
    def screen(self) -> bool:
        """Are there passes over the screen?"""
        return any(step.over_screen for step in self.blocks.steps)

    @property
    def renames(self) -> bool:
        """Have objects textures that have another name in the file?"""
        return any(map(_renamed, self.items))

    @property
    def moving(self) -> list[str]:
        """What values are written to buffers, by name: attributes of instances, uniform blocks.

        Raises :class:`UnfitForExampleError` for textures that change with each frame.
        """
        moving = {name for item in self.items for name in item.moving}
        found = list(self.blocks.blocks)
        for name, entry in self.blocks.inputs.items():
            if self.blocks.twins.get(name, name) in moving:
                if isinstance(entry, SamplerInput):
                    raise UnfitForExampleError(f"{name} is a texture that changes with each frame")
                found.append(name)
        return found

    def text(self) -> str:
        """The text. Raises as :attr:`moving`, and for shaders of different outputs."""
        blocks, data = self.blocks, self.blocks.data
        kinds = {array.dtype.kind for key, array in data.arrays.items() if key.startswith("mesh ")}
        texts = {
            "title": blocks.title(),
            "about": blocks.about(),
            "constants": filled(blocks.constants(self._uses())),
            "context": filled(blocks.context()),
            "kind": "f" if kinds == {"f"} else "{DATA[name].dtype.kind}",
            "texture": filled(texture_function(data.textures.values())),
            "targets": filled(blocks.targets.lines()),
            "things": ", ".join(self._fields()),
            "inputs": filled([*blocks.textures(), *self._things(), *self._tables()]),
            "presence": filled(self._presence()),
            "outputs": blocks.outputs(),
            "vertices": filled(self._vertices(), 4),
            "values": filled(self._values(), 4),
            "thing": ", ".join(self._fields()),
            "binding": filled(
                [*self._written(), *blocks.binding(self._textures(), bool(self.moving))], 8
            ),
            "count": "vertices=-1 if array.index_buffer else 3" if self.screen else "",
            "frame": filled(self._frame(), 4),
            "original": filled(self._original(), 4),
            **blocks.picture(),
        }
        return Template(template("example_several.py.txt")).substitute(texts)

    def _uses(self) -> str:
        """The code that uses constants."""
        return " ".join(self._values())

    def _textures(self) -> str:
        """What an object's programs may sample, as code."""
        return "given" if self.renames else self.blocks.sampled()

    def _fields(self) -> list[str]:
        """What is told of each object."""
        more = [*["culls"] * self.culls, *["own"] * self.renames]
        return ["folder", "row", "mesh", *more]

    def _things(self) -> list[str]:
        """The objects of each shader."""
        told: dict[str, list[str]] = {}
        for shader in self.blocks.shaders:
            items = list(enumerate(self.blocks.data.objects[shader]))
            for cached in (True, False):
                rows = [row for row in items if (row[1].given.configuration is not None) == cached]
                if rows:
                    told[key_of(shader, cached)] = self._runs(shader, rows)
        if len(told) == 1:
            [(key, parts)] = told.items()
            return spread(f'ALL = {{"{key}": [', parts, "]}")
        listed = (spread(f'"{key}": [', parts, "],", 4) for key, parts in told.items())
        return ["ALL = {", *(line for each in listed for line in each), "}"]

    def _runs(self, shader: HandedShader, rows: Sequence[tuple[int, ExampleObject]]) -> list[str]:
        """Objects as code; those that differ in nothing but their row as one."""
        parts: list[str] = []
        for what, group in groupby(rows, lambda row: self._told(row[1])):
            numbers = [row for row, _ in group]
            if len(numbers) > 2 and numbers[-1] - numbers[0] == len(numbers) - 1:
                one = f'("{shader.folder}", row, {what})'
                span = f"{numbers[0]}, {numbers[-1] + 1}" if numbers[0] else f"{numbers[-1] + 1}"
                parts.append(f"*({one} for row in range({span}))")
            else:
                parts += [f'("{shader.folder}", {row}, {what})' for row in numbers]
        return parts

    def _told(self, item: ExampleObject) -> str:
        """What is told of an object behind its row."""
        told = [f'"{item.mesh}"', *[str(item.given.part.cull)] * self.culls]
        own = ", ".join(f'"{name}": "{key}"' for name, key in _renamed(item).items())
        return ", ".join([*told, *[f"{{{own}}}"] * self.renames])

    def _tables(self) -> list[str]:
        """Values, and the buffers of what changes beside uniforms."""
        twins = {twin: f'"{name}"' for twin, name in self.blocks.twins.items()}
        if self._before is None:
            lines = entries("TWINS = {", twins, "}")
        else:
            lines = spread("TWINS = [", twins.values(), "]")
        if self.moving:
            lines.append(f"moving = {_MOVING}  # to be written for each draw")
            lines += spread("MOVING = {", (f'"{name}"' for name in self.moving), "}")
        return lines

    @property
    def _before(self) -> str | None:
        """What the name of every twin has in front of the other's, where that is all to be known
        of twins."""
        found = {twin.removesuffix(name) for twin, name in self.blocks.twins.items()}
        return found.pop() if len(found) == 1 and not self.moving else None

    def _vertices(self) -> list[str]:
        """What a program draws."""
        lines: list[str] = []
        inputs = self.blocks.inputs
        names = [name for name in self.moving if isinstance(inputs[name], AttributeInput)]
        if names:
            told = ", ".join(f'"{name}"' for name in names)
            lines += [
                f"for one in {{{told}}} & set(made):",
                '    one_frame = DATA[f"moving/{mesh}/{TWINS.get(one, one)}"][0, 0]',
                '    form = f"{one_frame.shape[-1]}f/i"',
                "    content.append((moving(mesh, one, one_frame.nbytes), form, one))",
            ]
        index = 'buffer(f"index/{mesh}")[0]' + (" if content else None" if self.screen else "")
        counts = {item.mesh: item.given.part.inputs.instances.number for item in self.items}
        many = {mesh: str(count) for mesh, count in counts.items() if count > 1}
        if not many:
            return [*lines, f"return made, ctx.vertex_array(made, content, {index})"]
        table = ", ".join(f'"{mesh}": {count}' for mesh, count in many.items())
        number = f"{{{table}}}.get(mesh, 1)" + (" if content else 1" if self.screen else "")
        return [
            *lines,
            f"array = ctx.vertex_array(made, content, {index})",
            f"array.instances = {number}",
            "return made, array",
        ]

    def _presence(self) -> list[str]:
        """A function that tells which objects there are, where some come and go."""
        if not self.goes:
            return []
        found = 'DATA["there/" + one[0]][one[1], at] for at in frames'
        return [
            "def shown(things, *frames):  # those that are there in all of these frames",
            f"    return [one for one in things if all({found})]",
            *[""] * 3,
        ]

    def _values(self) -> list[str]:
        """The values of an object."""
        added, blocks = dict(self.blocks.added), self.blocks
        for shader in blocks.shaders:
            roles = {one.role: one.name for one in shader.added}
            if has_own_periods(blocks.shaders) and "clock" in roles:
                added[roles["clock"]] = f'np.int32(frame % now.get("{roles["period"]}", 1))'
        # What is the same in all frames stands in the file.
        known = {key.rpartition("/")[2] for key in self.blocks.data.arrays}
        added = {
            name: code
            for name, code in added.items()
            if name not in known or "frame" in code or "reset" in code
        }
        start = '("values/" + folder, f"moving/{mesh}/")' if self.moving else '"values/" + folder'
        keys = f"key in DATA if key.startswith({start})"
        lines = [f'tables = {{key.rpartition("/")[2]: DATA[key] for {keys}}}']
        if len(lines[0]) > WIDEST - INNER:
            lines = [f"keys = [key for {keys}]"]
            lines.append('tables = {key.rpartition("/")[2]: DATA[key] for key in keys}')
        lines += [
            "now = {one: t[row % len(t), frame % t.shape[1]] for one, t in tables.items()}",
            "last = {one: t[row % len(t), (frame - 1) % t.shape[1]] for one, t in tables.items()}",
        ]
        if any("reset" in value for value in added.values()):
            if self.goes:
                lines.append(
                    f'reset = {blocks.resets} or not DATA["there/" + folder][row, frame - 1]'
                )
            else:
                added = {one: code.replace("reset", blocks.resets) for one, code in added.items()}
        twins = "{twin: last[one] for twin, one in TWINS.items() if one in last}"
        if self._before is not None:
            twins = f'{{f"{self._before}{{one}}": last[one] for one in TWINS if one in last}}'
        return [*lines, f"twins = {twins}", *entries("return now | twins | {", added, "}")]

    def _written(self) -> list[str]:
        """What fills and binds buffers, and sets what differs between objects."""
        lines = []
        if self.culls:
            lines.append("(ctx.enable if culls else ctx.disable)(moderngl.CULL_FACE)")
        if self.moving:
            lines += [
                "for one in MOVING & values.keys():",
                "    moving(mesh, one, values[one].nbytes).write(values[one].tobytes())",
            ]
        if self.blocks.blocks:
            names = ", ".join(f'"{name}"' for name in self.blocks.blocks)
            lines += [
                f"for point, one in enumerate([{names}]):",
                "    if one in made:",
                "        made[one].binding = point",
                "        moving(mesh, one, values[one].nbytes).bind_to_uniform_block(point)",
            ]
        if self.renames:
            lines.append(
                "given = TEXTURES | {one: TEXTURES[key] for one, key in own.items()} | textures"
            )
        return lines

    def _frame(self) -> list[str]:
        """A frame by the variants."""
        blocks = self.blocks
        lines = [f"reset, {blocks.targets.swapped()} = {blocks.resets}, caches", *blocks.clears()]
        said, before = set[str](), ""
        for step in blocks.steps:
            notes = [comment_of(step)] * self.comments
            if not step.entry.depth.write:
                place = ", ".join(["marks", *blocks.targets.attached(step.shader, step.entry)])
                notes.append(f"framebuffer({place}).depth_mask = False")
            lines += [note for note in notes if note not in said]
            said.update(notes)
            given = [f'"{step.program}"', self._drawn(step), "frame"]
            given += arguments_of(step, blocks.targets)
            if step.entry.on_reset:
                lines += call("draw(", given)
            else:
                lines += [*[_UNLESS] * (before != _UNLESS), *call("draw(", given, 4)]
            before = "" if step.entry.on_reset else _UNLESS
        return [*lines, "caches.reverse()"]

    def _drawn(self, step: PassStep) -> str:
        """The objects that a step draws, as code."""
        things = f'ALL["{key_of(step.shader, step.cached)}"]'
        if step.over_screen:
            rows = self._first_of_groups(step)
            if rows == [0]:
                return f"{things}[:1]"
            return f"[{things}[at] for at in {rows}]"
        if self.goes:
            frames = "frame" if step.entry.on_reset else "frame - 1, frame"
            return f"shown({things}, {frames})"
        return things

    def _first_of_groups(self, step: PassStep) -> list[int]:
        """The first object of each group, or of all, by their places among those cached."""
        if step.entry.draws == "screen":
            return [0]
        numbers = [
            number
            for number, item in zip(
                self.blocks.data.groups[step.shader], step.shader.objects, strict=True
            )
            if item.configuration is not None
        ]
        return [at for at, number in enumerate(numbers) if number not in numbers[:at]]

    def _original(self) -> list[str]:
        """All objects by their originals."""
        [colors, *others] = {
            ", ".join(variable(target) for target in shader.manifest.original.targets)
            for shader in self.blocks.shaders
        }
        if others:
            raise UnfitForExampleError("its shaders have different outputs")
        things = "shown(things, frame)" if self.goes else "things"
        return [
            *self.blocks.targets.cleared(),
            "for things in ALL.values():",
            f'    draw(things[0][0] + "original", {things}, frame, {{}}, [{colors}], "<")',
        ]


def key_of(shader: HandedShader, cached: bool) -> str:
    """What the objects of a shader are called that its variant, or its original, draws."""
    mixed = shader.cached and shader.plain
    return f"{shader.title}, not cached" if mixed and not cached else shader.title


def _renamed(item: ExampleObject) -> dict[str, str]:
    """The textures that have another name in the file."""
    return {name: key for name, key in item.textures.items() if name != key}


def example_of_several(blocks: ExampleBlocks) -> str:
    """The text, without comments on passes where it would be too long.

    Raises :class:`UnfitForExampleError` for textures that change with each frame, and where
    shaders have different outputs.
    """
    text = SeveralObjects(blocks, comments=True).text()
    if len(text.splitlines()) < MOST_LINES:
        return text
    return SeveralObjects(blocks, comments=False).text()
