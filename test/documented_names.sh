#!/bin/sh
# Checks that the names of classes and functions in the documents that tell what is where are names
# of the library: each `Name`, `Name::member` or `name.h` in code is looked up in its headers.
#   sh documented_names.sh REPOSITORY
set -eu
cd "$1"
documents="doc/architecture.md doc/manual/algorithm.md doc/manual/policies.md doc/manual/units.md doc/manual/guarantees.md"
names=$(mktemp)
trap 'rm -f "$names"' EXIT
for document in $documents; do
  awk -v document="$document" '
    /^ *```/ { code = !code; next }
    { n = split($0, parts, "`")
      for (i = 2; i <= n; i += 2)
        if (!code && match(parts[i], /^[A-Za-z_:\/]+(\.h)?/) && RLENGTH > 2)
          print document ":" FNR, substr(parts[i], 1, RLENGTH) }' "$document"
done | grep -E '[: ][A-Z][A-Za-z]*[a-z][A-Za-z]*(::[a-z_]+)?$|\.h$' > "$names"

status=0
while read -r place name; do
  case $name in
  CGAL::* | FaceGraph | MutableFaceGraph | FaceListGraph | SurfaceMesh) continue ;;
  *.h) find include examples -path "*/$name" | grep -q . || { echo "$place: there is no $name" >&2; status=1; } ;;
  *) for part in $(echo "$name" | sed 's/::/ /g'); do
       grep -rqw -e "$part" include || { echo "$place: there is no $name" >&2; status=1; }
     done ;;
  esac
done < "$names"
echo "$(wc -l < "$names") names"
[ -s "$names" ] || status=1
exit $status
