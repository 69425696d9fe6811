#!/bin/sh
# Checks that the documents' calls and the headers beside them compile with LLVM's standard library;
# exits with 77 where the compiler has none.
#   sh libcxx.sh REPOSITORY COMPILER FLAG...
set -eu
repository=$1
shift
compile() { "$@" -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror; }

if ! echo '#include <version>' | compile "$@" -x c++ - 2>/dev/null; then
  echo "skipped: $1 has no libc++"
  exit 77
fi
sh "$repository/test/documented_calls.sh" "$repository" \
  "$@" -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror
compile "$@" "$repository/test/measured_surfaces.cpp"
