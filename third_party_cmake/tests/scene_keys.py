#!/usr/bin/env python3
"""scene_keys.py CLEFT SOURCE FOLDER...: no string in the sources below libs/FOLDER may name a key of the scene file.

Only `scene` and what is above it know how a user writes things down; below it an error says which quantity is wrong.
The keys are those that the program CLEFT lists. SOURCE is the folder that holds libs/.
"""
import re
import subprocess
import sys

import sources


def listed_keys(program):
    rows = subprocess.run([program, "scene"], check=True, capture_output=True, text=True).stdout.splitlines()
    keys = {row.split()[0] for row in rows}
    sections = {row.split()[0] for row in rows if " section " in row or " array of sections " in row}
    if not sections or not any("." in key for key in keys):
        sys.exit(f"{program} scene lists no keys")
    return keys, sections


def pattern_of(keys, sections):
    """Keys with a dot, their ends with a dot (contact.method of crack.contact.method), crack[ and crack.{}"""
    ends = {".".join(parts[k:]) for parts in (key.split(".") for key in keys) for k in range(len(parts) - 1)}
    some = "|".join(map(re.escape, sorted(ends, key=len, reverse=True)))
    section = "|".join(map(re.escape, sorted(sections)))
    return re.compile(rf"(?<!\w)(?:(?:{some})(?!\w)|(?:{section})(?:\[|\.\{{))|\A(?:{section})\.\Z")


def main(program, root, *folders):
    pattern = pattern_of(*listed_keys(program))
    faults = []
    for path in sources.files(root, folders):
        for line, content in sources.literals(path.read_text()):
            if found := pattern.search(content):
                faults.append(f"{path}:{line}: {found[0]}")
    return sources.end(faults, "strings below scene name keys of it")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
