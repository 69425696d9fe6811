#!/bin/bash
# Completes words as a shell does.
#
#   completion.sh COMPLETION PROGRAM
completion=$1
shell_functions=/usr/share/bash-completion/bash_completion
[ -e $shell_functions ] || { echo "skipped: no bash-completion"; exit 77; }
PATH=$(dirname "$2"):$PATH
# shellcheck disable=SC1090,SC1091
. $shell_functions && . "$completion" || exit 1

failures=0
expect() { # line, a word among the completions; or - and a word that is not
  read -ra COMP_WORDS <<<"$1"
  [[ $1 != *' ' ]] || COMP_WORDS+=("")
  COMP_LINE=$1 COMP_POINT=${#1} COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
  _quadrille quadrille "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  if [[ " ${COMPREPLY[*]} " != *" $2 "* ]]; then
    failures=$((failures + 1))
    echo "'$1' is not completed to $2 but to: ${COMPREPLY[*]}"
  fi
}

expect 'quadrille --fa' --faces
expect 'quadrille --ke' --keep-partial
expect 'quadrille --cost me' memoryless
expect 'quadrille --cost ' thin-features
expect 'quadrille --order ' relaxed
expect 'quadrille --seams ' priced
expect 'quadrille --boundary l' lock
expect 'quadrille --format ' glb
expect 'quadrille --out-' --out-of-core
expect 'quadrille --step c' close
expect 'quadrille --boundary-weight l' lock
expect 'quadrille --weighting ' by-squared-area
expect 'quadrille --pairs-c' --pairs-closer-than
cd "$(mktemp -d)" || exit 1
touch in.ply in.txt run.qlv
expect 'quadrille in' in.ply
[[ " ${COMPREPLY[*]} " != *in.txt* ]] || { failures=$((failures + 1)); echo "a text is no mesh"; }
expect 'quadrille --from r' run.qlv
expect 'quadrille --weld in' in.ply
expect 'quadrille --error ' ''
[ ${#COMPREPLY[@]} -eq 0 ] || { failures=$((failures + 1)); echo "a distance is completed"; }
rm -f in.ply in.txt run.qlv && rmdir "$PWD"

echo "$failures failures"
[ $failures -eq 0 ]
