#!/bin/sh
# Checks that Debug and Release builds of g++ and clang give the same results to the last digit, of
# four costs. It takes about six minutes of a processor.
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
