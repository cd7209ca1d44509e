#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The line of docs/cluster.md that divides work by GNU parallel over ssh, against an sshd of its own on this machine.

usage: over_ssh.py POLHODE
Exit code 77: parallel or sshd is not installed, or sshd may not run here.
"""
import os
import shlex
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENE = """format = 1
[body]
solid = { kind = "ellipsoid", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }
[motion]
duration = 2
attitude = { zxz_deg = [0, 40, 0] }
spin = { body = [1, 0, 3] }
[video]
size = "128x72"
fps = 10
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def answers(port):
    for _ in range(50):
        with socket.socket() as one:
            if one.connect_ex(("127.0.0.1", port)) == 0:
                return True
        time.sleep(0.1)
    return False


def skip(words):
    print(f"skipped: {words}")
    sys.exit(77)


def main():
    polhode = str(Path(sys.argv[1]).resolve())
    os.environ["PATH"] += ":/usr/sbin"
    sshd = shutil.which("sshd")
    if not sshd or not shutil.which("parallel") or not shutil.which("ssh-keygen"):
        skip("parallel or sshd is missing; run tools/install-dependencies --for cluster")
    with tempfile.TemporaryDirectory(prefix="polhode-ssh-") as name:
        place = Path(name)
        for key in ("host", "user"):
            subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(place / key)], check=True)
        (place / "authorized").write_bytes((place / "user.pub").read_bytes())
        port = free_port()
        (place / "sshd_config").write_text(
            f"Port {port}\nListenAddress 127.0.0.1\nHostKey {place}/host\nAuthorizedKeysFile {place}/authorized\n"
            f"PidFile {place}/pid\nStrictModes no\nUsePAM no\nPasswordAuthentication no\nPermitRootLogin yes\n")
        if os.geteuid() == 0:
            Path("/run/sshd").mkdir(mode=0o755, exist_ok=True)  # sshd wants it, and init makes it elsewhere
        server = subprocess.Popen([sshd, "-D", "-e", "-f", str(place / "sshd_config")], stderr=subprocess.PIPE)
        try:
            if not answers(port):
                server.terminate()
                skip(f"sshd does not run here: {server.stderr.read().decode().strip()}")
            work = place / "a folder"
            work.mkdir()
            (work / "top.toml").write_text(SCENE)
            ssh = (f"ssh -p {port} -i {place}/user -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null "
                   "-o LogLevel=ERROR")
            # the names of the machines stand once for each task that they are to run at a time
            hosts = f"1/{ssh} 127.0.0.1,1/{ssh} localhost"
            environment = dict(os.environ, PARALLEL_HOME=str(place / ".parallel"))
            words = "stability top.toml -o maps --methods rk4 --cells 6x6 --turns 5"
            subprocess.run([polhode, *words.replace("-o maps", "-o whole").split()], cwd=work, check=True,
                           stdout=subprocess.DEVNULL)
            line = (f"parallel --will-cite --wd . -S {shlex.quote(hosts)} {shlex.quote(polhode)} {words} "
                    f"--shard '{{}}/3' ::: 1 2 3 && {shlex.quote(polhode)} {words}")
            ran = subprocess.run(["bash", "-c", line], cwd=work, env=environment, capture_output=True, text=True,
                                 timeout=300, check=False)
            table = "stability.csv"
            if ran.returncode != 0 or (work / "whole" / table).read_bytes() != (work / "maps" / table).read_bytes() \
                    or ran.stdout.count("part ") != 3:
                print(f"exit code {ran.returncode}, or another table: {ran.stdout}{ran.stderr}")
                return 1
            # a film: the pieces meet in a hidden folder beside it
            words = "render top.toml --resume --pieces 4 -o top.mp4"
            line = (f"parallel --will-cite --wd . -S {shlex.quote(hosts)} {shlex.quote(polhode)} {words} "
                    f"--shard '{{}}/2' ::: 1 2 && {shlex.quote(polhode)} {words}")
            ran = subprocess.run(["bash", "-c", line], cwd=work, env=environment, capture_output=True, text=True,
                                 timeout=300, check=False)
            subprocess.run([polhode, *words.replace("top.mp4", "whole.mp4").split()], cwd=work, check=True)
            if ran.returncode != 0 or (work / "whole.mp4").read_bytes() != (work / "top.mp4").read_bytes():
                print(f"another film: {ran.stdout}{ran.stderr}")
                return 1
            if "4 of 4 pieces are already complete" not in ran.stderr:
                print(f"the last run made pieces: {ran.stderr}")
                return 1
        finally:
            server.terminate()
            server.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
