"""The dragon's mesh: closed, outward, of the stated size, and what its generator makes."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from shadercache.scene.mesh import Mesh, load_mesh

FOLDER = Path(__file__).resolve().parent.parent.parent / "corpus" / "dragon"


def directed_edges(mesh: Mesh) -> np.ndarray:
    """(3 m, 2): every face's edges, in its own direction."""
    faces = mesh.index.astype(np.int64)
    return np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])


def face_normals(mesh: Mesh) -> np.ndarray:
    """(m, 3), as long as twice the face's area."""
    a, b, c = (mesh.arrays["position"][mesh.index[:, k]].astype(np.float64) for k in range(3))
    return np.cross(b - a, c - a)


def test_number_of_faces() -> None:
    assert len(load_mesh(FOLDER / "dragon.npz").index) == pytest.approx(75_000, rel=0.01)
    assert len(load_mesh(FOLDER / "dragon-small.npz").index) == pytest.approx(4_000, rel=0.05)


def test_every_edge_is_shared_by_exactly_two_faces_that_agree(dragon: Mesh) -> None:
    edges = directed_edges(dragon)
    _, uses = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    assert set(uses) == {2}
    assert len(np.unique(edges, axis=0)) == len(edges)


def test_one_body_without_loose_vertices(dragon: Mesh) -> None:
    edges, count = directed_edges(dragon), len(dragon.arrays["position"])
    graph = coo_array((np.ones(len(edges)), edges.T), shape=(count, count))
    assert connected_components(graph, directed=False)[0] == 1


def test_the_faces_around_a_vertex_form_one_fan(dragon: Mesh) -> None:
    # A corner's neighbour at the same vertex lies across the edge that leads into the corner.
    # Walking on so gives one ring for every vertex, and two for one where the mesh is pinched.
    faces = dragon.index.astype(np.int64)
    corner = np.arange(faces.size)
    vertex, after, before = faces, np.roll(faces, -1, axis=1), np.roll(faces, 1, axis=1)
    count = np.int64(len(dragon.arrays["position"]))
    outgoing, incoming = (vertex * count + after).ravel(), (vertex * count + before).ravel()
    order = np.argsort(outgoing)
    partner = corner[order][np.searchsorted(outgoing[order], incoming)]
    graph = coo_array((np.ones(faces.size), (corner, partner)), shape=(faces.size,) * 2)
    assert connected_components(graph, directed=False)[0] == count


def test_faces_and_normals_look_outward(dragon: Mesh) -> None:
    position, normal = (dragon.arrays[k].astype(np.float64) for k in ("position", "normal"))
    across = face_normals(dragon)
    volume = (position[dragon.index[:, 0]] * across).sum() / 6.0
    assert 0.3 < volume < 1.0
    around = np.zeros_like(position)
    for k in range(3):
        np.add.at(around, dragon.index[:, k], across)
    assert ((around * normal).sum(axis=1) > 0.0).all()
    assert np.allclose(np.linalg.norm(normal, axis=1), 1.0, atol=1e-5)


def test_triangles_come_in_an_order_that_keeps_vertices_in_a_cache(dragon: Mesh) -> None:
    flat = dragon.index.ravel()
    recent: dict[int, int] = {}
    misses = 0
    for vertex in flat.tolist():
        if misses - recent.get(vertex, -10_000) >= 32:
            recent[vertex] = misses
            misses += 1
    assert misses / len(dragon.index) < 1.0  # 3 in random order, 0.5 at best
    first = np.unique(flat, return_index=True)[1]
    assert (np.diff(first) > 0).all()  # vertices are named by first use


def test_size_of_the_files() -> None:
    assets = [p for p in FOLDER.iterdir() if p.suffix in (".npz", ".png")]
    assert sum(p.stat().st_size for p in assets) < 1_000_000


def test_the_generator_repeats_itself(dragon_generator: ModuleType) -> None:
    one, other = (dragon_generator.dragon(0.04, 2000, 0.02) for _ in range(2))
    assert one.keys() == other.keys()
    assert all(np.array_equal(one[key], other[key]) for key in one)
    assert len(one["index_delta"]) // 3 == pytest.approx(2000, rel=0.02)


def test_the_committed_small_dragon_is_the_generators(dragon_generator: ModuleType) -> None:
    # Another version of a library may move a vertex or choose another edge; the shape stays.
    made = dragon_generator
    vertices, _ = made.body(made.STEP_SMALL, made.FATTER)
    mesh = load_mesh(FOLDER / "dragon-small.npz").arrays["position"]
    assert np.allclose(mesh.min(axis=0), vertices.min(axis=0), atol=0.02)
    assert np.allclose(mesh.max(axis=0), vertices.max(axis=0), atol=0.02)


def test_careful_collapse_keeps_a_closed_mesh_closed(dragon_generator: ModuleType) -> None:
    t = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    u, v = np.meshgrid(t, t, indexing="ij")
    ring = 1.0 + 0.4 * np.cos(v)
    points = np.stack([ring * np.cos(u), ring * np.sin(u), 0.4 * np.sin(v)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(24), np.arange(24), indexing="ij")
    right, up = (i + 1) % 24, (j + 1) % 24
    here, there, across, above = i * 24 + j, right * 24 + j, right * 24 + up, i * 24 + up
    faces = np.stack([here, there, across, here, across, above], -1).reshape(-1, 3)
    vertices, left = dragon_generator.collapsed(points, faces, 200)
    assert dragon_generator.closed(left)
    assert len(left) <= 200
    assert len(vertices) == len(left) // 2  # Euler: a torus stays a torus
