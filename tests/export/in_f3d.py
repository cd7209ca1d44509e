# SPDX-License-Identifier: MIT
"""Draws files of `polhode export` with F3D, without a screen, and compares silhouettes with `polhode render`.
usage: in_f3d.py POLHODE SCENES

What is opaque is compared: body, arrows, stand; ours where it covers at least half of a pixel. F3D shows the first moment of a file, so files begin at three
times; it looks through the camera of the file, which is that of the scene, from two sides."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zlib

polhode, scenes = sys.argv[1:]
SIZE = (960, 540)
LEAST = 0.99  # overlap: common area over area of both


def pixels(path):
    """Rows of (r, g, b) of a PNG without interlacing, 8 bits; by the PNG specification."""
    data = path.read_bytes()
    at, packed, width, height, channels = 8, b"", 0, 0, 0
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height = int.from_bytes(body[:4], "big"), int.from_bytes(body[4:8], "big")
            assert body[8] == 8 and body[12] == 0
            channels = {2: 3, 6: 4}[body[9]]
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            up, corner = before[i], before[i - channels] if i >= channels else 0
            if kind == 1:
                line[i] = (line[i] + left) & 255
            elif kind == 2:
                line[i] = (line[i] + up) & 255
            elif kind == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif kind == 4:
                guess = left + up - corner
                ways = (abs(guess - left), abs(guess - up), abs(guess - corner))
                line[i] = (line[i] + (left, up, corner)[ways.index(min(ways))]) & 255
        rows.append([tuple(line[k : k + channels]) for k in range(0, stride, channels)])
        before = line
    return rows


def covered(rows):
    return {(x, y) for y, row in enumerate(rows) for x, color in enumerate(row) if color[3] >= 128}


def drawn(rows):
    """Pixels that differ from the one in the corner."""
    ground = rows[0][0]
    return {
        (x, y)
        for y, row in enumerate(rows)
        for x, color in enumerate(row)
        if max(abs(a - b) for a, b in zip(color[:3], ground)) > 6
    }


def overlap(a, b):
    return len(a & b) / len(a | b)


def check(name, settings, t, direction, folder):
    shown = ["--set", "show.labels=false", "--set", "show.clock=false", "--set", f"camera.direction={direction}"]
    for element in ("space_cone", "body_cone", "precession_cone", "floor", "trail"):
        shown += ["--set", f"show.{element}=false"]
    for setting in settings:
        shown += ["--set", setting]
    scene = f"{scenes}/{name}.toml"
    run = lambda *words: subprocess.run(words, check=True, capture_output=True)
    run(polhode, "export", scene, "-o", f"{folder}/a.glb", "--quiet", "--from", str(t), *shown)
    run(polhode, "render", scene, "-o", f"{folder}/ours.png", "--still", str(t), "--quiet", "--transparent",
        "--size", "{}x{}".format(*SIZE), *shown)
    run("xvfb-run", "-a", "-s", "-screen 0 1920x1200x24", "f3d", f"{folder}/a.glb", f"--output={folder}/theirs.png",
        "--resolution={},{}".format(*SIZE), "--camera-index=0", "--bg-color=0,0,0.2")
    ours = covered(pixels(pathlib.Path(folder, "ours.png")))
    theirs = drawn(pixels(pathlib.Path(folder, "theirs.png")))
    found = overlap(ours, theirs)
    print("ok" if found > LEAST else "BAD", name, f"at {t} s from {direction}: overlap {found:.4f}, {len(ours)} pixels")
    return found > LEAST


if not (shutil.which("f3d") and shutil.which("xvfb-run")):
    print("f3d or xvfb-run is missing: tools/install-dependencies --for lecture")
    sys.exit(77)
with tempfile.TemporaryDirectory() as place:
    good = [
        check(name, settings, t, direction, place)
        for name, settings in (("free_symmetric_top", []), ("heavy_top", []))
        for t in (0.2, 1.3, 2.9)
        for direction in ("[0.82,0.46,0.34]", "[-0.3,0.9,0.2]")
    ]
sys.exit(0 if all(good) else 1)
