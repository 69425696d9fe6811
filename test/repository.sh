#!/bin/sh
# Looks at the sources, without a compiler. Prints what is wrong, and fails if anything is.
#   sh repository.sh CHECK REPOSITORY    a CHECK is one of the functions below
set -eu
cd -- "$2"

# Folders of include/quadrille/internal include in one direction only. Each module, as cmake/modules.cmake
# lists them, includes the modules that it needs, by their internal headers or their doors, and no other;
# in the core, each room includes itself and those before it in the list. No function of the library,
# public or internal, has more than 40 lines, and no header more than 600.
rooms() {
  lists=$PWD/cmake/modules.cmake
  cd include/quadrille

  # list NAME: a list of cmake/modules.cmake
  list() {
    sed -n "s/^set($1 *\([^)]*\))/\1/p" "$lists"
  }
  modules=$(list quadrille_modules)
  # module_of HEADER, by its path from include/quadrille
  module_of() {
    case $1 in
      internal/*) set -- "${1#internal/}"; echo "${1%%/*}"; return ;;
      compiled/*) echo compiled; return ;;
      c/*) echo c; return ;;
    esac
    for module in $modules; do
      case " $(list "${module}_headers") " in *" $1 "*) echo "$module"; return ;; esac
    done
    echo core
  }
  wrong=0
  for folder in internal/*; do
    case " $modules " in
      *" ${folder#internal/} "*) ;;
      *) echo "the module ${folder#internal/} is not in cmake/modules.cmake"; wrong=1 ;;
    esac
  done
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  grep -o '^#include <quadrille/[^>]*' *.h compiled/* c/* internal/*/*.h internal/*/*/*.h |
    sed 's|:#include <quadrille/| |' >"$folder/includes"
  cut -d' ' -f1 "$folder/includes" | cat - "$folder/includes" |
    tr ' ' '\n' | sort -u | while read -r header; do echo "$header $(module_of "$header")"; done \
    >"$folder/modules"
  needs=$(for module in $modules; do echo "$module: $(list "${module}_needs")"; done)
  awk -v needs="$needs" '
    BEGIN {
      count = split(needs, lines, "\n")
      for (i = 1; i <= count; ++i) {
        n = split(lines[i], words, /[: ]+/)
        for (j = 1; j <= n; ++j)
          may[words[1], words[j]] = 1
      }
    }
    FNR == NR { module[$1] = $2; next }
    !((module[$1], module[$2]) in may) {
      print $1 " of " module[$1] " includes " $2 " of " module[$2]
      wrong = 1
    }
    END { exit wrong }' "$folder/modules" "$folder/includes" || wrong=1

  rooms="base memory complex surface guard policy cost appearance input pairs state evaluation contraction recording order adapter call"
  cd internal/core
  for room in *; do
    case " $rooms " in
      *" $room "*) ;;
      *) echo "the room $room is not in the list of test/repository.sh"; wrong=1 ;;
    esac
  done
  earlier=
  for room in $rooms; do
    earlier="$earlier $room"
    for included in $(sed -n 's|^#include <quadrille/internal/core/\([a-z_]*\)/.*|\1|p' "$room"/*.h | sort -u); do
      case "$earlier " in
        *" $included "*) ;;
        *) wrong=1; grep -n "<quadrille/internal/core/$included/" "$room"/*.h ;;
      esac
    done
  done
  cd ../..

  # A function begins where a declaration with a parameter list ends in a brace, and ends with a brace
  # below the first letter of the declaration, which comes after one that is complete.
  for header in *.h compiled/*.h compiled/*.cpp c/*.h c/*.cpp internal/*/*.h internal/*/*/*.h; do
    if [ "$(wc -l <"$header")" -gt 600 ]; then
      echo "$header has more than 600 lines"
      wrong=1
    fi
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
    grep -v -e '/internal/core/base/compiler\.h:' -e '/internal/core/base/lanes\.h:' -e '/quadrille/quadrille\.h:'
  ! grep -rn '' include | sed 's|//.*||' | grep -E '\b(min|max) *\('
}

