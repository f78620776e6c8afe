# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the manual read from Markdown: fenced blocks, headings, links, tables."""
import dataclasses
import pathlib
import re

FENCE = re.compile(r"^```(.*)$")
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*$")
LINK = re.compile(r"\]\(([^()\s]+)\)")


@dataclasses.dataclass
class Block:
    """A fenced block: its info string ("sh", "sh not-run", "output") and lines."""
    path: pathlib.Path
    line: int
    info: list
    lines: list

    @property
    def kind(self):
        return self.info[0] if self.info else ""

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"


def pages(source):
    """README.md, examples/README.md and the manual: docs/ without docs/design and docs/paper."""
    found = [source / "README.md", source / "examples" / "README.md"]
    for path in sorted((source / "docs").rglob("*.md")):
        if path.relative_to(source).parts[1] not in ("design", "paper"):
            found.append(path)
    return found


def read(path):
    """The fenced blocks of a page, and its other lines as (number, text)."""
    blocks, prose, block = [], [], None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        fence = FENCE.match(line)
        if fence and block is None:
            block = Block(path, number, fence.group(1).split(), [])
        elif fence:
            blocks.append(block)
            block = None
        elif block is not None:
            block.lines.append(line)
        else:
            prose.append((number, line))
    if block is not None:
        raise ValueError(f"{path}:{block.line}: this block has no end")
    return blocks, prose


def plain(text):
    """Text without the marks of code, emphasis and links."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return text.replace("`", "").replace("*", "")


def anchors(path):
    """The anchors that GitHub gives the headings of a page."""
    names, seen = set(), {}
    for _, line in read(path)[1]:
        heading = HEADING.match(line)
        if not heading:
            continue
        name = re.sub(r"[^\w\- ]", "", plain(heading.group(2)).lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        names.add(name if count == 0 else f"{name}-{count}")
    return names


def tables(path):
    """Rows of all tables as (nearest heading, cells), without heads and rules."""
    rows, heading, waiting = [], "", []
    for _, line in read(path)[1]:
        match = HEADING.match(line)
        if match:
            heading = plain(match.group(2))
        if not line.startswith("|"):
            waiting = []
            continue
        cells = [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(waiting) >= 2:
            rows.append((heading, cells))
        waiting.append(cells)
    return rows
