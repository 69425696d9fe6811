#!/bin/sh
# Simplifies random surfaces, and some that are hard, with filters of shapes, edges and degrees and with limits of the
# distance, and fails if a face of a level is worse than its filter says or than it was, or a level is further away than
# it tells. Equal seeds are equal surfaces. Takes a minute to compile and an eighth of a second a seed.
#   sh test/promises/filters.sh FIRST_SEED COUNT [MODEL.off...]
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/promises
mkdir -p "$folder"
${CXX:-g++} -std=c++20 -O1 "-I$here/../../include" "-I$here/../support" "$here/filters.cpp" -o "$folder/filters" \
  -lgmp -lmpfr
"$folder/filters" "$@"
