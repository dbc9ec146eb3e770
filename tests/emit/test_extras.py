"""What guards keep beside the payloads, and where."""

from __future__ import annotations

import json

import pytest
from emit.test_programs import check_programs
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from payloads import PAYLOADS, analysed_payload

from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.layout import Extra, Layout, extras_of
from shadercache.caching.payload_text import payload_text
from shadercache.diagnostics import InputError
from shadercache.lang.types import FLOAT, INT, vector
from tests.configured import configured, rewritten

ID = Extra("id", INT, "object")
AGE = Extra("age", FLOAT, "age")

PLACES = [
    (FLOAT, ("rgba16f",), {"id": (0, "y"), "age": (0, "z")}),
    (vector("float", 2), ("rgba16f", "r16f"), {"id": (0, "z"), "age": (1, "x")}),
    (vector("float", 3), ("rgba16f", "rg16f"), {"id": (1, "x"), "age": (1, "y")}),
    (vector("int", 4), ("rgba32ui", "rgba32ui"), {"id": (1, "y"), "age": (1, "z")}),
]


@pytest.mark.parametrize(("kind", "formats", "places"), PLACES, ids=lambda item: str(item)[:8])
def test_extras_take_the_channels_behind_the_payload(
    kind: object, formats: tuple[str, ...], places: dict[str, tuple[int, str]]
) -> None:
    layout = Layout((kind,), extras=(ID, AGE))  # type: ignore[arg-type]
    assert layout.formats("rgba16f") == formats
    assert layout.extra_places == places
    assert layout.fits


def written(layout: Layout) -> str:
    return payload_text(layout, "sc_", False, ("-1.0", "-2.0"))


def test_how_extras_are_written_and_read() -> None:
    floats = written(Layout((vector("float", 2),), extras=(ID, AGE)))
    assert "vec4 sc_PACKED() { return vec4(sc_payload, float(sc_object), 0); }" in floats
    assert "vec4 sc_PACKED_2() { return vec4(sc_age, 0.0, 0.0, 0.0); }" in floats
    assert "int sc_ID(vec4 first, vec4 second) { return int(first.z); }" in floats
    assert "float sc_AGE(vec4 first, vec4 second) { return second.x; }" in floats
    bits = written(Layout((INT,), extras=(ID, AGE)))
    packed = "uint(sc_payload), uint(sc_object), floatBitsToUint(sc_age)"
    assert f"uvec4 sc_PACKED() {{ return uvec4({packed}, 0); }}" in bits
    assert "int sc_ID(uvec4 first, uvec4 second) { return int(first.y); }" in bits
    assert "return uintBitsToFloat(first.z);" in bits
    # Where only extras lie in the second texel, the third pass need not read it.
    taken = "sc_payload = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0).xyz;"
    assert taken in written(Layout((vector("float", 3),), extras=(ID,)))


def test_nothing_is_kept_unasked() -> None:
    assert extras_of(Configuration()) == ()
    assert Layout((FLOAT,)).channels == (1,)


@pytest.mark.parametrize("name", PAYLOADS)
@pytest.mark.slow
def test_every_type_with_an_id_has_valid_programs(name: str) -> None:
    validator = Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))
    analysis, node = analysed_payload(name)
    modes: tuple[Mode, ...] = ("plain", "proof")
    for mode in modes:
        options = configured(mode=mode, ids=True)
        if name in ("Whole", "Mixed"):
            with pytest.raises(InputError, match="no channel left for the id") as caught:
                rewritten(analysis, node, options, unprofitable=True)
            assert caught.value.diagnostics[0].code == "SC430"
            continue
        emission = rewritten(analysis, node, options, unprofitable=True)
        check_programs(emission)
        validator.validate(plain(emission.manifest))
