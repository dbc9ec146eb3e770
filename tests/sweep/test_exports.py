"""JSON, CSV and Parquet."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import jsonschema
import msgspec
import pytest
from msgspec import structs

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import UsageError
from shadercache.sweep import exports
from shadercache.sweep.exports import check_export, export_schema, flat_row, write_export
from shadercache.sweep.row import (
    ImageErrors,
    RatioEntry,
    ReuseShares,
    Samples,
    Times,
    TrialResult,
)

from .test_store import row

RESULT = TrialResult(
    Times(
        RatioEntry(1.5, 1.4, 1.6, 1.5),
        1.1,
        False,
        1.0,
        0.9,
        None,
        None,
        Samples((1.0,), (1.5,), (0.1,)),
    ),
    ImageErrors(0.0, 0.0, 0.0, None, (0.0,)),
    ReuseShares(0.9, 0.1, {"hit": 0.9}, {"hit": 100.0}, {"hit": 1}),
    0.5,
)
CONFIGURATION = Configuration(("main.1-abc",), "2-pass").to_json()
ROWS = (
    row("a", "A", outcome=RESULT, configuration=CONFIGURATION),
    row("b", "B", configuration=CONFIGURATION),
    structs.replace(
        row("c", "C", outcome=RESULT, label="half resolution", kind="peer"), payload=None
    ),
)


def test_json_is_what_its_schema_says(tmp_path: Path) -> None:
    path = tmp_path / "rows.json"
    write_export(path, ROWS)
    data = json.loads(path.read_text())
    jsonschema.validate(data, export_schema())
    assert msgspec.convert(data, exports.Export).rows == ROWS
    del data["rows"][0]["machine"]
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(data, export_schema())


def test_csv_has_a_row_for_each(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    write_export(path, ROWS)
    with path.open(newline="") as stream:
        table = list(csv.DictReader(stream))
    assert [one["ratio"] for one in table] == ["1.5", "", "1.5"]
    assert [one["failure"] for one in table] == ["", "hung", ""]
    assert [one["algorithm"] for one in table] == ["2-pass", "2-pass", ""]
    assert {len(one) for one in table} == {len(flat_row(ROWS[0]))}


def test_parquet_keeps_numbers(tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "rows.parquet"
    write_export(path, ROWS)
    table = parquet.read_table(path).to_pylist()
    assert [one["ratio"] for one in table] == [1.5, None, 1.5]
    assert [one["period"] for one in table] == ["32", "32", None]


def test_no_rows(tmp_path: Path) -> None:
    for name in ("rows.json", "rows.csv"):
        write_export(tmp_path / name, ())
    assert json.loads((tmp_path / "rows.json").read_text())["rows"] == []


def test_bad_names_and_a_missing_package(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(UsageError, match="SC008"):
        check_export(Path("rows.txt"))

    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(exports, "import_module", missing)
    with pytest.raises(UsageError, match="SC031") as caught:
        check_export(Path("rows.parquet"))
    assert "shadercache[parquet]" in str(caught.value)
