#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the site by tools/docs and checks it: check_site.py PROGRAM, or check_site.py -s SITE of one that is built.

Every link leads to a page and a heading, nothing is loaded from elsewhere or is missing, no page shows a control
character, and the reference has a section for every name that the program lists. Skipped by name without mkdocs and
Doxygen, unless KREISEL_REQUIRE has `docs`.
"""
import functools
import hashlib
import html.parser
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

sys.dont_write_bytecode = True
import pages

LOADED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "video": "src", "audio": "src",
          "embed": "src", "object": "data", "link": "href"}
SECTIONS = {"problems": "problems", "projections": "projections", "formulations": "formulations", "kinds": "kinds",
            "figures": "figures", "tables": "tables", "methods": "methods-*"}


class Page(html.parser.HTMLParser):
    """Links, what is loaded, and anchors."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], {""}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(value for value in (values.get("id"), values.get("name")) if value)
        if values.get(LOADED.get(tag)):
            self.loaded.append(values[LOADED[tag]])
        elif tag == "a" and values.get("href"):
            self.links.append(values["href"])


@functools.lru_cache(None)
def read(file):
    return Page(file.read_text(encoding="utf-8"))


def is_external(link):
    return re.match(r"([a-z]+:)?//|[a-z]+:", link) is not None


def loads(file):
    """Addresses of what a page or a style sheet loads."""
    if file.suffix == ".html":
        return read(file).loaded
    return re.findall(r"(?:url\(|@import\s+)['\"]?([^'\")\s;]+)", file.read_text(encoding="utf-8"))


def dead_links(file, site):
    for link in read(file).links:
        path, _, anchor = urllib.parse.unquote(link).partition("#")
        target = (file.parent / path).resolve() if path else file
        if is_external(link) or link.startswith("javascript"):
            continue
        if not target.is_file():
            yield f"{link}: there is no such page"
        elif target.suffix == ".html" and anchor not in read(target).anchors:
            yield f"{link}: there is no such heading"


def unloadable(file, addresses):
    """Addresses of what comes from elsewhere, or is not there."""
    for address in addresses:
        path = re.split("[?#]", urllib.parse.unquote(address))[0]
        if address.startswith("data:") or not (path or is_external(address)):
            continue
        if is_external(address):
            yield f"loads {address}"
        elif not (file.parent / path).is_file():
            yield f"loads {address}, which is not there"


def findings(site):
    for file in sorted(file for suffix in ("*.html", "*.css") for file in site.rglob(suffix)):
        place = file.relative_to(site)
        yield from (f"{place}: {finding}" for finding in unloadable(file, loads(file)))
        if file.suffix == ".html" and place.parts[0] != "api":  # Doxygen's links are its own affair
            yield from (f"{place}: {finding}" for finding in dead_links(file, site))
            if re.search("[\\x00-\\x08]", file.read_text(encoding="utf-8")):
                yield f"{place}: shows a control character"


def names(program, topic):
    listed = subprocess.run([program, "list", topic], check=True, capture_output=True, text=True).stdout
    return re.findall(r"^  (\S+)", listed, flags=re.M)


def missing_sections(site, program):
    for topic, files in SECTIONS.items():
        anchors = set().union(*(read(file).anchors for file in site.glob(f"reference/{files}.html")))
        for name in names(program, topic):
            if re.sub(r"[^\w-]", "", name.lower()) not in anchors:
                yield f"reference: there is no section on {name}"


def write_sheet(folder, program, method):
    """A data sheet as `tools/docs -s` would have made it."""
    digest = hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()[:16]
    sheet = pathlib.Path(folder) / "sheets" / digest / (method.replace("/", "-") + ".md")
    sheet.parent.mkdir(parents=True)
    sheet.write_text(f"# {method}\n\nThe sheet.\n")


def skip_unless_installed():
    if subprocess.run([pages.ROOT / "tools/setup", "-n", "docs"], capture_output=True).returncode != 0:
        print("docs: skipped: there is no mkdocs or Doxygen; tools/setup docs installs them")
        sys.exit(1 if "docs" in os.environ.get("KREISEL_REQUIRE", "").split() else 77)


def report(found, site):
    files = [file for file in site.rglob("*") if file.is_file()]
    print("\n".join(found) or f"{len(files)} files, {sum(file.stat().st_size for file in files) / 1e6:.1f} MB: sound")
    sys.exit(1 if found else 0)


def main(program, site=None):
    if program == "-s":
        report(list(findings(pathlib.Path(site).resolve())), pathlib.Path(site))
    skip_unless_installed()
    with tempfile.TemporaryDirectory() as folder:
        write_sheet(folder, program, "rkmk/rk4")
        subprocess.run([pages.ROOT / "tools/docs", "-k", program, "-o", folder], check=True)
        site = pathlib.Path(folder).resolve() / "site"
        found = list(findings(site)) + list(missing_sections(site, program))
        if "sheets/rkmk-rk4.html" not in read(site / "reference/methods-rkmk.html").links:
            found.append("reference: the data sheet of rkmk/rk4 is not shown")
        report(found, site)


if __name__ == "__main__":
    main(*sys.argv[1:])
