"""check_links.py FOLDER: fails where a page below the folder refers to a file or an anchor that there is not.

Addresses outside the folder are not followed, as a build may have no network; they must be https addresses."""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """Where a page leads to, and the anchors that it has."""

    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(file.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value is not None:
                self.links.append(value)
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)


def fault(link, file, root, pages):
    """What is wrong with a link, or None."""
    parts = urllib.parse.urlsplit(link)
    if parts.scheme or parts.netloc:
        fine = parts.scheme in ("https", "http") and "." in parts.netloc or parts.scheme == "data"
        return None if fine else "no address"
    target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
    if root not in target.parents:
        return "leads out of the documentation"
    if not target.is_file():
        return "no such file"
    if parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
        return "no such anchor"
    return None


def check(folder):
    """(how many links, what is wrong)"""
    root = pathlib.Path(folder).resolve()
    pages = {file: Page(file) for file in sorted(root.rglob("*.html"))}
    links, wrong = 0, []
    for file, page in pages.items():
        for link in page.links:
            if link.startswith("javascript:"):
                continue
            links += 1
            if what := fault(link, file, root, pages):
                wrong.append(f"{file.relative_to(root)}: {link}: {what}")
    return links, wrong


def main(folder):
    links, wrong = check(folder)
    if links == 0:
        wrong.append(f"no links below {folder}")
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{links} links lead somewhere")


if __name__ == "__main__":
    main(sys.argv[1])
