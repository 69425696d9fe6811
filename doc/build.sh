#!/bin/sh
# Builds the manual and the reference as HTML; doxygen, a Debian package, is installed if it is missing.
#   sh doc/build.sh [FOLDER]     build/doc/html by default; open its index.html
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
cd "$root"
output=${1:-build/doc/html}
command -v doxygen >/dev/null || sh .ci/install_packages.sh doxygen

mkdir -p "$output"
output=$(CDPATH='' cd -- "$output" && pwd -P)
sources=$(mktemp)
trap 'rm -f "$sources"' EXIT
version=$(sed -n 's/^#define QUADRILLE_VERSION_[A-Z]* //p' include/quadrille/version.h | paste -sd .)
QUADRILLE_DOC_ROOT=$root QUADRILLE_DOC_OUTPUT=$output QUADRILLE_DOC_SOURCES=$sources \
  QUADRILLE_VERSION=$version doxygen doc/reference/Doxyfile

# What documents link to and is no page itself, to be read beside them.
sort -u "$sources" | while read -r file; do
  mkdir -p "$output/source/$(dirname "$file")"
  if [ -d "$file" ]; then ls "$file"; else cat "$file"; fi > "$output/source/$file.txt"
done
