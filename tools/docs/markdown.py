"""What the pages of the documentation are made of: their Markdown with numbered equations, and texts taken from elsewhere."""

import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ROOT / "tools/docs/pages"
PROGRAM = "build/release/bin/cleft"

# $$ ... $$ (2.3), on lines of their own
EQUATION = re.compile(r"^\$\$(?P<formula>.+?)\$\$ \((?P<number>\d+\.\d+)\)$", re.MULTILINE | re.DOTALL)
# (2.3) in a sentence, or what is code or a formula
MENTION = re.compile(r"`[^`]*`|\$[^$]*\$|\((\d+\.\d+)\)")
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".toml": "toml", ".txt": "cmake", ".py": "python"}


class Mistake(Exception):
    """Something in the sources of the documentation that must be mended."""


def equations(text):
    """The numbers of a page's equations."""
    numbers = [match["number"] for match in EQUATION.finditer(text)]
    twice = sorted({number for number in numbers if numbers.count(number) > 1})
    if twice:
        raise Mistake(f"equations numbered twice: {', '.join(twice)}")
    return set(numbers)


def theory():
    """The numbers of the equations of the theory page."""
    return equations((PAGES / "theory.md").read_text())


def number_equations(text, here=frozenset()):
    """Gives every equation its number and anchor, and makes links of the numbers in sentences: to the equations `here`, or to those of
    the theory page."""
    there = theory()

    def link(match):
        number = match[1]
        if number is None:
            return match[0]
        if number not in there | here:
            raise Mistake(f"there is no equation ({number})")
        return f"[({number})]({'' if number in here else 'theory.html'}#eq-{number})"

    out, end = [], 0
    for match in EQUATION.finditer(text):
        number = match["number"]
        out.append(MENTION.sub(link, text[end:match.start()]))
        out.append(f"::: {{.equation #eq-{number}}}\n$${match['formula']}$$ [({number})]{{.number}}\n:::\n")
        end = match.end()
    out.append(MENTION.sub(link, text[end:]))
    return "".join(out)


def output(*arguments):
    """What the program prints."""
    return subprocess.run([PROGRAM, *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def code(path):
    """A file of the sources as a block of code."""
    file = ROOT / path
    if not file.is_file():
        raise Mistake(f"there is no {path}")
    return f"`{path}`:\n\n```{LANGUAGES[file.suffix]}\n{file.read_text().rstrip()}\n```\n"


def keys():
    """The keys of scene files, a table a section, as the program lists them."""
    rows = [re.match(r"\| `(.+?)` \| (.+?) \| (.+) \|$", line) for line in output("scene", "--markdown").splitlines()]
    rows = [row.groups() for row in rows if row]
    if not rows:
        raise Mistake("the program lists no keys")
    sections = [key for key, kind, _ in rows if "section" in kind or kind.endswith("table")]
    tops = [key for key in dict.fromkeys(key.split(".")[0] for key, _, _ in rows)]
    out = []
    for top in tops:
        own = [row for row in rows if row[0].split(".")[0] == top]
        head = next((row for row in own if row[0] == top), None)
        if head and len(own) == 1 and top not in sections:
            out.append(f"## {top}\n\n{head[1]}: {head[2]}\n\n")
            continue
        out.append(f"## {top}\n\n" + (f"{head[1]}: {head[2]}\n\n" if head else ""))
        out.append("| key | type | meaning |\n| --- | --- | --- |\n")
        out += [f"| `{key}` | {kind} | {meaning} |\n" for key, kind, meaning in own if key != top]
        out.append("\n")
    return "".join(out)


def verbs():
    """The names of the program's subcommands."""
    return listed_verbs(output("--help"))


def listed_verbs(text):
    """The first words of the lines below "Subcommands:", up to the next empty one."""
    listed = text.split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.splitlines() if line.strip()]


def commands():
    """What the program says of its subcommands."""
    texts = [("cleft", output("--help"))] + [(f"cleft {verb}", output(verb, "--help")) for verb in verbs()]
    return "\n".join(f"## {name}\n\n```\n{text.rstrip()}\n```\n" for name, text in texts)


def expand(text):
    """Replaces the lines that begin with @ by what they stand for."""
    out = []
    for line in text.splitlines(keepends=True):
        word, _, rest = line.strip().partition(" ")
        if word == "@code":
            out.append(code(rest))
        elif word == "@keys":
            out.append(keys())
        elif word == "@commands":
            out.append(commands())
        elif word.startswith("@"):
            raise Mistake(f"{word} is none of @code, @keys, @commands")
        else:
            out.append(line)
    return "".join(out)
