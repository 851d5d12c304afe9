# SPDX-License-Identifier: Apache-2.0
"""Which points lie inside the surfaces of an STL, OBJ, PLY or GLB file, read by its format's own
rules: a 0 or 1 a point, by how often a ray from it passes a triangle.

The second file has a point a line, LPS mm. Third: the axes of the numbers in the file, LPS or RAS
(a GLB file has its own: metres, X to the left, Y up, Z forward).
"""
import json
import struct
import sys

import numpy


def stl(data):
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count
    rows = numpy.frombuffer(data, numpy.uint8, offset=84).reshape(count, 50)
    return rows[:, 12:48].copy().view("<f4").reshape(count, 3, 3)


def obj(data):
    points, faces = [], []
    for line in data.decode().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return numpy.array(points)[numpy.array(faces)]


def ply(data):
    types = {"float": "f", "uchar": "B", "uint": "I", "int": "i", "ushort": "H"}
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements, at = [], end
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "format":
            assert words[1] == "binary_little_endian"
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    points, faces = [], []
    for name, count, properties in elements:
        for _ in range(count):
            found = {}
            for words in properties:
                if words[0] == "list":
                    size = struct.unpack_from("<" + types[words[1]], data, at)[0]
                    at += struct.calcsize(types[words[1]])
                    form = "<%d%s" % (size, types[words[2]])
                    found[words[3]] = struct.unpack_from(form, data, at)
                else:
                    form = "<" + types[words[0]]
                    found[words[1]] = struct.unpack_from(form, data, at)[0]
                at += struct.calcsize(form)
            if name == "vertex":
                points.append([found["x"], found["y"], found["z"]])
            else:
                faces.append(found["vertex_indices"])
    return numpy.array(points)[numpy.array(faces)]


def glb(data):
    magic, version, _, size, kind = struct.unpack_from("<4sIIII", data)
    assert magic == b"glTF" and version == 2 and kind == 0x4E4F534A
    scene = json.loads(data[20:20 + size])
    binary = data[28 + size:]

    def values(number, form, width):
        accessor = scene["accessors"][number]
        view = scene["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = numpy.frombuffer(binary, form, accessor["count"] * width, start)
        return flat.reshape(-1, width)

    triangles = []

    def visit(number, above):
        node = scene["nodes"][number]
        assert not {"rotation", "scale", "translation"} & set(node)
        # Matrices stand in files column by column.
        own = numpy.array(node.get("matrix", numpy.eye(4).ravel())).reshape(4, 4).T
        world = above @ own
        if "mesh" in node:
            for part in scene["meshes"][node["mesh"]]["primitives"]:
                points = values(part["attributes"]["POSITION"], "<f4", 3).astype(float)
                points = points @ world[:3, :3].T + world[:3, 3]
                corners = values(part["indices"], "<u4", 1).reshape(-1, 3)
                triangles.append(points[corners])
        for child in node.get("children", []):
            visit(child, world)

    for root in scene["scenes"][scene["scene"]]["nodes"]:
        visit(root, numpy.eye(4))
    metres = numpy.concatenate(triangles)
    return 1000.0 * numpy.stack([metres[..., 0], -metres[..., 2], metres[..., 1]], axis=-1)


def inside(points, triangles):
    ray = numpy.array([0.8017, 0.4613, 0.3797])
    a = triangles[:, 0]
    ab = triangles[:, 1] - a
    ac = triangles[:, 2] - a
    p = numpy.cross(ray, ac)
    determinant = (ab * p).sum(axis=1)
    marks = []
    for point in points:
        to = point - a
        u = (to * p).sum(axis=1) / determinant
        q = numpy.cross(to, ab)
        v = q @ ray / determinant
        t = (ac * q).sum(axis=1) / determinant
        passed = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)
        marks.append(int(passed.sum()) % 2)
    return marks


path, places, axes = sys.argv[1:4]
with open(path, "rb") as file:
    ending = path.rsplit(".", 1)[1]
    read = {"stl": stl, "obj": obj, "ply": ply, "glb": glb}[ending](file.read()).astype(float)
if axes == "RAS" and ending != "glb":
    read = read * numpy.array([-1.0, -1.0, 1.0])
# Triangles without an area are no walls.
sizes = numpy.linalg.norm(numpy.cross(read[:, 1] - read[:, 0], read[:, 2] - read[:, 0]), axis=1)
print("".join(str(mark) for mark in inside(numpy.loadtxt(places), read[sizes > 0])))
