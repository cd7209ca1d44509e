# SPDX-License-Identifier: MIT
"""Compares files of `polhode export`, read by an independent reader (glb.py), with `polhode simulate`.
usage: check_glb.py POLHODE SCENES

At the key times of "body_frame" attitude and place agree to 1e-6 (single precision has 7 digits); at other times
within the accuracy that the file tells of, and to 1e-6 where that was asked for. Arrows of angular velocity and
angular momentum point along them, with lengths in proportion."""
import math
import sys

from glb import Glb, applied, normalized
from simulated import attitude, output_of, row_at, rows, turned

polhode, scenes = sys.argv[1:]
FINEST = 1e-6


AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def exported(scene, settings=()):
    return Glb(output_of(polhode, "export", scene, "-o", "-", "--quiet", *settings))


def axis_in_space(matrix, axis):
    return [a - b for a, b in zip(applied(matrix, axis), applied(matrix, (0, 0, 0)))]


def check(name, settings=(), fine=False):
    scene = f"{scenes}/{name}.toml"
    accuracy = ["--accuracy", "1e-6"] if fine else []
    glb = exported(scene, [*settings, *accuracy])
    about = glb.json["asset"]["extras"]
    radius, origin, scale = about["body_radius"], about["origin"], about["time_scale"]
    motion = rows(polhode, scene, [*settings, *accuracy], 200.0 / about["to"])
    allowed = FINEST if fine else about["accuracy"]["asked_m"] / radius
    most = {"omega": max(math.hypot(row["wx"], row["wy"], row["wz"]) for row in motion),
            "momentum": max(math.hypot(row["Lx"], row["Ly"], row["Lz"]) for row in motion)}
    center = None
    lengths = {"omega": [], "momentum": []}
    worst = 0.0
    for row in motion:
        matrix = glb.world("body_frame", row["t"] / scale, above="space")
        q = attitude(row)
        for axis in AXES:
            worst = max(worst, math.dist(axis_in_space(matrix, axis), turned(q, axis)))
        # the centre of mass keeps its place in the body
        at = [row["x"] - origin[0], row["y"] - origin[1], row["z"] - origin[2]]
        offset = [a - b for a, b in zip(at, applied(matrix, (0, 0, 0)))]
        in_body = turned([q[0], -q[1], -q[2], -q[3]], offset)
        center = center or in_body
        worst = max(worst, math.dist(center, in_body) / radius / 2)
        vectors = {
            "omega": turned(q, [row["wx"], row["wy"], row["wz"]]),
            "momentum": [row["Lx"], row["Ly"], row["Lz"]],
        }
        for element, vector in vectors.items():
            size = math.hypot(*vector)
            if size < 0.1 * most[element] or not glb.has(f"{element}.arrow"):
                continue
            head = glb.world(f"{element}.arrow.head", row["t"] / scale, above="space")
            foot = applied(glb.world(f"{element}.arrow", row["t"] / scale, above="space"), (0, 0, 0))
            along = [a - b for a, b in zip(applied(head, (0, 0, 1)), foot)]
            worst = max(worst, math.dist(normalized(along), normalized(vector)))
            lengths[element].append(math.hypot(*along) / size)
    for element, ratios in lengths.items():
        if ratios:
            worst = max(worst, (max(ratios) - min(ratios)) / max(ratios) / 2)
    keys = glb.key_times("body_frame")
    assert worst <= allowed, f"{name}: {worst:.3g} from simulate, allowed {allowed:.3g}"
    assert about["accuracy"]["measured_m"] <= about["accuracy"]["asked_m"], about["accuracy"]
    print(f"ok {name} {' '.join(settings)}: {len(keys)} keys, {worst:.2g} of {allowed:.2g}")


def check_at_keys(name):
    """At its key times the body is where it should be, as exactly as single precision says it."""
    scene = f"{scenes}/{name}.toml"
    glb = exported(scene)
    scale = glb.json["asset"]["extras"]["time_scale"]
    keys = glb.key_times("body_frame")
    for played in keys[1 :: max(1, len(keys) // 12)]:
        t = played * scale
        q = attitude(row_at(polhode, scene, t))
        matrix = glb.world("body_frame", played, above="space")
        for axis in AXES:
            assert math.dist(axis_in_space(matrix, axis), turned(q, axis)) < FINEST, f"{name} at {t}"
    print(f"ok {name} at key times")


check_at_keys("free_symmetric_top")
check_at_keys("heavy_top")
check("free_symmetric_top")
check("free_symmetric_top", fine=True)
check("heavy_top")
check("t_handle", fine=True)
check("toutatis")
check("single_force")
check("free_rotator")
