#!/bin/sh
# Looks at the sources, without a compiler. Prints what is wrong, and fails if anything is.
#   sh repository.sh CHECK REPOSITORY    a CHECK is one of the functions below
set -eu
cd -- "$2"

# The folders of include/quadrille/internal, the rooms, depend on each other in one direction only: each
# may include from itself and from those before it in the list. No function of the library, public or
# internal, has more than 40 lines.
rooms() {
  cd include/quadrille/internal

  rooms="base memory complex surface guard distance intersection normals policy cost appearance input pairs state evaluation contraction order adapter levels call file cluster planar verify"

  for room in *; do
    case " $rooms " in
      *" $room "*) ;;
      *) echo "the room $room is not in the list of test/repository.sh"; exit 1 ;;
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

  # A function begins where a declaration with a parameter list ends in a brace, and ends with a brace
  # below the first letter of the declaration, which comes after one that is complete.
  cd ..
  for header in *.h compiled/*.h compiled/*.cpp internal/*/*.h; do
    awk '
      begin && index($0, closing) == 1 {
        if (NR - begin >= 40) {
          print FILENAME ":" begin ": a function of " NR - begin + 1 " lines"
          wrong = 1
        }
        begin = 0
      }
      !begin && is_complete { match($0, /^ */); closing = substr($0, 1, RLENGTH) "}"; text = "" }
      !begin { text = text " " $0 }
      !begin && /\{$/ && !/^ *\/\// && text ~ /\(/ && text !~ /(^|[ >])(namespace|class|struct|union|enum|concept) [^(]*\{$|= *\{$/ {
        begin = NR
      }
      { is_complete = /[;{}:]$/ || /^ *(\/\/|#|$|template <.*>$)/ }
      END { exit wrong }' "$header" || wrong=1
  done
  exit $wrong
}

# What each compiler spells in its own way is in the two headers that hide it, and no header calls min or
# max, which may be macros where windows.h is included: (std::min)(a, b).
compiler_spellings() {
  ! grep -rnE 'gnu::|msvc::|__attribute__|__builtin_|__forceinline|\[\[no_unique_address' include |
    grep -v -e '/internal/base/compiler\.h:' -e '/internal/base/lanes\.h:'
  ! grep -rn '' include | sed 's|//.*||' | grep -E '\b(min|max) *\('
}

# No file mentions a path of a developer's machine: a home, or the folder that the repository lies in.
developer_paths() {
  folder=$(dirname "$(pwd -P)")
  # The brackets keep this file from finding itself.
  find_in_files() {
    grep -rIn --exclude=.git --exclude-dir=.git --exclude-dir='build*' "$@" .
  }
  ! find_in_files -E '/[h]ome/[a-z]|/[U]sers/' &&
    { [ "$folder" = / ] || ! find_in_files -F "$folder/"; }
}

"$1"
