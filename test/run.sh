#!/bin/sh
# Builds and runs all tests, or some. Debian packages that are missing are installed first.
#   sh test/run.sh [CMAKE_ARGUMENT...]   for instance -DQUADRILLE_WERROR=ON
#   sh test/run.sh --quick               what notices most in two minutes
#   sh test/run.sh --module NAME         a folder of test/, core or guards: builds nothing of the others
#   sh test/run.sh --headers             compiles each header by itself: minutes the first time
set -eu
export LC_ALL=C

cd -- "$(dirname -- "$0")/.."
# An npm from elsewhere does, and does not go together with Debian's.
npm=
command -v npm >/dev/null || npm=npm
sh .ci/install_packages.sh cmake g++ clang libc++-dev ninja-build libcgal-dev libcgal-demo \
  libboost-dev libnanoflann-dev catch2 libopenmesh-dev libeigen3-dev libtbb-dev libcli11-dev libbenchmark-dev \
  libdraco-dev libmeshoptimizer-dev libtinyobjloader-dev nlohmann-json3-dev libzstd-dev gnuplot-nox doxygen help2man \
  bash-completion dpkg-dev file chromium $npm libopenmpi-dev python3-numpy python3-scipy

jobs=$(nproc)
target=
case ${1:-} in
  --quick) target=check_quick ;;
  --headers) target=all_verify_interface_header_sets ;;
  --module)
    target=check_${2:?"usage: sh test/run.sh --module NAME"}
    shift
    ;;
esac
[ -z "$target" ] || shift
cmake --preset test "$@"
[ -z "$target" ] || exec cmake --build --preset test --parallel "$jobs" --target "$target"
# A test that does not compile must not keep the others from running.
built=0
cmake --build --preset test --parallel "$jobs" -- -k 0 || built=$?
ctest --preset test --parallel "$jobs"
exit "$built"
