"""The files of the slots: what they declare, who chooses them, that nothing is left to fill in."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import product

import pytest

from shadercache.ast import nodes as n
from shadercache.caching.configuration import Configuration
from shadercache.caching.layout import Layout, layout_of
from shadercache.caching.outcomes import OUTCOMES
from shadercache.caching.program_parts import program_part
from shadercache.caching.read_template import FOLDER, read_template
from shadercache.caching.settings import NUMBER, cache_choices, with_settings
from shadercache.caching.slots import LOCATE, Choice
from shadercache.emit.printer import print_node
from shadercache.emit.runtime import FOLDER as PASSES
from shadercache.lang.types import BOOL, FLOAT, INT, Type, vector

FILES = {path.relative_to(FOLDER).with_suffix("").as_posix() for path in FOLDER.rglob("*.glsl")}
MAINS = [PASSES / "passes" / f"{name}.glsl" for name in ("one", "reuse", "needed", "shade")]
AT_FRACTION = PASSES / "passes" / "neighbours.glsl"
TYPES = {
    "float": (FLOAT,),
    "vec3": (vector("float", 3),),
    "vec4": (vector("float", 4),),
    "int": (INT,),
    "bvec4": (vector("bool", 4),),
    "set": (vector("float", 2), BOOL),
}

PAIRS = (
    "refresh=none,age",
    "adaptive=0.1",
    "filter=lanczos2,fallback",
    "filter=lanczos2,ids",
    "guard=off,mask,age",
    "filter=carried,age",
    "filter=carried,ids",
    "filter=carried,adaptive=0.1",
)


def choices(types: tuple[Type, ...]) -> list[Choice]:
    """Every value of every option; every mapping; payloads that may be lacking."""
    known = cache_choices().items()
    single = [f"{name}={word}" for name, words in known for word in words if word != NUMBER]
    configurations = [with_settings(Configuration(), [text]) for text in (*single, *PAIRS)]
    plain = [Choice(layout_of(types, one), "sc_", configuration=one) for one in configurations]
    filters = [plain[0], *(one for one in plain if one.configuration.filter.kind == "nearest")]
    slower = [replace(one.configuration, payload_rate="half") for one in filters]
    plain += [replace(plain[0], configuration=one) for one in slower]
    plain.append(replace(plain[0], instanced=True))
    others = [
        replace(plain[0], located=where, whole=whole) for where in LOCATE for whole in (False, True)
    ]
    return [*plain, *others]


def heads(name: str) -> dict[str, str]:
    """The heads of the functions of a file that stand for something in others."""
    decls = read_template(FOLDER / f"{name}.glsl", "sc_").decls
    functions = [decl for decl in decls if isinstance(decl, n.FunctionDef)]
    return {f.name: print_node(f.proto) for f in functions if f.name[3:].isupper()}


@pytest.mark.parametrize(
    "slot",
    [
        "locate",
        "frame",
        "fetch",
        "depth",
        "tolerance",
        "test",
        "resample",
        "store",
        "combine",
        "rate",
        "ids",
        "found",
        "mark",
        "opt_out",
        "payload",
        "carry",
        "tuck",
    ],
)
def test_all_files_of_a_slot_have_one_signature(slot: str) -> None:
    known: dict[str, str] = {}
    for name in sorted(FILES):
        if name.startswith(f"{slot}/"):
            for function, head in heads(name).items():
                assert known.setdefault(function, head) == head, name
    assert known


def test_every_file_is_chosen_by_something_and_is_there() -> None:
    chosen = {
        name
        for types in TYPES.values()
        for choice in choices(types)
        for name in (*choice.files, choice.marking(True), choice.marking(False))
    }
    assert chosen == FILES


@pytest.mark.parametrize("name", TYPES)
def test_nothing_is_left_to_fill_in(name: str) -> None:
    chosen = choices(TYPES[name])
    slower = [one for one in chosen if one.configuration.payload_rate != "full"]
    for choice, main in (*product(chosen, MAINS), *product(slower, [AT_FRACTION])):
        text = "\n".join(print_node(decl) for decl in program_part(main, choice).decls)
        assert not re.findall(r"\bsc_[A-Z]\w*", text), main.stem
        assert ("sc_cache_2" in text) <= choice.layout.second


def test_outcomes_are_called_what_they_are() -> None:
    text = (FOLDER / "globals.glsl").read_text(encoding="utf-8")
    found = re.findall(r"const int sc_(?:miss_)?(\w+) = (\d+);", text)
    assert {name.replace("_", "-"): int(value) for name, value in found} == OUTCOMES


def test_names_get_the_prefix() -> None:
    choice = Choice(Layout((INT,)), "sc7_")
    text = "\n".join(print_node(decl) for decl in program_part(MAINS[0], choice).decls)
    assert "sc_" not in text
    assert "sc7_look_up" in text


def test_what_is_put_in_keeps_its_order_of_operations() -> None:
    """As text in the place of a name it would not: ``texel.w - 2.0 * z - 1.0``."""
    asked = with_settings(Configuration(), ["depth=ndc,filter=bilinear"])
    choice = Choice(Layout((FLOAT,)), "sc_", located="screen", configuration=asked)
    text = "\n".join(print_node(decl) for decl in program_part(MAINS[0], choice).decls)
    assert "abs(sc_texel.w - (2.0 * gl_FragCoord.z - 1.0))" in text
