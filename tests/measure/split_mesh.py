"""A mesh with four times the triangles, each divided at the middles of its edges: the study's dragon in our size."""

import gzip
from pathlib import Path

import numpy as np


def read_ply(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n, 3) and triangles (m, 3) of an ascii PLY that begins its vertices with x y z; plain or gzip."""
    with gzip.open(path, "rt") if path.suffix == ".gz" else path.open() as file:
        counts = {}
        for line in file:
            words = line.split()
            if words[:1] == ["element"]:
                counts[words[1]] = int(words[2])
            if words == ["end_header"]:
                break
        vertices = [next(file).split()[:3] for _ in range(counts["vertex"])]
        faces = [next(file).split() for _ in range(counts["face"])]
    if any(face[0] != "3" for face in faces):
        raise ValueError(f"{path} has faces that are no triangles")
    return np.array(vertices, dtype=np.float32), np.array(faces, dtype=np.int32)[:, 1:4]


def split(vertices: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    a, b, c = triangles.T
    edges = np.sort(np.concatenate([np.stack(pair, 1) for pair in ((a, b), (b, c), (c, a))]), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = (number.reshape(-1) + len(vertices)).reshape(3, -1)
    middles = (vertices[unique[:, 0]] + vertices[unique[:, 1]]) * np.float32(0.5)
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([vertices, middles]), np.concatenate([np.stack(part, 1) for part in parts]).astype(np.int32)


def ply_bytes(vertices: np.ndarray, triangles: np.ndarray) -> bytes:
    """A binary PLY, little endian."""
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(triangles), dtype=np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    faces["count"], faces["corners"] = 3, triangles
    return header.encode() + vertices.astype("<f4").tobytes() + faces.tobytes()
