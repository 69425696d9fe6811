#!/bin/sh
# Checks that a Debug build of the first compiler and Release builds of all give the same results, to
# the last digit.
#   sh debug_and_release.sh MODEL.off FLAG... -DCOST=Quadric -- COMPILER...
# Where the processor has a fused multiply-add, compilers take it in different places, so it is
# switched off.
set -eu
model=$1
shift
flags=
while [ "$1" != -- ]; do
  flags="$flags $1"
  shift
done
shift
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for compiler; do
  for build in -O0 '-O2 -DNDEBUG'; do
    [ "$build" != -O0 ] || [ ! -e "$folder/first" ] || continue
    # shellcheck disable=SC2086
    "$compiler" $flags -ffp-contract=off $build "$here/debug_and_release.cpp" -o "$folder/program"
    "$folder/program" "$model" >"$folder/results"
    echo "$compiler $build: $(wc -l <"$folder/results") lines"
    [ -e "$folder/first" ] || cp "$folder/results" "$folder/first"
    cmp "$folder/first" "$folder/results"
  done
done
