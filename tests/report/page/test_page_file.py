"""The file of a report: what stands in it, what is left out, what cannot be made."""

from __future__ import annotations

import gzip
import io
import json
import re
from base64 import b64decode
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from msgspec import structs
from PIL import Image

from shadercache.diagnostics import InputError, UsageError
from shadercache.paths import data_path
from shadercache.report.page.page_contents import fill_pictures
from shadercache.report.page.page_data import PageSource, page_data
from shadercache.report.page.page_file import page_file
from shadercache.report.page.page_group import page_groups
from shadercache.report.page.page_rows import histogram, repeat_command, scene_in_words
from shadercache.report.page.picture_shelf import PictureShelf
from shadercache.report.parts import page_parts as making
from shadercache.sweep.row import Row

from .conftest import Sourced

PLENTY = 10**8


def element(page: bytes, name: str) -> str:
    """The text of a script element with an id."""
    found = re.search(rf'<script type="[^"]*" id="{name}">(.*?)</script>', page.decode(), re.S)
    assert found is not None
    return found[1]


def with_pictures(source: PageSource, room: int) -> dict[str, Any]:
    groups = page_groups(source.rows)
    data = page_data(source, groups)
    fill_pictures(data, groups, PictureShelf(source.blob, room))
    return data


def rows_of(data: dict[str, Any]) -> list[dict[str, Any]]:
    return [row for group in data["groups"] for row in group["rows"]]


def shown(uri: str) -> np.ndarray[Any, Any]:
    kind, _, text = uri.partition(",")
    assert kind == "data:image/webp;base64"
    return np.asarray(Image.open(io.BytesIO(b64decode(text))).convert("RGB"))


def test_a_page_is_one_file_with_all_that_it_needs(sourced: Sourced, made_rows: list[Row]) -> None:
    page = page_file(sourced(made_rows))
    assert page.startswith(b"<!doctype html>")
    own = page.decode().replace(making.plotly_script(), "")
    assert not re.search(r"""(?:src|href)=["']?(?!data:)\w|@import|url\(""", own)
    data = json.loads(element(page, "data"))
    assert [row["key"] for row in rows_of(data)] == [row.key for row in made_rows]
    assert len(own) < len(page) - 4_000_000


def test_texts_are_packed(
    sourced: Sourced, made_rows: list[Row], made_blobs: dict[str, bytes]
) -> None:
    packed = element(page_file(sourced(made_rows)), "texts")
    texts = json.loads(gzip.decompress(b64decode(packed)))
    named = {hashed for row in made_rows if row.result for hashed in row.texts.values()}
    assert texts == {hashed: made_blobs[hashed].decode() for hashed in named}


def test_no_text_ends_the_script(sourced: Sourced, made_rows: list[Row]) -> None:
    payload = made_rows[0].payload
    assert payload is not None
    evil = "</script><script>alert(1)</script><!-- $data ${plotly}"
    row = structs.replace(made_rows[0], payload=structs.replace(payload, text=evil))
    scene = structs.replace(row.scene, name=evil)
    page = page_file(sourced([structs.replace(row, scene=scene)]))
    assert json.loads(element(page, "data"))["groups"][0]["nodes"][0]["text"] == evil
    assert b"<script>alert" not in page


def test_layers_are_made_of_what_the_store_keeps(
    sourced: Sourced, made_rows: list[Row], made_blobs: dict[str, bytes]
) -> None:
    row = next(row for row in made_rows if "ages" in row.pictures and row.result)
    data = with_pictures(sourced([row]), PLENTY)
    layers = rows_of(data)[0]["layers"]
    assert set(layers) == {"original", "cached", "payload", "difference", "hits", "age"}
    original, cached = (
        np.asarray(Image.open(io.BytesIO(made_blobs[row.pictures[kind]]))).astype(int)
        for kind in ("original", "cached")
    )
    difference = shown(data["pictures"][layers["difference"]])
    assert np.array_equal(difference, np.minimum(10 * np.abs(original - cached), 255))
    mask = np.asarray(Image.open(io.BytesIO(made_blobs[row.pictures["outcomes"]])))
    assert row.result is not None and row.result.reuse is not None
    hits = shown(data["pictures"][layers["hits"]])
    assert (hits[mask == row.result.reuse.values["hit"]] == (38, 132, 148)).all()
    assert not hits[mask == 0].any() and not shown(data["pictures"][layers["age"]])[mask == 0].any()
    lossy = shown(data["pictures"][layers["original"]]).astype(int)
    assert np.abs(lossy - original).mean() < 6.0


