# SPDX-License-Identifier: BSD-3-Clause
"""What the installed completions of bash, zsh and fish offer."""
import shlex

from places import PREFIX, Scratch, commands, names, needs, say

BASH = PREFIX / "share/bash-completion/completions/kreisel"
ZSH = PREFIX / "share/zsh/site-functions/_kreisel"
FISH = PREFIX / "share/fish/vendor_completions.d/kreisel.fish"

# Line, some of what is offered, and some of what is not. FILES are of the working folder.
FILES = ("my_top.json", "notes.txt", "results/my_top/results.csv")
LINES = (
    ("kreisel r", ("run", "report"), ("table", "--help")),
    ("kreisel --", ("--help", "--version"), ("run",)),
    ("kreisel info rkmk/rk", ("rkmk/rk4", "rkmk/rk4_38"), ("rkmk/euler",)),
    ("kreisel info heavy", ("heavy_top",), ("orders_heavy_top",)),
    ("kreisel info or", ("orders",), ("orders_heavy_top",)),
    ("kreisel certify magnus/", ("magnus/gauss2",), ("rkmk/rk4",)),
    ("kreisel list m", ("methods", "metrics"), ("problems",)),
    ("kreisel list --fam", ("--family",), ("--help",)),
    ("kreisel list methods --family e", ("energy", "extrapolation"), ("rkmk",)),
    ("kreisel run orders_", ("orders_heavy_top",), ("certification",)),
    ("kreisel run my", ("my_top.json",), ("notes.txt",)),
    ("kreisel run my_top.json --re", ("--resume",), ("--overwrite",)),
    ("kreisel run my_top.json -o re", ("results",), ("my_top.json",)),
    ("kreisel run my_top.json -j ", (), ("my_top.json", "orders_heavy_top")),
    ("kreisel run my_top.json --filter methods=rkmk/rk", ("rkmk/rk4",), ("rkmk/euler",)),
    ("kreisel table re", ("results",), ("my_top.json",)),
    ("kreisel table results --table er", ("errors",), ("orders", "my_top.json")),
    ("kreisel table results --table errors --format l", ("latex",), ("csv",)),
    ("kreisel plot results --figure my", ("my_top.json",), ("notes.txt",)),
    ("kreisel new ", ("method", "problem", "experiment"), ("rkmk/rk4", "my_top.json")),
    ("kreisel run my_top.json --references re", ("results",), ("my_top.json",)),
    ("kreisel diff re", ("results",), ("my_top.json",)),
    ("kreisel plot ", ("results",), ("orders_heavy_top", "heavy_top", "my_top.json")),
)

# What zsh's own functions would show, as lines.
ZSH_DRIVER = r"""
_describe() { local -a shown=("${(@P)argv[-1]}"); print -rl -- "${shown[@]%%:*}"; }
_files() { case $1 in -g) print -rl -- *.json(N) *(N/) ;; -/) print -rl -- *(N/) ;; *) print -rl -- *(N) ;; esac; }
compset() { : }
compdef() { : }
compadd() { print -rl -- $@ }
words=(__WORDS__); CURRENT=$#words
source __FILE__
"""


class Completion:
    def setUp(self):
        super().setUp()
        needs(self.shell, "docs")
        for file in FILES:
            (self.scratch / file).parent.mkdir(parents=True, exist_ok=True)
            (self.scratch / file).write_text("")

    def test_lines(self):
        for line, some, none in LINES:
            with self.subTest(line):
                offered = self.offered(line)
                self.assertEqual(set(some) - offered, set())
                self.assertEqual(set(none) & offered, set())

    def test_all_names_of_the_registry(self):
        self.assertEqual(set(commands()) - self.offered("kreisel "), set())
        self.assertEqual(set(names("methods")) - self.offered("kreisel certify "), set())
        self.assertEqual(set(names("configs")) - self.offered("kreisel run "), set())
        topics = ("problems", "methods", "projections", "formulations", "figures", "tables")
        self.assertEqual({name for topic in topics for name in names(topic)} - self.offered("kreisel info "), set())


class Bash(Completion, Scratch):
    shell = "bash"

    def offered(self, line):
        words = line.replace("=", " = ").split() + ([""] if line.endswith(" ") else [])
        script = (f"source {BASH}; COMP_WORDS=({' '.join(map(shlex.quote, words))}); "
                  'COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _kreisel; printf "%s\\n" "${COMPREPLY[@]}"')
        return set(say("bash", "--norc", "-c", script, cwd=self.scratch).split("\n"))

    def test_a_path_of_the_program_will_do(self):
        self.assertIn("run", self.offered(f"{PREFIX}/bin/kreisel ru"))


class Fish(Completion, Scratch):
    shell = "fish"

    def offered(self, line):
        said = say("fish", "-c", f"source {FISH}; complete -C{shlex.quote(line)}", cwd=self.scratch)
        return {row.split("\t")[0].rstrip("/").split("=")[-1] for row in said.split("\n")}


class Zsh(Completion, Scratch):
    shell = "zsh"

    def test_it_is_sound(self):
        say("zsh", "-n", ZSH)
        self.assertEqual(ZSH.read_text().split("\n")[0], "#compdef kreisel")

    def offered(self, line):
        """Candidates that begin like the last word, which is what zsh would keep of them."""
        words = line.split() + ([""] if line.endswith(" ") else [])
        script = ZSH_DRIVER.replace("__WORDS__", " ".join(map(shlex.quote, words))).replace("__FILE__", str(ZSH))
        said = say("zsh", "-f", "-c", script, cwd=self.scratch).split("\n")
        return {row for row in said if row.startswith(words[-1].split("=")[-1])}
