# SPDX-License-Identifier: MIT
"""A Markdown page of the documentation, taken apart: blocks of code, headings, links, inline code.

The word after the language of a block says what the test does with it:

    ```toml top.toml           a whole scene: saved under that name for the commands after it, and drawn small
    ```toml top.toml at=1.5    the same at 1.5 s; tools/doc-pictures draws docs/images/PAGE/top.png at that time
    ```toml top.toml at=1.5 picture=step_1    the picture is called step_1.png
    ```toml fragment           part of a scene, not checked
    ```sh                      commands, run
    ```sh exit=1               commands that must end with this exit code
    ```sh slow                 run by `tools/test slow` only
    ```sh not-run              commands that install, build or open a window; no polhode command may be among them
    ```markdown deck.md        any other file, saved under that name
"""
import re
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Block:
    line: int  # of the opening fence, from 1
    language: str
    words: list[str]  # what follows the language
    text: str

    @property
    def name(self):
        """The name under which the block is saved, or None."""
        return next((word for word in self.words if "." in word and "=" not in word), None)

    @property
    def moment(self):
        """The time of the picture, s, as it is written; None where no picture is asked for."""
        return next((word[3:] for word in self.words if word.startswith("at=")), None)

    @property
    def exit_code(self):
        return next((int(word[5:]) for word in self.words if word.startswith("exit=")), 0)

    @property
    def picture(self):
        """The file of the picture, in docs/images/PAGE/."""
        named = next((word[8:] for word in self.words if word.startswith("picture=")), None)
        return f"{named or Path(self.name).stem}.png"

    @property
    def is_scene(self):
        return self.language == "toml" and "fragment" not in self.words and not (self.name or "").endswith("cases.toml")


class Page:
    def __init__(self, path: Path):
        self.path = path
        self.blocks = []
        self.prose = []  # (line number, text) outside of blocks
        block = None
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if block is None and line.startswith("```"):
                language, *words = line[3:].split() or [""]
                block = Block(number, language, words, "")
            elif block is not None and line.startswith("```"):
                self.blocks.append(block)
                block = None
            elif block is not None:
                block.text += line + "\n"
            else:
                self.prose.append((number, line))
        if block is not None:
            raise SystemExit(f"{path}:{block.line}: this block of code is never closed")

    def headings(self):
        return [line.lstrip("#").strip() for _, line in self.prose if re.match(r"#{1,6} ", line)]

    def anchors(self):
        """The anchors of the headings, formed the way GitHub does it."""
        seen = {}
        anchors = set()
        for heading in self.headings():
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
            anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            count = seen.get(anchor, 0)
            seen[anchor] = count + 1
            anchors.add(f"{anchor}-{count}" if count else anchor)
        return anchors

    def links(self):
        """(line number, target) of every link and picture."""
        for number, line in self.prose:
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
                yield number, target

    def inline_code(self):
        for number, line in self.prose:
            for code in re.findall(r"`([^`]+)`", line):
                yield number, code

    def table_rows(self, section):
        """(line number, cells) of the rows of tables under the heading `section`, without their heads."""
        inside = False
        for number, line in self.prose:
            if line.startswith("#"):
                inside = line.lstrip("#").strip() == section
            elif inside and line.startswith("|") and not re.match(r"\|[\s:|-]+\|$", line):
                yield number, [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
