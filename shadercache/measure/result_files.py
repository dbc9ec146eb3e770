"""Store measurements: JSON with everything, CSV with one row for each variant.

A JSON result says where it was measured (renderer, clock, machine) and keeps the raw samples, so
that every number of a table can be computed again.
"""

from __future__ import annotations

import csv
import io
import json
import os
import platform
import re
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec

from shadercache import foreign_files as foreign
from shadercache.diagnostics import input_error
from shadercache.files import write_bytes
from shadercache.gpu.context import Gpu
from shadercache.measure.measurement import (
    Group,
    Measurement,
    NodeResult,
    SubjectResult,
    VariantResult,
)

SCHEMA_VERSION = 3


def environment(gpu: Gpu) -> dict[str, Any]:
    """Where the numbers come from: date (UTC), renderer, processor, Python."""
    return {
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "gl": gpu.describe(),
        "cpu": _processor(),
        "cores": os.cpu_count(),
        "system": _system(),
        "python": platform.python_version(),
    }


def to_json(measurement: Measurement, where: Mapping[str, Any]) -> dict[str, Any]:
    """The measurement as plain JSON values; times in seconds, numbers without end as null.

    Args:
        where: what ``environment`` returns.
    """
    return {
        "schema_version": SCHEMA_VERSION,
        "environment": dict(where),
        "clock": measurement.clock,
        "scene": measurement.scene,
        "size": list(measurement.size),
        "options": plain(measurement.options),
        "assignments": {
            configuration.key: assignment.to_json()
            for configuration, assignment in measurement.assignments.items()
        },
        "covered": measurement.covered,
        "notes": list(measurement.notes),
        "gains": plain(measurement.gains),
        "rank_correlation": measurement.rank_correlation,
        "groups": plain(measurement.groups),
    }


def write_json(path: Path, data: Mapping[str, Any]) -> None:
    """Write a result file. Raises :class:`UsageError` SC025: the path cannot be written."""
    write_bytes(path, (json.dumps(data, indent=1, allow_nan=False) + "\n").encode())


def read_json(path: Path) -> dict[str, Any]:
    """Read a result file back.

    Raises :class:`InputError` SC023: it is no result file of this version.
    """
    try:
        data = foreign.read_json(path)
    except (OSError, ValueError) as error:
        raise input_error("SC023", f"cannot read the result {path}: {error}") from None
    if not isinstance(data, dict) or data.get("schema_version") != SCHEMA_VERSION:
        raise input_error("SC023", f"{path} is no result of schema_version {SCHEMA_VERSION}")
    return data


def rows(measurement: Measurement) -> list[dict[str, Any]]:
    """One row for each variant, values by column (None where there is none).

    Rows of what is no variant come last, and have no node.
    """
    variants = [
        {**_what(node, variant), **_figures(group, variant), **_parts(variant)}
        for group in measurement.groups
        for node in group.nodes
        for variant in node.variants
    ]
    others = [
        {"label": other.label, **_figures(group, other)}
        for group in measurement.groups
        for other in group.others
    ]
    # csv.DictWriter takes its heading from the first row, so every row has all columns.
    columns = dict.fromkeys(column for row in (*variants, *others) for column in row)
    return [{**columns, **row} for row in (*variants, *others)]


def to_csv(measurement: Measurement) -> str:
    """The rows as CSV with a heading; lines end in a line feed."""
    table = rows(measurement)
    buffer = io.StringIO()
    writer = csv.DictWriter(buffer, table[0] if table else (), lineterminator="\n")
    writer.writeheader()
    writer.writerows(table)
    return buffer.getvalue()


def _what(node: NodeResult, variant: VariantResult) -> dict[str, Any]:
    configuration = variant.configuration
    return {
        "label": node.label,
        "node": node.node_id,
        "algorithm": configuration.algorithm,
        "period": configuration.refresh.period,
        "block": configuration.refresh.block,
        "configuration": configuration.key,
        "p_over_t": node.ratio,
        "p_over_t_static": node.static_ratio,
    }


def _figures(group: Group, found: SubjectResult) -> dict[str, Any]:
    timing, speedup, error, perceived = found.timing, found.speedup, found.error, found.perceived
    return {
        "original_ms": group.original.median * 1e3,
        "time_ms": timing.median * 1e3,
        "minimum_ms": timing.minimum * 1e3,
        "p95_ms": timing.p95 * 1e3,
        "p99_ms": timing.p99 * 1e3,
        "speedup": speedup.median,
        "speedup_low": speedup.low,
        "speedup_high": speedup.high,
        "tail": timing.tail,
        "original_tail": group.original.tail,
        "rmse": error.rmse,
        "p99": error.p99,
        "maximum": error.maximum,
        "psnr_db": error.psnr,
        "ssim": perceived and perceived.ssim,
        "flip": perceived and perceived.flip,
        "flicker": perceived and perceived.flicker,
        "pattern": perceived and perceived.pattern,
    }


def _parts(variant: VariantResult) -> dict[str, Any]:
    return {
        "reset_over_original": variant.reset,
        "hit_rate": variant.hit_rate,
        "refresh_burst": variant.burst,
        "floor_ms": None if variant.floor is None else variant.floor * 1e3,
        "efficiency": variant.efficiency,
        "bytes_per_pixel": variant.bytes_per_pixel,
    }


def plain(value: Any) -> Any:
    """Dataclasses, mappings and sequences as JSON values; numbers without end become null."""
    # JSON has no infinity (the PSNR of equal images), and msgspec writes null for it.
    return msgspec.json.decode(msgspec.json.encode(value, enc_hook=float))


def machine_name(where: Mapping[str, Any]) -> str:
    """``$MACHINE``, or the renderer and the number of cores, such as ``llvmpipe-2-cores``.

    Args:
        where: what ``environment`` returns.
    """
    renderer = where["gl"]["renderer"].partition("(")[0]
    slug = re.sub(r"[^a-z0-9]+", "-", f"{renderer} {where['cores']} cores".lower()).strip("-")
    return os.environ.get("MACHINE") or slug


def _system() -> str:
    """The distribution; the kernel's own name often gives away whose machine it is."""
    try:
        return f"{platform.freedesktop_os_release()['PRETTY_NAME']}, {platform.machine()}"
    except (OSError, KeyError):
        return f"{platform.system()}, {platform.machine()}"


def _processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
