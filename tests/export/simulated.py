# SPDX-License-Identifier: MIT
"""The motion as `polhode simulate` tells it, and rotations by quaternions (w, x, y, z)."""
import csv
import io
import subprocess


def output_of(*words):
    return subprocess.run(words, check=True, capture_output=True).stdout


def rows(polhode, scene, settings, rate):
    text = output_of(polhode, "simulate", scene, "-o", "-", "--rate", repr(rate), *settings).decode()
    return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(io.StringIO(text))]


def row_at(polhode, scene, t):
    """The row of one time, s of motion, greater than 0."""
    row = rows(polhode, scene, [], 1.0 / t)[1]
    assert abs(row["t"] - t) < 1e-12 * max(1.0, t)
    return row


def attitude(row):
    return [row[k] for k in ("qw", "qx", "qy", "qz")]


def turned(q, v):
    w, x, y, z = q
    first = [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]]
    second = [y * first[2] - z * first[1], z * first[0] - x * first[2], x * first[1] - y * first[0]]
    return [v[i] + 2 * (w * first[i] + second[i]) for i in range(3)]
