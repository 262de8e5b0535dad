#!/usr/bin/env python3
"""The page of benchmarks, docs/benchmarks.md, made from docs/benchmarks.json.

  tests/docs/benchmarks.py docs/benchmarks.json docs/benchmarks.md            fails when they differ
  tests/docs/benchmarks.py docs/benchmarks.json docs/benchmarks.md --write    writes the page

The file: "machines", a name and a sentence for each; "sections", each with "title", "text" (paragraphs) and "tables". A
table has "title", "command" (lines), "machine", "columns", "rows" and "notes". A column that begins with ">" is aligned
to the right. A text is a string or a list of strings that are joined. Every table needs a command and a machine.
"""
import json
import sys
import textwrap

WIDTH = 120
PREFACE = [
    "This page is made from `docs/benchmarks.json` by `tests/docs/benchmarks.py`. Each table has the command that makes"
    " it and the machine that it was seen on. CPU seconds are user and system time of the whole process; the machines"
    " were shared with other work, so times are upper bounds. The release preset, g++ 12.2.",
]


def joined(text):
    return text if isinstance(text, str) else " ".join(text)


def wrapped(text, first="", rest=""):
    return textwrap.fill(joined(text), WIDTH, initial_indent=first, subsequent_indent=rest, break_long_words=False,
                         break_on_hyphens=False)


def table_of(table, machines):
    title = table["title"]
    for key in ("command", "machine", "columns", "rows"):
        if not table.get(key):
            sys.exit(f"table \"{title}\": expected \"{key}\", found none")
    if table["machine"] not in machines:
        sys.exit(f"table \"{title}\": expected a machine of {', '.join(machines)}, found {table['machine']}")
    out = [f"### {title}", "```\n" + "\n".join(table["command"]) + "\n```"]
    out.append(wrapped(f"Machine: {machines[table['machine']]}."))
    names = [name.lstrip(">") for name in table["columns"]]
    rules = ["--:" if name.startswith(">") else "---" for name in table["columns"]]
    lines = ["| " + " | ".join(names) + " |", "|" + "|".join(rules) + "|"]
    for row in table["rows"]:
        if len(row) != len(names):
            sys.exit(f"table \"{title}\": expected {len(names)} cells, found {len(row)}: {row}")
        lines.append("| " + " | ".join(str(cell) for cell in row) + " |")
    out.append("\n".join(lines))
    if table.get("notes"):
        out.append("\n".join(wrapped(note, "- ", "  ") for note in table["notes"]))
    return out


def page_of(data):
    out = ["# Benchmarks"] + [wrapped(text) for text in PREFACE]
    for section in data["sections"]:
        out.append(f"## {section['title']}")
        out += [wrapped(text) for text in section.get("text", [])]
        for table in section.get("tables", []):
            out += table_of(table, data["machines"])
    return "\n\n".join(out) + "\n"


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["--write"]):
        sys.exit(__doc__)
    source, path = sys.argv[1:3]
    with open(source, encoding="utf-8") as file:
        page = page_of(json.load(file))
    if sys.argv[3:]:
        with open(path, "w", encoding="utf-8") as file:
            file.write(page)
        return
    with open(path, encoding="utf-8") as file:
        if file.read() == page:
            return
    sys.exit(f"{path} is not made from {source}: run tests/docs/benchmarks.py {source} {path} --write")


main()
