#!/bin/sh
# Runs the example textured_obj on a sheet of two charts and two materials: both stay, and meet at
# the same line.
#   textured_obj.sh PROGRAM
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }

# 40 × 40 quads. The left half has u in [0, 0.4], the right half in [0.6, 1].
awk 'BEGIN {
  n = 40
  print "mtllib sheet.mtl"
  for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x) print "v", x, y, sin(x * y / 50)
  for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x) print "vt", x / n * 0.8, y / n
  for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x) print "vt", 0.2 + x / n * 0.8, y / n
  for (half = 0; half < 2; ++half) {
    print "usemtl", half ? "right" : "left"
    for (y = 0; y < n; ++y) for (x = half * n / 2; x < (half + 1) * n / 2; ++x) {
      split((y * (n + 1) + x) " " (y * (n + 1) + x + 1) " " ((y + 1) * (n + 1) + x + 1) " " ((y + 1) * (n + 1) + x), v)
      printf "f"
      for (c = 1; c <= 4; ++c) printf " %d/%d", v[c] + 1, v[c] + 1 + half * (n + 1) * (n + 1)
      print ""
    }
  }
}' >"$work/sheet.obj"
printf 'newmtl left\nnewmtl right\n' >"$work/sheet.mtl"

"$1" "$work/sheet.obj" "$work/out.obj" || fail "the program fails"
awk '
  $1 == "mtllib" { materials = $2 }
  $1 == "v"      { x[++points] = $2 }
  $1 == "vt"     { u[++uvs] = $2 }
  $1 == "usemtl" { material = $2 }
  $1 == "f" {
    ++faces[material]
    for (c = 2; c <= 4; ++c) {
      split($c, at, "/")
      right = material == "right"
      if (right ? x[at[1]] < 19.8 : x[at[1]] > 20.2) wrong = "a face of " material " reaches the other half"
      if (right ? u[at[2]] < 0.5 : u[at[2]] > 0.5) wrong = "a face of " material " has the other chart"
      difference = u[at[2]] - (0.2 * right + x[at[1]] / 50)
      if (difference > 0.01 || difference < -0.01) wrong = "the texture has moved by " difference
    }
  }
  END {
    if (materials != "sheet.mtl") wrong = "the material file is " materials
    if (faces["left"] < 300 || faces["right"] < 300) wrong = "a half has too few faces"
    if (faces["left"] + faces["right"] != 1000) wrong = faces["left"] + faces["right"] " faces"
    if (wrong != "") { print wrong; exit 1 }
  }' "$work/out.obj"

sed '/^vt/d; s,/[0-9]*,,g' "$work/sheet.obj" >"$work/bare.obj"
! "$1" "$work/bare.obj" "$work/bare_out.obj" 2>"$work/message" || fail "a file without a texture is taken"
grep -q 'bare.obj: a face has no texture coordinates' "$work/message" || fail "the message is $(cat "$work/message")"
[ ! -e "$work/bare_out.obj" ] || fail "it has written something"
