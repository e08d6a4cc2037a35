#!/usr/bin/env python3
"""check_words.py ROOT: phrases that do not belong into comments of C++ and titles of tests, each with what to say instead."""

import re
import sys
from pathlib import Path

INSTEAD = {
    r"(?:^|///?<? )\s*What\b|///< what\b": "a noun: the wrapped observer, requirements of all parts",
    r"\b(?:hold|holds|held|holding)\b": "constrain (a velocity), keep (memory)",
    r"\bbehind\b|\bahead of\b": "after, before",
    r"\bof (?:its|their) own\b|\bwhere there (?:is|are) none\b": "its own, or nothing; if absent",
    r"\blook(?:s|ed|ing)?\b": "check, inspect, sample",
    r"\bhand(?:s|ed|ing)? (?:over|back|on|out)\b|\bhanded\b": "give, pass, return, scatter",
    r"\b(?:told|tells?|telling)\b": "report, say, give",
    r"\b(?:meets?|met|meeting)\b": "touch, overlap, intersect",
    r"\b(?:bear|bears|borne)\b": "carry (stress), allow, tolerate",
    r"\bgo(?:es)? on\b|\bwent on\b|\banew\b|\bof before\b|\bas ever\b": "continue, resume; again; previous; as usual",
    r"\bless\b(?! than\b)|\bso many\b|\balone\b": "minus; n; only",
    r"\bstand(?:s|ing)? for\b": "represent, replace",
    r"\bbook(?:s|ed|ing)?\b": "record, account for",
    r"\bsentence is enough\b": "already reported",
}
READ_BY_TESTS = ("// must print", "// errors", "// compile with")


def comments(path):
    """Number and text of each line of comment, without the names in it."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        at = line.find("//")
        while at > 0 and line[:at].count('"') % 2:  # within a text
            at = line.find("//", at + 2)
        if at >= 0:
            yield number, re.sub("`[^`]*`", "``", line[at:])


def titles(path):
    """Number and text of the title of each test."""
    text = path.read_text()
    for found in re.finditer(r'(?:TEST_CASE|SECTION)\(\s*((?:"[^"]*"\s*)+)', text):
        yield text.count("\n", 0, found.start()) + 1, re.sub(r'"\s*"', "", found[1]).strip()[1:-1]


def main(root):
    wrong = [f"{path.relative_to(root)}:{number}: {text.strip()}\n  say: {instead}"
             for folder in ("include", "src", "tests", "examples", "benchmarks", "python")
             for path in sorted((Path(root) / folder).rglob("*.[ch]pp"))
             for number, text in (*comments(path), *titles(path)) if not text.startswith(READ_BY_TESTS)
             for phrase, instead in INSTEAD.items() if re.search(phrase, text)]
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main(sys.argv[1])
