#!/bin/sh
# Checks that the calls which the documents show compile: every block of C++ that is no file of its
# own (see documented_code.sh) becomes a scope of documented_calls.cpp.
#   sh documented_calls.sh REPOSITORY COMPILER FLAG...
set -eu
repository=$1
shift
blocks=$(mktemp -d)
trap 'rm -rf "$blocks"' EXIT

find "$repository/README.md" "$repository/doc" -name '*.md' | sort | while read -r document; do
  awk -v document="$document" '
    /^<!-- (file|part): .* -->$/ { is_file = 1; next }
    /^```cpp$/ && !is_file     { print "{\n#line " FNR + 1 " \"" document "\""; inside = 1; next }
    /^```$/ && inside          { print "}"; inside = 0 }
    inside                     { print }
                               { is_file = 0 }' "$document"
done > "$blocks/documented_calls.inc"

calls=$(grep -c simplify "$blocks/documented_calls.inc") || calls=0
echo "$calls calls"
[ "$calls" -gt 0 ]
"$@" "-I$blocks" "$repository/test/documented_calls.cpp"
