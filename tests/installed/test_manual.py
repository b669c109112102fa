# SPDX-License-Identifier: BSD-3-Clause
"""The man page is sound, and tells all that the help tells."""
import re

from places import PREFIX, PROGRAM, Scratch, commands, needs, say

PAGE = PREFIX / "share/man/man1/kreisel.1"


class Manual(Scratch):
    def test_nothing_is_wrong_with_it(self):
        needs("mandoc", "docs")
        self.assertEqual(say("mandoc", "-T", "lint", "-W", "style", PAGE), "")

    def test_it_has_every_command_and_option(self):
        needs("mandoc", "docs")
        text = re.sub(r".\x08", "", say("mandoc", "-T", "utf8", "-O", "width=400", PAGE))
        for command in commands():
            self.assertRegex(text, rf"(?m)^ +{command}$")
            for option in re.findall(r"^  (-\S+)", say(PROGRAM, command, "--help"), flags=re.M):
                self.assertIn(option, re.split(r"\n   \S", text.split(f" kreisel {command} [OPTIONS]")[1])[0])
        self.assertIn("an array of parts after it", re.sub(r"\s+", " ", text.replace("\n\n", "\n.\n")))
        self.assertIn(say(PROGRAM, "--version").split()[1], text)
        for code in ("0", "1", "2", "3", "4", "130"):
            self.assertRegex(text.split("EXIT STATUS")[1], rf"(?m)^ +{code} ")

    def test_man_finds_it(self):
        needs("man", "docs")
        self.assertIn("KREISEL(1)", say("man", "-M", PREFIX / "share/man", "kreisel"))
