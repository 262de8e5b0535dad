#!/usr/bin/env bash
# The completion scripts as the shells read them: commands, flags and values at the places where a user asks for them.
#   completion.sh PROGRAM WORK_FOLDER
set -u
fastscene=$1 work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
fail() { echo "FAILED: $*" >&2; exit 1; }
for shell in bash zsh fish; do "$fastscene" completion $shell >script.$shell || fail "completion $shell"; done
"$fastscene" completion tcsh 2>/dev/null && fail "tcsh was taken"
touch bedroom.ply

# expect SHELL "typed words" wanted…: the candidates for the last word contain these.
expect() {
  local shell=$1 typed=$2 word; shift 2
  "complete_$shell" "$typed" >got
  for word in "$@"; do grep -qxF -- "$word" got || fail "$shell: after \"$typed\" expected $word, found: $(tr '\n' ' ' <got)"; done
}
# refuse SHELL "typed words" unwanted
refuse() { "complete_$1" "$2" >got; ! grep -qxF -- "$3" got || fail "$1: after \"$2\" there is $3"; }

complete_bash() {
  bash --norc -c '
    source script.bash
    read -ra COMP_WORDS <<<"$1"
    case $1 in *" ") COMP_WORDS+=("") ;; esac
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _fastscene 2>/dev/null
    printf "%s\n" "${COMPREPLY[@]}"' - "$1"
}
complete_fish() { fish --no-config -c "source script.fish; complete -C '$1'" 2>&1 | cut -f 1; }

shells=(bash)
if command -v fish >/dev/null; then shells+=(fish); fi
for shell in "${shells[@]}"; do
  expect $shell "fastscene " make render completion demo
  expect $shell "fastscene re" render
  expect $shell "fastscene depth " train check
  expect $shell "fastscene depth train --da" --data
  expect $shell "fastscene render --o" --of --out
  refuse $shell "fastscene render --o" --quality
  expect $shell "fastscene render --of " splats room
  expect $shell "fastscene render out/bedroom --of r" room
  expect $shell "fastscene render --path t" tour
  expect $shell "fastscene make --quality " draft standard high
  # bash offers files by itself where a script offers nothing.
  [ $shell = bash ] || expect $shell "fastscene render bed" bedroom.ply
  expect $shell "fastscene render --path bed" bedroom.ply
done 2>&1 | { grep . && exit 1; exit 0; } || exit 1

# zsh: the script is read whole, and defines a function for every command.
if command -v zsh >/dev/null; then
  zsh -n script.zsh || fail "zsh cannot read its script"
  zsh -f -c 'autoload -Uz compinit && compinit -u -D && source ./script.zsh &&
    (( $+functions[_fastscene] && $+functions[_fastscene_depth_train] && $+functions[_fastscene_render] )) &&
    [[ $_comps[fastscene] = _fastscene ]]' || fail "zsh does not take its script"
  # Asked as at a prompt: a terminal types "fastscene rend", the tabulator, and a moment later return.
  cat >ask.zsh <<'ASK'
zmodload zsh/zpty
zpty shell 'TERM=dumb zsh -f -i'
until_said() { local line; repeat 100; do zpty -r -t shell line && print -r -- $line; [[ $line = *$1* ]] && return; sleep 0.05; done }
zpty -w shell 'autoload -Uz compinit; compinit -u -D; source ./script.zsh; fastscene() { print GOT $@ }; print REA""DY'
until_said READY
zpty -w -n shell $'fastscene rend\t'
sleep 0.7
zpty -w -n shell $'\n'
until_said GOT
zpty -d shell
ASK
  zsh -f ask.zsh >got 2>&1
  grep -q "GOT render" got || fail "zsh: expected render after rend, found: $(tr -d '\r' <got | tail -5)"
fi
