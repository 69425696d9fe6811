#!/bin/sh
# Checks that builds of debug_and_release.cpp give the same results, to the last digit.
#   sh debug_and_release.sh MODEL.off FLAG... -DCOST=Quadric -- 'COMPILER OPTION...'...
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

for build; do
  # shellcheck disable=SC2086
  $build $flags -ffp-contract=off "$here/debug_and_release.cpp" -o "$folder/program"
  "$folder/program" "$model" >"$folder/results"
  echo "$build: $(wc -l <"$folder/results") lines"
  [ -e "$folder/first" ] || cp "$folder/results" "$folder/first"
  cmp "$folder/first" "$folder/results"
done
