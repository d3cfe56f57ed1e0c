# What the scans of this folder read: C++ sources below libs/, without their comments.
import pathlib
import re
import sys

_TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<fence>[^(\s]*)\((?P<raw>.*?)\)(?P=fence)"'
    r"|'(?:\\[^\n']+|\\'|[^'\\\n])'" r'|"(?P<text>(?:\\.|[^"\\\n])*)"', re.S)


def files(root, folders):
    """The sources of these folders below libs/."""
    found = [path for folder in folders for path in sorted(pathlib.Path(root, "libs", folder).rglob("*.[ch]pp"))]
    if not found:
        sys.exit(f"no sources below {root}/libs in {' '.join(folders)}")
    return found


def literals(text):
    """Line and content of every string literal but the names of included files."""
    for token in _TOKEN.finditer(text):
        content = token["raw"] if token["raw"] is not None else token["text"]
        line_start = text.rfind("\n", 0, token.start()) + 1
        if content is not None and not text.startswith("#include", line_start):
            yield text.count("\n", 0, token.start()) + 1, content


def without_comments(text):
    """The same text, line by line, with comments and the contents of strings blanked."""
    return _TOKEN.sub(lambda t: "\n" * t[0].count("\n") if t[0].startswith("/") else '""' + "\n" * t[0].count("\n"), text)


def end(faults, what):
    """Prints the faults and their number; the exit code says whether there are any."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} {what}")
    return 1 if faults else 0
