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

# The mesh as a PLY file whose vertices have the scalar NAME: write_scalar NAME FILE
write_scalar() {
  "$program" "$mesh" plain.off --keep 100% --quiet --force
  awk -v name="$1" '
    NF == 0 || /^#/ || /OFF/ { next }
    !faces { vertices = $1; faces = $2
             print "ply\nformat ascii 1.0\nelement vertex", vertices
             print "property double x\nproperty double y\nproperty double z\nproperty double", name
             print "element face", faces "\nproperty list uchar int vertex_indices\nend_header"; next }
    n++ < vertices { print $1, $2, $3, 1 + ($1 > 0); next }
    { print }' plain.off > "$2"
}

# Makes the first mesh that a command names, with a scalar that it asks for; all with --into.
make_input() {
  scalar=
  previous=
  several=
  for word in "$@"; do
    [ "$word" != --into ] || several=yes
    case $previous in --tolerance | --importance) scalar=$word ;; esac
    previous=$word
  done
  for word in "$@"; do
    [ -z "$scalar" ] || case $word in *.ply) write_scalar "$scalar" "$word"; return 0 ;; esac
    case $word in
    -*) ;;
    *.gltf | *.glb) [ -e "$word" ] || "$program" sheet.gltf "$word" --keep 100% --quiet; return 0 ;;
    *.off | *.obj | *.ply | *.stl)
      [ -e "$word" ] || "$program" "$mesh" "$word" --keep 100% --quiet
      [ -n "$several" ] || return 0
      ;;
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
