#!/bin/sh
# Compiles what must not compile, and keeps what the compiler says of it, for compile_fail.sh.
#   sh compile_mistakes.sh SAID COMPILER ARGUMENT...
set -eu
said=$1
shift
case $1 in *clang*) set -- "$@" -ferror-limit=0 ;; esac
if "$@" >"$said" 2>&1; then
  echo "it compiles"
  exit 1
fi
grep -c ' error: ' "$said"
