#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes system calls fail, one at a time, while a short film is made over an old one.

usage: fail_each_call.py POLHODE [--every N]
Whatever fails, the run must say so in one line, end with the right exit code, keep the old film or
have made the whole new one, and leave nothing behind. strace makes the calls fail, in the real
program and libraries; calls of the loader, before the scene is opened, are left out. --every: only
each N-th of the calls of which there are hundreds. Exit code 77: there is no strace that works here.
"""
import argparse
import collections
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

SCENE = """format = 1
[body]
solid = { kind = "ellipsoid", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }
[motion]
duration = 0.4
attitude = { zxz_deg = [0, 40, 0] }
spin = { body = [1, 0, 3] }
[video]
size = "128x72"
fps = 10
"""
FAILURES = {"write": "ENOSPC", "fsync": "EIO", "rename": "EACCES", "openat": "EMFILE", "clone3": "EAGAIN",
            "mmap": "ENOMEM"}
MANY = {"openat", "clone3", "mmap"}
OLD_FILM, OLD_REPORT = b"old film", b"old report"
PATIENCE_S = 20

Ran = collections.namedtuple("Ran", "code err film left log")


def run(polhode, options):
    """Makes the film under strace with these options, in a folder of its own."""
    folder = tempfile.mkdtemp()
    try:
        work, scratch, log = (os.path.join(folder, name) for name in ("work", "scratch", "log"))
        os.mkdir(work)
        os.mkdir(scratch)
        for name, content in (("scene.toml", SCENE.encode()), ("a.mp4", OLD_FILM), ("a.json", OLD_REPORT)):
            with open(os.path.join(work, name), "wb") as file:
                file.write(content)
        command = ["strace", "-f", "--seccomp-bpf", "-o", log, *options,
                   polhode, "render", "scene.toml", "-o", "a.mp4", "--report", "a.json"]
        process = subprocess.Popen(command, cwd=work, env={**os.environ, "TMPDIR": scratch}, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        hung = False
        try:
            err = process.communicate(timeout=PATIENCE_S)[1]
        except subprocess.TimeoutExpired:
            hung = True
            with open(log) as file:
                os.kill(int(file.readline().split()[0]), signal.SIGTERM)
            err = process.communicate(timeout=PATIENCE_S)[1]
        with open(os.path.join(work, "a.mp4"), "rb") as file:
            film = file.read()
        with open(log) as file:
            calls = file.read()
        left = set(os.listdir(work)) - {"scene.toml", "a.mp4", "a.json"} | set(os.listdir(scratch))
        return Ran("hung" if hung else process.returncode, err, film, left, calls)
    finally:
        shutil.rmtree(folder)


def calls_of(log):
    """For each call, its numbers (from 1, per thread, as strace counts) after the scene was opened."""
    counts, first = collections.Counter(), {}
    for line in log.splitlines():
        match = re.match(r"(\d+) +(\w+)\(", line)
        if not match:
            continue
        counts[match.groups()] += 1
        if "scene.toml" in line and not first:
            first = {call: counts[match[1], call] for call in FAILURES}
    most = {call: max((n for (_, name), n in counts.items() if name == call), default=0) for call in FAILURES}
    return {call: range(max(1, first[call]), most[call] + 1) for call in FAILURES}


def injected_in(log):
    """The lines of the calls that were made to fail, also where another thread's call parts them in two."""
    begun, found = {}, []
    for line in log.splitlines():
        thread = line.split(" ", 1)[0]
        if "<unfinished ...>" in line:
            begun[thread] = line
        elif "INJECTED" in line:
            found.append(begun.pop(thread, "") + line if " resumed>" in line else line)
    return "\n".join(found)


def faults_of(ran, call, whole):
    injected = injected_in(ran.log)
    # the picture of a machine that lacks a font, or the time to look for one, is whole as well
    drawn_otherwise = "/fonts/" in injected or "/fontconfig/" in injected
    if ran.code == "hung":
        # Mesa waits for ever for a thread that it could not start; a signal ends that, and is tested here
        if call != "clone3" or ran.err != "polhode: interrupted\n":
            yield "hung"
    elif ran.code not in ((0, 2, 3) if call == "openat" else (0, 3)):
        yield f"exit code {ran.code}"
    if ran.code == 0 and ran.film != whole and not drawn_otherwise:
        yield "another film"
    if ran.code == 0 and ran.film == OLD_FILM:
        yield "no film"
    told = ran.film == whole and "a.mp4 is complete" in ran.err
    if ran.code != 0 and ran.film != OLD_FILM and not told:
        yield "the old film is gone"
    if ran.left:
        yield f"left behind: {sorted(ran.left)}"
    mute = re.search(r"write\(2,.*INJECTED", injected) or "write resumed" in injected
    if ran.code != 0 and ran.err.count("\n") != 1 and not mute:
        yield f"{ran.err.count(chr(10))} lines on standard error"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("polhode")
    parser.add_argument("--every", type=int, default=1)
    arguments = parser.parse_args()
    arguments.polhode = os.path.abspath(arguments.polhode)
    try:
        undisturbed = run(arguments.polhode, ["-e", "trace=" + ",".join(FAILURES)])
    except FileNotFoundError:
        undisturbed = None
    if undisturbed is None or "ptrace" in undisturbed.err:
        print("strace is missing, or may not trace here")
        return 77
    if undisturbed.code != 0:
        print(undisturbed.err)
        return 1
    ends, bad = collections.Counter(), 0
    for call, numbers in calls_of(undisturbed.log).items():
        for number in numbers[::arguments.every] if call in MANY else numbers:
            ran = run(arguments.polhode, ["-e", f"trace={call}",
                                          "-e", f"inject={call}:error={FAILURES[call]}:when={number}"])
            ends[call, ran.code] += 1
            faults = list(faults_of(ran, call, undisturbed.film))
            bad += bool(faults)
            for fault in faults:
                print(f"{call} {number} of {numbers[-1]}: {fault}: {ran.err.strip()}", flush=True)
    for (call, code), count in sorted(ends.items(), key=str):
        print(f"{call}: {count} times exit code {code}")
    print(f"{sum(ends.values())} failures, {bad} of them without the right answer")
    return 1 if bad or not ends else 0


sys.exit(main())
