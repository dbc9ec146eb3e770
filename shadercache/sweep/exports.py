"""A store written as JSON, CSV or Parquet."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import msgspec

from shadercache.diagnostics import usage_error
from shadercache.files import write_bytes
from shadercache.sweep.row import Row

EXPORT_VERSION = 1

SUFFIXES = (".json", ".csv", ".parquet")


class Export(msgspec.Struct, frozen=True):
    """The JSON export; ``export_schema`` describes it."""

    schema_version: int
    rows: tuple[Row, ...]


def export_schema() -> dict[str, Any]:
    """The JSON Schema of a JSON export."""
    return msgspec.json.schema(Export)


def check_export(path: Path) -> Path:
    """The same path. Raises :class:`UsageError` SC008 for a suffix that no export has, SC031 where
    Parquet needs what is not installed."""
    if path.suffix not in SUFFIXES:
        raise usage_error("SC008", f"cannot export {path}", f"it may end in {', '.join(SUFFIXES)}")
    if path.suffix == ".parquet":
        _parquet()
    return path


def write_export(path: Path, rows: Sequence[Row]) -> None:
    """Write rows by the suffix of the path. CSV and Parquet have one flat row for each, without
    samples. Raises as :func:`check_export` and ``write_bytes``."""
    if path.suffix == ".json":
        data = msgspec.json.encode(Export(EXPORT_VERSION, tuple(rows)))
        write_bytes(path, msgspec.json.format(data, indent=1) + b"\n")
        return
    table = [flat_row(row) for row in rows]
    if path.suffix == ".csv":
        buffer = io.StringIO()
        writer = csv.DictWriter(buffer, table[0] if table else (), lineterminator="\n")
        writer.writeheader()
        writer.writerows(table)
        write_bytes(path, buffer.getvalue().encode())
        return
    arrow, parquet = _parquet()
    # Into memory first: pyarrow writes as it goes, and write_bytes leaves no half file.
    stream = io.BytesIO()
    parquet.write_table(arrow.Table.from_pylist(table), stream)
    write_bytes(path, stream.getvalue())


def flat_row(row: Row) -> dict[str, Any]:
    """The values of a row by column, None where there is none."""
    result, failure = row.result, row.failure
    times = result.times if result else None
    image = result.image if result else None
    reuse = result.reuse if result else None
    perceived = image.perceived if image else None
    return {
        "key": row.key,
        "kind": row.kind,
        **row.words,
        "text": row.payload.text if row.payload else None,
        "type": row.payload.type if row.payload else None,
        "static_p_over_t": row.payload.static_ratio if row.payload else None,
        "width": row.scene.size[0],
        "height": row.scene.size[1],
        "frames": row.scene.frames,
        "failure": failure.kind if failure else None,
        "code": failure.code if failure else None,
        "message": failure.message if failure else None,
        "ratio": times.ratio.median if times else None,
        "ratio_low": times.ratio.low if times else None,
        "ratio_high": times.ratio.high if times else None,
        "tail": times.tail if times else None,
        "capped": times.capped if times else None,
        "reset_over_original": times.reset if times else None,
        "p_over_t": times.p_over_t if times else None,
        "floor_seconds": times.floor if times else None,
        "efficiency": times.efficiency if times else None,
        "timed_frames": len(times.samples.subject) if times else None,
        "hit_rate": reuse.hit_rate if reuse else None,
        "bytes_per_pixel": reuse.bytes_per_pixel if reuse else None,
        "rmse": image.rmse if image else None,
        "p99": image.p99 if image else None,
        "maximum": image.maximum if image else None,
        "psnr_db": image.psnr if image else None,
        "ssim": perceived.ssim if perceived else None,
        "flip": perceived.flip if perceived else None,
        "flicker": perceived.flicker if perceived else None,
        "pattern": perceived.pattern if perceived else None,
        "renderer": row.machine.renderer,
        "driver": row.machine.driver,
        "clock": row.machine.clock,
        "date": row.written.date,
        "version": row.written.version,
    }


def _parquet() -> tuple[Any, Any]:
    try:
        return import_module("pyarrow"), import_module("pyarrow.parquet")
    except ImportError:
        hint = "pip install 'shadercache[parquet]'"
        raise usage_error("SC031", "Parquet needs the package pyarrow", hint) from None
