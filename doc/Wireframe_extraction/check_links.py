#!/usr/bin/env python3
"""Checks that every link, anchor and picture of a folder of HTML pages is there, and looks at nothing outside of it."""

import pathlib
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """What a page refers to, with the lines, and what others can refer to in it."""

    def __init__(self, path):
        super().__init__()
        self.references, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        for key in ("href", "src"):
            if attributes.get(key):
                self.references.append((attributes[key], self.getpos()[0]))
        for key in ("id", "name"):
            if attributes.get(key) and (key == "id" or tag == "a"):
                self.anchors.add(attributes[key])


def faults(folder):
    """Yields a line for each reference that leads nowhere."""
    pages = {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for reference, line in page.references:
            parts = urlsplit(reference)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            where = f"{path.relative_to(folder.resolve())}:{line}"
            if not target.is_file():
                yield f"{where}: there is no file {reference}"
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                yield f"{where}: there is no anchor {reference}"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_links.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    if not (folder / "index.html").is_file():
        sys.exit(f"check_links.py: {folder}: there is no index.html; build the target doc first")
    found = list(faults(folder))
    for fault in found:
        print(f"check_links.py: {fault}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
