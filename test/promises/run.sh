#!/bin/sh
# Holds what doc/manual/guarantees.md promises on models: distances both ways, tolerances that vary, no
# self-intersections, solids; in doubles, in floats and far from the origin, each measured apart.
# Takes about ten seconds a model of 10,000 faces; fails if a promise is broken.
#   sh test/promises/run.sh MODEL.off...    for instance those of libcgal-demo
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/promises
mkdir -p "$folder"
${CXX:-g++} -std=c++20 -O2 "-I$here/../../include" "-I$here/../support" "$here/promises.cpp" \
  -o "$folder/promises" -lgmp -lmpfr
"$folder/promises" "$@"
