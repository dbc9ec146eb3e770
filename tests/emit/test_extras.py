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


@pytest.mark.parametrize("name", ["float", "vec3"])
def test_what_was_emitted_before_does_not_matter(name: str) -> None:
    """Carried samples are packed by the format, so the same nodes have other textures in each."""
    options = [configured(filter="carried", form=form) for form in ("rgba32f", "rgba16f")]
    shared, node = analysed_payload(name)
    for each in (*options, *reversed(options)):
        fresh, same = analysed_payload(name)
        now = rewritten(shared, node, each, unprofitable=True)
        alone = rewritten(fresh, same, each, unprofitable=True)
        assert now.files == alone.files and now.manifest == alone.manifest
