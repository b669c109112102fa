# SPDX-License-Identifier: BSD-3-Clause
"""All pages of the reference."""
from . import schema, sheets, sources
from .markdown import anchor, escaped, table

TOPICS = {"problems": "Problems", "projections": "Projections", "formulations": "Formulations",
          "kinds": "Kinds of experiments", "figures": "Kinds of figures", "tables": "Tables"}


def family_page_name(family):
    return f"methods-{family}.md"


def methods_page(families):
    text = ("# Methods\n\nWhat a step of each family does is in "
            "[Notation](../project/notation.md#families-of-methods).\n\n")
    for family, methods in families.items():
        page = family_page_name(family)
        text += f"## {escaped(family)}\n\n" + table(["method", "what it is"], [
            (f"[{escaped(name)}]({page}#{anchor(name)})", escaped(summary)) for name, summary in methods])
    return text


def write(program, folder, data_sheets, bibliography, manual):
    """Markdown into a folder; data_sheets are {method: file}, manual is the text of README in the site."""
    (folder / "sheets").mkdir(parents=True)

    def write_page(name, text):
        (folder / name).write_text(text, encoding="utf-8")

    for topic, title in TOPICS.items():
        write_page(f"{topic}.md", sheets.topic_page(program, title, topic))
    families = sheets.families(program)
    places = {name: f"sheets/{file.name}" for name, file in data_sheets.items()}
    write_page("methods.md", methods_page(families))
    for family, methods in families.items():
        write_page(family_page_name(family), sheets.family_page(program, family, methods, places))
    for file in data_sheets.values():
        write_page(f"sheets/{file.name}", file.read_text(encoding="utf-8"))
    write_page("metrics.md", sheets.metrics_page(program))
    write_page("configs.md", sheets.configs_page(program))
    write_page("commands.md", sheets.commands_page(program))
    write_page("config.md", schema.config_page(program, manual))
    write_page("sources.md", sources.sources_page(bibliography.read_text(encoding="utf-8")))
