#!/bin/sh
# Gives a copy of the headers a part of its own that follows contractions, by the recipe of
# doc/architecture.md and by nothing else, and checks that it is told of them and packed.
#   sh own_part.sh ROOT COMPILER FLAG...
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cp -r "$root/include" "$folder/include"
room=$folder/include/quadrille/internal/contraction
cp "$here/own_part/merged_vertices.h" "$room"

# Puts a line after the only one that has a text.
insert_after() {
  [ "$(grep -c -F -- "$1" "$room/working_surface.h")" -eq 1 ] || {
    echo "working_surface.h has not one line with: $1"
    exit 1
  }
  awk -v text="$1" -v line="$2" '{ print } index($0, text) { print line }' \
    "$room/working_surface.h" >"$folder/edited.h"
  mv "$folder/edited.h" "$room/working_surface.h"
}
insert_after '#include <quadrille/internal/contraction/contraction_count.h>' \
  '#include <quadrille/internal/contraction/merged_vertices.h>'
insert_after '  MovedVertices<dimension> moved_;' '  MergedVertices merged_{complex_};'
insert_after 'return std::tie(self.recording_,' 'self.merged_,'

compiler=$1
shift
"$compiler" "-I$folder/include" "$@" -O0 "$here/own_part/main.cpp" -o "$folder/main"
"$folder/main"
