#!/bin/sh
# Damages right results of random solids, a vertex moved, a face turned, parts swapped, a handle or a cavity moved, and
# fails if <quadrille/verify.h> does not find it by the claim that it breaks, or finds more. Equal seeds are equal
# solids. Takes a minute to compile and a twentieth of a second a seed.
#   sh test/promises/verdicts.sh FIRST_SEED COUNT
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/promises
mkdir -p "$folder"
${CXX:-g++} -std=c++20 -O2 "-I$here/../../include" "-I$here/../support" "$here/verdicts.cpp" -o "$folder/verdicts" \
  -lgmp -lmpfr
"$folder/verdicts" "$@"
