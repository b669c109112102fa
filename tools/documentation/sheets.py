# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the reference from `kreisel list` and `kreisel info`: a section for each name."""
import re

from .markdown import anchor, code, escaped, table


def sources(line):
    keys = line.removeprefix("Sources: ").split(", ")
    return "Sources: " + ", ".join(f"[{key}](sources.md#{anchor(key)})" for key in keys) + "\n\n"


def indented(lines):
    """Lines of `name  text` as a table, others as a nested list."""
    if all(re.match(r"  \S+ {2,}", line) for line in lines):
        return table(["name", "meaning"], [(code(name), escaped(text)) for name, text in
                                           (line.strip().split(None, 1) for line in lines)])
    return "".join(("    " if line.startswith("    ") else "") + "- " + escaped(line.strip()) + "\n"
                   for line in lines) + "\n"


def described(name, info):
    """What `kreisel info` says; its first line without the name."""
    summary, *lines = info.rstrip("\n").split("\n")
    text = escaped(re.sub(f"^{re.escape(name)}(: |, )", "", summary)) + "\n\n"
    while lines:
        line, count = lines[0], 1
        while count < len(lines) and lines[count].startswith("  "):
            count += 1
        text += sources(line) if line.startswith("Sources: ") else escaped(line) + "\n\n"
        text += indented(lines[1:count]) if count > 1 else ""
        lines = lines[count:]
    return text


def section(program, name):
    return f"## {escaped(name)}\n\n{described(name, program.say('info', name))}"


def topic_page(program, title, topic):
    listed = program.listed(topic)
    text = f"# {title}\n\n" + table(["name", "what it is"], [(f"[{escaped(name)}](#{anchor(name)})", escaped(summary))
                                                            for name, summary in listed])
    return text + "".join(section(program, name) for name, _ in listed)


def families(program):
    """{family: [(name, summary)]} of all methods."""
    found = {}
    for name, summary in program.listed("methods"):
        found.setdefault(name.split("/")[0], []).append((name, summary))
    return found


def family_page(program, family, methods, data_sheets):
    text = f"# {escaped(family)}\n\n"
    for name, _ in methods:
        text += section(program, name)
        if name in data_sheets:
            text += f"[Data sheet: what is observed]({data_sheets[name]})\n\n"
    return text


def metrics_page(program):
    return "# Metrics\n\n" + table(["metric", "meaning and unit"], [(code(name), escaped(text)) for name, text in
                                                                   program.listed("metrics")])


def configs_page(program):
    return "# Experiments\n\n" + table(["config", "what it shows"], [(code(name), escaped(text)) for name, text in
                                                                    program.listed("configs")])


def commands_page(program):
    text = "# Commands\n\n" + table(["command", "what it does"], [(f"[{name}](#{name})", escaped(summary))
                                                                 for name, summary in program.commands()])
    return text + "".join(f"## {name}\n\n```text\n{program.say(name, '--help')}```\n\n"
                          for name, _ in program.commands())
