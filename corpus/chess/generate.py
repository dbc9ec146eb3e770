"""Makes the game of chess: board, pieces, their wood, and the discs that darken them.

Run as ``python corpus/chess/generate.py`` (needs the ``assets`` extra). Nobody has to: what it
makes is committed. The same versions of the libraries make the same arrays every time.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import numpy.typing as npt
from discs import Floats, discs_of, forest, hierarchy, texels
from pieces import Mesh, box, merged, moved, piece, turned
from PIL import Image
from scipy.ndimage import gaussian_filter

HERE = Path(__file__).parent
EDGE = 4.5
"""Half of the board's width, with its frame."""

KINDS = {"p": "pawn", "r": "rook", "n": "knight", "b": "bishop", "q": "queen", "k": "king"}
GAME = """
r.bqk..r
pppp.ppp
..n..n..
..b.p...
..B.P...
.....N..
PPPP.PPP
RNBQ...R
"""
"""The pieces that stand still, from the eighth rank to the first: all but White's king."""

DISCS = {"pawn": 10, "rook": 11, "bishop": 11, "knight": 12, "queen": 11, "king": 9}
BOARD = 12
"""Discs along an edge of the board. With those of the pieces and the king 480 in all."""
BOARD_FINE = 18
"""The same where pieces have twice as many: 996 in all."""


def standing() -> list[tuple[str, bool, float, float]]:
    """Kind, whether it is White's, x and z of every piece that stands still."""
    return [
        (KINDS[letter.lower()], letter.isupper(), file - 3.5, rank - 3.5)
        for rank, row in enumerate(GAME.split())
        for file, letter in enumerate(row)
        if letter != "."
    ]


def pieces(white: bool, around: int) -> Mesh:
    """All standing pieces of a colour."""
    made = {kind: piece(kind, around) for kind in DISCS}
    turn = 0.0 if white else np.pi
    return merged(
        [
            moved(turned(made[kind], 1, turn), x, z)
            for kind, whites, x, z in standing()
            if whites == white
        ]
    )


def board() -> Mesh:
    """The board; its texture covers the top, and its frame the sides."""
    mesh = box((-EDGE, -0.35, -EDGE), (EDGE, 0.0, EDGE), cells=8)
    return {**mesh, "uv": mesh["position"][:, [0, 2]] / (2.0 * EDGE) + 0.5}


def static_discs(scale: int, edge: int) -> npt.NDArray[np.float32]:
    """The hierarchy over the board (``edge`` x ``edge`` discs) and the standing pieces."""
    made = {
        kind: discs_of(piece(kind, 24), scale * count, seed)
        for seed, (kind, count) in enumerate(DISCS.items())
    }
    groups = [_placed(made[kind], white, x, z) for kind, white, x, z in standing()]
    middle = ((np.arange(edge) + 0.5) / edge * 2.0 - 1.0) * EDGE
    x, z = (axis.ravel() for axis in np.meshgrid(middle, middle))
    flat = np.zeros((edge * edge, 7))
    flat[:, 0], flat[:, 2], flat[:, 4], flat[:, 6] = x, z, 1.0, (2.0 * EDGE / edge) ** 2
    return texels([*hierarchy(flat), *forest(groups)])


def _placed(discs: Floats, white: bool, x: float, z: float) -> Floats:
    """A piece's discs where it stands; Black's look the other way."""
    placed = discs.copy()
    if not white:
        placed[:, [0, 2, 3, 5]] *= -1.0
    placed[:, [0, 2]] += (x, z)
    return placed


def wood(size: int, dark: Floats, light: Floats, seed: int) -> Floats:
    """Grain (size, size, 3) between two colours, which repeats in both directions."""
    random = np.random.Generator(np.random.PCG64(seed))
    noise = random.normal(size=(size, size))
    rings = gaussian_filter(noise, (size / 6, size / 28), mode="wrap")
    pores = gaussian_filter(noise, (size / 32, 0.6), mode="wrap")
    grain = 0.5 + 0.19 * rings / rings.std() + 0.13 * pores / pores.std()
    return np.asarray(dark + (light - dark) * np.clip(grain, 0.0, 1.0)[..., None])


LIGHT = (np.array([0.70, 0.51, 0.31]), np.array([0.88, 0.72, 0.49]))
DARK = (np.array([0.17, 0.09, 0.055]), np.array([0.34, 0.18, 0.10]))
FRAME = (np.array([0.24, 0.115, 0.06]), np.array([0.40, 0.21, 0.11]))


def board_texture(size: int = 512) -> Floats:
    """Squares (size, size, 3) with a frame around them; a1 is dark."""
    at = (np.arange(size) + 0.5) / size * 2.0 * EDGE - EDGE
    x, z = np.meshgrid(at, at)
    column, row = np.floor(x).astype(int), np.floor(z).astype(int)
    maple, walnut = (wood(size, *colors, seed) for seed, colors in ((1, LIGHT), (2, FRAME)))
    # Every square is cut from another part of the plank.
    i, j = np.meshgrid(np.arange(size), np.arange(size), indexing="ij")
    i, j = (i + 61 * (column + 4)) % size, (j + 97 * (row + 4)) % size
    light = ((column + row) % 2 == 0)[..., None]
    squares = np.where(light, maple[i, j], walnut[i, j] * 0.9)
    rim = np.maximum(abs(x), abs(z))[..., None]
    line = np.where((rim > 4.0) & (rim < 4.06), 0.5, 1.0)
    return np.asarray(np.where(rim < 4.0, squares, walnut * 0.8) * line)


def save(path: Path, mesh: Mesh) -> None:
    """Writes a mesh in short form."""
    low, high = mesh["position"].min(0), mesh["position"].max(0)
    np.savez_compressed(
        path,
        position_u16=np.round((mesh["position"] - low) / (high - low) * 65535.0).astype(np.uint16),
        bounds=np.stack([low, high]),
        normal_i8=np.round(mesh["normal"] * 127.0).astype(np.int8),
        uv=mesh["uv"].astype(np.float16),
        index_delta=np.diff(mesh["index"].ravel(), prepend=0).astype(np.int32),
    )


def save_picture(path: Path, colors: Floats) -> None:
    """Writes colours between 0 and 1 with 64 of them in a palette, which keeps the file small."""
    pixels = np.round(colors * 255.0).astype(np.uint8)
    Image.fromarray(pixels).quantize(64, dither=Image.Dither.NONE).save(path, optimize=True)


def main() -> None:
    """Writes every asset into the folder given by ``--output`` (default: beside this file)."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("--output", type=Path, default=HERE)
    out: Path = arguments.parse_args().output
    save(out / "board.npz", board())
    for suffix, around in (("", 20), ("-small", 8)):
        save(out / f"white{suffix}.npz", pieces(True, around))
        save(out / f"black{suffix}.npz", pieces(False, around))
        save(out / f"king{suffix}.npz", piece("king", around))
    for suffix, scale, edge in (("", 1, BOARD), ("-fine", 2, BOARD_FINE)):
        king = hierarchy(discs_of(piece("king", 24), scale * DISCS["king"], len(DISCS)))
        np.savez_compressed(out / f"discs{suffix}.npz", pixels=static_discs(scale, edge))
        np.savez_compressed(out / f"king-discs{suffix}.npz", pixels=texels(king))
    save_picture(out / "board.png", board_texture())
    save_picture(out / "light.png", wood(128, *LIGHT, seed=3))
    save_picture(out / "dark.png", wood(128, *DARK, seed=4))


if __name__ == "__main__":
    main()
