# Completion of the program quadrille, for bash with the package bash-completion. Options, and the files
# and words that they take, are read from `quadrille --help`.
_quadrille() {
  local cur prev words cword help value
  _init_completion || return
  help=$("$1" --help 2>/dev/null)
  value=$(sed -n -E "s/^  (-[^ ]+,)?$prev(,[^ ]+)? ([^ ]+)( .*)?$/\\3/p" <<<"$help")
  case $prev:$value in
    --*:FILE.*) _filedir "${value#FILE.}" ;;
    --*:FOLDER) _filedir -d ;;
    --*:[!\[]*) mapfile -t COMPREPLY < <(compgen -W "$(tr '|' '\n' <<<"$value" | grep '^[a-z]')" -- "$cur") ;;
    *)
      if [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(grep -o -E '^  -[^ ]+' <<<"$help" | tr -d ' ' | tr ',' '\n')" -- "$cur")
      else
        _filedir '@(off|obj|ply|stl|ts|gltf|glb|html)'
      fi
      ;;
  esac
} && complete -F _quadrille quadrille
