#!/bin/sh
# Runs the program quadrille over a folder of small files on which results were wrong, and checks
# what must hold of those that are there.
#
#   example_files.sh FOLDER PROGRAM
#
# If FOLDER is empty, it is what the environment variable QUADRILLE_CASES says. Without it the test
# is skipped (exit status 77).

folder=${1:-${QUADRILLE_CASES-}}
program=$2
if [ $# -ne 2 ] || [ ! -x "$program" ]; then
  echo "usage: $0 FOLDER PROGRAM" >&2
  exit 2
fi
if [ -z "$folder" ] || [ ! -d "$folder" ]; then
  echo "skipped: no folder '$folder'"
  exit 77
fi

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
checked=0
failures=0

fail() { # message
  failures=$((failures + 1))
  echo "$file $options: $1"
  sed 's/^/    /' "$work/stderr" | head -n 3
}

run() { # output, option...
  output=$work/$1
  shift
  options=$*
  rm -f "$output"
  timeout 60 "$program" "$@" "$folder/$file" "$output" >"$work/stdout" 2>"$work/stderr"
  status=$?
  checked=$((checked + 1))
}

has() { # name: is this file there?
  file=$1
  [ -f "$folder/$file" ]
}

expect_remark() { # extended regular expression: of the one line that there must be
  [ "$(wc -l <"$work/stderr")" -eq 1 ] || fail "not one remark"
  grep -qE "$1" "$work/stderr" || fail "no remark of '$1'"
}

# Each face of an OBJ file lies in one of the six charts, which are apart from each other, and each
# chart has faces.
charts_are_right() { # file.obj
  awk '$1 == "vt" { chart[++n] = int(3 * $2) " " int(2 * $3) }
    $1 == "f" {
      for (k = 2; k <= 4; ++k) { split($k, c, "/"); of[k] = chart[c[2]] }
      if (of[2] != of[3] || of[3] != of[4]) bad = 1
      ++faces[of[2]]
    }
    END { for (name in faces) ++count; exit bad || count != 6 }' "$1"
}

costs='default quadric memoryless thin-features color length'
with_cost() { # cost: as an option
  [ "$1" = default ] || echo "--cost $1"
}

# Each face has one colour, and one of those that the input has.
one_colour='
  NR == 2 { n = $1; next }
  NR <= 2 + n { colour[NR - 3] = $4 " " $5 " " $6; next }
  colour[$2] != colour[$3] || colour[$3] != colour[$4] { bad = 1 }
  { seen[colour[$2]] = 1 }
  END { for (c in seen) print c; if (bad) print "mixed" }'
for name in touching_colours.ply two_boxes_colours.ply shell_two_colours.ply; do
  has $name || continue
  run all.off --ratio 1
  awk "$one_colour" "$work/all.off" | sort >"$work/colours"
  grep -q mixed "$work/colours" && fail "the input has faces of several colours"
  for cost in $costs; do
    for ratio in 1 0.7 0.4 0.2 0.1; do
      # shellcheck disable=SC2046
      run out.off --ratio $ratio $(with_cost "$cost")
      [ $status -le 1 ] || fail "exit status $status"
      awk "$one_colour" "$work/out.off" | sort >"$work/left"
      [ -z "$(comm -23 "$work/left" "$work/colours")" ] || fail "faces with colours of other sheets"
      # A sheet of one face that is sewn to another may go, when that face does.
      [ $name = touching_colours.ply ] || cmp -s "$work/left" "$work/colours" || fail "a sheet is gone"
    done
  done
done

for name in header_off216.off ncoff.off end_loop.stl end_solid.stl one_line.stl \
  uchar_written_255.0.ply rgba.obj; do
  has $name || continue
  run out.off --ratio 1
  [ $status -eq 0 ] || fail "exit status $status"
done

for name in cloud.ply points_only.obj lines_only.obj; do
  has $name || continue
  echo old >"$work/old.off"
  "$program" "$folder/$name" "$work/old.off" >"$work/stdout" 2>"$work/stderr"
  [ $? -eq 2 ] || fail "it must be refused with exit status 2"
  [ "$(cat "$work/old.off")" = old ] || fail "the output has changed"
  expect_remark 'nothing to simplify'
done

if has float_colour_above_one.ply; then
  run out.off --ratio 1
  expect_remark 'numbers above 1'
  awk 'NR == 3 { exit !($4 == 0.5) }' "$work/out.off" || fail "0.5 has changed"
  awk 'NR == 4 { exit !($4 == 0.9) }' "$work/out.off" || fail "0.9 has changed"
fi
if has coff_zero_one.off; then
  run out.off --ratio 1
  expect_remark 'taken as fractions'
fi
if has materials.obj; then
  run out.obj
  [ -s "$work/stderr" ] && fail "there is something to remark"
  for line in 'mtllib b.mtl' 'o plate' 'g part_red' 'usemtl red' 'g part_blue' 'usemtl blue' 's 1'; do
    [ "$(grep -cx "$line" "$work/out.obj")" -eq 1 ] || fail "not one line '$line'"
  done
  grep -q '^f [0-9]*/[0-9]*/[0-9]* ' "$work/out.obj" || fail "no texture coordinates and normals"
  run out.ply
  expect_remark 'not kept: .*mtllib.*usemtl.*'
fi
if has sphere_6_charts_corners.obj; then
  run out.obj --ratio 0.2
  [ $status -eq 0 ] || fail "exit status $status"
  [ -s "$work/stderr" ] && fail "there is something to remark"
  charts_are_right "$work/out.obj" || fail "texture coordinates of other charts"
fi
if has labels_quality_texnumber.ply; then
  run out.ply
  [ -s "$work/stderr" ] && fail "there is something to remark"
  for line in 'comment TextureFile atlas.png' 'property float nx' 'property float quality' \
    'property int label' 'property list uchar float texcoord' 'property int texnumber' \
    'property uchar red' 'property int region'; do
    [ "$(grep -acx "$line" "$work/out.ply")" -eq 1 ] || fail "not one line '$line'"
  done
  run out.obj
  expect_remark 'not kept: .*TextureFile atlas.png.*quality.*label.*texnumber.*region'
fi
if has hard_edges_split.ply; then # split for normals only
  run out.off --ratio 0.3
  grep -q 'vertices welded to another at the same place: 196' "$work/stderr" || fail "no remark on what was welded"
  if grep -q 'cracks may open' "$work/stderr"; then fail "a seam is left"; fi
fi
for name in split_seam.off; do
  has $name || continue
  run out.off
  grep -q 'vertices welded to another at the same place: 117' "$work/stderr" || fail "the seam and the poles are not sewn"
  if grep -q 'cracks may open' "$work/stderr"; then fail "a remark on a seam that is none"; fi
  run again.off
  [ $status -eq 0 ] || fail "exit status $status"
done

echo "$checked runs, $failures failures"
[ "$checked" -gt 0 ] && [ "$failures" -eq 0 ]
