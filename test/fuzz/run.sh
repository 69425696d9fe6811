#!/bin/sh
# Builds the fuzzers and runs each for so many seconds. Debian packages that are missing are installed
# first. A new corpus grows in build/fuzz/corpus; what fails is written to build/fuzz as crash-*, to be
# given to the program that found it, and ends the run with that program's exit status.
#   sh test/fuzz/run.sh SECONDS [FUZZER...]
set -eu
export LC_ALL=C

seconds=${1:?"usage: sh test/fuzz/run.sh SECONDS [FUZZER...]"}
shift
[ $# -gt 0 ] || set -- fuzz_soup fuzz_file fuzz_levels

cd -- "$(dirname -- "$0")/../.."
sh .ci/install_packages.sh cmake clang libclang-rt-dev ninja-build libcgal-dev libcgal-demo \
  libboost-dev catch2 libopenmesh-dev libeigen3-dev libzstd-dev
cmake --preset fuzz
cmake --build --preset fuzz --parallel 2 --target "$@"

cd build/fuzz
for fuzzer in "$@"; do
  mkdir -p "corpus/$fuzzer"
  "test/fuzz/$fuzzer" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 \
    -print_final_stats=1 "corpus/$fuzzer" "../../test/fuzz/corpus/$fuzzer"
done
