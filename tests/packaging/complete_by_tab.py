# Presses TAB in a real shell: complete_by_tab.py bash|zsh POLHODE
import os
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

# what is typed before TAB -> the words of the line after it
CASES = [
    ("polhode rend", ["polhode", "render"]),
    ("polhode compl", ["polhode", "completion"]),
    ("polhode render --trans", ["polhode", "render", "--transparent"]),
    ("polhode render --verb", ["polhode", "render", "--verbose"]),
    ("polhode render --codec av", ["polhode", "render", "--codec", "av1"]),
    ("polhode render --quality arch", ["polhode", "render", "--quality", "archive"]),
    ("polhode render a.toml --method dop8", ["polhode", "render", "a.toml", "--method", "dop853"]),
    ("polhode render --preset ultra", ["polhode", "render", "--preset", "ultrafast"]),
    ("polhode render --backend os", ["polhode", "render", "--backend", "osmesa"]),
    ("polhode render lonely", ["polhode", "render", "lonely.toml"]),
    ("polhode render -q lonely", ["polhode", "render", "-q", "lonely.toml"]),
    ("polhode render --size 64x36 a\\ sp", ["polhode", "render", "--size", "64x36", "a space.toml"]),
    ("polhode --verbose rend", ["polhode", "--verbose", "render"]),
    ("polhode --verbose render lonely", ["polhode", "--verbose", "render", "lonely.toml"]),
    ("polhode submit render lonely", ["polhode", "submit", "render", "lonely.toml"]),
    ("polhode list meth", ["polhode", "list", "methods"]),
    ("polhode golden upd", ["polhode", "golden", "update"]),
    ("polhode golden run fol", ["polhode", "golden", "run", "folder"]),
    ("polhode lecture talk", ["polhode", "lecture", "talk.md"]),
    ("polhode lecture talk.md --to pp", ["polhode", "lecture", "talk.md", "--to", "pptx"]),
    ("polhode chart a.toml --methods rk4,dop8", ["polhode", "chart", "a.toml", "--methods", "rk4,dop853"]),
    ("polhode manual stab", ["polhode", "manual", "stability"]),
    ("polhode completion z", ["polhode", "completion", "zsh"]),
]
FILES = ["lonely.toml", "lonely.txt", "a space.toml", "talk.md", "talk.toml"]

STARTS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"],
             "PS1=; PS2=; bind 'set enable-bracketed-paste off'; source '{script}'"),
    "zsh": (["zsh", "-f", "-i"],
            "PS1=; RPS1=; unset zle_bracketed_paste; bindkey -e; autoload -Uz compinit; compinit -D; source '{script}'"),
}


class Shell:
    def __init__(self, name, folder, script):
        command, prepare = STARTS[name]
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", LC_ALL="C.UTF-8", HOME=folder, ZDOTDIR=folder, COLUMNS="300")
            os.execvp(command[0], command)
        self.send(f"stty cols 300; {prepare.format(script=script)}; printf '%s%s\\n' read y\n")
        self.read_until("ready\r?\n")

    def send(self, text):
        os.write(self.terminal, text.encode())

    def read_until(self, pattern, seconds=20):
        text, end = "", time.time() + seconds
        while time.time() < end:
            if select.select([self.terminal], [], [], 0.05)[0]:
                text += os.read(self.terminal, 65536).decode(errors="replace")
                found = re.search(pattern, text)
                if found:
                    return found
        raise TimeoutError(f"no {pattern!r} in {text!r}")

    def completed(self, line):
        # C-a: the words are printed between <> instead of being run; the quotes keep the echo from matching
        self.send(line + "\t")
        self.send("\x01printf '%s''|' be''gin \x05 e''nd; echo\n")
        found = self.read_until(r"begin\|(.*?)\|end\|")
        # zsh takes the slash of a folder back when something else is typed
        return [word.rstrip("/") for word in found.group(1).split("|")]


def main():
    shell, binary = sys.argv[1:]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        for name in FILES:
            open(os.path.join(folder, name), "w").close()
        os.mkdir(os.path.join(folder, "folder"))
        script = os.path.join(folder, ".completion")
        with open(script, "w") as out:
            subprocess.run([binary, "completion", shell], stdout=out, check=True)
        os.environ["PATH"] = os.path.dirname(binary) + ":" + os.environ["PATH"]
        running, wrong = Shell(shell, folder, script), 0
        for line, expected in CASES:
            got = running.completed(line)
            if got != expected:
                print(f"{shell}: {line!r} + TAB gives {got}, not {expected}")
                wrong += 1
        os.close(running.terminal)
        print(f"{len(CASES) - wrong} passed, {wrong} failed")
        return 1 if wrong else 0


sys.exit(main())
