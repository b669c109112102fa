# SPDX-License-Identifier: BSD-3-Clause
"""The series coefficients of lie/small_angle.hpp. All mutants are in one program: in the header that it is compiled
with, an environment variable names the coefficient that is multiplied, and by what, when the arrays are made."""

import re
import sys

from .build import Overlay, run_suite
from .mutants import ROOT, Mutant

FILE = "lie/small_angle.hpp"
VARIABLE = "KREISEL_MUTANT"
FACTORS = {"1e-6": "1.000001", "sign": "-1"}
ARRAY = re.compile(r"^inline constexpr auto (\w+) = (.*);$", re.MULTILINE)
CHOSEN = """
/// The array as it is, but for the entry that the environment names: "array entry factor". Tells what it has done.
template <class Array>
Array chosen(const char* name, Array a) {
    const char* mutant = std::getenv("%s");
    if (mutant == nullptr) return a;
    char array[64];
    unsigned long k = 0;
    double factor = 1;
    if (std::sscanf(mutant, "%%63s %%lu %%lf", array, &k, &factor) != 3 || std::strcmp(array, name) != 0) return a;
    const auto before = a.at(k);
    a[k] *= factor;
    std::fprintf(stderr, "MUTANT %%s %%lu of %%zu: %%s\\n", name, k, a.size(), a[k] == before ? "same" : "changed");
    return a;
}

""" % VARIABLE


def lengths(text):
    """Lengths of the arrays in double precision: the constants after #else, and the arrays made from them."""
    constants = re.search(r"#else\ninline constexpr std::size_t (.*?);", text)[1]
    n = {name: int(value) for name, value in re.findall(r"(\w+) = (\d+)", constants)}
    return {"sinc": n["entire_terms"], "cosc": n["entire_terms"], "sincc": n["entire_terms_wide"],
            "cosc_ds": n["entire_terms_wide"], "sincc_ds": n["entire_terms_wide"], "bernoulli": n["cot_terms_wide"],
            "cotc": n["cot_terms_wide"], "cotc_ds": n["cot_terms_wide"] - 1}


def mutants():
    text = (ROOT / FILE).read_text()
    of = lengths(text)
    for array in ARRAY.finditer(text):
        line = text.count("\n", 0, array.start()) + 1
        for k in range(of.pop(array[1])):
            for kind, factor in FACTORS.items():
                yield Mutant(FILE, line, kind, array[0], f"{array[1]} {k} {factor}")
    if of:
        sys.exit(f"{FILE}: the arrays {', '.join(of)} were not found")


def with_choice(text):
    """The header with all mutants in it."""
    text = ARRAY.sub(r'inline const auto \1 = chosen("\1", \2);', text)
    text = text.replace("#include <cstddef>\n", "#include <cstddef>\n#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n")
    return text.replace("namespace series {\n", "namespace series {\n" + CHOSEN, 1)


class Schema:
    """Runs the mutants of the series; with factor 1 in place of theirs, the suites must pass for each array."""

    def __init__(self, build):
        self.overlay = Overlay(build, FILE, with_choice((build.source / FILE).read_text()), "series")
        self.controlled = set()

    def run(self, suite, choice):
        """(whether the suite is red, "same" or "changed"); ends the program if the coefficient was not found."""
        program = self.overlay.program(suite, [])
        if program is None:
            sys.exit(f"the suite {suite} does not compile with the coefficients chosen at run time")
        red, told = run_suite(program, {VARIABLE: choice} if choice else None)
        name, k, _ = (choice or "none 0 1").split()
        done = re.findall(r"^MUTANT (\w+) (\d+) of (\d+): (\w+)$", told, re.MULTILINE)
        size = lengths((ROOT / FILE).read_text()).get(name)
        if [entry[:3] for entry in done] != ([(name, k, str(size))] if choice else []):
            sys.exit(f"the program has not changed {choice} once: {done}")
        return red, done[0][3] if done else "same"

    def control(self, suite, array):
        for choice in (None, f"{array} 0 1"):
            if (suite, choice) not in self.controlled and self.run(suite, choice) != (False, "same"):
                sys.exit(f"the suite {suite} is red with no coefficient changed ({choice})")
            self.controlled.add((suite, choice))

    def verdict(self, mutant):
        """The suite that turned red, or "survived"."""
        for suite in mutant.suites:
            self.control(suite, mutant.after.split()[0])
            red, done = self.run(suite, mutant.after)
            if done != "changed":
                sys.exit(f"{mutant} changes nothing")
            if red:
                return suite
        return "survived"
