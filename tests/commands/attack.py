#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Attacks every command with scenes, film files, settings and decks that were changed at random along the schema.

  tests/commands/attack.py POLHODE SECONDS [SEED]

Each run must end by itself with exit code 0 to 3, an error with a line that says what is wrong, without words of a
library; a command that fails leaves no output, and none leaves scratch files. What breaks this is printed, and its
folder kept in output/attack. Ends with exit code 1 if anything was found. Needs what the commands need, gnuplot
and pandoc too.
"""
import copy
import json
import math
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "output/attack"
LONG = 90  # seconds, after which a command is interrupted; it then has five more
NUMBERS = [0, -1, 1, 2, 3, 0.5, 1e-300, 1e300, 5e-324, -0.0, 1e-12, 1e6, 1e9, 1e15, 2**63 - 1, -(2**63), 90, 360,
           math.nan, math.inf, -math.inf]
TEXTS = ["", " ", "x", "a\u0301\u0302", "\u202eabc", "𝛀", "a" * 1900, "<b>x", "&amp;", "%n%s", "{}", "{:>99999999}",
         "../x", "/", "-", ".", "pivot", "auto", "exact", "rk4", "none", "\t\n", "$(id)", "#ff00ff", "\ufeffx", "字" * 50]
PARAGRAPHS = ["Some text.", "# A slide", "- a\n- b", "| a | b |\n|---|---|\n| 1 | 2 |", "$x^2$", "> q", "**b**",
              "<script>x</script>", "\\input{x}", "[l](#a)", "[x](javascript:1)", "`scene.toml:motion.duration`",
              "![A film](scene.toml){.film}", "![A still](scene.toml){.still at=0.3}", "![A loop](b.toml){.loop}",
              "![C](scene.toml){.inspect}", '![D](scene.toml){.compare with="b.toml"}', "![](missing.toml)",
              "![](/etc/passwd)", "![](scene.toml){ at=nan }", "::: notes\nx\n:::", "[^1]\n\n[^1]: n"]


def as_toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        if not math.isfinite(value):
            return "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"
        text = repr(value)
        return text if "." in text or "e" in text else text + ".0"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, list):
        return "[" + ", ".join(map(as_toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(k)} = {as_toml(v)}" for k, v in value.items()) + " }"
    return str(value)


def as_file(tree):
    return "".join(f"{json.dumps(key)} = {as_toml(value)}\n" for key, value in tree.items())


class Schema:
    """The keys of scenes, each with a schema of its values."""

    def __init__(self, text):
        self.root = json.loads(text)
        self.keys = []
        self._walk(self.root, [])

    def resolve(self, node):
        while "$ref" in node:
            found = self.root
            for part in node["$ref"].lstrip("#/").split("/"):
                found = found[part]
            node = found
        return node

    def _walk(self, node, path):
        node = self.resolve(node)
        for key, value in node.get("properties", {}).items():
            value = self.resolve(value)
            self.keys.append((path + [key], value))
            if value.get("type") == "array":
                self._walk(value.get("items", {}), path + [key, 0])
            else:
                self._walk(value, path + [key])
        for choice in node.get("anyOf", []) + node.get("oneOf", []) + node.get("allOf", []):
            self._walk(choice, path)


class Attack:
    def __init__(self, polhode, seed):
        self.polhode = polhode
        self.any = random.Random(seed)
        self.schema = Schema(subprocess.run([polhode, "schema"], capture_output=True, text=True, check=True).stdout)
        self.scenes, self.films = {}, {}
        for file in sorted((ROOT / "scenes").glob("*.toml")) + sorted((ROOT / "src/app/templates").glob("*.toml")):
            tree = tomllib.loads(file.read_text(encoding="utf-8"))
            (self.films if "panel" in tree or "sweep" in tree else self.scenes)[file.name] = tree

    def maybe(self, chance):
        return self.any.random() < chance

    def anything(self, depth=0):
        kind = self.any.randrange(6 if depth < 3 else 4)
        if kind < 2:
            return self.any.choice(NUMBERS)
        if kind < 4:
            return self.any.choice(TEXTS)
        if kind == 4:
            return [self.anything(depth + 1) for _ in range(self.any.randrange(4))]
        return {"kind": self.anything(depth + 1)}

    def value_for(self, node):
        """A value that the schema allows, more or less."""
        if self.maybe(0.03):
            return self.anything()
        if "enum" in node:
            return self.any.choice(node["enum"])
        for choice in ("anyOf", "oneOf"):
            if choice in node:
                return self.value_for(self.schema.resolve(self.any.choice(node[choice])))
        kind = node.get("type")
        kind = self.any.choice(kind) if isinstance(kind, list) else kind
        if kind == "boolean":
            return self.maybe(0.5)
        if kind in ("number", "integer"):
            number = self.any.choice(NUMBERS) if self.maybe(0.2) else round(self.any.uniform(-3, 12), 2)
            return int(number) if kind == "integer" and math.isfinite(number) else number
        if kind == "string":
            return self.any.choice(TEXTS)
        if kind == "array":
            count = node.get("minItems", self.any.randrange(5)) if self.maybe(0.85) else self.any.randrange(7)
            return [self.value_for(self.schema.resolve(node.get("items", {}))) for _ in range(count)]
        if kind == "object":
            return {key: self.value_for(self.schema.resolve(value)) for key, value in node.get("properties", {}).items()
                    if self.maybe(0.25)}
        return self.anything()

    def change(self, tree):
        """One change: of a value, by another key of the schema, by leaving one out, or by a part of another scene."""
        places = []

        def walk(node):
            for key, value in node.items() if isinstance(node, dict) else enumerate(node):
                places.append((node, key, value))
                if isinstance(value, (dict, list)):
                    walk(value)

        walk(tree)
        what = self.any.random()
        if what < 0.65 and places:
            node, key, old = self.any.choice(places)
            if isinstance(old, (int, float)) and not isinstance(old, bool) and self.maybe(0.7):
                node[key] = self.any.choice([old * self.any.uniform(0.3, 3), old * self.any.uniform(0.8, 1.2), -old,
                                             old * 30, old * 1e-3, self.any.choice(NUMBERS)])
            else:
                node[key] = self.any.choice(TEXTS) if isinstance(old, str) else self.anything()
        elif what < 0.9:
            path, schema = self.any.choice(self.schema.keys)
            node = tree
            try:
                for key in path[:-1]:
                    node = node.setdefault(key, {}) if isinstance(node, dict) else node[key]
                node[path[-1]] = self.value_for(schema)
            except (AttributeError, IndexError, KeyError, TypeError):
                pass  # no such place in this scene
        elif what < 0.94 and places:
            node, key, _ = self.any.choice(places)
            del node[key]
        else:
            other = self.any.choice(list(self.scenes.values()))
            key = self.any.choice(list(other))
            tree[key] = copy.deepcopy(other[key])

    def changed(self, tree, most):
        tree = copy.deepcopy(tree)
        if isinstance(tree.setdefault("video", {}), dict):
            tree["video"].update(size=[192, 108], fps=5)
        for _ in range(self.any.randrange(most + 1)):
            self.change(tree)
        return as_file(tree)

    def scene(self):
        return self.changed(self.any.choice(list(self.scenes.values())), 3)

    def film(self):
        shipped = [name for name in self.scenes if (ROOT / "scenes" / name).exists()]
        if self.maybe(0.3):
            tree = self.any.choice(list(self.films.values()))
        elif self.maybe(0.5):
            tree = {"format": 1, "panel": [{"scene": self.any.choice(shipped), "caption": self.any.choice(TEXTS)}
                                           for _ in range(self.any.randrange(11))]}
        else:
            path, schema = self.any.choice(self.schema.keys)
            tree = {"format": 1, "sweep": {"scene": self.any.choice(shipped), "caption": self.any.choice(["{}", "{", "x"]),
                                           "key": ".".join(key for key in path if key != 0),
                                           "values": [self.value_for(schema) for _ in range(self.any.randrange(7))]}}
        return self.changed(tree, 2)

    def settings(self):
        words = []
        while self.maybe(0.2):
            path, schema = self.any.choice(self.schema.keys)
            key = "".join(f"[{self.any.randrange(4)}]" if part == 0 else "." + part for part in path).lstrip(".")
            words += ["--set", f"{key}={as_toml(self.value_for(schema))}"]
        return words

    def commands(self, folder):
        """What is run in a folder, one after the other until one fails."""
        scene = folder / "scene.toml"
        scene.write_text(self.film() if self.maybe(0.35) else self.scene(), encoding="utf-8")
        (folder / "b.toml").write_text(self.scene(), encoding="utf-8")
        (folder / "deck.md").write_text("\n\n".join(self.any.choices(PARAGRAPHS, k=self.any.randint(1, 5))) + "\n",
                                        encoding="utf-8")
        out, more, pick = folder / "out", self.settings(), self.any.choice
        short = ["--size", "192x108", "--to", pick(["0.2", "0.5", "1"])]
        film = out / f"f.{pick(['mp4', 'mp4', 'gif', 'webm', 'mkv', 'y4m', 'apng', 'mov'])}"
        return pick([
            [["render", scene, "-o", film, *short, *more]],
            [["render", scene, "-o", out / "s.png", "--still", pick(["0", "0.5", "-1", "1e9"]), "--size", "192x108", *more]],
            [["render", scene, "-o", out / "v.mp4", *short, "--report", out / "v.json", *more], ["verify", out / "v.mp4"]],
            [*[["render", scene, "--shard", f"{k}/2", "-o", out / f"{k}.mp4", *short, *more] for k in (1, 2)],
             ["join", out / "1.mp4", out / "2.mp4", "-o", out / "all.mp4"]],
            [["inspect", scene, *more, *pick([[], ["--json"]])]],
            [["simulate", scene, "-o", out / "m.csv", "--rate", pick(["1", "10", "0", "-3", "1e9"]), *more]],
            [["plot", scene, pick(["tilt", "azimuth", "energy", "euler_angles", "euler_rates", "phase", "potential",
                                   "polhode_map", "satellite_map", "x"]),
              "-o", out / f"p.{pick(['svg', 'png', 'pdf', 'csv', 'x'])}", *more]],
            [["preview", scene, "-o", out / "p.png", *more]],
            [["section", scene, "-o", out / "section", "--starts", pick(["1", "3", "0"]), "--crossings", "20", *more]],
            [["stability", scene, "-o", out / "maps", "--methods", pick(["rk4", "rk4,dmv2", "x"]), "--cells", "3x3", *more]],
            [["chart", scene, "-o", out / "chart", "--methods", pick(["rk4", "rk4,taylor10"]), *more]],
            [["lecture", folder / "deck.md", "-o", out / "l", "--to", pick(["html", "handout", "data"])]],
            [["diff", scene, folder / "b.toml"]],
            [["new", pick(["heavy_top", "film", "deck", "x"]), "-o", out / pick(["n.toml", "n", "../x/y.toml"])]],
        ])

    def run(self, command, folder, scratch):
        """Runs a command; returns its exit code and what is wrong with its end."""
        words = [self.polhode, *map(str, command)]
        before = set(folder.rglob("*"))
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   cwd=folder, env={**os.environ, "TMPDIR": str(scratch)}, start_new_session=True)
        wrong = []
        try:
            out, err = process.communicate(timeout=LONG)
        except subprocess.TimeoutExpired:
            wrong.append(f"took longer than {LONG} s")
            process.send_signal(signal.SIGINT)
            try:
                out, err = process.communicate(timeout=5)
            except subprocess.TimeoutExpired:
                wrong.append("is deaf to SIGINT")
                os.killpg(process.pid, signal.SIGKILL)
                out, err = process.communicate()
        code, err = process.returncode, err.decode(errors="replace")
        if code not in (0, 1, 2, 3) and not wrong:
            wrong.append(f"exit code {code}")
        if code and not err.strip() and command[0] != "diff":
            wrong.append("says nothing")
        if re.search(r"unexpected:|std::|basic_string|bad_alloc|map::at|CHECK|terminate", err):
            wrong.append("words of a library")
        if code and command[0] in ("render", "simulate", "plot", "preview", "join") and set(folder.rglob("*")) - before:
            wrong.append("leaves something behind")
        if list(scratch.iterdir()):
            wrong.append("leaves scratch files")
        return code, [f"{'; '.join(wrong)}: {' '.join(words)}\n{err[-600:]}"] if wrong else []


def main():
    polhode, seconds = str(Path(sys.argv[1]).resolve()), float(sys.argv[2])
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else int(time.time())
    attack, codes, findings = Attack(polhode, seed), Counter(), 0
    work = KEPT / f"work_{seed}"
    begin = time.monotonic()
    while time.monotonic() - begin < seconds:
        shutil.rmtree(work, ignore_errors=True)
        folder, scratch = work / "case", work / "scratch"
        (folder / "out").mkdir(parents=True)
        scratch.mkdir(exist_ok=True)
        for file in (ROOT / "scenes").glob("*.*"):
            shutil.copy(file, folder)
        for command in attack.commands(folder):
            code, wrong = attack.run(command, folder, scratch)
            codes[code] += 1
            for words in wrong:
                findings += 1
                shutil.copytree(work, KEPT / f"found_{seed}_{findings}")
                print(f"{words}\n  kept: {KEPT / f'found_{seed}_{findings}'}", flush=True)
            if code != 0:
                break
    shutil.rmtree(work, ignore_errors=True)
    print(f"seed {seed}: {sum(codes.values())} commands, exit codes {dict(sorted(codes.items()))}, {findings} findings")
    sys.exit(findings > 0)


main()
