#!/bin/sh
# Holds the tables of what others call it, in coming_from.md, against the code: in the column "library"
# each name in code is one of the headers, in "program" each option one of the program, in "Python" each
# argument one of the module, and in "CGAL 5.5" or "CGAL 6" each name one of that CGAL, if it is here.
#   sh documented_tables.sh REPOSITORY [FOLDER OF CGAL'S HEADERS]
set -eu
cd "$1"
cgal=${2:-/usr/include/CGAL}
names=$(mktemp)
trap 'rm -f "$names"' EXIT

# A line "LINE COLUMN CODE" for each piece of code in a table, with _ for blanks in the column's name.
awk -F '|' '
  !/^\|/ { delete column; next }
  !(2 in column) { for (i = 2; i < NF; ++i) { gsub(/^ +| +$/, "", $i); gsub(/ /, "_", $i); column[i] = $i }; next }
  { for (i = 2; i < NF; ++i) { n = split($i, parts, "`"); for (k = 2; k <= n; k += 2) print NR, column[i], parts[k] } }
' doc/manual/coming_from.md > "$names"

# The names of C++ in a piece of code, with at least four letters and a capital or an underscore.
cpp_names() {
  printf '%s\n' "$1" | sed 's/"[^"]*"//g' | grep -oE '[A-Za-z_]{4,}' | grep -E '[A-Z_]' || true
}

version=$(sed -n 's/^#define CGAL_VERSION \([0-9.]*\).*/\1/p' "$cgal/version.h" 2>/dev/null || true)
status=0 count=0
missing() {
  echo "doc/manual/coming_from.md:$1: there is no $2" >&2
  status=1
}
while read -r line column code; do
  case $column in
  library)
    for name in $(cpp_names "$code"); do
      [ "$name" = FILE ] || grep -rqw -e "$name" include || missing "$line" "$name"
      count=$((count + 1))
    done ;;
  program)
    for option in $(printf '%s\n' "$code" | grep -oE -e '--[a-z-]+' || true); do
      grep -rqE -e "[\",]$option[\",]" examples/program || missing "$line" "$option"
      count=$((count + 1))
    done ;;
  Python)
    for argument in $(printf '%s\n' "$code" | grep -oE '\b[a-z_]+=' | tr -d = || true); do
      grep -rqE "^ +$argument:" examples/python/quadrille || missing "$line" "$argument="
      count=$((count + 1))
    done ;;
  CGAL_5.5 | CGAL_6)
    case CGAL_$version in
    "$column"*)
      for name in $(cpp_names "$code"); do
        grep -rqw -e "$name" "$cgal/Surface_mesh_simplification" "$cgal/boost/graph" "$cgal/STL_Extension" \
          "$cgal/Named_function_parameters.h" || missing "$line" "$name"
        count=$((count + 1))
      done ;;
    esac ;;
  esac
done < "$names"
echo "$count names"
[ "$count" -gt 100 ] || status=1
exit $status