# Comments are sentences in plain English, and fragments behind a declaration noun phrases or verbs: none begins with a word such as Of or What, and none uses a word
# of words.txt. Names of functions, and what stands in backquotes, are no words.
words() {
  banned=$(grep -v '^#' test/words.txt | cut -f1 | paste -sd '|')
  cd include/quadrille
  find . -name '*.h' -exec awk -v banned=" ($banned) " '
    BEGIN {
      first = "^(Of|What|The same|Who|Whose|Those|That|Where)( |$)"
      fragment = "^(of|what|the same|who|whose|those|that|where)( |$)"
    }
    FNR == 1 { inside = 0 }
    {
      begin = match($0, /\/\/+<?( |$)/)
      if (!begin || substr($0, 1, begin - 1) ~ /"[^"]*$/) { inside = 0; next }
      is_line = substr($0, 1, begin - 1) ~ /^ *$/
      text = substr($0, begin + RLENGTH)
      is_fragment = substr($0, begin, RLENGTH) ~ /</ && !(inside && is_line)
      if (((!inside || !is_line) && text ~ first) || (is_fragment && text ~ fragment)) {
        print FILENAME ":" FNR ": begins with " text
        wrong = 1
      }
      inside = is_line && text != "" && text !~ /^\\file/
      gsub(/`[^`]*`|[A-Za-z_:]+\(/, "", text)
      gsub(/[^A-Za-z_]+/, "  ", text)
      if (match(" " tolower(text) " ", banned)) {
        print FILENAME ":" FNR ": says" substr(" " text " ", RSTART, RLENGTH)
        wrong = 1
      }
    }
    END { exit wrong }' {} +
}

# No name in a header, program or example has a word of private_names.txt, but in the places that its line allows.
names() {
  # shellcheck disable=SC2046
  perl -ne '
    BEGIN {
      open my $list, "<", "test/private_names.txt" or die;
      while (<$list>) {
        next if /^#/;
        chomp;
        my ($words, $instead, $folder, $allowed) = split /\t/;
        for my $word (split /\|/, $words) {
          $folder{$word} = $folder;
          $allowed{$word}{$_} = 1 for split / /, $allowed // "";
        }
      }
    }
    s{"(?:[^"\\]|\\.)*"|//.*|^ */?\*.*|/\*.*?\*/}{""}ge;
    (my $name = $ARGV) =~ s{.*/}{};
    while (/([A-Za-z_]\w*)/g) {
      my $identifier = $1;
      for my $word (map { lc } split /_+|(?<=[a-z0-9])(?=[A-Z])/, $identifier) {
        my $folder = $folder{$word} or next;
        next if $ARGV !~ m{^(?:$folder)/} || $allowed{$word}{$name} || $allowed{$word}{$identifier};
        print "$ARGV:$.: $identifier has the word $word\n";
        $wrong = 1;
      }
    }
    close ARGV if eof;
    END { $? = $wrong ? 1 : 0 }' $(find include examples -name '*.h' -o -name '*.cpp' -o -name '*.def' | sort)
}

# Messages are plain English as well: no text in quotes that has a blank uses a word of words.txt.
messages() {
  banned=$(grep -v '^#' test/words.txt | cut -f1 | paste -sd '|')
  find include examples/products \( -name '*.h' -o -name '*.cpp' -o -name '*.def' -o -name '*.py' -o -name '*.js' \) \
    ! -path '*/node_modules/*' -exec awk -F '"' -v banned=" ($banned) " '
    /^ *(\/\/|#)/ { next }
    {
      for (i = 2; i <= NF; i += 2) {
        text = $i
        if (text !~ /[a-z] |  *[a-z]/)
          continue
        gsub(/\047[a-z]+\047/, " - ", text) # names
        gsub(/[^A-Za-z_]+/, "  ", text)
        if (match(" " tolower(text) " ", banned)) {
          print FILENAME ":" FNR ": says" substr(" " text " ", RSTART, RLENGTH) "in a message"
          wrong = 1
        }
      }
    }
    END { exit wrong }' {} +
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
