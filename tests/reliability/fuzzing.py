# SPDX-License-Identifier: BSD-3-Clause
"""libFuzzer on every reader, from the inputs in tests/fuzz/corpus on; what it finds stays in build/fuzz/found."""
import pathlib
import re
import shutil
import subprocess

from attack import attack, emptied

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD, KEPT = ROOT / "build/fuzz", ROOT / "tests/fuzz/corpus"
SECONDS, SLOW = 60, 10  # of fuzzing a reader; that reading one input may take


def built():
    for words in (["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-D", "CMAKE_CXX_COMPILER=clang++-14", "-D",
                   "CMAKE_BUILD_TYPE=Release", "-D", "KREISEL_FUZZ=ON", "-D", "KREISEL_TESTS=OFF", "-D",
                   "KREISEL_BINARY128=OFF"],
                  ["cmake", "--build", BUILD, "--target", "fuzzers"]):
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return sorted(BUILD.glob("fuzz_*"))


def dictionary(kept):
    """The words of the kept inputs, which chance would hardly write."""
    words = {word for file in kept.iterdir() for word in re.findall(r"[\w.]{3,40}", file.read_text(errors="ignore"))}
    file = BUILD / f"{kept.name}.dict"
    file.write_text("".join(f'"{word}"\n' for word in sorted(words) if word.isascii()))
    return file


@attack("R21")
def fuzz(kreisel, cases, random, measured):
    """The cases are readers."""
    if shutil.which("clang++-14") is None:
        measured.case("clang++-14", "is not installed (tools/setup maintain)")
        return
    programs, executions = [file for file in built() if file.suffix == ""], []

    def fuzzed(program):
        name = program.name.removeprefix("fuzz_")
        found, corpus, kept = emptied(BUILD / "found" / name), BUILD / "corpus" / name, KEPT / name
        corpus.mkdir(parents=True, exist_ok=True)
        ended = subprocess.run(
            [program, f"-max_total_time={SECONDS}", f"-timeout={SLOW}", "-rss_limit_mb=1000", "-print_final_stats=1",
             f"-seed={random.randrange(1, 2**31)}", f"-dict={dictionary(kept)}", f"-artifact_prefix={found}/", corpus,
             kept], capture_output=True, text=True, errors="replace")
        count = re.search(r"number_of_executed_units: (\d+)", ended.stderr)
        executions.append(int(count[1]) if count else 0)
        if ended.returncode != 0:
            yield f"exit code {ended.returncode}: {ended.stderr[-1500:]}"
        yield from (f"kept {file}" for file in sorted(found.iterdir()))

    measured.each(kreisel, fuzzed, programs)
    measured.require(cases)
    measured.remark = f"{SECONDS} s each, {sum(executions):,} inputs"
