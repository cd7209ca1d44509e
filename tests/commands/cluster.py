#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Films, lectures, maps and sections on a real Slurm, and what happens to them there.

usage: cluster.py POLHODE SLURM_HERE [CASE...]
SLURM_HERE (tools/slurm-here) starts Slurm with two nodes of one processor. Products are compared with those of
undivided runs; then tasks are requeued, killed, starved of disk and time, and submitted twice. Without CASE all run.
Exit code 77: Slurm is not installed here.
"""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

SCENE = """format = 1
title = "A brick hung by a corner"
[body]
solid = { kind = "box", size_cm = [24, 11.5, 7], mass = 3 }
pivot_cm = [12, 5.75, 3.5]
[motion]
hold = "pivot"
duration = 4
attitude = { zxz_deg = [20, 100, 30] }
spin = { body = [6, 12, -4] }
[video]
size = "320x180"
fps = 30
"""
DECK = """# A lecture

## The film

![It turns](brick.toml){.film size=320x180 fps=10}

## A picture

![It hangs](brick.toml){.still at=1 size=320x180}

## Numbers

![Its numbers](brick.toml){.inspect}
"""
# about fifty seconds of one processor
MAP = "stability brick.toml --methods rk4,gauss6 --cells 64x64 --turns 600 -o maps"
PATIENCE_S = 600
# each call that writes, renames or flushes takes this long
SLOW_CALLS = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h>
static void wait_a_little(void) { usleep(20000); }
int rename(const char* from, const char* to) {
  wait_a_little();
  return ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename"))(from, to);
}
int fsync(int file) {
  wait_a_little();
  return ((int (*)(int))dlsym(RTLD_NEXT, "fsync"))(file);
}
ssize_t write(int file, const void* bytes, size_t size) {
  wait_a_little();
  return ((ssize_t (*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write"))(file, bytes, size);
}
"""


class Failed(Exception):
    pass


def expect(condition, words):
    if not condition:
        raise Failed(words)


def becomes(condition, words, patience=PATIENCE_S):
    end = time.monotonic() + patience
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.1)
    raise Failed(f"in {patience} s never: {words}")


class Cluster:
    """A folder in which jobs are submitted, and the Slurm that runs them."""

    def __init__(self, polhode, slurm_here, slurm_folder):
        self.polhode, self.slurm_here, self.slurm = polhode, slurm_here, slurm_folder
        self.folder = None

    def begin(self, folder):
        self.folder = folder
        folder.mkdir(exist_ok=True)
        (folder / "brick.toml").write_text(SCENE)
        (folder / "deck.md").write_text(DECK)

    def run(self, words, code=0, **more):
        words = words.split() if isinstance(words, str) else words
        ran = subprocess.run([self.polhode, *words], cwd=self.folder, capture_output=True, text=True,
                             timeout=PATIENCE_S, check=False, **more)
        expect(code is None or ran.returncode == code,
               f"exit code {ran.returncode} of {words}: {ran.stdout}{ran.stderr}")
        return ran

    def submit(self, words, code=0, **more):
        return self.run("submit " + words, code, **more)

    def wait(self, words, code=0):
        return self.submit("--wait --progress none " + words, code)

    def array_of(self, output):
        return json.loads((self.folder / (output + ".job") / "job.json").read_text())["submissions"][-1]["array"]

    def collecting_of(self, output):
        return json.loads((self.folder / (output + ".job") / "job.json").read_text())["submissions"][-1]["collecting"]

    def state(self, job):
        ran = subprocess.run(["squeue", "--noheader", "--array", "--job", job, "--format=%T"], capture_output=True,
                             text=True, check=False)
        return ran.stdout.split()

    def becomes_over(self, output):
        becomes(lambda: not self.state(self.collecting_of(output)), f"{output} is over")

    def processes(self, words):
        """The ids of the programs that do a task: they have all these words in their command line."""
        found = []
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                line = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                folder = os.readlink(entry / "cwd")
            except OSError:
                continue
            if line[0] == self.polhode and all(word in line for word in words) and folder == str(self.folder):
                found.append(int(entry.name))
        return found

    def expect_only(self, output):
        """Nothing is left but the product, the scripts, the logs and the mark that it was collected."""
        job = self.folder / (output + ".job")
        left = sorted(str(path.relative_to(job)) for path in job.rglob("*") if not path.is_dir())
        rest = [name for name in left if not re.fullmatch(r"logs/(task-\d+|collect)\.log", name)]
        expect(rest == ["collect.sh", "job.json", "state/collected", "tasks.sh"], f"left in {job}: {left}")
        hidden = [path for path in self.folder.rglob("*")
                  if re.search(r"\.part$|\.parts$|\.resume|work-", path.name)]
        expect(not hidden, f"left: {hidden}")


