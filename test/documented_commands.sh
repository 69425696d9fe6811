#!/bin/sh
# Checks the commands that the documents show: each block of shell is parsed, and where the program
# is there each command `quadrille ...` runs, in the order of its document, in a folder of their own;
# a mesh that is not there is made first.
#   sh documented_commands.sh REPOSITORY [PROGRAM MESH.off]
set -eu
repository=$1
program=${2:-}
mesh=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Writes the blocks of shell of a document to a file, without their indentation.
blocks() {
  awk '/^ *```sh$/ { inside = 1; indentation = index($0, "`"); next }
       /^ *```$/   { inside = 0 }
       inside      { print substr($0, indentation) }' "$1"
}

# shellcheck source=sheet_gltf.sh
. "$(dirname "$0")/sheet_gltf.sh"

# Makes the first mesh that a command names.
make_input() {
  for word in "$@"; do
    case $word in
    -*) ;;
    *.gltf | *.glb) [ -e "$word" ] || "$program" sheet.gltf "$word" --keep 100% --quiet; return 0 ;;
    *.off | *.obj | *.ply | *.stl) [ -e "$word" ] || "$program" "$mesh" "$word" --keep 100% --quiet; return 0 ;;
    esac
  done
}

status=0
count=0
[ -z "$program" ] || (cd "$folder" && write_sheet sheet.gltf)
for document in $(cd "$repository" && find README.md doc benchmark -name '*.md' | sort); do
  blocks "$repository/$document" > "$folder/commands"
  [ -s "$folder/commands" ] || continue
  sh -n "$folder/commands" || { echo "$document: its shell does not parse" >&2; status=1; }
  [ -n "$program" ] || continue
  grep '^quadrille ' "$folder/commands" > "$folder/runs" || continue
  while read -r command; do
    count=$((count + 1))
    if ! (cd "$folder" && set -f && eval "set -- ${command%%#*}" && shift && make_input "$@" &&
          "$program" "$@" < /dev/null > output 2>&1) &&
        ! grep -q 'built without the viewer of pages' "$folder/output"; then
      echo "$document: $command: fails:" >&2
      cat "$folder/output" >&2
      status=1
    fi
  done < "$folder/runs"
done
[ -z "$program" ] || echo "$count commands were run"
[ -z "$program" ] || [ "$count" -gt 0 ] || status=1
exit $status
