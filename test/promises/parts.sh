#!/bin/sh
# Simplifies random surfaces, and some that are hard, by small parts, and fails if what comes out is further away than it
# tells, has another topology or other regions of labels than what went in, or depends on how many parts are in flight.
# Equal seeds are equal surfaces. Takes a minute to compile and a tenth of a second a seed.
#   sh test/promises/parts.sh FIRST_SEED COUNT [MODEL.off...]
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/promises
mkdir -p "$folder"
${CXX:-g++} -std=c++20 -O1 "-I$here/../../include" "-I$here/../support" "-I$here/../file" "$here/parts.cpp" \
  -o "$folder/parts" -lgmp -lmpfr -lpthread
"$folder/parts" "$@"
