# SPDX-License-Identifier: BSD-3-Clause
"""What the program says of itself."""
import re
import subprocess


class Program:
    def __init__(self, path):
        self.path = str(path)

    def say(self, *arguments):
        return subprocess.run([self.path, *arguments], check=True, capture_output=True, text=True).stdout

    def listed(self, topic):
        """[(name, text)] of `kreisel list TOPIC`."""
        return rows(self.say("list", topic).split("\n")[1:])

    def topics(self):
        return re.search(r"\{([\w,]+)\}", self.say("list", "--help")).group(1).split(",")

    def commands(self):
        """[(name, text)] from the help."""
        return rows(self.say("--help").split("Subcommands:\n")[1].split("\n\n")[0].split("\n"))


def rows(lines):
    """Lines like `  name   text`; what they are indented by more is left out."""
    found = (re.match(r"  (\S+) +(.*)$", line) for line in lines)
    return [match.groups() for match in found if match]
