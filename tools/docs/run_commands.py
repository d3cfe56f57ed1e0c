"""Runs the commands that README.md and the pages tell their readers to run, in a scratch folder, and fails where one of them does.

Those that take long or are run by tools/test.sh anyway are in skipped_commands.toml, each with its reason and, where others need what it
leaves, a shorter one to run instead. An entry of a command that nobody gives any more is a mistake, too."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

from markdown import PAGES, ROOT

BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
OURS = ("build/release/bin/cleft ", "tools/", "verification/")
SKIPPED = pathlib.Path(__file__).resolve().parent / "skipped_commands.toml"
SCRATCH = ROOT / "build/docs/commands"


def without_comment(line):
    """A line without what follows a # outside of quotes."""
    quote = ""
    for at, sign in enumerate(line):
        if sign == quote:
            quote = ""
        elif not quote and sign in "'\"":
            quote = sign
        elif not quote and sign == "#" and (at == 0 or line[at - 1].isspace()):
            return line[:at]
    return line


def commands_in(text):
    """The commands of a page: the lines of its blocks of shell, joined where a backslash says so."""
    out = []
    for block in BLOCK.findall(text):
        joined = re.sub(r"\s*\\\n\s*", " ", block)
        out += [line for line in (without_comment(line).strip() for line in joined.splitlines()) if line.startswith(OURS)]
    return out


def stale(skipped, commands):
    """The skipped commands that are not among those given."""
    return [entry["command"] for entry in skipped if entry["command"] not in commands]


def scratch_folder():
    """An empty folder that looks like the root of the project, but for results."""
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    for name in ("build", "tools", "verification", "libs"):
        (SCRATCH / name).symlink_to(ROOT / name)


def run(command):
    """(seconds, exit code, output)"""
    start = time.monotonic()
    done = subprocess.run(["bash", "-c", command], cwd=SCRATCH, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=os.environ | {"OPENBLAS_NUM_THREADS": "1"})
    return time.monotonic() - start, done.returncode, done.stdout


def main():
    pages = [ROOT / "README.md", *sorted(PAGES.glob("*.md"))]
    given = [(page, command) for page in pages for command in commands_in(page.read_text())]
    skipped = tomllib.loads(SKIPPED.read_text())["skip"]
    wrong = [f"{SKIPPED.name}: nobody gives `{command}`" for command in stale(skipped, [command for _, command in given])]
    instead = {entry["command"]: entry.get("instead") for entry in skipped}
    scratch_folder()
    done, total = set(), 0.0
    for page, command in given:
        todo = instead.get(command) if command in instead else command
        if todo is None or todo in done:
            continue
        done.add(todo)
        seconds, code, output = run(todo)
        total += seconds
        print(f"{seconds:6.1f} s  {todo}", flush=True)
        if code != 0:
            wrong.append(f"{page.name}: exit code {code}: {todo}\n{output}")
    print(f"{len(done)} commands in {total:.0f} s, {len(skipped)} skipped")
    if wrong or not done:
        sys.exit("\n".join(wrong) or "no commands")


if __name__ == "__main__":
    main()
