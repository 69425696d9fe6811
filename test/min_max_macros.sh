#!/bin/sh
# Checks that the headers compile where min and max are macros, as in programs that include windows.h.
# What other libraries do about that is theirs: their headers come before the macros.
#   sh min_max_macros.sh INCLUDE_FOLDER COMPILER FLAG...
set -eu
headers=$1/quadrille
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

grep -r -h -o '^ *#include <[^>]*>' "$headers" | grep -v -e '<quadrille/' -e '<intrin.h>' | sort -u |
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
"$@" "-I$folder" "$folder/macros.cpp"
