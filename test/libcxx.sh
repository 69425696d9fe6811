#!/bin/sh
# Checks that a source of meshes, soups and levels compiles with LLVM's standard library; exits with 77
# where the compiler has none. A main that is a function of a namespace need not return anything either.
#   sh libcxx.sh SOURCE COMPILER FLAG...
set -eu
source=$1
shift
compile() { "$@" -stdlib=libc++ -fsyntax-only -Wall -Wextra -Wno-return-type -Werror; }

if ! echo '#include <version>' | compile "$@" -x c++ - 2>/dev/null; then
  echo "skipped: $1 has no libc++"
  exit 77
fi
compile "$@" "$source"
