# SPDX-License-Identifier: BSD-3-Clause
"""Copies of the pages that are in the sources, with links as they are in the site."""
import os
import re
import shutil

ROOT_PAGES = ("README.md", "NOTATION.md", "CONTRIBUTING.md", "CHANGELOG.md")
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)|<img src=\"([^\"]+)\"")
BLOCKS = re.compile(r"(^```.*?^```$)", flags=re.M | re.S)


def place_in_site(path):
    """Where a file of the sources is in the site, None if it is not there."""
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    if path in ROOT_PAGES:  # mkdocs makes README.md the index of a folder
        return "project/" + path.lower().replace("readme", "manual")
    return "pictures/" + os.path.basename(path) if path.endswith(".png") else None


def with_links(text, page):
    """A page whose relative links are those of the site; of files that it does not hold only the text is left."""
    here = os.path.dirname(place_in_site(page))

    def replaced(match):
        bang, title, link, heading, picture = match.groups()
        link = link or picture
        if not link or re.match(r"[a-z]+:", link):
            return match.group()
        target = os.path.normpath(os.path.join(os.path.dirname(page), link))
        place = place_in_site(target)
        if place is None:
            return title
        place = os.path.relpath(place, here or ".")
        return f'<img src="{place}"' if picture else f"{bang}[{title}]({place}{heading or ''})"

    parts = BLOCKS.split(text)
    return "".join(part if part.startswith("```") else LINK.sub(replaced, part) for part in parts)


def stage(root, folder):
    """All pages, and the pictures and other files of docs/."""
    files = [root / name for name in ROOT_PAGES] + sorted((root / "docs").rglob("*")) + sorted(root.glob("plots/*.png"))
    for file in files:
        path = file.relative_to(root).as_posix()
        if not file.is_file() or place_in_site(path) is None or file.name in ("mkdocs.yml", "Doxyfile", "main.html"):
            continue
        target = folder / place_in_site(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            target.write_text(with_links(file.read_text(encoding="utf-8"), path), encoding="utf-8")
        else:
            shutil.copyfile(file, target)
