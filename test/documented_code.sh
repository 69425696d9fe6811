#!/bin/sh
# Checks that the code which the documents show is compiled code: a block that follows the line
#   <!-- file: PATH -->
# must equal that file byte for byte.
#   sh documented_code.sh REPOSITORY
set -eu
cd "$1"
blocks=$(mktemp -d)
trap 'rm -rf "$blocks"' EXIT

# Writes the blocks as block.1, block.2, ... and a line "BLOCK PATH DOCUMENT:LINE" for each.
find README.md doc -name '*.md' | sort | while read -r document; do
  awk -v block="$blocks/$(echo "$document" | tr / .)" '
    /^<!-- file: .* -->$/ { path = $3; next }
    path != "" && /^```/  { name = block "." ++n; printf "" > name
                            print name, path, FILENAME ":" FNR; path = ""; inside = 1; next }
    path != ""            { print "-", path, FILENAME ":" FNR; path = "" }
    inside && /^```$/     { inside = 0; close(name) }
    inside                { print > name }' "$document"
done > "$blocks/list"

status=0
while read -r block path place; do
  if ! cmp -s "$block" "$path"; then
    echo "$place: the block is not the same as $path"
    diff "$block" "$path" || true
    status=1
  fi
done < "$blocks/list"
echo "$(wc -l < "$blocks/list") blocks compared"
exit $status
