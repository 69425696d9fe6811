# Completion of the program quadrille, for bash with the package bash-completion. Options and the
# words that they take are read from `quadrille --help`.
_quadrille() {
  local cur prev words cword
  _init_completion || return
  local choices
  choices=$("$1" --help 2>/dev/null |
    sed -n -E "s/^ +$prev ([a-z-]+(\\|[a-z-]+)+)( .*)?$/\\1/p" | tr "|" " ")
  case $prev in
    --record | --from) _filedir qlv ;;
    --report | --progress) _filedir json ;;
    --out-of-core) _filedir -d ;;
    --step) mapfile -t COMPREPLY < <(compgen -W 'cut close' -- "$cur") ;;
    --faces | --keep | --ratio | --vertices | --error | --levels | --crease | --lines | --normal-noise | --noise | --importance | --labels | --pairs | --cut-handles | --threads | --memory) ;;
    --boundary) mapfile -t COMPREPLY < <(compgen -W lock -- "$cur") ;;
    *)
      if [[ $prev == --* && -n $choices ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$cur")
      elif [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_parse_help "$1")" -- "$cur")
      else
        _filedir '@(off|obj|ply|stl|ts|gltf|glb|html)'
      fi
      ;;
  esac
} && complete -F _quadrille quadrille
