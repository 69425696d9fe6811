#!/bin/sh
# Checks that what a compiler says first, where it is told an older standard, is what Quadrille needs.
#   sh older_standard.sh COMPILER FLAG...
set -u
for header in simplify threshold_pairs distance concepts; do
  said=$(printf '#include <quadrille/%s.h>\n' "$header" | "$@" -std=c++17 -Wfatal-errors -fsyntax-only -x c++ - 2>&1)
  first=$(printf '%s\n' "$said" | grep -m 1 'error: ')
  echo "$header.h: $first"
  case $first in
    *'Quadrille needs C++20: '*) ;;
    *) exit 1 ;;
  esac
done
