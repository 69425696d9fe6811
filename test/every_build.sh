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

# Builds of debug_and_release.cpp give the same results, to the last digit. Where the processor has a
# fused multiply-add, compilers take it in different places, so it is switched off.
#   debug_and_release COST 'COMPILER OPTION...'...
debug_and_release() {
  cost=$1
  shift
  rm -f "$folder/first"
  for build; do
    # shellcheck disable=SC2086
    $build -std=c++20 -Iinclude "-DCOST=$cost" -ffp-contract=off test/debug_and_release.cpp -o "$folder/program"
    "$folder/program" "$model" >"$folder/results"
    echo "$build: $(wc -l <"$folder/results") lines"
    [ -e "$folder/first" ] || cp "$folder/results" "$folder/first"
    cmp "$folder/first" "$folder/results"
  done
}

# Costs are the same, to the last digit, with and without the vectors that a compiler has.
#   lanes COMPILER FLAG...
lanes() {
  "$@" -O0 -ffp-contract=off test/lanes.cpp test/support/soups.cpp -o "$folder/vectors"
  "$@" -O0 -ffp-contract=off -DQUADRILLE_NO_VECTOR_EXTENSIONS test/lanes.cpp test/support/soups.cpp -o "$folder/scalars"
  "$folder/vectors" >"$folder/vectors.txt"
  "$folder/scalars" >"$folder/scalars.txt"
  echo "$(wc -l <"$folder/vectors.txt") lines"
  cmp "$folder/vectors.txt" "$folder/scalars.txt"
}

# The headers compile where min and max are macros, as in programs that include windows.h. What other
# libraries do about that is theirs: their headers come before the macros.
#   min_max_macros COMPILER FLAG...
min_max_macros() {
  grep -r -h -o '^ *#include <[^>]*>' include/quadrille | grep -v -e '<quadrille/' -e '<intrin.h>' | sort -u |
    sed 's/ *#include \(<.*>\)/#if __has_include(\1)\n#include \1\n#endif/' >"$folder/others.h"
  cat >"$folder/macros.cpp" <<END
#include "others.h"
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>
#include <quadrille/distance.h>
#include <quadrille/file_distance.h>
END
  "$@" -fsyntax-only "-I$folder" "$folder/macros.cpp"
}

# A copy of the headers is given a part of its own that follows contractions, by the recipe of
# doc/architecture.md and by nothing else, and is told of them and packed.
#   own_observer COMPILER FLAG...
own_observer() {
  rm -rf "$folder/include" && cp -r include "$folder/include"
  room=$folder/include/quadrille/internal/core/contraction
  cp test/own_observer/merged_vertices.h "$room"

  # Puts a text behind another, which stands there once.
  insert_after() {
    [ "$(grep -c -F -- "$1" "$room/working_surface.h")" -eq 1 ] || {
      echo "working_surface.h has not one line with: $1"
      exit 1
    }
    awk -v text="$1" -v more="$2" '{
        at = index($0, text)
        print at ? substr($0, 1, at - 1) text more substr($0, at + length(text)) : $0
      }' "$room/working_surface.h" >"$folder/edited.h"
    mv "$folder/edited.h" "$room/working_surface.h"
  }
  insert_after '#include <quadrille/internal/core/contraction/guard_list.h>' \
    '\n#include <quadrille/internal/core/contraction/merged_vertices.h>'
  insert_after '  OptionalDistances<Policies> distances_;' '\n  MergedVertices merged_{state_.complex};'
  insert_after 'std::tie(self.evaluator_,' ' self.merged_,'

  compiler=$1
  shift
  "$compiler" "-I$folder/include" "$@" -O0 test/own_observer/main.cpp -o "$folder/main"
  "$folder/main"
}

for cost in Quadric MemorylessQuadric ThinFeatureQuadric ColorQuadric; do
  echo "$cost"
  debug_and_release $cost 'g++ -O0' 'g++ -O2 -DNDEBUG' 'clang++ -O0' 'clang++ -O2 -DNDEBUG'
done

for compiler in g++ clang++; do
  echo "$compiler"
  $compiler -std=c++20 -O2 -ffp-contract=off -Iinclude -Itest -Itest/support test/main.cpp \
    test/support/*.cpp test/programs/test_digests.cpp -lOpenMeshCore -lmpfr -lgmp -o "$folder/digests"
  "$folder/digests"
  lanes $compiler -std=c++20 -Iinclude
  min_max_macros $compiler -std=c++20 -Iinclude
  own_observer $compiler -std=c++20
  sh test/documented.sh calls . $compiler -std=c++20 -Iinclude -fsyntax-only -Wall -Wextra \
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
