#!/bin/sh
# Simplifies random surfaces, and some that are hard, with each filter and limit that doc/manual/guarantees.md promises
# something of, and has <quadrille/verify.h> look at the results. Equal seeds are equal surfaces. Takes three minutes to
# compile and about a fifth of a second a seed; what is broken fails, and is written to the current folder.
#   sh test/promises/fuzz.sh FIRST_SEED COUNT [MODEL.off...]
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$here/../..
folder=$root/build/promises
mkdir -p "$folder"
for source in "$root"/include/quadrille/compiled/*.cpp "$here/fuzz.cpp"; do
  object=$folder/$(basename "$source" .cpp).o
  ${CXX:-g++} -std=c++20 -O1 -DQUADRILLE_ASSERTIONS "-I$root/include" "-I$here/../support" -c "$source" -o "$object"
  set -- "$@" "$object"
done
arguments=
while [ "${1%.o}" = "$1" ]; do
  arguments="$arguments $1"
  shift
done
${CXX:-g++} "$@" -o "$folder/fuzz" -lgmp -lmpfr
# shellcheck disable=SC2086
"$folder/fuzz" $arguments
