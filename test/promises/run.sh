#!/bin/sh
# Holds what doc/manual/guarantees.md promises on models. `promises` measures distances both ways, tolerances that
# vary, self-intersections and solids, in doubles, in floats and far from the origin; `replay` carries 100,000 points
# of each model along by the record of a run, for distances, tolerances and normals. Takes about fifteen seconds a
# model of 10,000 faces; fails if a promise is broken.
#   sh test/promises/run.sh MODEL.off...    for instance those of libcgal-demo
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/promises
mkdir -p "$folder"
for program in promises replay; do
  ${CXX:-g++} -std=c++20 -O2 "-I$here/../../include" "-I$here/../support" "$here/$program.cpp" \
    -o "$folder/$program" -lgmp -lmpfr
done
"$folder/promises" "$@" && "$folder/replay" "$@"