def test_every_picture_is_there_once(sourced: Sourced, made_rows: list[Row]) -> None:
    data = with_pictures(sourced(made_rows), PLENTY)
    named = {name for row in rows_of(data) for name in row.get("layers", {}).values()}
    assert named <= set(data["pictures"])
    originals = [row["layers"]["original"] for row in rows_of(data) if "layers" in row]
    assert len(originals) == 34 and len(set(originals)) == 1


def test_where_room_is_short_the_most_interesting_rows_come_first(
    sourced: Sourced, made_rows: list[Row]
) -> None:
    everything = with_pictures(sourced(made_rows), PLENTY)
    size = sum(map(len, everything["pictures"].values()))
    part = with_pictures(sourced(made_rows), size // 2)
    assert sum(map(len, part["pictures"].values())) <= size // 2
    with_layers = {place for place, row in enumerate(rows_of(part)) if row.get("layers")}
    assert 0 < len(with_layers) < sum("layers" in row for row in rows_of(everything))
    assert part["groups"][0]["chosen"] in with_layers
    assert set(part["groups"][0]["fronts"]["rmse"]["variant"]) & with_layers
    assert not with_pictures(sourced(made_rows), 0)["pictures"]


def test_pictures_that_are_missing_or_damaged_are_counted(
    made_rows: list[Row], made_blobs: dict[str, bytes]
) -> None:
    row = made_rows[-3]  # of the costliest value: its images differ from the original's
    blobs = {**made_blobs, row.pictures["cached"]: b"no picture"}
    del blobs[row.pictures["outcomes"]]
    data = with_pictures(PageSource("made.db", [row], blobs.__getitem__), PLENTY)
    assert set(rows_of(data)[0]["layers"]) == {"original", "payload"}
    assert data["missing"] == 2


@pytest.mark.parametrize("keep", [lambda row: row.failure, lambda row: row.kind == "peer"])
def test_failures_alone_and_peers_alone_are_a_page(
    sourced: Sourced, made_rows: list[Row], keep: Any
) -> None:
    rows = [row for row in made_rows if keep(row)]
    data = json.loads(element(page_file(sourced(rows)), "data"))
    assert len(rows_of(data)) == len(rows)
    assert data["groups"][0]["summary"]


def test_an_empty_store_is_told(sourced: Sourced) -> None:
    with pytest.raises(InputError, match=r"made\.db has no rows.*\[SC037\]"):
        page_file(sourced([]))


def test_without_plotly_the_extra_is_named(
    sourced: Sourced, made_rows: list[Row], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(making, "find_spec", lambda name: None)
    with pytest.raises(UsageError, match=r"plotly \[SC031\](.|\n)*shadercache\[report\]"):
        page_file(sourced(made_rows))


def test_how_to_repeat_a_row(sourced: Sourced, made_rows: list[Row]) -> None:
    row = structs.replace(made_rows[0], label="two octaves")
    shown = rows_of(page_data(sourced([row]), page_groups([row])))[0]
    assert shown["repeat"] == (
        "shadercache sweep corpus/dragon/scene.toml -o made.db --nodes 'two octaves' --passes 1 "
        "--period 4 --block 4 --format rgba16f --cache age=on --size 64x64 --frames 24 "
        "--perceptual --force"
    )
    chosen = row.configuration | {"payload_rate": "half"}
    slower = structs.replace(row, configuration=chosen)
    assert "--format rgba16f --rate half --cache age=on " in repeat_command(slower, "made.db")
    profiled = next(one for one in made_rows if one.result and one.result.times.profile)
    assert "--perceptual --profile --force" in repeat_command(profiled, "made.db")
    [shown] = rows_of(page_data(sourced([profiled]), page_groups([profiled])))
    assert shown["profile"][0][0] == "clears" and len(shown["profile"][0]) == 4
    assert repeat_command(made_rows[-1], "made.db") == (
        "python -m bench.peers corpus/dragon/scene.toml --size 64 --frames 24 --store made.db"
    )


def test_a_scene_of_the_corpus_goes_by_its_name(made_rows: list[Row]) -> None:
    entry = made_rows[0].scene
    own = str(data_path("corpus", "dragon", "scene.toml"))
    assert scene_in_words(structs.replace(entry, path=own)) == "dragon"
    assert scene_in_words(structs.replace(entry, path="my/dragon")) == "my/dragon"


@pytest.mark.parametrize(
    ("subject", "original"),
    [([0.01] * 9, [0.02] * 9), ([0.01] * 9, [0.01] * 9), ([0.01, 0.02, 9.0], [0.02] * 99)],
)
def test_every_frame_is_in_a_histogram(subject: Sequence[float], original: Sequence[float]) -> None:
    told = histogram(subject, original)
    assert [sum(counts) for counts in told["counts"]] == [len(subject), len(original)]
    assert told["start"] == pytest.approx(10.0)
    assert told["end"] < 100.0
