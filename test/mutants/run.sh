#!/bin/sh
# Puts the bugs of mutants.tsv, one at a time, into a copy of the library, and looks whether the
# tests named beside each notice. Prints one line for each; fails if one survives.
#   sh test/mutants/run.sh [FIRST [LAST]]   lines of mutants.tsv, all of them by default
#
# A line of mutants.tsv: header, code, what replaces its first occurrence, tests; between tabs, \n
# for the end of a line.
set -u
export LC_ALL=C

cd -- "$(dirname -- "$0")/../.."
first=${1:-1}
last=${2:-$(wc -l <test/mutants/mutants.tsv)}
folder=build/mutants
compile="${CXX:-g++} -std=c++20 -O0 -w"

mkdir -p "$folder"
[ "$folder/prelude.h.gch" -nt test/mutants/prelude.h ] || {
  cp test/mutants/prelude.h "$folder/prelude.h"
  $compile -x c++-header "$folder/prelude.h" -o "$folder/prelude.h.gch" || exit 2
}
[ "$folder/main.o" -nt test/main.cpp ] || $compile -c test/main.cpp -o "$folder/main.o" || exit 2

# passes TEST: sets the verdict if it does not.
passes() {
  $compile -include "$folder/prelude.h" -Itest -I"$folder/include" "test/test_$1.cpp" \
    "$folder/main.o" -o "$folder/test_$1" 2>"$folder/log" || {
    verdict="DOES NOT COMPILE"
    return 1
  }
  timeout 120 "$folder/test_$1" --abort >"$folder/log" 2>&1 || {
    verdict="killed by test_$1"
    return 1
  }
}

survivors=0
line=0
while IFS="$(printf '\t')" read -r header code replacement tests; do
  line=$((line + 1))
  [ "$line" -ge "$first" ] && [ "$line" -le "$last" ] || continue
  rm -rf "$folder/include"
  cp -r include "$folder/include"
  CODE=$code REPLACEMENT=$replacement perl -0777 -pi -e '
    my ($code, $replacement) = map { s/\\n/\n/gr } @ENV{"CODE", "REPLACEMENT"};
    my $at = index($_, $code);
    die "no such code\n" if $at < 0;
    substr($_, $at, length $code) = $replacement' "$folder/include/quadrille/$header" || {
    echo "$line: $header does not hold: $code"
    survivors=$((survivors + 1))
    continue
  }
  verdict=SURVIVED
  for test in $tests; do
    passes "$test" || break
  done
  case $verdict in killed*) ;; *) survivors=$((survivors + 1)) ;; esac
  echo "$line: $header: $verdict: $code -> $replacement"
done <<TSV
$(cat test/mutants/mutants.tsv)
TSV
echo "$survivors survived"
[ "$survivors" -eq 0 ]
