#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the documentation against the program.

check_page.py POLHODE PAGE          links, options, scenes and commands of one page
check_page.py POLHODE PAGE --slow   the commands of blocks marked slow
check_page.py POLHODE               what concerns all pages: each command has one, the index leads to each
"""
import argparse
import functools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

sys.dont_write_bytecode = True  # the source tree stays as it is
from markdown_page import Page  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"

# Commands of the pages are run as they stand, but small: this is what is appended to them. The last of several equal
# options counts, so a size in the text is overridden.
SMALLER = {
    "render": ["--size", "192x108", "--fps", "5"],
    "lecture": ["--size", "192x108", "--fps", "5"],
    "stability": ["--cells", "4x4", "--turns", "4"],
}
# What `submit` can divide.
DIVISIBLE = {"render", "lecture", "chart", "stability", "section"}
# Units that a key may carry.
SUFFIXES = {"mm", "cm", "km", "g", "ms", "min", "h", "d", "deg", "deg_per_s", "rpm", "hz", "g_cm2", "g_per_cm3"}
# Programs that would open a window.
SILENT = ["ffplay", "xdg-open"]

class Complaints:
    def __init__(self):
        self.found = []

    def add(self, page, line, text):
        place = page.path.relative_to(ROOT) if page else "docs"
        self.found.append(f"{place}:{line}: {text}" if page else f"{place}: {text}")


class Program:
    """The commands and options that `polhode --help` knows."""

    def __init__(self, polhode):
        self.path = str(Path(polhode).resolve())
        text = self.help()
        table = text.split("Subcommands:")[1].split("\n\n")[0]
        self.commands = re.findall(r"^  (\w+)", table, re.MULTILINE)
        self.common = self.options_of(text)

    @functools.cache
    def options(self, command):
        return self.options_of(self.help(command)) | self.common

    @functools.cache
    def any_option(self):
        return set().union(*map(self.options, self.commands))

    def help(self, *command):
        return subprocess.run([self.path, *command, "--help"], check=True, capture_output=True, text=True).stdout

    @staticmethod
    def options_of(text):
        """Long and short names at the beginning of the lines of a help text."""
        names = set()
        for line in re.findall(r"^  (-\S+)", text, re.MULTILINE):
            names.update(line.split(","))
        return names


def check_links(page, complaints):
    for line, target in page.links():
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = unquote(target).partition("#")
        path = (page.path.parent / file).resolve() if file else page.path
        if not path.exists():
            complaints.add(page, line, f"the link {target} leads to no file")
        elif anchor and path.suffix == ".md" and anchor not in Page(path).anchors():
            complaints.add(page, line, f"{file or 'this page'} has no heading #{anchor}")


def command_lines(text):
    """The polhode commands in shell text: (command, options) of each."""
    joined = text.replace("\\\n", " ")
    for call in re.findall(r"(?:^|[|;&(`]|\bdo )\s*(?:\S*/)?polhode ([^|;&#\n]*)", joined, re.MULTILINE):
        try:
            words = shlex.split(call)
        except ValueError:
            words = call.split()
        # `submit` is followed by the command that it divides
        inner = next((i for i, word in enumerate(words) if word in DIVISIBLE and words[0] == "submit"), len(words))
        for part in (words[:inner], words[inner:]):
            if part:
                yield part[0], [word.split("=")[0] for word in part[1:] if re.match(r"--?[a-z]", word)]


def check_options(page, program, complaints):
    shell = [(block.line, block.text) for block in page.blocks if block.language == "sh"]
    inline = list(page.inline_code())
    for line, text in shell + inline:
        for command, options in command_lines(text):
            if command in program.commands:
                for option in options:
                    if option not in program.options(command):
                        complaints.add(page, line, f"polhode {command} has no option {option}")
            elif re.fullmatch(r"[a-z]+", command):
                complaints.add(page, line, f"polhode has no command {command}")
            else:
                for option in options + [command]:
                    if option.startswith("-") and option not in program.common:
                        complaints.add(page, line, f"polhode has no option {option}")
    for line, text in inline:
        if text.startswith("--"):
            option = re.match(r"--[\w-]*", text)[0]
            if len(option) > 2 and option not in program.any_option():
                complaints.add(page, line, f"no command has an option {option}")

    # the page of a command has a table of all its options, and no others
    command = page.path.stem
    if page.path.parent == DOCS and command in program.commands:
        told = set()
        for line, cells in page.table_rows("Options"):
            names = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", cells[0]))
            for name in names - program.options(command):
                complaints.add(page, line, f"polhode {command} has no option {name}")
            told |= names
        for name in sorted(program.options(command) - program.common - told):
            complaints.add(page, 1, f"the table of options lacks {name}, which polhode {command} --help has")


def make_scratch(folder, program):
    """What the reader has before the first line: polhode, scenes/, tests/golden/."""
    shims = folder / ".bin"
    shims.mkdir()
    for name in SILENT:
        (shims / name).write_text("#!/bin/sh\nexec cat >/dev/null\n")
    cases = "".join(f"  {command}) set -- \"$@\" {' '.join(more)} ;;\n" for command, more in SMALLER.items())
    (shims / "polhode").write_text(f'#!/bin/sh\ncase "$1" in\n{cases}esac\nexec {shlex.quote(program.path)} "$@"\n')
    for shim in shims.iterdir():
        shim.chmod(0o755)
    (folder / "build/release").mkdir(parents=True)
    (folder / "build/release/polhode").symlink_to(shims / "polhode")
    shutil.copytree(ROOT / "scenes", folder / "scenes")
    shutil.copytree(ROOT / "tests/golden", folder / "tests/golden")
    (folder / "output").mkdir()
    return dict(os.environ, PATH=f"{shims}:{os.environ['PATH']}")


def run(arguments, folder, environment, exit_code=0):
    """None when all is well, else the last lines that were printed."""
    result = subprocess.run(arguments, cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace")
    if result.returncode != exit_code:
        return f"exit code {result.returncode}: " + " / ".join(result.stdout.strip().splitlines()[-3:])
    return None


def check_scene(page, block, program, folder, environment, complaints):
    if not re.search(r"^format = 1\b", block.text, re.MULTILINE):
        complaints.add(page, block.line, "a whole scene says `format = 1`; mark parts of scenes `toml fragment`")
        return
    for arguments in (["inspect", block.name],
                      ["render", block.name, "--still", block.moment or "0", "--size", "160x90", "-o", "still.png"]):
        fault = run([program.path, *arguments], folder, environment)
        if fault:
            complaints.add(page, block.line, fault)
            return
    if block.moment:
        drawn = DOCS / "images" / page.path.stem / block.picture
        if not drawn.exists():
            complaints.add(page, block.line, f"no picture {drawn.relative_to(ROOT)}: run tools/doc-pictures")


def check_blocks(page, program, folder, environment, slow, complaints):
    """Does what a reader does who follows the page from top to bottom: saves its files, runs its commands."""
    for block in page.blocks:
        if block.language == "sh":
            if "not-run" in block.words:
                if not slow and list(command_lines(block.text)):
                    complaints.add(page, block.line, "a polhode command in a block that is not run")
            elif ("slow" in block.words) == slow:
                fault = run(["bash", "-euo", "pipefail", "-c", block.text], folder, environment, block.exit_code)
                if fault:
                    complaints.add(page, block.line, fault)
            continue
        if block.is_scene and not block.name:
            complaints.add(page, block.line, "a scene has a name to be saved under: ```toml NAME.toml")
        elif block.name:
            (folder / block.name).parent.mkdir(parents=True, exist_ok=True)
            (folder / block.name).write_text(block.text, encoding="utf-8")
            if block.is_scene and not slow:
                check_scene(page, block, program, folder, environment, complaints)


def scene_keys(schema):
    """The keys of a scene in SI units: radius, not radius_cm."""
    keys = set()
    for name, value in schema.get("properties", {}).items():
        if isinstance(value, dict):
            keys |= {name} | scene_keys(value) | scene_keys(value.get("items") or {})
    return {key for key in keys if not any(key.startswith(f"{other}_") and key[len(other) + 1:] in SUFFIXES for other in keys)}


def check_all_pages(program, complaints):
    index = Page(DOCS / "README.md")
    reached = {(DOCS / target.partition("#")[0]).resolve() for _, target in index.links()}
    for path in sorted(DOCS.glob("*.md")):
        if path != index.path and path not in reached:
            complaints.add(index, 1, f"the index does not lead to {path.name}")
    for command in program.commands:
        if not (DOCS / f"{command}.md").exists():
            complaints.add(None, 0, f"polhode {command} has no page docs/{command}.md")
    code = " ".join(text for _, text in Page(DOCS / "scene.md").inline_code())
    schema = json.loads(subprocess.run([program.path, "schema"], check=True, capture_output=True, text=True).stdout)
    for key in sorted(scene_keys(schema)):
        if not re.search(rf"\b{key}\b", code):
            complaints.add(None, 0, f"scene.md lacks the key {key}, which polhode schema has")
    used = {(path.parent / target).resolve() for path in [ROOT / "README.md", *DOCS.glob("*.md")]
            for _, target in Page(path).links()}
    for picture in sorted(DOCS.rglob("*.png")):
        if picture not in used:
            complaints.add(None, 0, f"no page shows {picture.relative_to(DOCS)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("polhode")
    parser.add_argument("page", nargs="?", type=Path)
    parser.add_argument("--slow", action="store_true")
    options = parser.parse_args()
    program = Program(options.polhode)
    complaints = Complaints()
    if options.page is None:
        check_all_pages(program, complaints)
    else:
        page = Page(options.page.resolve())
        with tempfile.TemporaryDirectory(prefix="polhode_docs_") as name:
            folder = Path(name)
            environment = make_scratch(folder, program)
            if not options.slow:
                check_links(page, complaints)
                check_options(page, program, complaints)
            check_blocks(page, program, folder, environment, options.slow, complaints)
    for complaint in complaints.found:
        print(complaint)
    sys.exit(bool(complaints.found))


if __name__ == "__main__":
    main()
