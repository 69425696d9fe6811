#!/bin/sh
# Passes if SOURCE does not compile and the compiler says what it should.
#   sh compile_fail.sh SOURCE REGEX... -- COMPILER FLAG...
# With -DREMEDY, SOURCE must compile: it is wrong in nothing but what it is there to show.
set -u
source=$1
shift
regexes=
while [ "$1" != -- ]; do
  regexes="$regexes$1
"
  shift
done
shift

fail() {
  printf '%s\n\nFAILED: %s\n' "$output" "$1"
  exit 1
}

output=$("$@" -DREMEDY "$source" 2>&1) || fail "it does not compile with -DREMEDY either"
output=$("$@" "$source" 2>&1) && fail "it compiles"

first_error=$(printf '%s\n' "$output" | grep -E -m 1 ': (fatal )?error: ')
case $first_error in
  "$source":*) ;;
  *'static assertion failed: '* | *'static_assert failed '*) ;;
  *) fail "the first error is not in the user's file: $first_error" ;;
esac

printf '%s' "$regexes" | while IFS= read -r regex; do
  printf '%s\n' "$output" | grep -E -q -e "$regex" || fail "the message does not match: $regex"
done
