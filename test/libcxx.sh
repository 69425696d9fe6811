#!/bin/sh
# Checks that programs of meshes, soups and levels compile with LLVM's standard library; exits with 77
# where the compiler has none.
#   sh libcxx.sh REPOSITORY COMPILER FLAG...
set -eu
repository=$1
shift
compile() { "$@" -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror; }

if ! echo '#include <version>' | compile "$@" -x c++ - 2>/dev/null; then
  echo "skipped: $1 has no libc++"
  exit 77
fi
for program in test/measured_surfaces examples/first examples/levels examples/compiled; do
  compile "$@" "$repository/$program.cpp"
done
