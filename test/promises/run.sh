#!/bin/sh
# Holds what doc/manual/guarantees.md promises, and fails if anything is broken. Equal seeds are equal surfaces.
#   sh test/promises/run.sh models MODEL.off...    for instance those of libcgal-demo
# measures distances both ways, tolerances that vary, self-intersections and solids, in doubles, in floats and far from
# the origin, then carries 100,000 points of each model along by the record of a run, for distances, tolerances and
# normals. It takes about fifteen seconds a model of 10,000 faces.
#   sh test/promises/run.sh CHECK FIRST_SEED COUNT [MODEL.off...]
# simplifies random surfaces, some that are hard, and these models, once a minute or so has gone to compile. A CHECK is
#   fuzz      each filter and limit that guarantees.md promises something of, looked at by <quadrille/verify.h>: three
#             minutes to compile, a fifth of a second a seed; what is broken is written to the current folder
#   filters   filters of shapes, edges and degrees, and limits of the distance, at levels of the record: an eighth of a
#             second a seed
#   parts     runs by small parts, from a file to a file, with regions of labels: a tenth of a second a seed
#   verdicts  damages right results of random solids: <quadrille/verify.h> finds each by the claim that it breaks, and
#             by no other. It takes a twentieth of a second a seed, and no models
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
folder=$root/build/promises
mkdir -p "$folder"
check=${1:?"usage: sh test/promises/run.sh CHECK ARGUMENT..."}
shift

# compile SOURCE...: adds to the objects
objects=
compile() {
  for source; do
    object=$folder/$(basename "$source" .cpp).o
    ${CXX:-g++} -std=c++20 -O2 -DQUADRILLE_ASSERTIONS '-DCGAL_DATA_DIR=""' "-I$root/include" "-I$root/test/support" \
      "-I$root/test/file" -c "$source" -o "$object"
    objects="$objects $object"
  done
}
# run PROGRAM ARGUMENT...
run() {
  program=$1
  shift
  # shellcheck disable=SC2086
  ${CXX:-g++} "$folder/$program.o" $objects -o "$folder/$program" -lgmp -lmpfr -lpthread
  "$folder/$program" "$@"
}

compile "$root"/test/support/*.cpp
case $check in
  models)
    for program in promises replay; do
      (compile "$root/test/promises/$program.cpp")
      run $program "$@"
    done
    exit
    ;;
  fuzz) compile "$root"/include/quadrille/compiled/*.cpp ;;
esac
(compile "$root/test/promises/$check.cpp")
run "$check" "$@"