def same_bytes(a, b):
    expect(a.read_bytes() == b.read_bytes(), f"{a} and {b} differ")


def frames_of(report):
    return json.loads(report.read_text())["frame_hashes"]


# --- products are those of undivided runs

def case_film(c):
    words = "render brick.toml --pieces 8"
    c.run("render brick.toml -o whole.mp4 --report whole.json")
    c.run("render brick.toml -o resumed.mp4 --resume --pieces 8")
    c.wait(f"--tasks 4 {words} -o film.mp4 --report film.json")
    expect(frames_of(c.folder / "whole.json") == frames_of(c.folder / "film.json"), "frames differ")
    same_bytes(c.folder / "resumed.mp4", c.folder / "film.mp4")
    c.expect_only("film.mp4")
    # what is there is not made again
    expect("is there" in c.submit(f"--tasks 4 {words} -o film.mp4 --report film.json").stdout, "made twice")
    (c.folder / "film.mp4").unlink()
    c.wait(f"--tasks 4 {words} -o film.mp4 --report film.json")
    same_bytes(c.folder / "resumed.mp4", c.folder / "film.mp4")


def case_map(c):
    words = "stability brick.toml --methods rk4,gauss6,explicit_euler --cells 12x13 --turns 10"
    c.run(f"{words} -o whole")
    c.wait(f"--tasks 5 {words} -o maps")
    same_bytes(c.folder / "whole/stability.csv", c.folder / "maps/stability.csv")
    c.expect_only("maps")
    keys = "--x motion.spin.body[2] --y body.solid.mass"
    c.run(f"{words} {keys} -o whole2")
    c.wait(f"--tasks 4 {words} {keys} -o maps2")
    same_bytes(c.folder / "whole2/stability.csv", c.folder / "maps2/stability.csv")


def case_section(c):
    c.run("section brick.toml --starts 9 --crossings 60 -o whole")
    c.wait("--tasks 4 section brick.toml --starts 9 --crossings 60 -o section")
    same_bytes(c.folder / "whole/section.csv", c.folder / "section/section.csv")
    c.expect_only("section")
    keys = "--x motion.spin.body[1] --y motion.spin.body[0] --cells 6x7 --crossings 30"
    c.run(f"section brick.toml {keys} -o whole2")
    c.wait(f"--tasks 3 section brick.toml {keys} -o map")
    same_bytes(c.folder / "whole2/section_map.csv", c.folder / "map/section_map.csv")


def case_chart(c):
    """All but the times, and how far fast machines go."""
    def points(folder):
        with open(c.folder / folder / "chart.csv", encoding="utf-8") as file:
            return {(row["method"], row["step"]): {key: value for key, value in row.items() if key != "time_us"}
                    for row in csv.DictReader(file)}
    words = "chart brick.toml --methods rk4,gauss6,dop853"
    c.run(f"{words} -o whole")
    c.wait(f"--tasks 3 {words} -o chart")
    a, b = points("whole"), points("chart")
    both = a.keys() & b.keys()
    expect(len(both) >= 0.8 * max(len(a), len(b)), f"{len(both)} common points of {len(a)} and {len(b)}")
    expect(all(a[key] == b[key] for key in both), "points differ")
    c.expect_only("chart")


