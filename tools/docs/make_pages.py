"""make_pages.py FOLDER: writes the pages of the documentation into the folder as HTML."""

import pathlib
import shutil
import subprocess
import sys

import scenes
from markdown import PAGES, Mistake, equations, expand, number_equations

HERE = pathlib.Path(__file__).resolve().parent
# Pages by their names, in the order of the bar at the top; `scenes` is made here. The page `index` leads to all others.
BAR = {"index": "cleft", "start": "First steps", "format": "Scene files", "commands": "Commands", "results": "Results", "troubles": "What goes wrong",
       "known_answers": "Accuracy", "speed": "Speed", "theory": "Theory", "scenes": "Scenes", "program": "In a program"}


def bar():
    links = [f'<li><a href="{name}.html">{title}</a></li>' for name, title in BAR.items()]
    return "<ul>" + "".join(links + ['<li><a href="api/index.html">Libraries</a></li>']) + "</ul>"


def write(out, name, title, text, contents=True):
    """One page."""
    command = ["pandoc", "--from=markdown-smart", "--to=html5", "--mathml", "--standalone", f"--template={HERE / 'template.html'}",
               "--no-highlight", "--wrap=none", f"--metadata=title:{title}", f"--variable=nav:{bar()}", "--output", str(out / f"{name}.html")]
    if contents:
        command.append("--toc")
    done = subprocess.run(command, input=text, text=True, capture_output=True)
    if done.returncode != 0 or done.stderr.strip():
        raise Mistake(f"{name}: pandoc: {done.stderr.strip()}")


def split_title(text):
    """The first line of a page is its title."""
    first, _, rest = text.partition("\n")
    if not first.startswith("# "):
        raise Mistake("a page must begin with its title")
    return first[2:].strip(), rest


def main(folder):
    out = pathlib.Path(folder)
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for file in (HERE / "style.css", *PAGES.glob("*.png")):
        shutil.copyfile(file, out / file.name)
    for file in sorted(PAGES.glob("*.md")):
        try:
            title, text = split_title(file.read_text())
            write(out, file.stem, title, expand(number_equations(text, equations(text))), contents=file.stem != "index")
        except Mistake as mistake:
            raise Mistake(f"{file.name}: {mistake}") from None
    listed = []
    for name in scenes.names():
        title, text = scenes.page(name, out)
        write(out, f"scene_{name}", title, text, contents=False)
        listed.append((name, title))
    write(out, "scenes", "Scenes with known answers", scenes.overview(listed), contents=False)


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except Mistake as mistake:
        sys.exit(f"documentation: {mistake}")
