# SPDX-License-Identifier: BSD-3-Clause
"""The keys of a config from the JSON Schema that the program prints."""
import json
import re

from .markdown import code, table

MOST_NAMES = 12  # longer lists are in pages of their own


def bounds(node):
    words = {"minimum": "at least", "exclusiveMinimum": "above", "maximum": "at most", "exclusiveMaximum": "below"}
    return [f"{word} {node[key]:g}" for key, word in words.items() if key in node]


def listed(names, pages):
    """Names, or the page that has them all."""
    if len(names) <= MOST_NAMES:
        return ", ".join(code(json.dumps(name)) for name in names)
    return next((f"a name of [{title}]({page})" for names_of_page, title, page in pages if set(names) - {"*"} <=
                 names_of_page | {name.split("/")[0] + "/*" for name in names_of_page}), f"one of {len(names)} names")


def alternatives(nodes, pages):
    """Many objects differ by what their name or kind adds."""
    objects = [node["properties"] for node in nodes if node.get("type") == "object"]
    if len(objects) > 2:
        common = [key for key in objects[0] if all(key in keys for keys in objects)]
        nodes = [node for node in nodes if node.get("type") != "object"]
        yield from (kind(node, pages) for node in nodes)
        more = " and keys of its own" if any(len(keys) > len(common) for keys in objects) else ""
        yield "an object of " + ", ".join(map(code, common)) + more
    else:
        yield from (kind(node, pages) for node in nodes)


def kind(node, pages):
    """What a value may be, in one line."""
    if "const" in node:
        return code(json.dumps(node["const"]))
    if "enum" in node:
        return listed(node["enum"], pages)
    if "anyOf" in node and "type" not in node:
        return "; or ".join(dict.fromkeys(alternatives(node["anyOf"], pages)))
    if node.get("type") == "array":
        return "a list of: " + kind(node.get("items", {}), pages)
    if node.get("type") == "object":
        return "an object of " + ", ".join(map(code, node["properties"]))
    words = {"string": "a text", "integer": "a whole number", "number": "a number", "boolean": "`true` or `false`"}
    return " ".join([words.get(node.get("type"), "anything"), ", ".join(bounds(node))]).strip()


def values(node, pages, before=""):
    """{key: what it may be} of an object and of the objects in it that have no alternatives."""
    found = {}
    for name, value in node.get("properties", {}).items():
        found[before + name] = kind(value, pages)
        if value.get("type") == "object":
            found.update(values(value, pages, before + name + "."))
    return found


def meanings(manual):
    """{key: (meaning, default)} of the table in README, whose links are those of the site already."""
    section = manual.split("### A config\n")[1].split("\n### ")[0]
    section = section.replace("](#", "](../project/manual.md#")
    return {key: (meaning, default) for key, meaning, default in
            re.findall(r"^\| `([\w.]+)` \| (.*) \| ([^|]*?) ?\|$", section, flags=re.M)}


def config_page(program, manual):
    schema = json.loads(program.say("schema"))
    pages = [({name for name, _ in program.listed(topic)}, topic, topic + ".md") for topic in
             ("methods", "problems", "projections", "formulations")]
    whole, extending = sorted(schema["anyOf"], key=lambda some: "extends" in some["properties"])
    may_be = values(whole, pages) | {"extends": kind(extending["properties"]["extends"], pages)}
    told = meanings(manual)
    text = ("# Keys of a config\n\nWhat a key may be is from the JSON Schema that `kreisel schema` prints, and that "
            "editors take. [A config](../project/manual.md#a-config) has an example; parameters of "
            "[problems](problems.md), options of [methods](methods.md) and [projections](projections.md), and keys of "
            "[figures](figures.md) have pages of their own.\n\n")
    return text + table(["key", "meaning", "default", "what it may be"], [
        (code(key), *told.get(key, ("", "")), what) for key, what in may_be.items()])
