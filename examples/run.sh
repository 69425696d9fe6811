#!/bin/sh
# Builds the examples and runs one of them. Debian packages that are missing are installed first.
#   sh examples/run.sh               simplifies the models of the papers and prints a table
#   sh examples/run.sh --figures [NUMBER...]
#                                    computes the papers' figures (doc/figures.md)
#   sh examples/run.sh ARGUMENT...   runs the program quadrille (--help lists its arguments)
# Exit status: that of the program, or 3 if it cannot be built.
set -u

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$root/build/examples
log=$build/build.log
case $#,${1-} in
  0,*)         target=papers_models; set -- "$build/data/meshes" "$build/results" ;;
  *,--figures) target=figures; shift; set -- "$build/data/meshes" "$build/figures" "$@" ;;
  *)           target=quadrille_program ;;
esac
case $target in
  quadrille_program) program=$build/examples/program/quadrille ;;
  *)                 program=$build/examples/$target ;;
esac

# Pages take three.js, which npm fetches. An npm from elsewhere does, and does not go together with Debian's.
npm=
case $* in
  *.html*) command -v npm >/dev/null || npm=npm ;;
esac

prepare() {
  sh "$root/.ci/install_packages.sh" \
    cmake g++ make libcgal-dev libcgal-demo libboost-dev libeigen3-dev libcli11-dev nlohmann-json3-dev \
    libzstd-dev libtbb-dev $npm &&
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DQUADRILLE_BUILD_TESTS=OFF &&
  cmake --build "$build" --target "$target" --parallel "$(nproc)"
}

mkdir -p "$build" || exit 3
[ -x "$program" ] ||
  echo "The first run installs what is missing and builds $program;" \
    "this takes some minutes, up to 1.6 GB of memory for each core, and tells how far it is in $log" >&2
if ! prepare >"$log" 2>&1; then
  cat "$log" >&2
  echo "The program $target could not be built; what is above is in $log" >&2
  exit 3
fi

exec "$program" "$@"
