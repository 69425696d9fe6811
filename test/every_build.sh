#!/bin/sh
# What the tests do by one compiler, by both: Debug and Release builds of g++ and clang give the same
# results to the last digit, of four costs, and costs are the same with and without vectors; calls of
# the documents compile without a warning. It takes about eight minutes of a processor.
#   sh test/every_build.sh MODEL.off
set -eu
export LC_ALL=C
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
[ $# -eq 1 ] || { echo "usage: sh test/every_build.sh MODEL.off" >&2; exit 2; }

for cost in Quadric MemorylessQuadric ThinFeatureQuadric ColorQuadric; do
  echo "$cost"
  sh "$here/debug_and_release.sh" "$1" -std=c++20 "-I$here/../include" -DCOST=$cost -- \
    'g++ -O0' 'g++ -O2 -DNDEBUG' 'clang++ -O0' 'clang++ -O2 -DNDEBUG'
done

for compiler in g++ clang++; do
  echo "$compiler"
  sh "$here/lanes.sh" $compiler -std=c++20 "-I$here/../include"
  sh "$here/documented_calls.sh" "$here/.." $compiler -std=c++20 "-I$here/../include" -fsyntax-only \
    -Wall -Wextra -Wno-unused-local-typedefs -Wdouble-promotion -Werror
done
