#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Relative links of the guide and of the pages at the root lead to files, and their anchors to headings.

check_links.py [ROOT]; external links are left alone.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import pages

ROOT_PAGES = ("README.md", "CONTRIBUTING.md", "NOTATION.md", "CHANGELOG.md")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)|(?:src|href)=\"([^\"]+)\"")


def prose(text):
    """The text without blocks and without code in lines; lines keep their numbers."""
    text = re.sub(r"^```.*?^```$", lambda block: "\n" * block.group().count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(page):
    """As GitHub and mkdocs make them of headings."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    found = []
    for heading in re.findall(r"^#+ (.*)$", text, flags=re.M):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        found.append(re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", plain).strip()))
    return found


def broken_links(page, root):
    for number, line in enumerate(prose(page.read_text(encoding="utf-8")).split("\n"), 1):
        for match in LINK.finditer(line):
            link = match.group(1) or match.group(2)
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            place = f"{page.relative_to(root)}:{number}: {link}: "
            if root not in target.parents or not target.exists():
                yield place + "there is no such file"
            elif anchor and (target.suffix != ".md" or anchor not in anchors(target)):
                yield place + "there is no such heading"


def main(root=pages.ROOT):
    root = pathlib.Path(root).resolve()
    checked = [root / name for name in ROOT_PAGES if (root / name).is_file()] + pages.pages(root)
    findings = [finding for page in checked for finding in broken_links(page, root)]
    print("\n".join(findings) or f"{len(checked)} pages: all links lead somewhere")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