def case_lecture(c):
    c.run("lecture deck.md --to html,data -o whole")
    c.wait("--tasks 3 lecture deck.md --to html,data -o lecture")
    same_bytes(c.folder / "whole/index.html", c.folder / "lecture/index.html")
    films = sorted(path.name for path in (c.folder / "whole/media").glob("*.mp4"))
    expect(films, "no film")
    for name in films + ["../data/manifest.json"]:
        if name.endswith(".mp4"):
            same_bytes(c.folder / "whole/media" / name, c.folder / "lecture/media" / name)
    expect(", 0 made now" in (c.folder / "lecture.job/logs/collect.log").read_text(), "the collecting job made some")
    c.expect_only("lecture")


def case_names(c):
    """Names that shells, Slurm and options would like to take for something else."""
    here = c.folder / "it's 100%a $(false) \"x\";#é"
    c.begin(here)
    (here / "brick.toml").rename(here / "-br ick&.toml")
    words = ["submit", "--wait", "--progress", "none", "--tasks", "2", "stability", "./-br ick&.toml", "--methods", "rk4",
             "--cells", "4x4", "--turns", "5", "-o", "m'a ps%j"]
    c.run(words)
    expect((here / "m'a ps%j/stability.csv").exists(), "no map")
    c.expect_only("m'a ps%j")


# --- what happens to tasks

def undisturbed_map(c):
    whole = c.folder.parent / "undisturbed"
    if not (whole / "maps/stability.csv").exists():
        keep = c.folder
        c.begin(whole)
        c.run(MAP)
        c.begin(keep)
    return whole / "maps/stability.csv"


def case_requeue(c):
    right = undisturbed_map(c)
    c.submit(f"--tasks 3 {MAP}")
    becomes(lambda: c.processes(["1/3"]), "task 1 runs")
    time.sleep(2)
    subprocess.run(["scontrol", "requeue", c.array_of("maps") + "_1"], check=True)
    c.wait(MAP)
    same_bytes(right, c.folder / "maps/stability.csv")
    log = (c.folder / "maps.job/logs/task-1.log").read_text()
    expect(log.count("task 1 of 3 on") == 2, f"not begun twice: {log}")
    c.expect_only("maps")


def case_killed_task(c):
    right = undisturbed_map(c)
    c.submit(f"--tasks 3 {MAP}")
    becomes(lambda: c.processes(["2/3"]), "task 2 runs")
    time.sleep(2)
    for process in c.processes(["2/3"]):
        os.kill(process, signal.SIGKILL)
    c.becomes_over("maps")
    said = c.run("status maps.job", 1).stdout
    expect("2 of 3 tasks done, 1 failed" in said and "task 2: exit code 137" in said, said)
    expect(not (c.folder / "maps/stability.csv").exists(), "collected without a task")
    log = (c.folder / "maps.job/logs/collect.log").read_text()
    expect("task 2: exit code 137" in log, f"the collecting job said: {log}")
    said = c.wait(MAP).stdout
    expect("1 of 3 tasks" in said, said)
    same_bytes(right, c.folder / "maps/stability.csv")
    c.expect_only("maps")


def case_killed_node(c):
    """Its task is begun again elsewhere, though its processes go on where nobody sees them."""
    right = undisturbed_map(c)
    c.submit(f"--tasks 2 {MAP}")
    becomes(lambda: len(c.processes(["1/2"])) + len(c.processes(["2/2"])) == 2, "both tasks run")
    node = c.slurm / "slurmd_node1.pid"
    os.kill(int(node.read_text()), signal.SIGKILL)
    try:
        c.wait(MAP)
    finally:
        subprocess.run([c.slurm_here, "node", str(c.slurm), "node1"], check=True)
    same_bytes(right, c.folder / "maps/stability.csv")
    logs = "".join(path.read_text() for path in (c.folder / "maps.job/logs").glob("task-*.log"))
    expect(logs.count(" of 2 on ") == 3, f"no task was begun again: {logs}")
    becomes(lambda: not c.processes(["stability"]), "the last process has ended")
    becomes(lambda: subprocess.run(["sinfo", "--noheader", "--states=idle", "--format=%D"], capture_output=True,
                                   text=True, check=False).stdout.strip() == "2", "both nodes are back")


