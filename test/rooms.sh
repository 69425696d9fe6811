#!/bin/sh
# Checks that the folders of include/quadrille/internal, the rooms, depend on each other in one
# direction only: each may include from itself and from those before it in the list; and that no
# header has more than 300 lines. Prints what is wrong; fails if anything.
#   sh test/rooms.sh ROOT
set -eu
cd -- "$1/include/quadrille/internal"

rooms="base memory complex surface distance intersection policy cost pairs contraction order adapter levels call cluster"

for room in *; do
  case " $rooms " in
    *" $room "*) ;;
    *) echo "the room $room is not in the list of test/rooms.sh"; exit 1 ;;
  esac
done

wrong=0
earlier=
for room in $rooms; do
  earlier="$earlier $room"
  for included in $(sed -n 's|^#include <quadrille/internal/\([a-z_]*\)/.*|\1|p' "$room"/*.h | sort -u); do
    case "$earlier " in
      *" $included "*) ;;
      *) wrong=1; grep -n "<quadrille/internal/$included/" "$room"/*.h ;;
    esac
  done
done

for header in */*.h; do
  lines=$(wc -l <"$header")
  [ "$lines" -le 300 ] || { wrong=1; echo "$header has $lines lines"; }
done
exit $wrong
