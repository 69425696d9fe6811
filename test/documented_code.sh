#!/bin/sh
# Checks that the code which the documents show is compiled code: a block that follows the line
#   <!-- file: PATH -->   or   <!-- part: PATH -->
# must equal that file byte for byte, or consecutive lines of it.
#   sh documented_code.sh REPOSITORY
set -eu
cd "$1"
blocks=$(mktemp -d)
trap 'rm -rf "$blocks"' EXIT

# Writes the blocks as block.1, block.2, ... and a line "BLOCK KIND PATH DOCUMENT:LINE" for each.
find README.md doc -name '*.md' | sort | while read -r document; do
  awk -v block="$blocks/$(echo "$document" | tr / .)" '
    /^<!-- (file|part): .* -->$/ { kind = $2; path = $3; next }
    path != "" && /^```/  { name = block "." ++n; printf "" > name
                            print name, kind, path, FILENAME ":" FNR; path = ""; inside = 1; next }
    path != ""            { print "-", kind, path, FILENAME ":" FNR; path = "" }
    inside && /^```$/     { inside = 0; close(name) }
    inside                { print > name }' "$document"
done > "$blocks/list"

# is_part BLOCK FILE: are the lines of the block consecutive lines of the file?
is_part() {
  awk 'function slurp(file,    line, text) {
         text = "\n"
         while ((getline line < file) > 0)
           text = text line "\n"
         return text
       }
       BEGIN { block = slurp(ARGV[1]); exit !(length(block) > 1 && index(slurp(ARGV[2]), block)) }' "$1" "$2"
}

status=0
while read -r block kind path place; do
  if [ "$kind" = part: ]; then
    is_part "$block" "$path" || { echo "$place: the block is no part of $path"; status=1; }
  elif ! cmp -s "$block" "$path"; then
    echo "$place: the block is not the same as $path"
    diff "$block" "$path" || true
    status=1
  fi
done < "$blocks/list"
echo "$(wc -l < "$blocks/list") blocks compared"
exit $status
