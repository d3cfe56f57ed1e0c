"""The pages of the scenes of verification/: what a scene is, its picture from a run of it, what it is held against, and its text."""

import re
import shutil
import subprocess
import tomllib

from markdown import PAGES, PROGRAM, ROOT, Mistake

SCENES = ROOT / "verification/scenes"
RUNS = ROOT / "build/docs/runs"


def leading_comment(text):
    """The comment that a scene begins with, its lines joined."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("#").strip())
    return "\n".join(lines)


def held_against(name):
    """The rows of pages/known_answers.md of the tests that solve the scene; those of verification/hard have scenes of their own."""
    table = re.findall(r"^\| `(\w+)` \| (.+) \|$", (PAGES / "known_answers.md").read_text(), re.MULTILINE)
    rows = []
    for test, meaning in table:
        source = ROOT / f"verification/tests/{test}.cpp"
        if source.is_file() and not test.startswith("hard_") and f'"{name}"' in source.read_text():
            rows.append((test, meaning))
    return rows


def run(name):
    """Solves the scene into build/docs/runs, unless what lies there was made of the same scene by the same program."""
    scene, folder = SCENES / f"{name}.toml", RUNS / name
    stamp = folder / "solved"
    newest = max(scene.stat().st_mtime, (ROOT / PROGRAM).stat().st_mtime)
    if not (stamp.exists() and stamp.stat().st_mtime >= newest):
        for arguments in (["run", str(scene), "-o", str(folder)], ["report", str(folder)]):
            done = subprocess.run([PROGRAM, *arguments], cwd=ROOT, capture_output=True, text=True)
            if done.returncode != 0:
                raise Mistake(f"cleft {' '.join(arguments)}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        stamp.touch()
    return folder / "report"


def pictures(name, report, out):
    """Copies the drawing of the mesh at the last output, and that of the vertical reaction; the names of the copies."""
    meshes = sorted(report.glob("stress_yy_*.svg"))
    if not meshes:
        raise Mistake(f"{report} has no drawing of the mesh")
    wanted = {"mesh": meshes[-1], "reaction": report / "reaction_y.svg"}
    copied = {}
    for kind, file in wanted.items():
        if file.is_file():
            copied[kind] = f"scene_{name}_{kind}.svg"
            shutil.copyfile(file, out / copied[kind])
    return copied


def page(name, out):
    """Title and Markdown of a scene's page; its pictures go to the folder `out`."""
    text = (SCENES / f"{name}.toml").read_text()
    title = tomllib.loads(text)["title"]
    drawn = pictures(name, run(name), out)
    command = f"{PROGRAM} run verification/scenes/{name}.toml -o results/{name}"
    parts = [leading_comment(text), f"\n```\n{command}\n{PROGRAM} report results/{name}\n```\n",
             f"![At full load, coloured by the vertical stress]({drawn['mesh']})\n"]
    if "reaction" in drawn:
        parts.append(f"![Vertical reactions over the load]({drawn['reaction']})\n")
    rows = held_against(name)
    if rows:
        parts.append("## Held against\n\n| test | against |\n| --- | --- |\n"
                     + "".join(f"| `{test}` | {meaning} |\n" for test, meaning in rows)
                     + "\nThe numbers: `verification/run.sh`.\n")
    parts.append(f"## The scene\n\n```toml\n{text.rstrip()}\n```\n")
    return title, "\n".join(parts)


def names():
    """All scenes, by name."""
    return sorted(file.stem for file in SCENES.glob("*.toml"))


def overview(pages):
    """The page that lists the scenes, from their names and titles."""
    return "\n".join(["Scenes with known answers, as anybody may run them. `verification/run.sh` solves them and compares.\n",
                      "| scene | |\n| --- | --- |"] + [f"| [{name}](scene_{name}.html) | {title} |" for name, title in pages]) + "\n"
