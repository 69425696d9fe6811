#!/bin/sh
# What the tests do by one compiler, in one build, by both: Debug and Release builds of g++ and clang
# give the same results to the last digit, of four costs, and those of the headers alone are those of
# the library, which test_digests holds; costs are the same with and without vectors; the
# headers compile where min and max are macros, and take a part of a user's own; calls of the documents
# compile without a warning, and the benchmarks compile; and the package in JavaScript is what it
# has to be, where there is emscripten. It takes about half an hour of a processor.
#   sh test/every_build.sh [MODEL.off]
# The model is cow.off by default, of the models of a configured build: CGAL_DATA_DIR, or that of
# `cmake --preset test`.
set -eu
export LC_ALL=C
[ $# -eq 0 ] || set -- "$(realpath -- "$1")"
cd -- "$(dirname -- "$0")/.."
export CGAL_DATA_DIR="${CGAL_DATA_DIR:-$PWD/build/test/data}"
model=${1:-$CGAL_DATA_DIR/meshes/cow.off}
[ -f "$model" ] || {
  echo "no models in $CGAL_DATA_DIR: configure a build first, cmake --preset test" >&2
  exit 2
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for cost in Quadric MemorylessQuadric ThinFeatureQuadric ColorQuadric; do
  echo "$cost"
  sh test/debug_and_release.sh "$model" -std=c++20 -Iinclude -DCOST=$cost -- \
    'g++ -O0' 'g++ -O2 -DNDEBUG' 'clang++ -O0' 'clang++ -O2 -DNDEBUG'
done

for compiler in g++ clang++; do
  echo "$compiler"
  $compiler -std=c++20 -O2 -ffp-contract=off -Iinclude -Itest -Itest/support test/main.cpp \
    test/support/read_model.cpp test/programs/test_digests.cpp -lOpenMeshCore -lmpfr -lgmp -o "$folder/digests"
  "$folder/digests"
  sh test/lanes.sh $compiler -std=c++20 -Iinclude
  sh test/min_max_macros.sh include $compiler -std=c++20 -Iinclude -fsyntax-only
  sh test/own_part.sh . $compiler -std=c++20 -Iinclude
  sh test/documented_calls.sh . $compiler -std=c++20 -Iinclude -fsyntax-only -Wall -Wextra \
    -Wno-unused-local-typedefs -Wdouble-promotion -Werror
done

for source in benchmark/*.cpp benchmark/attributes/*.cpp; do
  echo "$source"
  g++ -std=c++20 -fsyntax-only -Iinclude -Iexamples -Ibenchmark -I/usr/include/eigen3 \
    -DCGAL_DATA_DIR='""' -DBENCH_WITH_MESHOPTIMIZER "$source"
done

if command -v emcmake >/dev/null; then
  sh test/web/run.sh "$folder/web"
else
  echo "the package in JavaScript is left out: there is no emscripten"
fi
