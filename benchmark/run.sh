#!/bin/sh
# Measures the library and its peers. Debian packages that are missing are installed first.
#   sh benchmark/run.sh [--quick] [--data DIR] [ARGUMENT...]
# --quick leaves out the models of 1.2 and 4.8 million faces, which take hours; --data DIR adds all
# meshes of a folder; these two come first. Other arguments go to quadrille_benchmark: --ratio 0.01,
# --faces 1000, --runs 9.
# Models with colours or texture coordinates are measured where QUADRILLE_DATA names a folder that has
# them in `coloured` and `textured`, or in those of its folder `public`.
# Per model a table (.md), its figures (.csv) and a plot (.png) go to build/benchmark/results.
set -eu
export LC_ALL=C

quick=false
data=
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=true ;;
    --data) data=$(CDPATH='' cd -- "$2" && pwd); shift ;;
    *) break ;;
  esac
  shift
done
for argument in "$@"; do
  case $argument in
    --quick | --data) echo "$argument comes before other arguments" >&2; exit 2 ;;
  esac
done

cd -- "$(dirname -- "$0")/.."
sh .ci/install_packages.sh cmake g++ make libcgal-dev libcgal-demo libboost-dev libeigen3-dev \
  libcli11-dev libtbb-dev libbenchmark-dev libmeshoptimizer-dev libopenmesh-dev libvtk9-dev gnuplot-nox

build=build/benchmark
results=$build/results
cmake -S . -B $build -DCMAKE_BUILD_TYPE=Release -DQUADRILLE_BUILD_BENCHMARKS=ON \
  -DQUADRILLE_BUILD_TESTS=OFF -DQUADRILLE_BUILD_EXAMPLES=OFF
cmake --build $build --parallel "$(nproc)"
mkdir -p $results

measure() {
  model=$1
  shift
  $build/benchmark/quadrille_benchmark --out $results "$@" "$model" || return 0 # says why
  for csv in $results/"$(basename "${model%.*}")"_*.csv; do
    gnuplot -e "table='$csv'; plot='${csv%.csv}.png'" benchmark/plot.gp
  done
}

measure_attributes() {
  model=$1
  shift
  $build/benchmark/quadrille_attribute_benchmark --out $results "$@" -- "$model" || return 0 # says why
}

$build/benchmark/quadrille_micro_benchmark --benchmark_out=$results/micro.json

for model in bunny00 refined_elephant armadillo fandisk_large lion-head cow; do
  measure $build/data/meshes/$model.off "$@"
done

if [ -n "$data" ]; then
  find "$data" -type f \( -name '*.off' -o -name '*.obj' -o -name '*.ply' -o -name '*.stl' \) |
    sort |
    while IFS= read -r model; do measure "$model" "$@"; done
fi

for model in colored-sphere textured-sphere; do
  measure_attributes $model "$@"
done
if [ -n "${QUADRILLE_DATA-}" ]; then
  folder=$QUADRILLE_DATA
  [ ! -d "$folder/public" ] || folder=$folder/public
  find "$folder/coloured" "$folder/textured" -type f \
    \( -name '*.obj' -o -name '*.ply' -o -name '*.off' \) | sort |
    while IFS= read -r model; do measure_attributes "$model" "$@"; done
fi

measure_refined() {
  refined=$build/data/bunny00_$1.ply
  levels=$2
  shift 2
  [ -f "$refined" ] || $build/benchmark/refine $build/data/meshes/bunny00.off "$refined" "$levels"
  measure "$refined" "$@"
}
if ! $quick; then
  measure_refined 1200k 2 "$@"
  measure_refined 4800k 3 "$@"
fi
