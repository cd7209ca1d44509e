# SPDX-License-Identifier: MIT
"""Reads binary glTF by its specification (Khronos, glTF 2.0), apart from the program's own writer: nodes, and
where they are at a time. Matrices are lists of four rows."""
import bisect
import json
import math
import struct


class Glb:
    def __init__(self, data):
        magic, version, length = struct.unpack_from("<III", data, 0)
        assert (magic, version, length) == (0x46546C67, 2, len(data)), "no binary glTF 2.0"
        size, kind = struct.unpack_from("<II", data, 12)
        assert kind == 0x4E4F534A
        self.json = json.loads(data[20 : 20 + size])
        at = 20 + size
        size, kind = struct.unpack_from("<II", data, at)
        assert kind == 0x004E4942
        self.binary = data[at + 8 : at + 8 + size]
        self.nodes = self.json["nodes"]
        self.parents = {child: i for i, node in enumerate(self.nodes) for child in node.get("children", [])}
        self.tracks = {}
        for animation in self.json.get("animations", []):
            for channel in animation["channels"]:
                sampler = animation["samplers"][channel["sampler"]]
                times = [row[0] for row in self.rows(sampler["input"])]
                assert all(a < b for a, b in zip(times, times[1:])), "times do not ascend"
                target = channel["target"]
                self.tracks[target["node"], target["path"]] = (
                    times, self.rows(sampler["output"]), sampler.get("interpolation", "LINEAR"))

    def rows(self, index):
        """The rows of an accessor of floats."""
        accessor = self.json["accessors"][index]
        assert accessor["componentType"] == 5126
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        values = struct.unpack_from(f"<{width * accessor['count']}f", self.binary, start)
        return [values[k : k + width] for k in range(0, len(values), width)]

    def index(self, name):
        found = [i for i, node in enumerate(self.nodes) if node.get("name") == name]
        assert len(found) == 1, f"{len(found)} nodes are called {name}"
        return found[0]

    def has(self, name):
        return any(node.get("name") == name for node in self.nodes)

    def key_times(self, name):
        node = self.index(name)
        return sorted({t for (of, _), track in self.tracks.items() if of == node for t in track[0]})

    def value(self, node, path, t):
        default = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}[path]
        if (node, path) not in self.tracks:
            return self.nodes[node].get(path, default)
        times, values, interpolation = self.tracks[node, path]
        i = bisect.bisect_right(times, t) - 1
        if i < 0:
            return values[0]
        if i + 1 == len(times) or interpolation == "STEP":
            return values[i]
        part = (t - times[i]) / (times[i + 1] - times[i])
        return (slerp if path == "rotation" else lerp)(values[i], values[i + 1], part)

    def local(self, node, t):
        x, y, z, w = normalized(self.value(node, "rotation", t))
        sx, sy, sz = self.value(node, "scale", t)
        tx, ty, tz = self.value(node, "translation", t)
        return [
            [(1 - 2 * (y * y + z * z)) * sx, 2 * (x * y - z * w) * sy, 2 * (x * z + y * w) * sz, tx],
            [2 * (x * y + z * w) * sx, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z - x * w) * sz, ty],
            [2 * (x * z - y * w) * sx, 2 * (y * z + x * w) * sy, (1 - 2 * (x * x + y * y)) * sz, tz],
            [0, 0, 0, 1],
        ]

    def world(self, name, t, above=None):
        """From the node's coordinates to those of the scene, or of the node `above` it."""
        node = self.index(name)
        stop = None if above is None else self.index(above)
        matrix = self.local(node, t)
        while node in self.parents and self.parents[node] != stop:
            node = self.parents[node]
            matrix = times(self.local(node, t), matrix)
        return matrix


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def applied(matrix, point):
    return [sum(matrix[i][k] * point[k] for k in range(3)) + matrix[i][3] for i in range(3)]


def lerp(a, b, part):
    return [x + part * (y - x) for x, y in zip(a, b)]


def normalized(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def slerp(a, b, part):
    cosine = sum(x * y for x, y in zip(a, b))
    if cosine < 0:
        b, cosine = [-y for y in b], -cosine
    if cosine > 1 - 1e-9:
        return normalized(lerp(a, b, part))
    angle = math.acos(min(1.0, cosine))
    return normalized([
        (math.sin((1 - part) * angle) * x + math.sin(part * angle) * y) / math.sin(angle) for x, y in zip(a, b)])
