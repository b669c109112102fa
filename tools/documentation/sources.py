# SPDX-License-Identifier: BSD-3-Clause
"""The bibliography as a page."""
import re


def entries(bibliography):
    """(key, text) of each entry of a BibTeX file."""
    for match in re.finditer(r"^@\w+\{([^,\s]+),.*?^\}", bibliography, flags=re.M | re.S):
        yield match.group(1), match.group(0)


def sources_page(bibliography):
    return "# Sources\n\n" + "".join(f"## {key}\n\n```bibtex\n{text}\n```\n\n" for key, text in
                                     sorted(entries(bibliography)))
