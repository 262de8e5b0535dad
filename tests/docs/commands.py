#!/usr/bin/env python3
"""Every fastscene command that the docs show exists: its verb, and each of its flags.

  tests/docs/commands.py PROGRAM ROOT

Reads the fenced blocks of docs/, README.md, CONTRIBUTING.md and the model cards and holds them against --help.
"""
import functools
import pathlib
import re
import shlex
import subprocess
import sys

PROGRAM_NAMES = ("fastscene", "./fastscene", "build/release/bin/fastscene", "./build/release/bin/fastscene")
# What ends a command within a line of shell.
ENDS = {"&&", "||", ";", "|", "&", ">", "done;", "done"}


@functools.cache
def help_of(program, words):
    done = subprocess.run([program, *words, "--help"], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None


def verbs_of(program, words):
    said = help_of(program, words) or ""
    listed = said.split("Subcommands:\n", 1)[1].split("\n\n", 1)[0] if "Subcommands:\n" in said else ""
    return set(re.findall(r"^  ([a-z][\w-]*) ", listed, re.M))


def flags_of(program, words):
    """The flags of a verb and of what it is a part of; those that may be written short."""
    flags = {"--help"}
    for end in range(len(words) + 1):
        said = help_of(program, words[:end]) or ""
        for names in re.findall(r"^  (-[^\s]*)", said, re.M):
            flags.update(name.split("=")[0] for name in names.split(","))
        if short := re.search(r"^(--[a-z]+-) may be left away", said, re.M):
            flags |= {"--" + flag[len(short[1]):] for flag in flags if flag.startswith(short[1])}
    return flags


def commands_of(text):
    """(line number, words) of each command in the fenced blocks. Blocks of Python hold no commands."""
    fenced, python, carried = False, False, ""
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            python = fenced and line.strip() == "```python"
            continue
        if not fenced or python or line.startswith("Usage"):
            continue
        line = carried + line
        carried = line[:-1] if line.endswith("\\") else ""
        if carried:
            continue
        if re.match(r"\s*fastscene .*(\[OPTIONS\]|SUBCOMMAND)", line):
            continue  # a usage line of docs/cli.md
        try:
            words = shlex.split(line.replace("`", ""), comments=True)
        except ValueError:
            words = line.split("#")[0].split()
        # bash -c '… fastscene …'
        words = [inner for word in words for inner in (word.split() if "fastscene " in word else [word])]
        is_path = words[:1] in (["git"], ["cd"])
        if not is_path:
            yield from ((number, words[i + 1:]) for i, word in enumerate(words) if word in PROGRAM_NAMES)


def faults_of(program, words):
    path = ()
    for word in words:
        if word not in verbs_of(program, path):
            break
        path += (word,)
    if not path:
        if words and words[0] in ("--version", "--help"):
            return
        yield f"fastscene {' '.join(words[:1])}: no such verb"
        return
    known = flags_of(program, path)
    for word in words[len(path):]:
        if word in ENDS or word.endswith(";"):
            return
        flag = word.split("=")[0]
        if re.match(r"--?[a-zA-Z]", flag) and flag not in known:
            yield f"fastscene {' '.join(path)}: no flag {flag}"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    pages = [root / "README.md", root / "CONTRIBUTING.md"]
    pages += sorted((root / "docs").rglob("*.md")) + sorted((root / "models").glob("*.md"))
    faults, count = [], 0
    for path in pages:
        for number, words in commands_of(path.read_text(encoding="utf-8")):
            count += 1
            faults += [f"{path.relative_to(root)}:{number}: {fault}" for fault in faults_of(program, words)]
    if faults:
        sys.exit("\n".join(faults))
    if count == 0:
        sys.exit("no command found in the docs: is this the root of the checkout?")
    print(f"{count} commands, all of them known")


main()
