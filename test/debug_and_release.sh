#!/bin/sh
# Checks that a Debug and a Release build give the same results, to the last digit.
#   sh debug_and_release.sh MODEL.off COMPILER FLAG...
# Where the processor has a fused multiply-add, g++ takes it at -O2 and not at -O0, so it is
# switched off.
set -eu
model=$1
shift
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$@" -ffp-contract=off -O0 "$here/debug_and_release.cpp" -o "$folder/debug"
"$@" -ffp-contract=off -O2 -DNDEBUG "$here/debug_and_release.cpp" -o "$folder/release"
"$folder/debug" "$model" > "$folder/of_debug"
"$folder/release" "$model" > "$folder/of_release"
echo "$(wc -l < "$folder/of_debug") lines compared"
cmp "$folder/of_debug" "$folder/of_release"
