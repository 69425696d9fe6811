#!/bin/sh
# Looks for data races in the passes of RelaxedOrder. Debian's oneTBB is not compiled for the thread
# sanitizer, so parallel.h is exchanged for one of std::thread.
#   sh test/tsan/run.sh MODEL    for instance bunny00.off of libcgal-demo
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$here/../../build/tsan-passes
mkdir -p "$folder"
${CXX:-g++} -std=c++20 -O1 -g1 -fsanitize=thread -DQUADRILLE_WITH_TBB "-I$here" \
  "-I$here/../../include" "$here/passes.cpp" -o "$folder/passes" -lgmp -lmpfr
TSAN_OPTIONS=halt_on_error=1 "$folder/passes" "$1"
