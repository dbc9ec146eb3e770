"""Edge collapse that never tears: slow and careful, for the last steps to a small mesh.

After Garland and Heckbert, "Surface simplification using quadric error metrics" (1997), with the
link condition of Dey et al. (1999): an edge may go only if its ends have exactly two neighbours
in common, so a closed manifold stays one.
"""

from __future__ import annotations

import heapq

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]


class _Mesh:
    """Vertices, faces and the faces at each vertex; ``age`` tells stale queue entries."""

    def __init__(self, vertices: Floats, faces: Indices) -> None:
        self.position = vertices.copy()
        self.faces: dict[int, tuple[int, int, int]] = {
            i: (int(a), int(b), int(c)) for i, (a, b, c) in enumerate(faces)
        }
        self.around: list[set[int]] = [set() for _ in vertices]
        for i, face in self.faces.items():
            for v in face:
                self.around[v].add(i)
        self.age = [0] * len(vertices)
        self.quadric = np.zeros((len(vertices), 4, 4))
        corners = vertices[faces]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = np.linalg.norm(normal, axis=1, keepdims=True)
        normal /= np.maximum(area, 1e-30)
        plane = np.concatenate([normal, -(normal * corners[:, 0]).sum(1, keepdims=True)], axis=1)
        weighted = plane[:, :, None] * plane[:, None, :] * area[:, :, None]
        for k in range(3):
            np.add.at(self.quadric, faces[:, k], weighted)

    def neighbours(self, v: int) -> set[int]:
        return {w for i in self.around[v] for w in self.faces[i]} - {v}

    def best(self, u: int, v: int) -> tuple[float, Floats]:
        """Cost and place of the vertex that would replace an edge."""
        a, b = self.position[u], self.position[v]
        quadric = self.quadric[u] + self.quadric[v]
        choices = [np.append(p, 1.0) for p in (a, b, (a + b) / 2)]
        costs = [float(p @ quadric @ p) for p in choices]
        k = int(np.argmin(costs))
        return costs[k] + 1e-7 * float((a - b) @ (a - b)), choices[k][:3]

    def flips(self, gone: int, kept: int, place: Floats) -> bool:
        """Whether moving a vertex to ``place`` turns one of its faces over."""
        for i in self.around[gone]:
            face = self.faces[i]
            if kept in face:
                continue
            old = self.position[list(face)]
            new = np.array([place if v == gone else p for v, p in zip(face, old, strict=True)])
            before = np.cross(old[1] - old[0], old[2] - old[0])
            after = np.cross(new[1] - new[0], new[2] - new[0])
            lengths = float(np.linalg.norm(before) * np.linalg.norm(after))
            if float(before @ after) < 0.2 * lengths or lengths == 0.0:
                return True
        return False

    def merge(self, u: int, v: int, place: Floats) -> None:
        """Moves ``u`` to ``place`` and lets it take over everything of ``v``."""
        for i in self.around[u] & self.around[v]:
            for w in self.faces.pop(i):
                self.around[w].discard(i)
        for i in self.around[v]:
            a, b, c = (u if w == v else w for w in self.faces[i])
            self.faces[i] = (a, b, c)
        self.around[u] |= self.around[v]
        self.around[v] = set()
        self.position[u] = place
        self.quadric[u] += self.quadric[v]
        self.age[u] += 1
        self.age[v] += 1


def collapsed(vertices: Floats, faces: Indices, count: int) -> tuple[Floats, Indices]:
    """The mesh with at most ``count`` faces, or as few as can be had; closed if it was closed."""
    mesh = _Mesh(vertices, faces)
    queue: list[tuple[float, int, int, int, int]] = []

    def push(u: int, v: int) -> None:
        heapq.heappush(queue, (mesh.best(u, v)[0], u, v, mesh.age[u], mesh.age[v]))

    for u in range(len(vertices)):
        for v in sorted(mesh.neighbours(u)):
            if u < v:
                push(u, v)
    while len(mesh.faces) > count and queue:
        _, u, v, age_u, age_v = heapq.heappop(queue)
        if (mesh.age[u], mesh.age[v]) != (age_u, age_v):
            continue
        place = mesh.best(u, v)[1]
        common = mesh.neighbours(u) & mesh.neighbours(v)
        if len(common) != 2 or mesh.flips(u, v, place) or mesh.flips(v, u, place):
            continue
        mesh.merge(u, v, place)
        for w in sorted(mesh.neighbours(u)):
            push(u, w)
    kept = np.array([mesh.faces[i] for i in sorted(mesh.faces)], np.int64)
    names, compact = np.unique(kept, return_inverse=True)
    return mesh.position[names], compact.reshape(-1, 3)
