"""Gamma Mesh Format files for the examples: reads .mesh, .meshb and .solb, writes .meshb and .solb. numpy only."""
import struct
from dataclasses import dataclass, field

import numpy as np

_VERTICES, _TRIANGLES, _TETRAHEDRA, _DIMENSION, _END, _SOLUTION = 4, 6, 8, 3, 54, 62
_NAMES = {"Vertices": (_VERTICES, 3), "Triangles": (_TRIANGLES, 3), "Tetrahedra": (_TETRAHEDRA, 4)}


def _none(width):
    return field(default_factory=lambda: np.empty((0, width) if width else 0, np.int64))


@dataclass
class Mesh:
    """Zero-based indices; triangle_refs are patches, tetrahedron_refs are regions."""
    points: np.ndarray
    tetrahedra: np.ndarray
    triangles: np.ndarray = _none(3)
    tetrahedron_refs: np.ndarray = _none(0)
    triangle_refs: np.ndarray = _none(0)


def read_mesh(path):
    path = str(path)
    blocks = _binary_blocks(path) if path.endswith("b") else _text_blocks(path)
    points, _ = blocks[_VERTICES]
    tetrahedra, regions = blocks[_TETRAHEDRA]
    triangles, patches = blocks.get(_TRIANGLES, (np.empty((0, 3)), np.empty(0)))
    whole = lambda a: a.astype(np.int64)
    return Mesh(points, whole(tetrahedra) - 1, whole(triangles) - 1, whole(regions), whole(patches))


def _binary_blocks(path):
    data = open(path, "rb").read()
    order = "<" if data[0] == 1 else ">"
    version = struct.unpack_from(order + "i", data, 4)[0]
    real = order + ("f4" if version == 1 else "f8")
    index = order + ("i8" if version >= 4 else "i4")
    offset = order + ("q" if version >= 3 else "i")
    widths = dict(_NAMES.values())
    at, blocks = 8, {}
    while at:
        keyword = struct.unpack_from(order + "i", data, at)[0]
        if keyword == _END:
            break
        begin = at + 4 + struct.calcsize(offset)
        at = struct.unpack_from(offset, data, at + 4)[0]
        if keyword in widths:
            count = int(np.frombuffer(data, index, 1, begin)[0])
            kind = real if keyword == _VERTICES else index
            row = np.dtype([("values", kind, widths[keyword]), ("ref", index)])
            rows = np.frombuffer(data, row, count, begin + np.dtype(index).itemsize)
            blocks[keyword] = rows["values"].astype(kind[1:]), rows["ref"]
    return blocks


def _text_blocks(path):
    words = open(path).read().split()
    blocks = {}
    at = 0
    while at < len(words):
        keyword, width = _NAMES.get(words[at], (None, 0))
        at += 1
        if keyword:
            count, begin = int(words[at]), at + 1
            at = begin + count * (width + 1)
            rows = np.array(words[begin:at], float).reshape(count, width + 1)
            blocks[keyword] = rows[:, :-1], rows[:, -1]
    return blocks


def read_solution(path):
    """The one field of a .solb of version 2 or 3: numbers, shape (n,), or tensors, shape (n, 3, 3)."""
    data = open(path, "rb").read()
    offset = "<q" if struct.unpack_from("<i", data, 4)[0] >= 3 else "<i"
    at = 8
    while struct.unpack_from("<i", data, at)[0] != _SOLUTION:
        at = struct.unpack_from(offset, data, at + 4)[0]
    begin = at + 4 + struct.calcsize(offset)
    count, fields, kind = struct.unpack_from("<3i", data, begin)
    assert fields == 1 and kind in (1, 3)
    if kind == 1:
        return np.frombuffer(data, "<f8", count, begin + 12)
    values = np.frombuffer(data, "<f8", 6 * count, begin + 12).reshape(count, 6)
    return values[:, [0, 1, 3, 1, 2, 4, 3, 4, 5]].reshape(count, 3, 3)


def write_mesh(path, mesh):
    def rows(values, refs, kind):
        out = np.zeros(len(values), [("values", kind, values.shape[1]), ("ref", "<i4")])
        out["values"] = values
        out["ref"] = refs if len(refs) else 0
        return _int(len(values)) + out.tobytes()

    _write(path, [
        (_VERTICES, rows(mesh.points, [], "<f8")),
        (_TRIANGLES, rows(mesh.triangles + 1, mesh.triangle_refs, "<i4")),
        (_TETRAHEDRA, rows(mesh.tetrahedra + 1, mesh.tetrahedron_refs, "<i4")),
    ])


def write_solution(path, values):
    """`values` at the vertices: numbers, shape (n,), or tensors, shape (n, 3, 3)."""
    kind = 1
    if values.ndim == 3:
        kind, values = 3, values[:, [0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]]  # xx, xy, yy, xz, yz, zz
    _write(path, [(_SOLUTION, _int(len(values)) + _int(1) + _int(kind) + values.astype("<f8").tobytes())])


def _int(value):
    return struct.pack("<i", value)


def _write(path, blocks):
    """Version 2: 32-bit offsets; after each keyword, the position of the next one."""
    out = _int(1) + _int(2)
    for keyword, content in [(_DIMENSION, _int(3)), *blocks]:
        out += _int(keyword) + _int(len(out) + 8 + len(content)) + content
    with open(path, "wb") as file:
        file.write(out + _int(_END) + _int(0))
