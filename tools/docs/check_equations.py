"""Fails where a comment of the libraries cites an equation, `theory (2.3)`, that the theory page does not have."""

import pathlib
import re
import sys

from markdown import ROOT, theory

CITATION = re.compile(r"\btheory((?:,? (?:and |to )?\(\d+\.\d+\))+)")


def citations(text):
    """The numbers that a text cites: theory (2.3), or theory (2.3), (2.4) and (2.5)."""
    return [number for match in CITATION.finditer(text) for number in re.findall(r"\d+\.\d+", match[1])]


def check(folder, known):
    """(how many citations, what is wrong) of the C++ files below a folder."""
    count, wrong = 0, []
    for file in sorted(pathlib.Path(folder).rglob("*.[ch]pp")):
        for number in citations(file.read_text()):
            count += 1
            if number not in known:
                wrong.append(f"{file}: there is no equation ({number}) in the theory page")
    return count, wrong


def main():
    known = theory()
    count, wrong = check(ROOT / "libs", known)
    if count == 0:
        wrong.append("no comment cites the theory page")
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{count} citations of {len(known)} equations")


if __name__ == "__main__":
    main()
