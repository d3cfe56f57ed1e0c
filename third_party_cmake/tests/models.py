#!/usr/bin/env python3
"""models.py SOURCE FOLDER...: sources below libs/FOLDER may hold and hand on an assembly::Model, but not fill one.

A model is filled where a variable of this type is declared in a file that also assigns a member of it. SOURCE is the
folder that holds libs/. A FOLDER that starts with a hyphen is a file that may: -tangent_check/src/element_tangent.cpp.
"""
import os
import re
import sys

import sources

DECLARED = re.compile(r"(?<!struct )(?<!class )\bModel\s+(?P<name>\w+)\s*(?:;|\{\}|\{\s*\.?\w|=\s*\{)")


def filled(text):
    """Line and name of each model that is filled."""
    text = sources.without_comments(text)
    for found in DECLARED.finditer(text):
        name = found["name"]
        begins_full = text[found.end() - 2 : found.end()] not in ("{}",) and "{" in found[0]
        if begins_full or re.search(rf"\b{name}\.\w+(?:\.\w+)*\s*(?:=[^=]|\.(?:push_back|emplace_back|insert|resize)\()",
                                    text[found.end():]):
            yield text.count("\n", 0, found.start()) + 1, name


def main(root, *folders):
    may = [f"{root}/libs/{folder[1:]}" for folder in folders if folder.startswith("-")]
    for path in may:
        if not os.path.isfile(path):
            sys.exit(f"{path} may fill a model, but there is no such file: mend the list of exceptions")
    paths = sources.files(root, [folder for folder in folders if not folder.startswith("-")])
    faults = [f"{path}:{line}: {name}" for path in paths if str(path) not in may for line, name in filled(path.read_text())]
    return sources.end(faults, "models are filled outside of problem")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
