#!/usr/bin/env python3
"""Builds the site of docs/ and checks the pages as their readers meet them.

  tests/docs/check_site.py ROOT FOLDER      ROOT: the checkout; FOLDER: scratch, the site goes into FOLDER/site

Fails when mkdocs warns, a link or an anchor leads nowhere, the search misses a page, a line is longer than 120 columns
(rows of tables and lines with an address cannot be broken), or a page outside docs/decisions names a commit. Exit code
77: no mkdocs here.
"""
import html.parser
import json
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

MAX_COLUMNS = 120
SKIPPED = 77
# At least seven hexadecimal digits, a letter and a digit among them: what git prints. Larger hashes are of files.
COMMIT = re.compile(r"(?<![\w./-])(?=[0-9a-f]*[a-f])(?=[0-9a-f]*[0-9])[0-9a-f]{7,40}(?![\w-])")
# Pages of the checkout that are no part of the site.
LOOSE_PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]


class Page(html.parser.HTMLParser):
    """The anchors of a page, and what it refers to."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.references = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            if name in ("href", "src") and value:
                self.references.append(value)


def build(root, folder):
    done = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--config-file", str(root / "mkdocs.yml"),
                           "--site-dir", str(folder)], capture_output=True, text=True)
    return [] if done.returncode == 0 else ["mkdocs build --strict:\n" + done.stdout + done.stderr]


def broken_links(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    for path, page in sorted(pages.items()):
        for reference in page.references:
            url = urllib.parse.urlsplit(reference)
            if url.scheme or url.netloc or path.name == "404.html":
                continue
            target = path if not url.path else (path.parent / urllib.parse.unquote(url.path)).resolve()
            if target.is_dir():
                target = target / "index.html"
            where = path.relative_to(site)
            if not target.exists():
                yield f"{where}: {reference} leads nowhere"
            elif url.fragment and target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors:
                yield f"{where}: {reference}: no such anchor"


def unsearchable_pages(site):
    with open(site / "search" / "search_index.json", encoding="utf-8") as file:
        indexed = {entry["location"].split("#")[0] for entry in json.load(file)["docs"]}
    for path in sorted(site.rglob("index.html")):
        location = "".join(part + "/" for part in path.parent.relative_to(site).parts)
        if location not in indexed:
            yield f"{path.relative_to(site)}: the search does not find this page"


def broken_links_of_loose_pages(root):
    for name in LOOSE_PAGES:
        for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", (root / name).read_text(encoding="utf-8")):
            if not re.match(r"\w+:", target) and not (root / target).exists():
                yield f"{name}: {target} leads nowhere"


def long_lines_and_commits(root):
    pages = sorted((root / "docs").rglob("*.md")) + [root / name for name in LOOSE_PAGES]
    for path in pages:
        where = path.relative_to(root)
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            cannot_be_broken = line.lstrip().startswith("|") or "://" in line
            if len(line) > MAX_COLUMNS and not cannot_be_broken:
                yield f"{where}:{number}: {len(line)} columns, expected at most {MAX_COLUMNS}"
            if "decisions" not in where.parts and (commit := COMMIT.search(line)):
                yield f"{where}:{number}: names a commit, {commit.group()}; history belongs to git or docs/decisions"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    root, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "site"
    faults = list(long_lines_and_commits(root)) + list(broken_links_of_loose_pages(root))
    has_mkdocs = shutil.which("mkdocs") is not None
    if has_mkdocs:
        shutil.rmtree(folder, ignore_errors=True)
        faults += build(root, folder) or [*broken_links(folder), *unsearchable_pages(folder)]
    if faults:
        sys.exit("\n".join(faults))
    if not has_mkdocs:
        print("no mkdocs on PATH: the site was not built (apt-get install mkdocs)")
        sys.exit(SKIPPED)


main()
