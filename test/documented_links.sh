#!/bin/sh
# Checks that the relative links of all documents lead to files that are there, and to headings that
# are in them. A heading is named as on GitHub: in lower case, without punctuation, with hyphens.
#   sh documented_links.sh REPOSITORY
set -eu
cd "$1"
links=$(mktemp)
trap 'rm -f "$links"' EXIT

# Writes a line "DOCUMENT:LINE TARGET" for each link that is not in code.
documents=$(find . -name '*.md' ! -path './.git/*' ! -path './build*' ! -path '*/node_modules/*' | sort)
for document in $documents; do
  awk -v document="${document#./}" '
    /^ *```/ { code = !code; next }
    code     { next }
             { gsub(/`[^`]*`/, "")
               while (match($0, /\]\([^)]*\)/)) {
                 print document ":" FNR, substr($0, RSTART + 2, RLENGTH - 3)
                 $0 = substr($0, RSTART + RLENGTH) } }' "$document"
done > "$links"

# headings DOCUMENT: their names.
headings() {
  awk '/^ *```/ { code = !code; next }
       !code && /^#+ / { sub(/^#+ /, ""); print }' "$1" |
    tr '[:upper:]' '[:lower:]' | sed -e 's/[]!-,./:;<=>?@[\^`{|}~]//g' -e 's/ /-/g'
}

status=0
while read -r place target; do
  case $target in *://* | mailto:*) continue ;; esac
  path=${target%%#*}
  [ -n "$path" ] && path=$(dirname "$place")/$path || path=${place%:*}
  if [ ! -e "$path" ]; then
    echo "$place: there is no $path"
    status=1
  elif [ "$target" != "${target#*#}" ] && ! headings "$path" | grep -qxF -e "${target#*#}"; then
    echo "$place: there is no heading ${target#*#} in $path"
    status=1
  fi
done < "$links"
echo "$(wc -l < "$links") links"
[ -s "$links" ] || status=1
exit $status
