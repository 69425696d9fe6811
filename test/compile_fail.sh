#!/bin/sh
# Passes if SOURCE does not compile and the compiler says what it should.
#   sh compile_fail.sh SOURCE REGEX... -- COMPILER FLAG...
# Each line of SOURCE that ends in "// mistake" must begin an error, and every extended regular
# expression must be found in what the compiler says of it, up to the next error. Only a static
# assertion may lie in the library: then the line and the expressions must be found anywhere. The
# first expression must be found within 20 lines: nobody reads on for the mistake.
# With -DREMEDY, SOURCE must compile, as it is wrong in nothing but what it is there to show: the test
# "compile_fail: remedies" compiles all of them at once.
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

output=$("$@" "$source" 2>&1) && fail "it compiles"

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
  printf '%s\n' "$said" | head -n 20 | grep -E -q -e "$(printf '%s' "$regexes" | head -n 1)" ||
    fail "the first 20 lines of what is said of line $line do not name the mistake"
  printf '%s' "$regexes" | while IFS= read -r regex; do
    printf '%s\n' "$said" | grep -E -q -e "$regex" ||
      fail "what is said of line $line does not match: $regex"
  done || exit 1
done
