#!/bin/sh
# Asks a compiler what it says of sources, or what it makes of them.
#   sh compiler.sh CHECK ARGUMENT...    a CHECK is one of the functions below
set -u
check=$1
shift

# Compiles what must not compile, and keeps what the compiler says of it, for `mistake`.
#   mistakes SAID COMPILER ARGUMENT...
mistakes() {
  said=$1
  shift
  case $1 in *clang*) set -- "$@" -ferror-limit=0 ;; esac
  if "$@" >"$said" 2>&1; then
    echo "it compiles"
    exit 1
  fi
  grep -c ' error: ' "$said"
}

# Passes if a compiler has said of SOURCE what it should.
#   mistake SAID SOURCE REGEX...
# SAID is a file of all that it said, of SOURCE and of others: see `mistakes`.
# Each line of SOURCE that ends in "// mistake" must begin an error, and every extended regular
# expression must be found in what the compiler says of it, up to the next error. Only a static
# assertion may lie in the library: then the line and the expressions must be found in what is said
# of SOURCE. The first expression must be found within 20 lines: nobody reads on for the mistake.
# With -DREMEDY, SOURCE must compile, as it is wrong in nothing but what it is there to show: the test
# "compile_fail: remedies" compiles all of them at once.
mistake() {
  all=$1 source=$2
  shift 2

  fail() {
    printf '%s\n\nFAILED: %s\n' "$output" "$1"
    exit 1
  }

  # Errors that name SOURCE, each with the lines before it that tell where it is, and the notes after it.
  # One that names no source of the folder goes on with the one before.
  output=$(awk -v source="$source:" -v folder="${source%/*}/" '
    { line[NR] = $0 }
    / (fatal )?error: / { error[++errors] = NR }
    END {
      for (i = 1; i <= errors; ++i) {
        first[i] = error[i]
        while (first[i] > 1 && line[first[i] - 1] ~ /^In file included|^  +from |: In |:   (recursively )?required /)
          --first[i]
      }
      first[errors + 1] = NR + 1
      for (i = 1; i <= errors; ++i) {
        text = names = ""
        for (n = first[i]; n < first[i + 1]; ++n) {
          text = text line[n] "\n"
          if (line[n] !~ /^In file included|^  +from /)
            names = names line[n]
        }
        if (index(names, folder))
          is_of_source = index(names, source)
        if (is_of_source)
          printf "%s", text
      }
    }' "$all")
  [ "$output" ] || fail "nothing is said of it"

  lines=$(grep -n '// mistake$' "$source" | cut -d: -f1)
  [ "$lines" ] || fail "no line is marked as a mistake"

  first_error=$(printf '%s\n' "$output" | grep -E -m 1 ': (fatal )?error: ')
  case $first_error in
    "$source":*) asserts= ;;
    *'static assertion failed: '* | *'static_assert failed '*) asserts=1 ;;
    *) fail "the first error is not in the user's file: $first_error" ;;
  esac

  for line in $lines; do
    if [ "$asserts" ]; then
      said=$output
      printf '%s\n' "$said" | grep -q -F "$source:$line:" || fail "line $line is not named"
    else
      said=$(printf '%s\n' "$output" | awk -v begin="$source:$line:" '
        / (fatal )?error: / { inside = index($0, begin) == 1 }
        inside')
      [ "$said" ] || fail "line $line is no error"
    fi
    printf '%s\n' "$said" | head -n 20 | grep -E -q -e "$1" ||
      fail "the first 20 lines of what is said of line $line do not name the mistake"
    for regex; do
      printf '%s\n' "$said" | grep -E -q -e "$regex" ||
        fail "what is said of line $line does not match: $regex"
    done
  done
}

# What a compiler says first, where it is told an older standard, is what Quadrille needs.
#   older_standard COMPILER FLAG...
older_standard() {
  for header in simplify threshold_pairs distance concepts; do
    said=$(printf '#include <quadrille/%s.h>\n' "$header" | "$@" -std=c++17 -Wfatal-errors -fsyntax-only -x c++ - 2>&1)
    first=$(printf '%s\n' "$said" | grep -m 1 'error: ')
    echo "$header.h: $first"
    case $first in
      *'Quadrille needs C++20: '*) ;;
      *) exit 1 ;;
    esac
  done
}

# A source of meshes, soups and levels compiles with LLVM's standard library; exits with 77 where the
# compiler has none. A main that is a function of a namespace need not return anything either.
#   libcxx SOURCE COMPILER FLAG...
libcxx() {
  source=$1
  shift
  compile() { "$@" -stdlib=libc++ -fsyntax-only -Wall -Wextra -Wno-return-type -Werror; }

  if ! echo '#include <version>' | compile "$@" -x c++ - 2>/dev/null; then
    echo "skipped: $1 has no libc++"
    exit 77
  fi
  compile "$@" "$source"
}

# An object file of headers alone defines nothing that another one may not define as well.
#   headers_define_nothing NM OBJECT
headers_define_nothing() {
  "$1" --extern-only --defined-only "$2" >/dev/null || return # it is no object file
  if "$1" -C --extern-only --defined-only "$2" | grep ' [ABCDGRST] '; then
    echo "defined in each unit that has the headers: inline is missing"
    exit 1
  fi
}

"$check" "$@"
