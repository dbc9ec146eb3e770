"""Peers in a result store."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from bench.peers.__main__ import main
from shadercache.sweep.store import Store

pytestmark = pytest.mark.xdist_group("gl")


def test_peers_become_rows_with_pictures(tmp_path: Path) -> None:
    store = tmp_path / "peers.db"
    given = ["trashcan", "--size", "64", "--frames", "4", "--only", "half-bilinear,color"]
    assert main([*given, "-o", str(tmp_path), "--store", str(store)]) == 0
    assert main([*given, "-o", str(tmp_path), "--store", str(store)]) == 0  # in place of the first
    with Store(store) as opened:
        rows = opened.rows()
        colors = [f"cached colour, period {period}" for period in (2, 4)]
        assert [row.label for row in rows] == [*colors, "half resolution, bilinear"]
        for row in rows:
            assert row.kind == "peer" and row.scene.size == (64, 64) and row.result is not None
            images = {
                kind: np.asarray(Image.open(io.BytesIO(opened.blob(name))))
                for kind, name in row.pictures.items()
            }
            assert images["original"].shape == images["cached"].shape == (64, 64, 3)
            apart = images["original"].astype(float) - images["cached"]
            assert 0.0 < np.abs(apart).mean() < 30.0
            assert 0.0 < row.result.image.rmse < 0.2
