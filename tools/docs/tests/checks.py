"""The checks of the documentation find what they are there for."""

import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import check_equations
import check_links
import markdown
import run_commands
import scenes


class Files(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)


class Verbs(unittest.TestCase):
    def test_end_with_the_list(self):
        text = "cleft\n\nSubcommands:\n  run    solves\n  check  looks\n\nExit code 1: wrong, what\n"
        self.assertEqual(markdown.listed_verbs(text), ["run", "check"])


class Links(Files):
    def test_those_that_lead_somewhere_are_fine(self):
        self.write("a.html", '<a href="b.html#here">b</a> <a href="https://www.debian.org/">d</a> <p id="top"><a href="#top">t</a>')
        self.write("b.html", '<h2 id="here">h</h2><img src="p.svg">')
        self.write("p.svg", "<svg/>")
        self.assertEqual(check_links.check(self.folder), (4, []))

    def test_files_anchors_and_addresses_that_there_are_not_are_named(self):
        self.write("a.html", '<a href="c.html">c</a><a href="b.html#there">b</a><img src="p.png"><a href="../x">x</a><a href="https:nowhere">n</a>')
        self.write("b.html", "<p>")
        wrong = check_links.check(self.folder)[1]
        self.assertEqual([line.split(": ", 1)[1] for line in wrong],
                         ["c.html: no such file", "b.html#there: no such anchor", "p.png: no such file",
                          "../x: leads out of the documentation", "https:nowhere: no address"])


class Equations(Files):
    def test_citations_of_missing_equations_are_found(self):
        self.write("a.cpp", "// theory (2.1), (2.2) and (9.9)\n// theory (2.1) to (2.3)\n")
        count, wrong = check_equations.check(self.folder, {"2.1", "2.2", "2.3"})
        self.assertEqual(count, 5)
        self.assertEqual(len(wrong), 1)
        self.assertIn("(9.9)", wrong[0])

    def test_numbers_are_anchors_and_links(self):
        text = markdown.number_equations("By\n\n$$a = b$$ (99.1)\n\nand (99.1), (1.1) and `code (9.9)`.\n", {"99.1"})
        self.assertIn("{.equation #eq-99.1}", text)
        self.assertIn("and [(99.1)](#eq-99.1)", text)
        self.assertIn("[(1.1)](theory.html#eq-1.1)", text)
        self.assertIn("`code (9.9)`", text)

    def test_a_number_twice_or_of_nothing_is_refused(self):
        with self.assertRaises(markdown.Mistake):
            markdown.equations("$$a$$ (1.1)\n\n$$b$$ (1.1)\n")
        with self.assertRaises(markdown.Mistake):
            markdown.number_equations("see (99.9)")


class Pages(unittest.TestCase):
    def test_code_that_there_is_not_is_refused(self):
        with self.assertRaises(markdown.Mistake):
            markdown.expand("@code libs/nothing.cpp\n")
        with self.assertRaises(markdown.Mistake):
            markdown.expand("@cod CMakeLists.txt\n")

    def test_a_scene_begins_with_what_it_is(self):
        self.assertEqual(scenes.leading_comment("# One\n# two.\n\n# three\ntitle = 1\n"), "One\ntwo.")
        self.assertIn("through_crack", [test for test, _ in scenes.held_against("through_crack")])


class Readme(unittest.TestCase):
    TEXT = (markdown.ROOT / "README.md").read_text()

    def test_is_short(self):
        lines = self.TEXT.splitlines()
        self.assertLessEqual(len(lines), 150)
        self.assertLessEqual(max(map(len, lines)), 120)

    def test_shows_the_scene_that_its_commands_run(self):
        self.assertIn(f"```toml\n{(markdown.PAGES / 'slide.toml').read_text()}```\n", self.TEXT)

    def test_links_lead_to_files(self):
        links = re.findall(r"\]\(([\w./-]+)\)", self.TEXT)
        self.assertGreater(len(links), 0)
        self.assertEqual([link for link in links if not (markdown.ROOT / link).is_file()], [])


class Texts(unittest.TestCase):
    """README.md, the READMEs of the folders, and the pages."""
    FILES = [markdown.ROOT / "README.md", *markdown.PAGES.glob("*.md"),
             *(file for folder in ("libs", "verification") for file in (markdown.ROOT / folder).rglob("README.md"))]
    PATH = re.compile(r"`((?:tools|libs|verification|third_party_cmake)/[\w./-]+)`")

    def test_name_files_that_there_are(self):
        named = [(file.relative_to(markdown.ROOT), path) for file in self.FILES for path in self.PATH.findall(file.read_text())]
        self.assertGreater(len(named), 50)
        self.assertEqual([(str(file), path) for file, path in named if not (markdown.ROOT / path).exists()], [])


class Libraries(unittest.TestCase):
    NAMES = re.search(r"set\(CLEFT_LIBRARIES\s+([^)]*)\)", (markdown.ROOT / "third_party_cmake/CleftArrows.cmake").read_text())[1].split()

    def test_are_listed_lowest_first(self):
        listed = re.findall(r"^\| `(\w+)` \|", (markdown.ROOT / "tools/docs/libraries.md").read_text(), re.MULTILINE)
        self.assertEqual(listed, self.NAMES)

    def test_have_their_headers_in_the_reference(self):
        stripped = re.findall(r"libs/(\w+)/include", (markdown.ROOT / "tools/docs/Doxyfile").read_text())
        self.assertEqual(stripped, self.NAMES)

    def test_say_on_half_a_page_what_may_not_go_in(self):
        for name in self.NAMES:
            with self.subTest(name):
                text = (markdown.ROOT / "libs" / name / "README.md").read_text()
                self.assertTrue(text.startswith(f"# {name}\n"))
                self.assertLessEqual(len(text.splitlines()), 25)
                self.assertIn("may not go in", text.lower())


class Index(unittest.TestCase):
    def test_leads_to_every_page(self):
        text = (markdown.PAGES / "index.md").read_text()
        lost = [page.stem for page in markdown.PAGES.glob("*.md") if page.stem != "index" and f"({page.stem}.html)" not in text]
        self.assertEqual(lost, [])


class Commands(unittest.TestCase):
    PAGE = "```sh\ntools/a.sh x  # one\nbuild/release/bin/cleft run \\\n  --set 'a=[1,2]'   # two\ncd nowhere\n```\n\n```\ntools/b.sh\n```\n"

    def test_are_those_of_the_shell_blocks(self):
        self.assertEqual(run_commands.commands_in(self.PAGE), ["tools/a.sh x", "build/release/bin/cleft run --set 'a=[1,2]'"])

    def test_a_skipped_one_that_nobody_gives_any_more_is_named(self):
        skipped = [{"command": "tools/a.sh x", "reason": "long"}, {"command": "tools/c.sh", "reason": "gone"}]
        self.assertEqual(run_commands.stale(skipped, ["tools/a.sh x"]), ["tools/c.sh"])


if __name__ == "__main__":
    unittest.main()
