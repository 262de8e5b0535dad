#!/usr/bin/env bash
# Manual pages out of what the program says under --help.     man.sh PROGRAM FOLDER
# Writes FOLDER/fastscene.1 and a page a verb, FOLDER/fastscene-make.1 …, with the verb's own verbs as sections.
set -euo pipefail
[ $# = 2 ] || { echo "usage: man.sh PROGRAM FOLDER" >&2; exit 2; }
program=$1 folder=$2
mkdir -p "$folder"
version=$("$program" --version | awk '{print $NF}')

# The verbs that a help text names, one a line.
verbs() { awk '/^Subcommands:/ {on = 1; next} /^[^ ]/ {on = 0} on && /^  [a-z]/ {print $1}'; }

# Help to troff: the line before "Usage:" says what it is; "Heading:" begins a section; "  flag   text" is an item.
body() {
  awk '
    function safe(s) { gsub(/\\/, "\\e", s); gsub(/-/, "\\-", s); sub(/^[.\x27]/, "\\\\\\&&", s); return s }
    !usage && /^Usage: / { usage = 1; print ".PP\n.B " safe(substr($0, 8)); next }
    !usage && NF { print safe($0); next }
    /^[^ ].*:$/ { print ".SS " safe(substr($0, 1, length($0) - 1)); example = /^Example/; next }
    example && NF { sub(/^ +/, ""); print ".PP\n.nf\n" safe($0) "\n.fi"; next }
    /^    / { sub(/^ +/, ""); print safe($0); next }
    /^  [^ ]/ {
      sub(/^ +/, "")
      at = match($0, /  +/)
      head = at ? substr($0, 1, at - 1) : $0
      print ".TP\n.B " safe(head)
      if (at) print safe(substr($0, at + RLENGTH))
      next
    }
    NF { print ".PP\n" safe($0) }'
}

# page NAME VERB…
page() {
  local name=$1; shift
  local help first sub
  help=$("$program" "$@" --help)
  first=$(head -n 1 <<<"$help")
  {
    printf '.TH %s 1 "" "fastscene %s" "User Commands"\n' "${name^^}" "$version"
    printf '.SH NAME\n%s \\- %s\n.SH DESCRIPTION\n' "${name//-/\\-}" "${first%.}"
    body <<<"$help"
    if [ $# -gt 0 ]; then
      for sub in $(verbs <<<"$help"); do
        printf '.SH %s\n' "$* $sub"
        "$program" "$@" "$sub" --help | body
      done
    else
      printf '.SH EXIT STATUS\n0: done; 1: failed; 2: wrong usage; 128 + signal: stopped by a signal.\n'
    fi
  } >"$folder/$name.1"
}

page fastscene
for verb in $("$program" --help | verbs); do page "fastscene-$verb" "$verb"; done
