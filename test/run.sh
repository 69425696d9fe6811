#!/bin/sh
# Builds and runs all tests, or the quick ones. Debian packages that are missing are installed
# first.
#   sh test/run.sh [--quick] [CMAKE_ARGUMENT...]   for instance -DQUADRILLE_WERROR=ON
#   sh test/run.sh --headers                       compiles each header by itself: minutes the first time
set -eu
export LC_ALL=C

cd -- "$(dirname -- "$0")/.."
# An npm from elsewhere does, and does not go together with Debian's.
npm=
command -v npm >/dev/null || npm=npm
sh .ci/install_packages.sh cmake g++ clang libc++-dev ninja-build libcgal-dev libcgal-demo \
  libboost-dev catch2 libopenmesh-dev libeigen3-dev libtbb-dev libcli11-dev libbenchmark-dev \
  libdraco-dev libmeshoptimizer-dev libtinyobjloader-dev nlohmann-json3-dev libzstd-dev gnuplot-nox doxygen help2man \
  bash-completion dpkg-dev file chromium $npm libopenmpi-dev pybind11-dev python3-dev python3-numpy

target=all
labels=
if [ "${1:-}" = --quick ]; then
  shift
  target=quick_tests
  labels="-L quick"
fi

jobs=$(nproc)
if [ "${1:-}" = --headers ]; then
  shift
  cmake --preset test "$@"
  exec cmake --build --preset test --parallel "$jobs" --target all_verify_interface_header_sets
fi
cmake --preset test "$@"
# A test that does not compile must not keep the others from running.
built=0
cmake --build --preset test --parallel "$jobs" --target $target -- -k 0 || built=$?
ctest --preset test --parallel "$jobs" $labels
exit "$built"
