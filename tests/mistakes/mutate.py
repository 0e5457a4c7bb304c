#!/usr/bin/env python3
"""Changes every operator, comparison, sign and constant in the lines that learners write (between the
`// [name]` marks of the parts that a stage's gaps.hpp has), one at a time, and asks whether some check
catches it.

usage: tests/mistakes/mutate.py [--write] [NN_name...]    after ./course test

--write puts the result into docs/mistakes.md. Exit code 1: a change gets through that is not explained
below, or less than 95 % are caught. It takes some minutes.
"""
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
BUILD = TOP / "build/release"

# What is replaced by what. clang-format puts blanks around binary operators, and none into types.
OPERATORS = [
    (r" \+ ", [" - "]), (r" - ", [" + "]), (r" \* ", [" / "]), (r" / ", [" * "]),
    (r" \+= ", [" -= "]), (r" -= ", [" += "]), (r" /= ", [" *= "]),
    (r" < ", [" <= ", " > "]), (r" <= ", [" < ", " > "]), (r" > ", [" >= ", " < "]), (r" >= ", [" > ", " < "]),
    (r" == ", [" != "]), (r" && ", [" || "]),
    (r"(?<=[ (])-(?=\w)", [""]),  # a sign
    (r"(?<=[ (])!(?=[\w(])", [""]),
    (r"std::sin", ["std::cos"]), (r"std::cos", ["std::sin"]),
]
NUMBER = re.compile(r"(?<![\w.])\d+(\.\d+)?(e[+-]?\d+)?(?![\w.])")

# Changes that get through, and why nothing is wrong with that: stage, the changed line, the reason.
EXPLAINED = [
    ("02_spring_floor", "if (y <= radius) {", "at y = r the spring's force is 0 anyway: the same program"),
    ("05_ball_collision", "if (d >= 1e-100) meeting.e12 = between / d;", "at exactly 1e-100 m only"),
    ("05_ball_collision", "if (d > 2e-100) meeting.e12 = between / d;",
     "the same for every distance above 2e-100 m, far below the size of an atom"),
]


MARK = re.compile(r" *// \[(\w+)\]")


def code_only(line):
    return "" if "through" in line else line.split("//")[0]  # stage 8's memory: no learner has it


def changes_of(line):
    """(column, length, replacement) of each change in one line."""
    code = code_only(line)
    for pattern, replacements in OPERATORS:
        for found in re.finditer(pattern, code):
            for new in replacements:
                yield found.start(), found.end() - found.start(), new
    for found in NUMBER.finditer(code):
        old = found.group()
        new = old.replace("1e", "2e") if "e" in old else repr(float(old) + 1) if "." in old else str(int(old) + 1)
        yield found.start(), len(old), new


def mutants_of(text, gaps):
    """(part, line number, text of the changed file, the changed line) for each change."""
    lines = text.split("\n")
    written = {mark.group(1) for mark in map(MARK.fullmatch, gaps.split("\n")) if mark}
    part = None
    for number, line in enumerate(lines):
        mark = MARK.fullmatch(line)
        if mark:
            part = None if part == mark.group(1) else mark.group(1)
        elif part in written:
            for column, length, new in changes_of(line):
                changed = line[:column] + new + line[column + length:]
                yield part, number, "\n".join(lines[:number] + [changed] + lines[number + 1:]), changed


def verdict(stage, text):
    """'caught in CHECK', 'does not compile', or 'gets through'."""
    with tempfile.TemporaryDirectory() as folder:
        header, module = pathlib.Path(folder, "mutant.hpp"), pathlib.Path(folder, "mutant.so")
        header.write_text(text)
        compiled = subprocess.run([BUILD / "checks/compile_stage", stage, header, module, "-w", "-O1", "-UNDEBUG"],
                                  capture_output=True)
        if compiled.returncode != 0:
            return "does not compile"
        ran = subprocess.run([BUILD / "bin/stage_checks", stage, module], capture_output=True, text=True)
        return "caught" if ran.returncode != 0 else "gets through"


def header_of(stage):
    subject = TOP / f"stages/{stage}/tests/subject.cpp"  # of a stage that ./course new made
    if not subject.exists():
        subject = TOP / f"tests/checks/subjects/{stage}.cpp"
    return TOP / "stages" / re.search(r'#define BOUNCE_STAGE_HEADER "(.*)"', subject.read_text()).group(1)


def explanation(stage, line):
    for where, changed, why in EXPLAINED:
        if where == stage and changed == line.strip():
            return why
    return None


def main():
    arguments = [a for a in sys.argv[1:] if a != "--write"]
    stages = arguments or sorted(p.stem for p in (TOP / "tests/checks/subjects").glob("[0-9]*.cpp"))
    rows, survivors, good = [], [], True
    tried_in_all = caught_in_all = 0
    for stage in stages:
        text = header_of(stage).read_text()
        if verdict(stage, text) != "gets through":
            sys.exit(f"{stage}: the course's own stage does not pass its checks")
        mutants = list(mutants_of(text, (header_of(stage).parent / "gaps.hpp").read_text()))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            found = list(pool.map(lambda m: verdict(stage, m[2]), mutants))
        broken, caught = found.count("does not compile"), found.count("caught")
        tried = len(mutants) - broken
        tried_in_all, caught_in_all = tried_in_all + tried, caught_in_all + caught
        rows.append(f"| {int(stage[:2])} | {tried} | {caught} | {100 * caught / tried:.0f} % |")
        print(rows[-1], flush=True)
        for (part, number, _, line), what in zip(mutants, found):
            if what != "gets through":
                continue
            why = explanation(stage, line)
            survivors.append(f"| {int(stage[:2])} | `{line.strip()}` | {why} |")
            print(f"  {part}, line {number + 1}: {line.strip()}   ({why})", flush=True)
            good = good and why is not None
    share = 100 * caught_in_all / tried_in_all
    rows.append(f"| all | {tried_in_all} | {caught_in_all} | {share:.1f} % |")
    print(rows[-1])
    if "--write" in sys.argv and not arguments:
        write(rows, survivors)
    return 0 if good and share >= 95 else 1


def write(rows, survivors):
    page = TOP / "docs/mistakes.md"
    head = page.read_text().split("\n## Every line, changed")[0].rstrip("\n")
    page.write_text(head + """

## Every line, changed

The mistakes above were thought of by people. [mutate.py](../tests/mistakes/mutate.py) thinks of others: it
changes each operator, comparison, sign and constant in the lines that learners write, one at a time (`<`
to `<=` and to `>`, `+` to `-`, `*` to `/`, 0 to 1, `sin` to `cos`), compiles the stage, and runs its checks.
Changes that do not compile do not count, nor do the lines about `through` in stage 8: no learner writes them, and
[08_racket_rim_test.cpp](../tests/stages/08_racket_rim_test.cpp) judges them. The result of its last run:

| stage | changes | caught | share |
|---|---|---|---|
""" + "\n".join(rows) + """

What got through, and why:

| stage | the changed line | why no check minds |
|---|---|---|
""" + "\n".join(survivors) + "\n")


if __name__ == "__main__":
    sys.exit(main())
