#!/usr/bin/env python3
"""The command line reference, docs/cli.md, generated from --help.

  tests/docs/cli_reference.py PROGRAM docs/cli.md            fails if the page is out of date
  tests/docs/cli_reference.py PROGRAM docs/cli.md --write    writes the page
"""
import re
import subprocess
import sys
import textwrap

WIDTH = 120
PREFACE = """\
# Command line

This page is generated from `--help` by `tests/docs/cli_reference.py`; a test compares it with the program.

`fastscene COMMAND …`: results go to stdout, everything else to stderr. Exit codes: 0: success; 1: failure; 2: wrong
usage; 128 + signal: stopped by a signal. If a flag is given more than once, the last value is used.
"""
COMMON_HEADING = "Common flags"
COMMON = ("-h,--help", "--threads", "--json", "--progress")


def help_of(program, words):
    done = subprocess.run([program, *words, "--help"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{program} {' '.join(words)} --help: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


class Section:
    """A headed block of help: items (head, description) or lines as they are."""

    def __init__(self, heading):
        self.heading, self.items, self.lines = heading, [], []

    def key(self):
        return (self.heading, tuple(self.items))


def parse(text):
    """-> (introduction, usage, sections, notes)"""
    introduction, usage, sections, notes = [], "", [], []
    section = None
    for line in text.split("\n"):
        if not line.strip():
            continue
        if line.startswith("Usage: "):
            usage = line[len("Usage: "):]
        elif not line.startswith(" "):
            if not usage:
                introduction.append(line)
            elif line.endswith(":") and len(line) < 100:
                section = Section(line[:-1])
                sections.append(section)
            else:
                notes.append(line)
        elif section is None:
            notes.append(line.strip())
        elif section.heading.startswith("Example"):
            section.lines.append(line.strip())
        elif line.startswith("    "):  # a description on its own line
            head, said = section.items[-1]
            section.items[-1] = (head, (said + " " + line.strip()).strip())
        else:
            parts = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            head, said = (parts + [""])[:2]
            if not said and " " in head and not head.startswith("-") and len(line) > 32:
                head, said = head.split(" ", 1)
            # A head that just fills its column is followed by a single space.
            if not said and (wide := re.fullmatch(r"(--\S+ \S+=\S+) (.+)", head)):
                head, said = wide.groups()
            section.items.append((head, said))
    return introduction, usage, sections, notes


def escaped(text):
    """Markdown's own signs in plain text; what stands between backticks stays."""
    parts = text.replace("->", "→").split("`")
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([*_<\[])", r"\\\1", parts[i])
        parts[i] = re.sub(r"docs/([a-z-]+\.md)", r"[docs/\1](\1)", parts[i])
    return "`".join(parts)


def paragraph(text, indent=""):
    return textwrap.fill(text, WIDTH, initial_indent=indent, subsequent_indent="  " if indent else "",
                         break_long_words=False, break_on_hyphens=False)


def item(head, said):
    """`--seed N` (default `0`): what it means."""
    remarks = []
    if head.endswith(" REQUIRED"):
        head = head[:-len(" REQUIRED")]
        remarks.append("required")
    head = re.sub(r" x \d+$", "", head)
    if " ..." in head:
        head = head.replace(" ...", " …")
    elif "=" in head:
        head, default = head.split("=", 1)
        remarks.append(f"default `{default}`")
    name = "`" + head.replace(",--", ", --") + "`"
    remark = f" ({', '.join(remarks)})" if remarks else ""
    return paragraph(f"{name}{remark}: {escaped(said)}", "- ")


def is_common(head):
    return any(head == name or head.startswith(name + " ") or head.startswith(name + "=") for name in COMMON)


def page_of(program):
    seen_settings = {}  # section -> the verb that has it
    out = [PREFACE]

    def verb(words, depth):
        introduction, usage, sections, notes = parse(help_of(program, words))
        name = "fastscene " + " ".join(words)
        out.append(f"{'#' * depth} {name}\n")
        out.append(paragraph(escaped(" ".join(introduction))) + "\n")
        out.append(f"```\n{usage}\n```\n")
        parts, elsewhere = [], {}
        for section in sections:
            if section.heading == "Subcommands":
                parts = [head for head, _ in section.items]
                continue
            if section.heading.startswith("Example"):
                out.append("```\n" + "\n".join(section.lines) + "\n```\n")
                continue
            items = [i for i in section.items if section.heading != "Options" or not is_common(i[0])]
            if not items:
                continue
            if section.heading.startswith("Settings of ") and section.key() in seen_settings:
                elsewhere.setdefault(seen_settings[section.key()], []).append(section.heading.split(" (")[0])
                continue
            seen_settings[section.key()] = name
            if section.heading not in ("Options", "Positionals"):
                out.append(f"**{escaped(section.heading)}**\n")
            out.append("\n".join(item(*i) for i in items) + "\n")
        for where, headings in elsewhere.items():
            names = ", ".join(heading[len("Settings of "):] for heading in headings)
            out.append(paragraph(f"Settings of {names}: see [{where}](#{where.replace(' ', '-')}).") + "\n")
        for note in notes:
            out.append(paragraph(escaped(note)) + "\n")
        for part in parts:
            verb(words + [part], depth + 1)

    _, _, sections, _ = parse(help_of(program, []))
    verbs = next(s.items for s in sections if s.heading == "Subcommands")
    _, _, options, _ = parse(help_of(program, ["make"]))
    common = [i for s in options if s.heading == "Options" for i in s.items if is_common(i[0])]
    overview = [paragraph(f"[{name}](#fastscene-{name}): {escaped(said)}", "- ") for name, said in verbs]
    out.append("\n".join(overview) + "\n")
    out.append(f"## {COMMON_HEADING}\n")
    out.append("\n".join(item(*i) for i in common) + "\n")
    for name, _ in verbs:
        verb([name], 2)
    return "\n".join(out)


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["--write"]):
        sys.exit(__doc__)
    program, path = sys.argv[1:3]
    page = page_of(program)
    if sys.argv[3:]:
        with open(path, "w", encoding="utf-8") as file:
            file.write(page)
        return
    with open(path, encoding="utf-8") as file:
        found = file.read()
    if found == page:
        return
    import difflib
    sys.stdout.writelines(difflib.unified_diff(found.splitlines(True), page.splitlines(True), path, "the program"))
    sys.exit(f"{path} is not what the program says: run tests/docs/cli_reference.py PROGRAM {path} --write")


main()
