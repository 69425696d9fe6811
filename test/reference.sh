#!/bin/sh
# Checks that the reference builds without a warning, that every relative link in its HTML leads to a
# page and a place in it, and that neither a public name without a comment nor a header without a
# module goes unnoticed. Skipped (77) where there is no doxygen.
#   sh reference.sh REPOSITORY
set -eu
command -v doxygen >/dev/null || { echo "skipped: doxygen is not there"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/copy"
cd "$1"
cp -R README.md doc benchmark examples include test .ci CMakeLists.txt LICENSE "$folder/copy"
cd "$folder/copy"

fail() { echo "$1" >&2; exit 1; }
sh doc/build.sh "$folder/html" 2>&1 | tee "$folder/warnings"
[ ! -s "$folder/warnings" ] && [ -s "$folder/html/index.html" ] || fail "the reference does not build silently"

cd "$folder/html"
find . -type f | sed 's|^\./||' | sort > "$folder/files"
find . -name '*.html' ! -path './search/*' | sed 's|^\./||' | sort | xargs awk -v files="$folder/files" '
  BEGIN { while ((getline name < files) > 0) is_file[name] = 1 }
  { line = $0
    while (match(line, /[ "](id|name)="[^"]*"/)) {
      place = substr(line, RSTART + 1, RLENGTH - 2)
      sub(/^[^"]*"/, "", place)
      is_place[FILENAME "#" place] = 1
      line = substr(line, RSTART + RLENGTH)
    }
    line = $0
    while (match(line, /(href|src)="[^"]*"/)) {
      target = substr(line, RSTART, RLENGTH - 1)
      line = substr(line, RSTART + RLENGTH)
      sub(/^[^"]*"/, "", target)
      if (target !~ /^([a-z]+:|#?$)/)
        from[target ~ /^#/ ? FILENAME target : target] = FILENAME
    } }
  END {
    for (target in from) {
      ++links
      file = target
      sub(/#.*/, "", file)
      if (!(file in is_file) || (target ~ /\.html#/ && !(target in is_place))) {
        print from[target] ": there is no " target
        ++wrong
      }
    }
    print links + 0 " links"
    exit wrong > 0 || links < 1000
  }' || fail "links of the HTML lead nowhere"

cd "$folder/copy"
sed -i 's|^struct MidpointPlacement {|&\n  int without_comment();|' include/quadrille/placement.h
! sh doc/build.sh "$folder/undocumented" > "$folder/warnings" 2>&1 || fail "a name without a comment goes unnoticed"
grep -q 'placement.h:.*without_comment.*not documented' "$folder/warnings" || fail "not the name without a comment is refused"
cp include/quadrille/topology.h include/quadrille/elsewhere.h
sed -i '/without_comment/d' include/quadrille/placement.h
! sh doc/build.sh "$folder/module" > "$folder/warnings" 2>&1 || fail "a header without a module goes unnoticed"
grep -q 'names no module for elsewhere.h' "$folder/warnings" || fail "not the header without a module is refused"
