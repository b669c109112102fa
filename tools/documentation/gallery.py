# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the experiments, from results that are there."""
import shutil

from .markdown import escaped


def gallery_page(program, results, pages):
    """Copies figures below pages/gallery."""
    text = "# Gallery\n\n"
    for name, description in program.listed("configs"):
        figures = sorted((results / name / "figures").glob("*.svg"))
        text += f"## {escaped(name)}\n\n{escaped(description)}\n\n" if figures else ""
        for figure in figures:
            target = pages / "gallery" / name / figure.name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(figure, target)
            text += f"![{escaped(figure.stem)}](gallery/{name}/{figure.name})\n\n"
    if not (pages / "gallery").is_dir():
        text += "There are no figures yet: `./reproduce` draws those of every experiment into `results/`.\n"
    (pages / "gallery.md").write_text(text, encoding="utf-8")
