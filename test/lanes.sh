#!/bin/sh
# Checks that costs are the same, to the last digit, with and without the vectors that a compiler has.
#   sh lanes.sh COMPILER FLAG...
# Where the processor has a fused multiply-add, compilers take it in different places, so it is
# switched off.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$@" -O0 -ffp-contract=off "$here/lanes.cpp" -o "$folder/vectors"
"$@" -O0 -ffp-contract=off -DQUADRILLE_NO_VECTOR_EXTENSIONS "$here/lanes.cpp" -o "$folder/scalars"
"$folder/vectors" >"$folder/vectors.txt"
"$folder/scalars" >"$folder/scalars.txt"
echo "$(wc -l <"$folder/vectors.txt") lines"
cmp "$folder/vectors.txt" "$folder/scalars.txt"
