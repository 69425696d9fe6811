#!/bin/sh
# Checks that no file mentions a path of a developer's machine: a home, or the folder that the
# repository lies in.
#   sh developer_paths.sh REPOSITORY
cd "$1" || exit 2
folder=$(dirname "$(pwd -P)")
# The brackets keep this file from finding itself.
find_in_files() {
  grep -rIn --exclude=.git --exclude-dir=.git --exclude-dir='build*' "$@" .
}
! find_in_files -E '/[h]ome/[a-z]|/[U]sers/' &&
  { [ "$folder" = / ] || ! find_in_files -F "$folder/"; }