def case_killed_node_with_film(c):
    words = "render brick.toml --pieces 4 --size 1280x720 -o film.mp4"
    c.run("render brick.toml --pieces 4 --size 1280x720 --resume -o whole.mp4")
    c.submit(f"--tasks 2 {words}")
    becomes(lambda: c.processes(["1/2"]), "task 1 runs")
    os.kill(int((c.slurm / "slurmd_node1.pid").read_text()), signal.SIGKILL)
    try:
        c.wait(words)
    finally:
        subprocess.run([c.slurm_here, "node", str(c.slurm), "node1"], check=True)
    same_bytes(c.folder / "whole.mp4", c.folder / "film.mp4")
    becomes(lambda: subprocess.run(["sinfo", "--noheader", "--states=idle", "--format=%D"], capture_output=True,
                                   text=True, check=False).stdout.strip() == "2", "both nodes are back")


def case_full_disk(c):
    if os.geteuid() != 0:
        print("  (skipped: only root may mount a small disk)")
        return
    disk = c.folder / "disk"
    disk.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=700k", "none", str(disk)], check=False)
    if mounted.returncode != 0:
        print("  (skipped: no disk can be mounted here)")
        return
    try:
        words = "render brick.toml --pieces 4 --crf 1 --size 1280x720 -o disk/film.mp4"
        c.wait(f"--tasks 2 {words}", 1)
        said = c.run("status disk/film.mp4", 1).stdout
        expect("No space left on device" in said, said)
        expect(not (disk / "film.mp4").exists(), "half a film")
        subprocess.run(["mount", "-o", "remount,size=100m", str(disk)], check=True)
        c.wait(words)
        c.run("render brick.toml --resume --pieces 4 --crf 1 --size 1280x720 -o whole.mp4")
        same_bytes(c.folder / "whole.mp4", disk / "film.mp4")
        c.expect_only("disk/film.mp4")
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)


def case_time_limit(c):
    """Slurm counts minutes, and looks twice a minute: the task is made longer than that by stopping it."""
    right = undisturbed_map(c)
    c.submit(f"--time 1 --tasks 2 {MAP}")
    becomes(lambda: list((c.folder / "maps").glob("*.1-of-2.*")), "task 1 has finished a row")
    stopped = c.processes(["1/2"])
    for process in stopped:
        os.kill(process, signal.SIGSTOP)
    becomes(lambda: not c.processes(["1/2"]), "task 1 is ended by its limit")
    c.becomes_over("maps")
    said = c.run("status maps", 1).stdout
    expect("task 1: TIMEOUT" in said and "DUE TO TIME LIMIT" in said, said)
    c.wait(MAP)
    same_bytes(right, c.folder / "maps/stability.csv")
    log = (c.folder / "maps.job/logs/task-1.log").read_text()
    kept = re.findall(r"part 1/2: \d+ of \d+ rows, (\d+) of them from earlier runs", log)
    expect(kept and int(kept[-1]) > 0, f"it began from nothing: {log}")
    c.expect_only("maps")


def case_slow_folder(c):
    """Pieces appear whole, however slowly they are written."""
    (c.folder / "slow.c").write_text(SLOW_CALLS)
    built = subprocess.run(["cc", "-shared", "-fPIC", "-o", "slow.so", "slow.c", "-ldl"], cwd=c.folder, check=False)
    expect(built.returncode == 0, "no compiler")
    words = "render brick.toml --pieces 8 -o film.mp4"
    seen, changed, over = {}, [], threading.Event()

    def watch():
        while not over.is_set():
            for path in (c.folder / ".film.mp4.parts").glob("*.mp4"):
                try:
                    size = path.stat().st_size
                except OSError:
                    continue
                if seen.setdefault(path.name, size) != size:
                    changed.append(path.name)
            time.sleep(0.002)
    watcher = threading.Thread(target=watch)
    watcher.start()
    try:
        c.submit(f"--tasks 4 {words}", env={**os.environ, "LD_PRELOAD": str(c.folder / "slow.so")})
        c.wait(words)
    finally:
        over.set()
        watcher.join()
    expect(len(seen) == 8 and not changed, f"{len(seen)} pieces seen, changed: {changed}")
    c.run("render brick.toml --resume --pieces 8 -o whole.mp4")
    same_bytes(c.folder / "whole.mp4", c.folder / "film.mp4")


