#!/bin/sh
# What is handed on contains no code under the GPL.
#   sh licence.sh headers REPOSITORY COMPILER    the headers of CGAL that the products and the library include
#   sh licence.sh objects NM FILE...             the symbols of programs and libraries
#   sh licence.sh metadata REPOSITORY            what each package says of itself
# COMPILER is that of one product of all: what others do without, it looks for, too. Headers that are not
# there are passed over.
set -eu

# A translation unit of all sources of a product: each header is read once, by the preprocessor alone.
#   included SOURCE...
included() {
  for source; do
    echo "#include \"$PWD/$source\""
  done | "$compiler" -std=c++20 -Iinclude -Iexamples/products/mesh_io -Iexamples/products/page -Iexamples/products \
    -DQUADRILLE_C_BUILDS -DQUADRILLE_WITH_COMPILED -DQUADRILLE_PYTHON_WITH_GLTF -DQUADRILLE_WITH_DRACO \
    -DQUADRILLE_WITH_MESHOPT -M -MG -x c++ - | tr ' \\' '\n\n' | grep '^/.*/CGAL/.*\.h$' | sort -u
}

# Each header of CGAL has a line with its licence.
#   are_free NAME SOURCE...
are_free() {
  name=$1
  shift
  headers=$(included "$@")
  if [ "$(printf '%s\n' "$headers" | wc -l)" -lt 20 ]; then
    echo "$name: the compiler lists no headers"
    return 1
  fi
  bound=$(printf '%s\n' "$headers" | xargs grep -LE 'SPDX-License-Identifier: *(LGPL-3|MIT|BSL)')
  if [ -n "$bound" ]; then
    echo "$name includes, which is not under the LGPL:"
    printf '  %s\n' $bound
    return 1
  fi
  echo "$name: $(printf '%s\n' "$headers" | wc -l) headers of CGAL, none under the GPL"
}

headers() {
  compiler=$2
  cd -- "$1"
  status=0
  are_free "the compiled library with the interface of C" include/quadrille/compiled/*.cpp include/quadrille/c/*.cpp || status=1
  are_free "the program" examples/products/program/*.cpp examples/products/mesh_io/*.cpp \
    examples/products/mesh_io/gltf/*.cpp examples/products/page/*.cpp || status=1
  are_free "the Python module" examples/products/python/library/*.cpp || status=1
  are_free "the npm package" examples/products/web/*.cpp examples/products/web/page/*.cpp || status=1
  # A program that uses the library is bound by two headers alone.
  are_free "the library" $(ls include/quadrille/*.h | grep -vE '/(threshold_pairs|bounded_hausdorff)\.h$') || status=1
  for header in threshold_pairs bounded_hausdorff; do
    ! are_free "$header.h" "include/quadrille/$header.h" > /dev/null ||
      { echo "$header.h no longer includes what this test looks for"; status=1; }
  done
  return $status
}

objects() {
  nm=$1
  shift
  status=0
  for file; do
    symbols=$("$nm" "$file" 2>/dev/null) || symbols=
    [ -n "$symbols" ] || { echo "$file has no symbols"; status=1; }
    # Classes of CGAL's packages under the GPL, as compilers spell them in symbols.
    found=$(printf '%s\n' "$symbols" | grep -oE '4CGAL[0-9]+(Kd_tree|Fuzzy_sphere|AABB_[a-z]*|Constrained_[a-zA-Z_]*|Triangulation_2|Triangulation_data_structure_2|Box_intersection_d|Surface_mesh|Polyhedron_3|Polygon_mesh_processing)' | sort -u) || true
    if [ -n "$found" ]; then
      echo "$file has symbols of" $(printf '%s\n' "$found" | sed 's/4CGAL[0-9]*/CGAL::/')
      status=1
    fi
  done
  return $status
}

metadata() {
  cd -- "$1"
  status=0
  for file in pyproject.toml NOTICE.md examples/products/web/package/package.json examples/products/web/package/README.md; do
    grep -q MIT "$file" && grep -q LGPL-3.0-or-later "$file" ||
      { echo "$file does not say that there is code under the MIT licence and under the LGPL"; status=1; }
    [ "$file" = NOTICE.md ] || ! grep -nE '(^|[^L])GPL-[0-9]' "$file" || { echo "$file speaks of the GPL"; status=1; }
  done
  for library in CGAL Boost nanoflann GMP MPFR oneTBB zstd Draco meshoptimizer nlohmann CLI11 three.js; do
    grep -q "| *$library" NOTICE.md || { echo "NOTICE.md does not name $library"; status=1; }
  done
  return $status
}

"$@"
