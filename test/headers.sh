#!/bin/sh
# Compiles each header by itself, in the build folder of test/run.sh: those that have changed since
# the last time, all of them the first time, which takes minutes.
#   sh test/headers.sh
set -eu
cd -- "$(dirname -- "$0")/.."
cmake --preset test
cmake --build --preset test --target all_verify_interface_header_sets