def case_two_submits(c):
    right = undisturbed_map(c)
    words = [c.polhode, "submit", "--tasks", "2", *MAP.split()]
    both = [subprocess.Popen(words, cwd=c.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            for _ in range(2)]
    said = [run.communicate(timeout=PATIENCE_S) for run in both]
    text = "".join(out + err for out, err in said)
    expect(text.count(" submitted as Slurm job ") == 1 + text.count("already submitted"), text)
    expect("already submitted" in text or "another run" in text, text)
    tasks = subprocess.run(["squeue", "--noheader", "--array", "--format=%i"], capture_output=True, text=True, check=True)
    expect(len(tasks.stdout.split()) == 3, f"queued: {tasks.stdout}")
    c.wait(MAP)
    same_bytes(right, c.folder / "maps/stability.csv")


def case_cancelled(c):
    right = undisturbed_map(c)
    c.submit(f"--tasks 4 {MAP}")
    becomes(lambda: c.processes(["1/4"]), "task 1 runs")
    time.sleep(3)
    expect("taken back" in c.run("cancel maps.job").stdout, "not taken back")
    becomes(lambda: not c.processes(["stability"]) and not c.state(c.array_of("maps")), "all are gone")
    c.becomes_over("maps")
    said = c.run("status maps.job", 1).stdout
    expect("CANCELLED" in said or "exit code 130" in said, said)
    expect("nothing is queued" in c.run("cancel maps.job").stdout, "still queued")
    c.wait(MAP)
    same_bytes(right, c.folder / "maps/stability.csv")
    c.expect_only("maps")


def case_changed_scene(c):
    c.submit(f"--at-once 1 --tasks 3 {MAP}")
    becomes(lambda: c.processes(["1/3"]), "task 1 runs")
    (c.folder / "brick.toml").write_text(SCENE.replace("[6, 12, -4]", "[6, 12, -5]"))
    ran = c.submit(MAP, 2)
    expect("other work is queued for this output" in ran.stderr, ran.stderr)
    c.becomes_over("maps")
    said = c.run("status maps.job", 1).stdout
    expect("task 2: exit code 2: polhode: --submitted: a scene, an option or the program has changed" in said, said)
    # the changed scene is work of its own
    c.wait(f"--tasks 2 {MAP}")
    c.run(MAP.replace("-o maps", "-o whole"))
    same_bytes(c.folder / "whole/stability.csv", c.folder / "maps/stability.csv")


CASES = {name[5:]: value for name, value in list(globals().items()) if name.startswith("case_")}


def main():
    polhode, slurm_here = (str(Path(path).resolve()) for path in sys.argv[1:3])
    wanted = sys.argv[3:] or list(CASES)
    place = Path(tempfile.mkdtemp(prefix="polhode-cluster-"))
    slurm = place / "slurm"
    started = subprocess.run([slurm_here, "start", str(slurm)], check=False)
    if started.returncode != 0:
        shutil.rmtree(place)
        return 77 if shutil.which("sbatch") is None else 1
    os.environ["SLURM_CONF"] = str(slurm / "slurm.conf")
    failed = []
    try:
        for name in wanted:
            cluster = Cluster(polhode, slurm_here, slurm)
            cluster.begin(place / name)
            began = time.monotonic()
            try:
                CASES[name](cluster)
                print(f"{name}: ok, {time.monotonic() - began:.0f} s", flush=True)
            except (Failed, subprocess.SubprocessError, OSError) as error:
                print(f"{name}: FAILED: {error}", flush=True)
                failed.append(name)
                subprocess.run(["scancel", "--user", str(os.geteuid())], check=False)
    finally:
        subprocess.run([slurm_here, "stop", str(slurm)], check=False)
        if failed:
            print(f"what is left is in {place}")
        else:
            shutil.rmtree(place)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
