# Completion of `fastscene` for bash: verbs and flags, as --help names them.
_fastscene() {
  local current=${COMP_WORDS[COMP_CWORD]} words=() word help
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in [a-z]*) words+=("$word") ;; *) break ;; esac
  done
  help=$("${COMP_WORDS[0]}" "${words[@]:0:2}" --help 2>/dev/null || "${COMP_WORDS[0]}" "${words[@]:0:1}" --help 2>/dev/null)
  case $current in
    -*) mapfile -t COMPREPLY < <(compgen -W "$(grep -oE '^  -[^ =]+' <<<"$help" | tr ',' ' ')" -- "$current") ;;
    *)
      local verbs
      verbs=$(awk '/^Subcommands:/ {on = 1; next} /^[^ ]/ {on = 0} on && /^  [a-z]/ {print $1}' <<<"$help")
      mapfile -t COMPREPLY < <(compgen -W "$verbs" -- "$current")
      ;;
  esac
}
complete -o default -F _fastscene fastscene
