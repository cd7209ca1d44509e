# SPDX-License-Identifier: MIT
"""Lets Blender import files of `polhode export` and compares the attitude of the body with `polhode simulate`.
usage: in_blender.py POLHODE SCENES"""
import json
import math
import pathlib
import shutil
import sys
import tempfile

# Blender keeps attitudes in single precision and interpolates the four parts of a quaternion each by
# itself, so between key times it is not what the file says; frames are compared at key times.
ALLOWED = 1e-6

# Blender 3.4 of Debian 12 calls numpy.bool, which numpy 1.24 has no more
INSIDE = """
import numpy
numpy.bool = bool
import bpy, json, sys
where, out = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.render.fps = 1000
bpy.ops.import_scene.gltf(filepath=where, import_pack_images=False)
scene = bpy.context.scene
found = {"names": [one.name for one in bpy.data.objects], "frames": []}
for keyed in json.load(open(where + ".times")):
    frame = keyed * scene.render.fps / scene.render.fps_base
    scene.frame_set(int(frame // 1), subframe=frame % 1)
    body = bpy.data.objects["body_frame"].matrix_world
    found["frames"].append([keyed, [list(row) for row in body]])
json.dump(found, open(out, "w"))
"""


def main():
    polhode, scenes = sys.argv[1:]
    if not shutil.which("blender"):
        print("blender is missing: tools/install-dependencies --for lecture")
        return 77
    sys.path.insert(0, str(pathlib.Path(__file__).parent))
    from glb import Glb
    from simulated import attitude, output_of, row_at

    with tempfile.TemporaryDirectory() as place:
        script = pathlib.Path(place, "inside.py")
        script.write_text(INSIDE)
        for name in ("free_symmetric_top", "t_handle"):
            scene = f"{scenes}/{name}.toml"
            where, out = f"{place}/{name}.glb", f"{place}/{name}.json"
            output_of(polhode, "export", scene, "-o", where, "--quiet")
            glb = Glb(pathlib.Path(where).read_bytes())
            keys = glb.key_times("body_frame")
            chosen = keys[1 :: max(1, len(keys) // 15)]
            pathlib.Path(where + ".times").write_text(json.dumps(chosen))
            said = output_of("env", "PATH=/usr/bin:/bin", "blender", "--background", "--factory-startup", "--python", str(script), "--", where, out)
            assert pathlib.Path(out).exists(), said.decode()
            found = json.loads(pathlib.Path(out).read_text())
            assert {"body", "omega.arrow", "momentum.arrow"} <= set(found["names"]), found["names"]
            scale = glb.json["asset"]["extras"]["time_scale"]
            worst = 0.0
            for played, seen in found["frames"]:
                w, x, y, z = attitude(row_at(polhode, scene, played * scale))
                exact = [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
                ]
                # Blender turns the axes of every object: its y is our -z, its z our y
                ours = [[row[0], row[2], -row[1]] for row in seen]
                worst = max(worst, *(math.dist(a, b) for a, b in zip(exact, ours)))
            print("ok" if worst < ALLOWED else "BAD", name, f"{len(chosen)} frames, {worst:.2g}")
            if worst >= ALLOWED:
                return 1
    return 0


sys.exit(main())
