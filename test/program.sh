#!/bin/sh
# Runs the program quadrille over small meshes that it writes itself, and checks exit status, output
# and messages.
#
#   program.sh PROGRAM

program=$1
if [ $# -ne 1 ] || [ ! -x "$program" ]; then
  echo "usage: $0 PROGRAM" >&2
  exit 2
fi
case $program in /*) ;; *) program=$PWD/$program ;; esac
products=$(cd "$(dirname "$0")/../examples/products" && pwd)
parts_mk=$products/chunks/chunks.mk option_table=$products/option_table.py
# shellcheck source=sheet_gltf.sh
. "$(dirname "$0")/sheet_gltf.sh"

LC_ALL=C
export LC_ALL
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
cd "$work" || exit 2
failures=0

fail() { # message
  failures=$((failures + 1))
  echo "quadrille $arguments: $1"
  sed 's/^/    /' stdout stderr | head -n 6
}

run() { # expected status, arguments...
  expected=$1
  shift
  arguments=$*
  "$program" "$@" >stdout 2>stderr
  status=$?
  [ $status -eq "$expected" ] || fail "exit status $status instead of $expected"
}

expect() { # file, extended regular expression
  grep -qsE -- "$2" "$1" || fail "no match for '$2' in $1"
}

expect_faces() { # file.off, count
  set -- "$1" "$2" "$(sed -n 2p "$1" 2>/dev/null | cut -d' ' -f2)"
  [ "$3" = "$2" ] || fail "$3 faces instead of $2 in $1"
}

expect_ratio() { # file.off, count: that many faces or one less, since a ratio asks for no exact count
  set -- "$1" "$2" "$(sed -n 2p "$1" 2>/dev/null | cut -d' ' -f2)"
  [ "$3" = "$2" ] || [ "$3" = $(($2 - 1)) ] || fail "$3 faces instead of $2 in $1"
}

expect_nothing() { # file
  [ ! -s "$1" ] || fail "$1 is not empty"
}

# A bumpy sheet of 20 x 20 quadrilaterals with a colour and a texture coordinate at each vertex.
awk 'BEGIN {
  n = 20
  print "STCOFF\n" (n + 1) * (n + 1), n * n, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j)
    print i, j, sin(i * j / 9), 10 * i, 10 * j, 99, i / n, j / n
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j
    print 4, v, v + 1, v + n + 2, v + n + 1
  }
}' >sheet.off
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >tetrahedron.off
printf 'OFF\n1 0 0\n0 0 0\n' >point.off
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n3 2 2 2\n' >degenerate.off
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n' >lines.obj
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n' >nan.off
awk 'NR == 1 { print "OFF"; next } NF == 8 { print $1, $2, $3; next } { print }' sheet.off >plain.off

# Targets
run 0 plain.off out.off
expect stdout '^plain.off: 800 -> (400|399) faces \(50 %\), [0-9.]+ m?s, error about [0-9.]+ % of the diagonal$'
expect_nothing stderr
expect_ratio out.off 400
run 0 plain.off out.off --faces 100
expect_faces out.off 100
run 0 plain.off out.off --ratio 0.25
expect_ratio out.off 200
run 0 plain.off out.off --vertices 50
[ "$(sed -n 2p out.off | cut -d' ' -f1)" -le 50 ] || fail "more than 50 vertices"
run 0 plain.off out.off --ratio 1
expect_faces out.off 800
run 0 plain.off out.off --faces 5000
expect stdout ' of the diagonal: IN already meets the target$'
run 0 plain.off out.off --error 0.05
expect stdout ', no point of OUT is further than 0\.1[0-9]* % of the diagonal from IN$'
run 0 plain.off out.off --error 1e300
run 0 --quiet plain.off out.off
expect_nothing stdout

# The target is not reached
run 1 tetrahedron.off out.off
expect stderr '^out.off: the target was not reached: '
expect_faces out.off 4
run 1 --quiet tetrahedron.off out.off
expect_nothing stdout
expect stderr 'the target was not reached'

# Parts that are in the way of a target
awk 'BEGIN {
  print "OFF\n40 40 0"
  for (i = 0; i < 10; ++i) {
    s = i == 0 ? 1 : 0.1
    print 9 * i, 0, 0; print 9 * i + s, 0, 0; print 9 * i, s, 0; print 9 * i, 0, s
  }
  for (v = 0; v < 40; v += 4) {
    print 3, v, v + 2, v + 1; print 3, v, v + 1, v + 3
    print 3, v + 1, v + 2, v + 3; print 3, v + 2, v, v + 3
  }
}' >parts.off
run 1 parts.off out.off --faces 8
expect stderr '^out.off: 10 components are left, and each keeps some faces: --pairs'
expect_faces out.off 40
run 0 parts.off out.off --faces 8 --drop-parts
expect stdout '8 small components vanished, the largest of size 0\.21 % of the diagonal'
expect_nothing stderr
expect_faces out.off 8
expect out.off '^1 0 0'
run 0 parts.off out.off --faces 8 --drop-parts --topology kept --cost memoryless
# Of assets small parts may go by default
run 0 parts.off parts.ply --keep 100%
run 0 parts.off parts.obj --keep 100%
for parts in parts.ply parts.obj; do
  run 0 $parts out.off --faces 8
  expect stdout '8 small components vanished'
  expect_faces out.off 8
  run 1 $parts out.off --faces 8 --keep-parts
  expect stderr '^out.off: 10 components are left, and each keeps some faces: --pairs DISTANCE joins'
  if grep -q 'with --drop-parts' stderr; then fail "what vanishes there is far from what stays"; fi
  expect_faces out.off 40
  run 1 $parts out.off --faces 8 --topology kept
  expect_faces out.off 40
  run 2 $parts out.off --faces 8 --keep-parts --drop-parts
done
run 0 parts.off out.off --error 0.2 --drop-parts
expect stdout '9 small components vanished'
run 0 parts.off out.off --error 0.1 --drop-parts
expect_faces out.off 40
run 1 parts.off out.off --faces 0 --drop-parts
expect_faces out.off 4
expect stderr '^out.off: topology is kept$'
run 1 tetrahedron.off out.off
expect stderr '^out.off: topology is kept$'
run 2 parts.off out.off --drop-parts --topology free
expect stderr '^--drop-parts does not go with'

# Options are tried before they are named: forty tetrahedra lie close above a sheet
awk 'BEGIN {
  n = 10; parts = 40; print "OFF\n" (n + 1) ^ 2 + 4 * parts, 2 * n * n + 4 * parts, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, 0.05 * sin(i) * cos(j)
  for (p = 0; p < parts; ++p)
    for (k = 0; k < 4; ++k) {
      x = p % 8 + 1; y = int(p / 8) + 1
      print x + 0.05 * (k == 1), y + 0.05 * (k == 2), 0.05 * sin(x) * cos(y) + 0.03 + 0.05 * (k == 3)
    }
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j; w = v + n + 1
    print 3, v, w, w + 1; print 3, v, w + 1, v + 1
  }
  for (p = 0; p < parts; ++p) {
    v = (n + 1) ^ 2 + 4 * p
    print 3, v, v + 2, v + 1; print 3, v, v + 1, v + 3; print 3, v + 1, v + 2, v + 3; print 3, v + 2, v, v + 3
  }
}' >gravel.off
run 1 gravel.off out.off --faces 150
expect stderr '^out.off: with --drop-parts the result has 150 faces, error about [0-9.]* % .*small components vanished'
run 0 gravel.off out.off --faces 150 --drop-parts
# Labels of faces do not go with small parts by default, materials do
for number in label texnumber; do
  awk -v number=$number -v ground=$(((10 + 1) * (10 + 1))) 'NR == 2 {
    print "ply\nformat ascii 1.0\nelement vertex " $1 "\nproperty double x\nproperty double y\nproperty double z"
    print "element face " $2 "\nproperty list uchar int vertex_indices\nproperty int " number "\nend_header"
    points = $1
  }
  NR > 2 { print $0 (NR > points + 2 ? " " ($2 >= ground) : "") }' gravel.off >$number.ply
done
run 1 label.ply out.ply --faces 150
expect stderr '^out.ply: with --drop-parts the result has 150 faces, error about [0-9.]* % .*small components vanished'
run 0 label.ply out.ply --faces 150 --drop-parts
run 0 texnumber.ply out.ply --faces 150
expect stdout 'small components vanished'

# Files with nothing in them
printf 'OFF\n0 0 0\n' >none.off
printf '<!DOCTYPE html>\n<body>404: v 1.0</body>\n' >none.obj
printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >none.ply
printf 'solid nothing\nendsolid nothing\n' >none.stl
printf 'GOCAD TSurf 1\nHEADER {\nname: nothing\n}\nTFACE\nEND\n' >none.ts
for format in off obj ply stl ts; do
  cp plain.off out.$format
  run 2 none.$format out.$format
  expect stderr "^none.$format: nothing to simplify: it has 0 vertices.* and no face with three different vertices$"
  cmp -s plain.off out.$format || fail "out.$format has changed"
done
for options in '' '--pairs 1' '--cost memoryless' '--cost length' '--weld'; do
  # shellcheck disable=SC2086
  run 2 $options none.off out.off
done

# Costs, placements, topology, pairs
for cost in quadric memoryless thin-features color texture length; do
  run 0 --cost $cost --ratio 0.2 sheet.off out.off
  expect out.off '^STCOFF'
  expect_ratio out.off 160
  # colour and texture coordinate still are those of the place, within the size of a face
  awk 'NF == 8 { d = ($4 - 10 * $1) ^ 2 + ($5 - 10 * $2) ^ 2; t = ($7 - $1 / 20) ^ 2
                 if (d > 900 || t > 0.05) bad = 1; ++n } END { exit bad || n < 50 }' out.off ||
    fail "colours or texture coordinates have moved"
done
for placement in optimal endpoint midpoint; do
  run 0 --placement $placement plain.off out.off
  cp out.off $placement.off
done
cmp -s optimal.off endpoint.off && fail "endpoint is the same as optimal"
cmp -s optimal.off midpoint.off && fail "midpoint is the same as optimal"
run 0 --topology free --faces 1 tetrahedron.off out.off
run 0 --pairs 1.2 --boundary 0 plain.off out.off
run 0 --weld plain.off out.off
run 0 --cost length --placement endpoint plain.off out.off

# Attributes

expect_vertices() { # file.off, file.off: all vertices of the first are among those of the second
  vertices "$1" >new_vertices
  vertices "$2" >old_vertices
  [ -s new_vertices ] || fail "no vertices in $1"
  if grep -Fvxf old_vertices new_vertices >strange; then
    fail "vertices of $1 that are none of $2: $(head -n 1 strange)"
  fi
}
vertices() { # file.off
  awk 'NR == 2 { n = $1 } NR > 2 && NR <= 2 + n' "$1"
}

# A vertex that has not moved keeps all its values, and so does one that goes to another's place.
awk 'NF == 8 { print $1, $2, $3, $4 / 1000 + 1 / 3, $5 / 1000, 0.1, 0.25 + $1 / 100, $7 / 3, $8 / 7; next }
     { print }' OFMT=%.17g CONVFMT=%.17g sheet.off >fine.off
"$program" --quiet --ratio 1 fine.off fine_again.off || fail "fine.off"
for cost in '' '--cost quadric' '--cost memoryless' '--cost thin-features' '--cost color' \
  '--cost texture' '--cost length'; do
  # shellcheck disable=SC2086
  run 0 $cost --ratio 1 sheet.off out.off
  expect_vertices out.off sheet.off
  # shellcheck disable=SC2086
  run 0 $cost --ratio 0.2 --placement endpoint fine.off out.off
  expect_vertices out.off fine_again.off
done

# Sheets, each of one colour: 0 is red and 1 blue beside it with an edge at the same place, 2 and 3
# are the two sides of a card, 4 and 5 two curved sheets close to each other.
awk 'BEGIN {
  n = 12
  print "COFF\n" 6 * (n + 1) * (n + 1), 12 * n * n, 0
  for (s = 0; s < 6; ++s) for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) {
    x = i / n; y = j / n
    print x + (s == 1) + 3 * int(s / 2), y, (s > 3) * sin(3 * x) * cos(2 * y) + (s == 5) / 100,
          255 * (s % 2 == 0), 10 * s, 255 * (s % 2), 255 - s
  }
  for (s = 0; s < 6; ++s) for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = (n + 1) * ((n + 1) * s + i) + j
    a = s % 2 ? v + n + 1 : v + 1; b = s % 2 ? v + 1 : v + n + 1
    print 3, v, b, v + n + 2 "\n" 3, v, v + n + 2, a
  }
}' >sheets.off
# A vertex has the colour of the sheet that its face began in: the first two lie on either side of
# x = 1, where a cost knows of places, the others by their heights.
check_sheets='
  NR == 2 { n = $1; next }
  NR > 2 && NR <= 2 + n {
    sheet = $5 / 10
    if ($4 != 255 * (sheet % 2 == 0) || $6 != 255 * (sheet % 2) || $7 != 255 - sheet) bad = 1
    of[NR - 3] = sheet
    if (int(sheet / 2) != int(($1 + 0.5) / 3) && sheet != 1) bad = 1
    if (!slides && (sheet == 0 && $1 > 1.001 || sheet == 1 && $1 < 0.999)) bad = 1
  }
  NR > 2 + n { if (of[$2] != of[$3] || of[$3] != of[$4]) bad = 1; ++faces[of[$2]] }
  END { for (s = 0; s < 6; ++s) if (!faces[s]) bad = 1; exit bad || n == 0 }'
for cost in '' '--cost quadric' '--cost memoryless' '--cost thin-features' '--cost color' \
  '--cost length'; do
  for ratio in 1 0.5 0.1; do
    # shellcheck disable=SC2086
    run 0 $cost --ratio $ratio sheets.off out.off
    awk -v slides="${cost#"${cost%length}"}" "$check_sheets" out.off || fail "colours of other sheets"
  done
done

# Two triangles without a common vertex are one surface, and each keeps its colour.
printf 'COFF\n6 2 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n1 0 0 0 0 255\n1 1 0 0 0 255\n0 1 0 0 0 255
3 0 1 2\n3 3 4 5\n' >loose.off
run 0 --ratio 1 loose.off out.off
expect stderr '^loose.off: vertices merged with another one at the same place: 2$'
[ "$(vertices out.off | sort)" = "$(vertices loose.off | sort)" ] || fail "other vertices"
run 0 --ratio 1 --weld loose.off out.off
[ "$(vertices out.off | sort)" = "$(vertices loose.off | sort)" ] || fail "other vertices"

# A sphere of two halves, each with vertices of its own along the cut.
awk 'BEGIN {
  n = 24; m = 8; pi = atan2(0, -1)
  print "OFF\n" 2 * (n * m + 1), 2 * n * (2 * m - 1), 0
  for (h = 1; h > -2; h -= 2) {
    for (j = 0; j < m; ++j) for (i = 0; i < n; ++i) {
      a = 2 * pi * i / n; b = pi / 2 * j / m
      print cos(a) * cos(b), sin(a) * cos(b), h * sin(b)
    }
    print 0, 0, h
  }
  for (h = 0; h < 2; ++h) for (j = 0; j < m; ++j) for (i = 0; i < n; ++i) {
    o = h * (n * m + 1); a = o + j * n + i; b = o + j * n + (i + 1) % n
    if (j == m - 1) print h ? 3 " " b " " a " " o + n * m : 3 " " a " " b " " o + n * m
    else print h ? 3 " " b " " a " " b + n "\n" 3 " " a " " a + n " " b + n : \
                   3 " " a " " b " " b + n "\n" 3 " " a " " b + n " " a + n
  }
}' >halves.off
run 0 halves.off out.off
expect stderr '^halves.off: vertices merged with another one at the same place: 24$'
[ "$(wc -l <stderr)" -eq 1 ] || fail "more than one remark"
run 0 out.off again.off
expect_nothing stderr
# A closed surface has no odd number of faces: to pass the target by one is no failure.
run 0 --weld --faces 101 halves.off out.off
expect_faces out.off 100

# Units of colours
printf 'COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n' >zero_one.off
run 0 --ratio 1 zero_one.off out.off
expect stderr '^zero_one.off: colours that are all 0 or 1 are taken as fractions$'
expect out.off '^1 0 0 0\.0 1\.0 0\.0 1\.0$'
printf 'COFF\n3 1 0\n0 0 0 .5 .5 .5\n1 0 0 .9 .9 .9\n0 1 0 1.0001 .5 .5\n3 0 1 2\n' >above_one.off
run 0 --ratio 1 above_one.off out.off
expect stderr '^above_one.off: colours are taken as fractions; values above 1.*: 1$'
expect out.off '^0 1 0 1\.0001 0\.5 0\.5$'

# What a file has and the result has not is told in one line, and only then.
printf 'mtllib a.mtl\nusemtl b\ng c\ns 1\nvn 0 0 1\nv 0 0 0 .2 .4 .6 .5\nv 1 0 0 .2 .4 .6 .5\nv 0 1 0 .2 .4 .6 .5
f 1//1 2//1 3//1\n' >materials.obj
run 0 --ratio 1 materials.obj out.obj
expect_nothing stderr
printf '# 3 vertices, 1 faces\nmtllib a.mtl\nv 0 0 0 0.2 0.4 0.6 0.5\nv 1 0 0 0.2 0.4 0.6 0.5
v 0 1 0 0.2 0.4 0.6 0.5\nvn 0 0 1\ng c\nusemtl b\ns 1\nf 1//1 2//1 3//1\n' | cmp -s - out.obj ||
  fail "an OBJ file has changed"
run 0 --ratio 1 out.obj out.ply
expect stderr '^out.obj: not kept: material libraries \(mtllib\), materials \(usemtl\), groups, smoothing groups$'
[ "$(wc -l <stderr)" -eq 1 ] || fail "more than one remark"
run 0 --ratio 1 out.ply again.obj
grep '^v ' out.obj >old
grep '^v ' again.obj | cmp -s - old || fail "colours have changed in a PLY file"
for format in stl ts; do
  run 0 --ratio 1 fine.off out.$format
  expect stderr '^fine.off: not kept: colours, texture coordinates$'
  [ "$(wc -l <stderr)" -eq 1 ] || fail "more than one remark"
done
run 0 --quiet materials.obj out.obj
expect_nothing stderr

# A bumpy sheet of four parts: two materials left and right of a ridge, each a chart of the texture
# and smooth by itself, in two groups each, which the texture and the normals do not know.
awk 'function height(x, y) { return sin(x / 3) * cos(y / 4) + (x < 10 ? x : 20 - x) / 2 }
  function normal(x, y, side) { print "vn", -cos(x / 3) / 3 * cos(y / 4) - side / 2, sin(x / 3) * sin(y / 4) / 4, 1 }
  BEGIN {
  n = 20
  print "mtllib red.mtl blue.mtl\no sheet"
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) {
    print "v", i, j, height(i, j), i / 20, j / 20, 0.5
    print "vt", i / 20, j / 20 "\nvt", 2 - i / 10, j / 30
    normal(i, j, 1); normal(i, j, -1)
  }
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    if (j % 10 == 0) print "usemtl", i < 10 ? "red" : "light blue", "\ng", j < 10 ? "front" : "back"
    v = i * (n + 1) + j + 1; s = i < 10
    printf "f"
    for (k = 0; k < 4; ++k) {
      c = k == 0 ? v : k == 1 ? v + n + 1 : k == 2 ? v + n + 2 : v + 1
      printf " %d/%d/%d", c, 2 * c - s, 2 * c - s
    }
    print ""
  }
}' >parts.obj
# The texture coordinates of a corner still are those of its place on its side, its normal points the
# same way, and vertices are one at each place, with its colour. Faces are with their parts. Costs that know no creases
# do not hold the borders between groups, which the surface does not show, and --cost length not the
# ridge either: there texture coordinates stay on the border while the vertex moves.
check_chunks='
  function abs(x) { return x < 0 ? -x : x }
  $1 == "v" {
    x[++v] = $2; y[v] = $3
    if (at[$2, $3, $4]++) bad = "two vertices at a place"
    if (abs($5 - $2 / 20) > far || abs($6 - $3 / 20) > far || $7 != 0.5) bad = "a colour has moved: " $0
  }
  $1 == "vt" { s[++t] = $2; u[t] = $3 }
  $1 == "vn" { nx[++n] = $2; ny[n] = $3; nz[n] = $4 }
  $1 == "mtllib" || $1 == "o" { head = head $0 ";" }
  $1 == "g" { group = $2 }
  $1 == "usemtl" { material = $2 }
  $1 == "f" {
    ++faces[material, group]
    for (k = 2; k <= 4; ++k) {
      split($k, c, "/")
      p = c[1]; q = c[2]; r = c[3]; red = material == "red"
      if (abs(s[q] - (red ? x[p] / 20 : 2 - x[p] / 10)) > far || abs(u[q] - y[p] / (red ? 20 : 30)) > far)
        bad = "a texture coordinate has moved: " $0
      if (red ? x[p] > 10 + slip : x[p] < 10 - slip) bad = "a material has moved: " $0
      if (knows_creases && (group == "front" ? y[p] > 10 + slip : y[p] < 10 - slip)) bad = "a group has moved: " $0
      a = -cos(x[p] / 3) / 3 * cos(y[p] / 4) - (red ? 1 : -1) / 2; b = sin(x[p] / 3) * sin(y[p] / 4) / 4
      if (r < 1 || a * nx[r] + b * ny[r] + nz[r] < 0.9 * sqrt((a * a + b * b + 1) * (nx[r] ^ 2 + ny[r] ^ 2 + nz[r] ^ 2)))
        bad = "a normal has turned: " $0
    }
  }
  END {
    if (head != "mtllib red.mtl blue.mtl;o sheet;") bad = "another head: " head
    if (!faces["red", "front"] || !faces["red", "back"] || !faces["light", "front"] || !faces["light", "back"])
      bad = "a part is gone"
    if (bad) { print bad; exit 1 }
  }'
for cost in '' '--cost quadric' '--cost memoryless' '--cost thin-features' '--cost texture' \
  '--cost color' '--cost length'; do
  far=0.02 slip=0.3 knows_creases=1
  case $cost in *memoryless | *thin-features | *length) far=0.07 knows_creases=0 ;; esac
  case $cost in *length) slip=1 ;; esac
  for ratio in 1 0.5 0.2; do
    # shellcheck disable=SC2086
    run 0 $cost --ratio $ratio parts.obj out.obj
    expect_nothing stderr
    wrong=$(awk -v far=$far -v slip=$slip -v knows_creases=$knows_creases "$check_chunks" out.obj) || fail "$wrong"
  done
done
run 0 --error 0.1 parts.obj out.obj
wrong=$(awk -v far=0.02 -v slip=0.3 -v knows_creases=1 "$check_chunks" out.obj) || fail "$wrong"

# A material file that only IN has in its folder
mkdir elsewhere
printf 'newmtl b\n' >elsewhere/a.mtl
printf 'mtllib a.mtl\nusemtl b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >elsewhere/a.obj
run 0 --keep 100% elsewhere/a.obj out.obj
expect stderr "^elsewhere/a.obj: OUT refers to the material file 'a.mtl', which is not in its folder: copy it there with its images$"
for quiet in 'elsewhere/a.obj elsewhere/out.obj' 'elsewhere/a.obj out.off' 'parts.obj elsewhere/out.obj'; do
  # shellcheck disable=SC2086
  run 0 --keep 100% $quiet
  ! grep -q 'refers to the material' stderr || fail "a remark of material files"
done
rm -r elsewhere

run 0 --ratio 0.2 parts.obj out.off
expect stderr '^parts.obj: not kept: normals, material libraries \(mtllib\), materials \(usemtl\), objects, groups$'
expect_ratio out.off 160
# Each face has one of the two charts, and both sides of the ridge have vertices of their own.
awk 'NR == 2 { n = $1; next }
  NR > 2 && NR <= 2 + n {
    red = ($7 - $1 / 20) ^ 2 + ($8 - $2 / 20) ^ 2 < 0.0004; blue = ($7 - 2 + $1 / 10) ^ 2 + ($8 - $2 / 30) ^ 2 < 0.0004
    side[NR - 3] = red && !blue ? 1 : blue && !red ? 2 : 0
    if (!red && !blue) bad = 1
  }
  NR > 2 + n { a = side[$2]; b = side[$3]; c = side[$4]
               if (a && b && a != b || b && c && b != c || c && a && c != a) bad = 1 }
  END { exit bad || !n }' out.off || fail "texture coordinates have moved"

# The same sheet as PLY of all there is, of two pictures and two labels: written again it is the same,
# and what it becomes has all of it. As OBJ it has the same texture coordinates.
awk 'BEGIN { print "ply\nformat ascii 1.0\ncomment TextureFile red.png\ncomment TextureFile blue.png" }
  $1 == "v" { v[++n] = $2 " " $3 " " $4 " " 200 * $5 " " 200 * $6 " 99 " $2 / 7 " " ($2 < 10 ? 5 : 6) }
  $1 == "vt" { t[++m] = $2 " " $3 }
  $1 == "usemtl" { picture = $2 == "red" ? 0 : 1 }
  $1 == "g" { label = $2 == "front" ? -3 : 9 }
  $1 == "f" {
    for (k = 2; k <= 5; ++k) { split($k, c, "/"); p[k] = c[1] - 1; q[k] = t[c[2]] }
    f[++l] = "4 " p[2] " " p[3] " " p[4] " " p[5] " 8 " q[2] " " q[3] " " q[4] " " q[5] " " picture " " label
  }
  END {
    print "element vertex", n "\nproperty double x\nproperty double y\nproperty double z"
    print "property uchar red\nproperty uchar green\nproperty uchar blue"
    print "property float quality\nproperty int label"
    print "element face", l "\nproperty list uchar int vertex_indices"
    print "property list uchar float texcoord\nproperty int texnumber\nproperty short label\nend_header"
    for (i = 1; i <= n; ++i) print v[i]
    for (i = 1; i <= l; ++i) print f[i]
  }' parts.obj >parts.ply
check_textures='
  function abs(x) { return x < 0 ? -x : x }
  $1 == "v" { x[++v] = $2; y[v] = $3 }
  $1 == "vt" { s[++t] = $2; u[t] = $3 }
  $1 == "f" {
    for (k = 2; k <= 4; ++k) {
      split($k, c, "/"); p = c[1]; q = c[2]
      red = abs(s[q] - x[p] / 20) < 0.07 && abs(u[q] - y[p] / 20) < 0.07
      blue = abs(s[q] - 2 + x[p] / 10) < 0.07 && abs(u[q] - y[p] / 30) < 0.07
      if (!red && !blue) { print "a texture coordinate has moved: " $0; exit 1 }
    }
  }'
for cost in '' '--cost quadric' '--cost memoryless' '--cost thin-features' '--cost texture' \
  '--cost color' '--cost length'; do
  for ratio in 1 0.5 0.2; do
    # shellcheck disable=SC2086
    run 0 $cost --ratio $ratio parts.ply out.ply
    expect_nothing stderr
    for line in 'comment TextureFile red.png' 'comment TextureFile blue.png' 'property uchar red' \
      'property float quality' 'property int label' 'property list uchar float texcoord' \
      'property int texnumber' 'property short label'; do
      [ "$(grep -acx "$line" out.ply)" -eq 1 ] || fail "not one line '$line'"
    done
    run 0 --ratio 1 out.ply again.ply
    cmp -s out.ply again.ply || fail "another file when it is written again"
    run 0 --ratio 1 out.ply out.obj
    expect stderr "^out.ply: not kept: comment 'TextureFile red.png', comment 'TextureFile blue.png', vertex property 'quality', vertex property 'label', face property 'texnumber', face property 'label'$"
    wrong=$(awk "$check_textures" out.obj) || fail "$wrong"
  done
done

# Levels of detail: each is what a run of its own gives, and OUT itself is not written
expect_same() { # file, file
  cmp -s "$1" "$2" || fail "$1 and $2 differ"
}
mkdir folder_of_levels
for input in plain.off sheet.off parts.obj parts.ply; do
  extension=${input##*.}
  out=folder_of_levels/a.b.$extension
  run 0 $input $out --levels 50%,25%,100
  [ "$(grep -c ': 800 -> .* in folder_of_levels/a.b-[123]' stdout)" -eq 3 ] || fail "no line for each level"
  [ ! -e $out ] || fail "$out is written"
  level=1
  for target in '--ratio 0.5' '--ratio 0.25' '--faces 100'; do
    # shellcheck disable=SC2086
    run 0 $target $input one.$extension
    expect_same one.$extension folder_of_levels/a.b-$level.$extension
    level=$((level + 1))
  done
done
run 2 --format off plain.off - --levels 50%,25%
expect stderr '^-: --levels writes a file for each level, so OUT cannot be standard output$'
for list in 50%,50% 25%,50% 100,200 50%,400 ,50% 50%, 50%,,25% 110% -1 x 5.5 nan% % 50%,x; do
  run 2 plain.off bad.off --levels $list
  expect stderr .
done
run 2 plain.off bad.off --levels ''
run 2 plain.off bad.off --levels 50%,400
expect stderr '^--levels: 400 is not coarser than 50% before it \(IN has 800 faces\)$'
run 2 plain.off bad.off --levels error=1%,error=0.5%
expect stderr '^--levels: error=0.5% is not coarser than error=1% before it'
run 2 plain.off bad.off --levels 50%,error=1%
expect stderr '^--levels: error=1% is not of the same kind as 50% before it'
run 0 plain.off far.off --levels error=0.5%,error=5% --verify
expect stdout '^far-1.off: verified: distance of the result from the input: .* promised'
expect stdout '^far-2.off: verified: distance of the result from the input: .* promised'
run 2 plain.off bad.off --tolerance q --error 1
expect stderr '^--tolerance: does not go with --error: both limit'
run 2 --from r.qlv bad.off --verify
expect stderr '^--from: does not go with --verify: a record does not contain IN'
run 2 plain.off bad.off --levels 50% --faces 10
cp plain.off bad-2.off
chmod 444 bad-2.off
run 2 plain.off bad.off --levels 50%,25%
expect stderr '^bad-2.off: is read-only; --force replaces it$'
[ "$(echo bad*.off)" = bad-2.off ] || fail "files are written: $(echo bad*.off)"
run 0 --force plain.off bad.off --levels 50%,25%
expect_ratio bad-2.off 200
run 1 tetrahedron.off few.off --levels 100%,50%
expect stderr '^few-2.off: the target was not reached: '
expect_faces few-1.off 4
expect_faces few-2.off 4
run 2 none.off empty.off --levels 50%,25%
[ ! -e empty-1.off ] || fail "a level of nothing is written"

# Records: a run that is recorded gives the same, and the record has its levels
for options in '' '--cost quadric --boundary 7' '--cost memoryless' '--cost thin-features' \
  '--cost length' '--placement endpoint' '--placement midpoint' '--pairs 1.2' \
  '--cost memoryless --topology free'; do
  # shellcheck disable=SC2086
  run 0 $options --ratio 0.1 plain.off expected.off
  # shellcheck disable=SC2086
  run 0 $options --ratio 0.1 --record record.qlv plain.off out.off
  expect_nothing stderr
  expect_same out.off expected.off
  for target in '--ratio 0.1' '--ratio 0.4' '--vertices 150' '--faces 800'; do
    # shellcheck disable=SC2086
    run 0 $options $target plain.off expected.off
    # shellcheck disable=SC2086
    run 0 --from record.qlv out.off $target
    expect stdout '^record.qlv: 800 -> [0-9]+ faces'
    expect_same out.off expected.off
  done
done
run 0 --from record.qlv - --format off --faces 800
expect_same stdout expected.off
expect stderr '^record.qlv: 800 -> 800 faces'
expect stderr ', (error about|no point of OUT is further than) [0-9.e-]+ in units of the mesh( from IN(, and no point of IN further than that from OUT)?)?$'
run 1 --from record.qlv out.off --faces 3
expect stderr '^out.off: the target was not reached: no pair left$'
expect_ratio out.off 80

# With attributes the record has the positions of the same run
positions() { # file.off
  awk 'NR == 2 { n = $1 } NR > 2 { print $1, $2, $3, (NR > 2 + n ? $4 : "") }' "$1"
}
for options in '' '--cost quadric' '--cost memoryless' '--cost thin-features' '--cost color' \
  '--cost texture' '--cost length'; do
  for input in fine.off parts.obj; do
    # shellcheck disable=SC2086
    run 0 $options --ratio 0.2 $input expected.${input##*.}
    # shellcheck disable=SC2086
    run 0 $options --ratio 0.2 --record record.qlv $input out.${input##*.}
    expect stderr "^$input: the record contains positions only$"
    expect_same out.${input##*.} expected.${input##*.}
    run 0 --from record.qlv from.off --ratio 0.2
    [ $input != fine.off ] || [ "$(positions from.off)" = "$(positions out.off)" ] || fail "other positions"
    run 0 --from record.qlv from.off --ratio 1
    expect_faces from.off 800
  done
done
run 0 --drop-parts --faces 60 sheets.off expected.off
run 0 --drop-parts --faces 60 --record record.qlv sheets.off out.off
expect_same out.off expected.off
run 0 --from record.qlv from.off --faces 60
places() { # file.off: each once, though OUT has a vertex for each side of a seam
  awk 'NR == 2 { n = $1 } NR > 2 && NR <= 2 + n { print $1, $2, $3 }' "$1" | sort -u
}
[ "$(places from.off)" = "$(places out.off)" ] || fail "other positions"
run 0 --record record.qlv parts.ply out.ply
expect stderr '^parts.ply: the record contains positions only$'

# Distances are in the record of a run that asks for them
run 2 --from record.qlv out.off --error 0.1
expect stderr '^record.qlv: the record contains no distances for --error'
run 0 --error 0.05 plain.off expected.off
run 0 --error 0.05 --record record.qlv plain.off out.off
expect_same out.off expected.off
run 0 --from record.qlv out.off --error 0.05
expect stdout ', no point of OUT is further than 0\.0([0-4][0-9]*|5) in units of the mesh from IN$'
expect_same out.off expected.off
run 0 --from record.qlv out.off --error 0.01
expect stdout ', no point of OUT is further than 0\.00'
cmp -s out.off expected.off && fail "no finer level"
run 0 --from record.qlv out.off --error 0
run 2 --record other.qlv none.off out.off
[ ! -e other.qlv ] || fail "a record of nothing is written"

# Bad records
run 0 --ratio 0.1 --record record.qlv plain.off out.off
cp plain.off out.off
head -c 900 record.qlv >cut.qlv
{ head -c 100 record.qlv; printf '\377\377\377\377'; tail -c +105 record.qlv; } >damaged.qlv
for bad in cut.qlv damaged.qlv plain.off missing.qlv; do
  run 2 --from $bad out.off --faces 700
  expect stderr "^$bad: not a file of levels, or a damaged one: "
  expect_nothing stdout
done
for bad in '--from record.qlv plain.off out.off' '--from record.qlv --cost quadric out.off' \
  '--from record.qlv --levels 50% out.off' '--from record.qlv --weld out.off' '--from record.qlv' \
  '--from record.qlv --drop-parts out.off' \
  '--from record.qlv out.glb' '--from record.qlv out.off --out-format gltf' \
  '--record new.qlv --levels 50% plain.off out.off' '--record - plain.off out.off' \
  '--record out.off plain.off out.off' '--record missing/record.qlv plain.off out.off' \
  '--record new.qlv --faces 10 point.off out.off'; do
  # shellcheck disable=SC2086
  run 2 $bad
  expect stderr .
  expect_nothing stdout
  expect_same out.off plain.off
done
[ ! -e new.qlv ] || fail "a record is written"
chmod 444 record.qlv
run 2 --record record.qlv plain.off out.off
expect stderr '^record.qlv: is read-only; --force replaces it$'
expect_same out.off plain.off

# Standard input and output
run 0 plain.off expected.off
for names in '- -' '- /dev/stdout' '/dev/stdin -' '/dev/stdin /dev/stdout'; do
  # shellcheck disable=SC2086
  cat plain.off | "$program" --format off $names 2>stderr | cat >stdout
  arguments=$names
  cmp -s stdout expected.off || fail "another result"
  expect stderr '^-?.*: 800 -> (400|399) faces'
done
"$program" --format off --out-format ply - - <fine.off 2>stderr >out.ply
"$program" --quiet fine.off expected.ply
cmp -s out.ply expected.ply || fail "another result as PLY"
"$program" --quiet --format ply - - <out.ply >again.ply 2>stderr
expect_nothing stderr
run 0 --quiet out.ply expected.ply
cmp -s again.ply expected.ply || fail "another result from PLY"
run 2 - out.off
expect stderr '^-: (its name does not show its format: pass --format|the file is empty)$'
run 2 plain.off -
expect stderr '^-: its name does not show its format: pass --format$'
run 2 --format xyz plain.off -
cp plain.off plain
run 0 --format off plain out
cmp -s out expected.off || fail "another result"
if [ -c /dev/full ]; then
  "$program" --format off plain.off - >/dev/full 2>stderr
  [ $? -eq 2 ] || fail "no complaint about a full device"
  expect stderr '^-: cannot be written in full$'
fi

# Bad usage
cp plain.off out.off
for bad in '' 'plain.off' 'plain.off out.off more' '--faces 1 --levels 50% plain.off out.off' \
  '--faces -1 plain.off out.off' '--faces 1.5 plain.off out.off' '--vertices x plain.off out.off' \
  '--error -1 plain.off out.off' '--error x% plain.off out.off' '--keep 101% plain.off out.off' '--boundary firm plain.off out.off' \
  '--crease 181 plain.off out.off' '--threads 2 plain.off out.off' '--quiet --verbose plain.off out.off' '--ratio 1.5 plain.off out.off' '--ratio nan plain.off out.off' '--cost gold plain.off out.off' \
  '--boundary -1 plain.off out.off' '--pairs inf plain.off out.off' \
  '--placement optimal --cost length plain.off out.off' '--cost color plain.off out.off' \
  '--cost texture plain.off out.off' '--unknown plain.off out.off'; do
  # shellcheck disable=SC2086
  run 2 $bad
  expect_nothing stdout
  expect stderr .
  cmp -s plain.off out.off || fail "out.off has changed"
done
expect_usage_error() { # message, arguments...
  message=$1
  shift
  run 2 "$@"
  expect stderr "$message"
}
expect_usage_error '^there is no option --face; did you mean --faces\?$' --face 9 plain.off out.off
expect_usage_error '^there is no option --kep; did you mean --keep\?$' plain.off out.off --kep=10%
expect_usage_error '^there is no option --unknown; --help lists all options$' --unknown plain.off out.off
expect_usage_error "^'25%': unexpected argument; did you mean --keep 25%\? Separate the items of a list by commas$" \
  plain.off out.off --levels 50% 25%
expect_usage_error "'10%' is not a count; --keep takes a fraction of the faces$" --faces 10% plain.off out.off
expect_usage_error "'5mm' is not a distance, which is a number in the units of IN" --error 5mm plain.off out.off
expect_usage_error "'1k' is not a count in digits only: did you mean 1000\?$" --faces 1k plain.off out.off
expect_usage_error "'1,500' is not a count in digits only: did you mean 1500\?$" --vertices 1,500 plain.off out.off
expect_usage_error "--seams: 'keep' is not one of kept, soft, priced, free$" --seams keep plain.off out.off
expect_usage_error '^there is no option --reduction; --keep takes' plain.off out.off --reduction 0.9
expect_usage_error '^there is no option --quite; did you mean --quiet\?$' plain.off out.off --quite
expect_usage_error '^there is no option --xost; did you mean --cost\?$' plain.off out.off --xost quadric
expect_usage_error "^'100': unexpected argument; did you mean --faces 100\?$" plain.off out.off 100
expect_usage_error "^'c.off': unexpected argument after IN and OUT; --into FOLDER simplifies several files$" plain.off out.off c.off
run 2 plain.off out.off --pairs 1000
expect stderr '^plain.off: about [0-9]+ pairs of vertices are closer than 1000, more than the limit of 64 per vertex$'
run 0 --help
expect stdout '--keep'

# IN and OUT by options, short ones, and other names for values
run 0 plain.off one.off --cost memoryless --seams soft
for words in '-i plain.off -o out.off' 'plain.off -o out.off' '-o out.off plain.off' '--input plain.off out.off' \
  '--output out.off --keep 50% plain.off'; do
  # shellcheck disable=SC2086
  run 0 $words --cost memoryless_quadric --seams SOFT
  cmp -s one.off out.off || fail "another result"
done
run 0 plain.off out.off -q
expect_nothing stdout
run 0 plain.off out.off -v
expect stdout 'contractions, stopped'
run 0 -V
expect stdout '^[0-9]+\.[0-9]+\.[0-9]+$'

# Several files
cp plain.off second.off
run 0 plain.off second.off sheet.off --keep 25% --into results/new
[ "$(grep -c ' -> ' stdout)" -eq 3 ] || fail "no line for each file"
for file in plain second sheet; do expect_ratio results/new/$file.off 200; done
run 2 plain.off missing.off sheet.off --keep 10% --into results/new
expect stderr '^missing.off: '
expect_ratio results/new/sheet.off 80
run 0 plain.off --into results --out-format ply
[ -s results/plain.ply ] || fail "no PLY"
run 2 plain.off second.off --into .
expect stderr '^plain.off: it is in the folder of --into, so its result would replace it$'
run 2 plain.off results/new/plain.off --into results
expect stderr '^results/new/plain.off: two results would be written to results/plain.off$'
run 2 plain.off second.off --into results --report report.json
expect stderr '^--into writes several results'

# A part of two faces is left alone, unless fewer faces are asked for.
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >quad.off
run 1 quad.off out.off
expect_faces out.off 2
expect stderr '^out.off: components of two faces are kept by default: --faces or --keep asks for fewer$'
run 0 quad.off out.off --faces 1
expect_faces out.off 1
printf 'v 9 9 0\nv 10 9 0\nv 10 10 0\nv 9 10 0\n' >quad_and_box.obj
printf 'f 1 2 3 4\n' >>quad_and_box.obj
awk 'NR == 2 { n = $1; next } NR > 2 && NR <= 2 + n { print "v", $1, $2, $3 } NR > 2 + n { print "f", $2 + 5, $3 + 5, $4 + 5 }' \
  halves.off >>quad_and_box.obj
run 0 quad_and_box.obj out.obj
expect stdout ': 722 -> 362 faces '
grep -cE '^v (9|10) (9|10) 0$' out.obj | grep -q '^4$' || fail "a part of two faces is not as it was"

# Nothing to simplify
cp plain.off out.off
for bad in point.off lines.obj degenerate.off; do
  run 2 $bad out.off
  expect_nothing stdout
  expect stderr "^$bad: nothing to simplify: it has [13] vertices(, lines)? and no face with three different vertices$"
  cmp -s plain.off out.off || fail "out.off has changed"
done

# Bad files
run 2 nan.off out.off
expect stderr '^nan.off: vertex 2, counted from 0, is not finite$'
cmp -s plain.off out.off || fail "out.off has changed"
run 2 missing.off out.off
expect stderr '^missing.off: no such file$'
run 2 plain.off out.xyz
expect stderr "^out.xyz: the extension '.xyz' is not one of"
run 2 plain.off missing/out.off
expect stderr '^missing/out.off: there is no folder missing$'
run 2 . out.off
expect stderr '^\.: (is a folder|not a regular file)$'
run 2 plain.off .

# Where the result goes

mode_of() { # file
  # shellcheck disable=SC2012 # the names are plain
  ls -ldL "$1" | cut -c1-10
}
expect_mode() { # file, mode
  [ "$(mode_of "$1")" = "$2" ] || fail "the mode of $1 is $(mode_of "$1") instead of $2"
}

umask 022
rm -f new.off
run 0 plain.off new.off
expect_mode new.off -rw-r--r--
for mode in 600 640 664 755; do
  cp plain.off out.off
  chmod $mode out.off
  before=$(mode_of out.off)
  run 0 plain.off out.off
  expect_mode out.off "$before"
  expect_ratio out.off 400
done

mkdir -p links
cp plain.off target.off
ln -s ../target.off links/link.off
ln -s links/link.off link.off
ln -s new_target.off dangling.off
ln -s loop.off loop.off
run 0 plain.off link.off
[ -L link.off ] && [ -L links/link.off ] || fail "a link is gone"
expect_ratio target.off 400
run 0 plain.off dangling.off
[ -L dangling.off ] || fail "a link is gone"
expect_ratio new_target.off 400
run 2 plain.off loop.off
expect stderr '^loop.off: '

cp plain.off read_only.off
chmod 444 read_only.off
run 2 plain.off read_only.off
expect stderr '^read_only.off: is read-only; --force replaces it$'
cmp -s plain.off read_only.off || fail "read_only.off has changed"
ln -s read_only.off to_read_only.off
run 2 plain.off to_read_only.off
run 0 --force plain.off read_only.off
expect_ratio read_only.off 400
expect_mode read_only.off -r--r--r--

run 0 --format off plain.off /dev/null
[ -c /dev/null ] || fail "/dev/null is gone"
mkfifo pipe
cat pipe >got &
run 0 --format off plain.off pipe
wait $!
cmp -s got expected.off || fail "another result through a pipe"
cat plain.off >pipe &
run 0 --format off pipe out.off
cmp -s out.off expected.off || fail "another result from a pipe"
run 2 plain.off links --format off
expect stderr '^links: is a folder$'

# Files that may be no larger than a few blocks: what does not fit leaves the file as it was.
(
  trap '' XFSZ
  ulimit -f 4
  "$program" --ratio 1 plain.off big.off 2>stderr
)
[ $? -eq 2 ] || fail "a file larger than allowed"
expect stderr '^big.off: cannot be written in full$'
[ ! -e big.off ] || fail "a part of a file is left"

# A user who may write the file but not its folder. Root may do anything, so nobody tries instead.
as_user=
[ "$(id -u)" -ne 0 ] || as_user='setpriv --reuid=65534 --regid=65534 --clear-groups'
mkdir folder
printf 'OFF\n0 0 0\n' >folder/mine.off
cp folder/mine.off folder/small.off
chmod 600 folder/*.off
printf 'OFF\n0 0 0\n' >folder/other.off
chmod 444 folder/other.off
if [ -n "$as_user" ]; then
  chmod 755 "$work"
  chmod 644 folder/other.off
  chown 65534:65534 folder/mine.off folder/small.off 2>/dev/null || as_user=false
fi
chmod 555 folder
if $as_user "$program" --help >/dev/null 2>&1; then
  arguments='as another user'
  inode=$(ls -i folder/mine.off)
  $as_user "$program" plain.off folder/mine.off >stdout 2>stderr || fail "not written in place"
  expect_ratio folder/mine.off 400
  expect_mode folder/mine.off -rw-------
  [ "$(ls -i folder/mine.off)" = "$inode" ] || fail "another file"
  $as_user "$program" plain.off folder/other.off >stdout 2>stderr
  [ $? -eq 2 ] || fail "another user's file was written"
  expect stderr '^folder/other.off: is read-only; --force replaces it$'
  $as_user "$program" plain.off folder/new.off >stdout 2>stderr
  [ $? -eq 2 ] || fail "a new file in a folder that takes none"
  expect stderr '^folder/new.off: cannot be opened for writing$'
  cp folder/small.off old.off
  (
    trap '' XFSZ
    ulimit -f 4
    $as_user "$program" --ratio 1 plain.off folder/small.off >/dev/null 2>stderr
  )
  [ $? -eq 2 ] || fail "a file larger than allowed"
  cmp -s folder/small.off old.off || fail "a file is left half written"
  if [ -n "$as_user" ]; then
    chmod 755 folder
    run 0 plain.off folder/mine.off
    # shellcheck disable=SC2012
    [ "$(ls -ln folder/mine.off | awk '{ print $3, $4 }')" = '65534 65534' ] || fail "another owner"
    expect_mode folder/mine.off -rw-------
  fi
else
  echo "skipped: there is no other user"
fi
chmod 755 folder
if [ -n "$(find . -name '*.part*')" ]; then fail "temporary files are left"; fi

# Several targets: the first that is met ends the run
run 0 plain.off out.off --faces 100 --vertices 300
[ "$(sed -n 2p out.off | cut -d' ' -f1)" -eq 300 ] || fail "not 300 vertices"
run 0 plain.off out.off --faces 500 --vertices 3
expect_faces out.off 500
run 0 plain.off out.off --keep 10% --faces 500
expect_faces out.off 500
run 0 plain.off out.off --keep 25%
cp out.off quarter.off
run 0 plain.off out.off --ratio 0.25
cmp -s out.off quarter.off || fail "25% and 0.25 are not the same"
run 0 plain.off out.off --error 0.5% --faces 2
expect stdout ', no point of OUT is further than 0\.(50?|[0-4][0-9]*) % of the diagonal from IN$'
run 0 plain.off out.off --error 1 --faces 500
expect_faces out.off 500

# The pass order, with any number of threads
run 0 plain.off relaxed.off --order relaxed --threads 1 --keep 20%
expect_ratio relaxed.off 160
run 0 plain.off out.off --order relaxed --keep 20%
cmp -s out.off relaxed.off || fail "another result with other threads"
run 0 plain.off out.off --keep 20%
cmp -s out.off relaxed.off && fail "the orders are the same"
for input in sheet.off parts.obj parts.ply; do
  run 0 $input "out.${input##*.}" --order relaxed --faces 200
  expect stdout ': 800 -> (199|200) faces'
done
wrong=$(run 0 parts.obj out.obj --order relaxed --faces 200 &&
  awk -v far=0.05 -v slip=0.3 -v knows_creases=1 "$check_chunks" out.obj) || fail "$wrong"

# Faces that are kept apart
run 0 plain.off out.off --no-self-intersection --faces 200 --report out.json
expect_faces out.off 200
expect stdout ', 0 -> 0 pairs of faces intersect$'
grep -A 2 '"self_intersections"' out.json | grep -q '"after": 0' || fail "no figures of intersections"
run 0 plain.off out.off --no-self-intersection --error 1% --verify --report out.json
expect stdout 'verified: distance of the result from the input: [0-9.e-]+ promised, [0-9.e-]+ measured'
expect stdout '; intersecting pairs of faces: 0 promised, 0 measured$'
grep -c '"held": true' out.json | grep -q '^2$' || fail "no figures of what was verified"
run 0 --weld halves.off ball.off --keep 100%
run 0 ball.off plain_limit.off --error 2% --both-ways
run 0 ball.off out.off --error 2% --both-ways --calibrated --verify --report out.json
expect stdout 'verified: distance of the result from the input: [0-9.e-]+ promised, [0-9.e-]+ measured; '
grep -q '"calibrated": true' out.json || fail "no word of calibration"
[ "$(sed -n 2p out.off | cut -d' ' -f2)" -lt "$(sed -n 2p plain_limit.off | cut -d' ' -f2)" ] ||
  fail "a limit that is measured leaves as many faces as one that is added up"
run 0 ball.off ball.glb --keep 100%
run 0 ball.glb out.glb --error 2% --both-ways
mv stdout added_up
run 0 ball.glb out.glb --error 2% --both-ways --calibrated --verify
expect stdout 'verified: distance of the result from the input: [0-9.e-]+ promised, [0-9.e-]+ measured; '
[ "$(grep -o '[0-9]* faces' stdout | cut -d' ' -f1)" -lt "$(grep -o '[0-9]* faces' added_up | cut -d' ' -f1)" ] ||
  fail "of glTF, a limit that is measured leaves as many faces as one that is added up"
# What is promised is about the files: welding counts, and so do floats of OUT
run 2 ball.off out.off --weld 20% --error 1%
expect stderr '^ball.off: --weld or the precision of OUT moves points by up to [0-9.]+ before the simplification begins, and --error allows '
run 0 ball.off out.off --weld 1% --error 3% --both-ways --verify
run 2 ball.glb out.off --weld 1% --error 3%
expect stderr '^ball.glb: --weld does not go with glTF, where vertices are merged anyway where edges of faces coincide$'
run 0 ball.off ball.gltf --keep 100%
sed 's/"nodes":\[{/"nodes":[{"translation":[300000.3,0,0],/' ball.gltf >far.gltf
run 2 far.gltf out.stl --error 0.1%
expect stderr '^far.gltf: --weld or the precision of OUT moves points by up to 0.01[0-9]* before '
run 0 far.gltf out.stl --error 1% --both-ways --verify
run 2 ball.off out.html --error 2% --both-ways --calibrated
expect stderr '^out.html: a page shows a single recorded run, and --calibrated needs several$'
run 2 ball.off out.off --error 2% --both-ways --calibrated --record out.qlv
expect stderr '^--calibrated does not go with --record'
# Another placement is named where it comes nearer: three shells close to each other
awk '{ line[NR] = $0 }
END {
  split(line[2], n)
  print "OFF\n" 3 * n[1], 3 * n[2], 0
  for (s = 0; s < 3; ++s) for (v = 1; v <= n[1]; ++v) {
    split(line[2 + v], p); r = 1 - 0.01 * s; print r * p[1], r * p[2], r * p[3]
  }
  for (s = 0; s < 3; ++s) for (f = 1; f <= n[2]; ++f) {
    split(line[2 + n[1] + f], t); o = s * n[1]
    print 3, t[2] + o, t[s == 1 ? 4 : 3] + o, t[s == 1 ? 3 : 4] + o
  }
}' ball.off >shells.off
run 1 shells.off out.off --no-self-intersection --faces 12 --placement midpoint
expect stderr '^out.off: with --placement (endpoint|optimal) the result has [0-9]* faces, error about [0-9.]* % of the diagonal$'
run 0 --solid --verify --faces 100 ball.off out.off
expect stdout ', 0 -> 0 pairs of faces intersect, [0-9.]+ % of the volume$'
expect stdout 'verified: .*; components: 1 promised, 1 measured; .*; components inside other components than before: 0 promised, 0 measured$'
run 2 plain.off out.off --solid
expect stderr 'plain.off: the surface is not closed: [0-9]+ edges have different numbers of faces'
run 2 plain.off out.off --solid --topology free
expect stderr '^--solid keeps the topology'
run 0 ball.off out.off --faces 200 --normals 40 --verify --report out.json
expect stdout ', normals within [0-9.]+ degrees$'
expect stdout 'verified: degrees between normals: [0-9.]+ promised, [0-9.]+ measured; .* without a face in the input: 0 promised, 0 measured$'
grep -q '"normal_bound_degrees": [0-9]' out.json || fail "no figures of normals"
run 2 ball.off out.off --normals 0
run 2 plain.off out.off --verify
expect stderr '^--verify needs a promise to check'
run 2 plain.off out.off --no-self-intersection --order relaxed
expect stderr '^--no-self-intersection does not go with --order relaxed'

# Boundaries that are locked, or hardly hold
edge='NF == 3 && ($1 == 0 || $1 == 20 || $2 == 0 || $2 == 20)'
for cost in quadric memoryless length; do
  run 0 plain.off out.off --cost $cost --boundary lock --faces 200
  awk "$edge" plain.off >old
  vertices out.off >new
  [ "$(grep -cxFf old new)" -eq 80 ] || fail "not all vertices of the boundary are left"
done
run 0 sheet.off out.off --boundary lock --faces 200
[ "$(awk 'NF == 8 && ($1 == 0 || $1 == 20 || $2 == 0 || $2 == 20)' out.off | wc -l)" -eq 80 ] ||
  fail "not all vertices of the boundary are left"
run 1 plain.off out.off --boundary lock --faces 20
expect stderr '^out.off: the boundary is locked \([0-9,]+ contractions rejected\): --boundary WEIGHT'
run 0 plain.off out.off --boundary 0 --faces 200
run 0 plain.off again.off --faces 200
cmp -s out.off again.off && fail "--boundary 0 does nothing"

# Creases hold: a roof of two bumpy slopes
awk 'BEGIN {
  n = 20
  print "OFF\n" (n + 1) * (n + 1), n * n, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j)
    print i, j, (i < 10 ? i : 20 - i) + (i != 10) * sin(i * j) / 2
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j
    print 4, v, v + 1, v + n + 2, v + n + 1
  }
}' >roof.off
run 0 roof.off out.off --crease 60 --faces 60
run 0 roof.off again.off --faces 60 --report report.json
expect report.json '"options": \{$'
cmp -s out.off again.off && fail "--crease does nothing"
run 2 roof.off out.off --crease 60 --cost length
expect stderr '^--crease goes with --cost quadric'

# Lines, noise and weights of faces make other surfaces
for option in '--lines 0.1' '--normal-noise 10' '--noise 2%' '--weighting by-squared-area' '--weighting uniform'; do
  # shellcheck disable=SC2086
  run 0 roof.off other.off $option --faces 60
  cmp -s other.off again.off && fail "$option does nothing"
done
run 2 roof.off out.off --lines 0.1 --cost memoryless
expect stderr '^--lines, --normal-noise, --noise and --weighting go with --cost quadric only'
run 2 roof.off out.off --normal-noise 90
expect stderr 'is not an angle from 0 to less than 90 degrees'
run 2 roof.off out.off --crease 181
expect stderr '^--crease: .181. is not an angle in degrees in \[0, 180\]$'
run 2 roof.off out.off --ratio 101%
expect stderr '^--keep: .101%. is not a fraction such as 0.1 or 10% in \[0, 1\]$'
run 2 roof.off out.off --threads 0 --order relaxed
expect stderr '^--threads: .0. is not a count in \[1, 1024\]$'

# The report has the options of the table, as their schema says
run 0 roof.off out.off --keep 50% --noise 1% --weighting uniform --seams kept --placement endpoint --report report.json
for option in '"ratio": 0.5' '"position_noise": 0\.[0-9]+' '"weighting": "uniform"' '"seams": "kept"' '"placement": "endpoint"'; do
  expect report.json "^    $option,?\$"
done
if command -v python3 >/dev/null; then
  python3 "$option_table" schema schema.json
  python3 -c 'import json
schema, options = (json.load(open(file)) for file in ("schema.json", "report.json"))
for name, value in options["options"].items():
    row = schema["properties"][name]
    assert "enum" not in row or value in row["enum"], name
    assert row.get("minimum", value) <= value <= row.get("maximum", value), name' 2>stderr || fail "the schema is another one"
fi

# More faces stay where a scalar is large, whatever OUT can hold
awk 'BEGIN {
  n = 40
  printf "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n", (n + 1) ^ 2
  printf "property float detail\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n", 2 * n * n
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j)
    print i, j, 3 * sin(i / 6) * cos(j / 7), (i > n / 2 ? 64 : 1)
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j
    print 3, v, v + n + 1, v + n + 2 "\n" 3, v, v + n + 2, v + 1
  }
}' >detail.ply
run 0 detail.ply out.off --importance detail --faces 300
awk 'NR == 2 { vertices = $1 } NR > 2 && NF == 3 && NR <= 2 + vertices { ++side[$1 > 20] }
  END { exit !(side[1] > 2 * side[0]) }' out.off || fail '--importance leaves no more faces'
run 0 detail.ply out.ply --importance detail --faces 300
grep -q '^property float detail' out.ply || fail 'the scalar is gone'
run 2 detail.ply out.off --importance heat
expect stderr "^detail.ply: the vertices of IN have no scalar 'heat'; they have 'detail'"
run 2 roof.off out.off --importance heat
expect stderr "^roof.off: the vertices of IN have no scalar 'heat'; they have none"
sed '11,1691s/ 64$/ -1/' detail.ply >wrong.ply
run 2 wrong.ply out.off --importance detail
expect stderr '^wrong.ply: importance\[[0-9]*\] is -1, not in \[0, inf\)$'

# Only a region is simplified, by scalars of faces or by names; all others stay as they are
awk 'BEGIN {
  n = 20
  printf "ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n", (n + 1) ^ 2
  printf "element face %d\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n", 2 * n * n
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, 3 * sin(i / 6) * cos(j / 7)
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j; label = (i < n / 2 ? 3 : i < 3 * n / 4 ? 5 : 0)
    print 3, v, v + n + 1, v + n + 2, label "\n" 3, v, v + n + 2, v + 1, label
  }
}' >labels.ply
faces_beyond() { # file.off, x: the corners of each face beyond that, by their places, in order
  awk -v x="$2" 'NR == 2 { n = $1 } NR > 2 && NF == 3 { at[v] = $1; place[v++] = $0 }
    NR > 2 && NF == 4 && at[$2] + at[$3] + at[$4] > 3 * x { print place[$2], place[$3], place[$4] }' "$1"
}
run 0 labels.ply all.off --keep 100%
for region in 'label=3 10 --faces 100' 'label 15 --keep 25%'; do # what is not selected lies beyond
  # shellcheck disable=SC2086
  set -- $region
  run 0 labels.ply out.off --region "$1" "$3" "$4"
  faces_beyond all.off "$2" >before
  [ -s before ] || fail "no face lies beyond $2"
  faces_beyond out.off "$2" | cmp -s before - || fail "faces outside of the region have changed"
  if [ "$1" = label ]; then expect_ratio out.off 350; else expect_faces out.off 500; fi
done
run 0 labels.ply out.off --region label=3,label=5 --keep 25%
faces=$(sed -n 2p out.off | cut -d' ' -f2)
[ "$faces" -gt 200 ] && [ "$faces" -le 350 ] || fail "the region is another one in OFF: $faces faces"
run 2 labels.ply out.off --region ''
expect stderr "is not a list of names"
run 2 labels.ply out.off --region label=4
expect stderr '^labels.ply: no face of IN is in the region'
run 2 labels.ply out.off --region head,label
expect stderr "^labels.ply: the faces of IN have no 'head'; they have 'label'"
run 2 roof.off out.off --region head
expect stderr "^roof.off: the faces of IN have no 'head'; they have no names"
awk '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next } !body { next }
  v < n { print "v", $0; ++v; next }
  $5 != last { print "g side" $5; last = $5 } { print "f", $2 + 1, $3 + 1, $4 + 1 }' labels.ply >sides.obj
run 0 sides.obj out.obj --region side3 --faces 100
[ "$(awk '/^g / { group = $2 } /^f / && group == "side3"' out.obj | wc -l)" -eq 100 ] || fail "the group has other than 100 faces"
[ "$(grep -c '^f ' out.obj)" -eq 500 ] || fail "other groups have changed"

# Vertices that nearly touch: a sheet of loose quadrilaterals with noise
awk 'BEGIN {
  n = 10; print "OFF\n" 4 * n * n, n * n, 0
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j)
    for (k = 0; k < 4; ++k) {
      x = i + (k == 1 || k == 2); y = j + (k > 1); noise = 1e-7 * sin(7 * i + 5 * j + k)
      printf "%.12g %.12g %.12g\n", x + noise, y - noise, sin(x * y / 9) + noise
    }
  for (f = 0; f < n * n; ++f) print 4, 4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3
}' >loose_quads.off
run 1 loose_quads.off out.off --faces 50
expect stderr '^out.off: 100 components are left.*--weld TOLERANCE'
run 0 loose_quads.off out.off --faces 50 --weld 1e-6
expect stderr '^loose_quads.off: vertices merged with another one at the same place: 279$'
expect_faces out.off 50
cp out.off welded.off
run 0 loose_quads.off out.off --faces 50 --weld=1e-5%
cmp -s out.off welded.off || fail "another result with a part of the diagonal"
run 0 --weld 1e-6 --faces 50 loose_quads.off out.off
cmp -s out.off welded.off || fail "another result with another order of words"

# Faces wound this way and that: a closed octahedron-like surface of 8 faces, of which one is turned,
# beside a tetrahedron of which all are wound alike
printf 'OFF\n10 12 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n5 0 0\n6 0 0\n5 1 0\n5 0 1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 0 2 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n3 6 8 7\n3 6 7 9\n3 7 8 9\n3 8 6 9\n' >turned.off
run 0 turned.off out.off --faces 12
expect stderr '^turned.off: faces wound against their neighbours \(--orient turns them.*\): 1$'
expect out.off '^3 0 2 5$'
run 0 turned.off out.off --faces 12 --orient
expect stderr '^turned.off: faces turned to agree with their neighbours: 1$'
expect out.off '^3 0 5 2$'
expect out.off '^3 6 8 7$'
run 0 --orient out.off again.off --faces 12
expect_nothing stderr
cmp -s out.off again.off || fail "faces wound alike have been turned"
run 0 --orient --quiet turned.off again.off --faces 12
expect_nothing stderr
cmp -s out.off again.off || fail "another result with --quiet"
# What is at the corners of a face turns with it, and it stays in its material
printf 'mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\nusemtl blue\nf 1/1 4/4 3/3\n' >turned.obj
run 0 turned.obj out.obj --faces 2 --orient
expect stderr '^turned.obj: faces turned to agree with their neighbours: 1$'
expect out.obj '^f 1/[0-9]+ 3/[0-9]+ 4/[0-9]+$'
awk '/^vt/ { t[++n] = $2 " " $3 } /^v / { v[++m] = $2 " " $3 }
  /^f/ { for (i = 2; i <= 4; ++i) { split($i, c, "/"); if (t[c[2]] != v[c[1]]) exit 1 } }' out.obj ||
  fail "the texture has not been turned with its face"
expect out.obj '^usemtl blue$'
# A Moebius strip has but one side
awk 'BEGIN { n = 12; print "OFF\n" 2 * n, 2 * n, 0
  for (i = 0; i < n; ++i) { a = 2 * 3.14159265 * i / n
    for (j = -1; j < 2; j += 2) { r = 1 + j * cos(a / 2) / 3; print r * cos(a), r * sin(a), j * sin(a / 2) / 3 } }
  for (i = 0; i < n; ++i) { p = 2 * i; q = p + 1; r = i + 1 < n ? p + 2 : 1; s = i + 1 < n ? p + 3 : 0
    print 3, p, r, s; print 3, p, s, q } }' >strip.off
run 0 strip.off out.off --faces 24 --orient
expect stderr '^strip.off: one-sided components, whose faces cannot be wound alike: 1$'
run 2 --orient --from record.qlv out.off

# What is measured and reported
run 0 sheet.off out.off --faces 100 --measure --report report.json
expect stdout ', measured [0-9.e-]+ % of the diagonal apart, [0-9.e-]+ % of the diagonal RMS, the texture [0-9.e-]+ % of the diagonal RMS$'
expect report.json '"input": "sheet.off"'
expect report.json '"target_met": true'
expect report.json '"distance_bound": null'
expect report.json '"bleeding": '
run 0 plain.off out.off --levels 50%,25% --report report.json
[ "$(grep -c '"output": "out-[12].off"' report.json)" -eq 2 ] || fail "not a result for each level"
run 1 tetrahedron.off out.off --report report.json
expect report.json '"stop": "all pairs rejected"|"stop": "target unreachable"'
run 0 plain.off out.off --error 0.05 --report report.json
expect report.json '"distance_bound": 0\.0[0-4]'
expect report.json '"hausdorff_bound": null'
run 0 plain.off out.off --error 0.05 --both-ways --report report.json
expect report.json '"hausdorff_bound": 0\.0[0-4]'
expect report.json '"both_ways": true'
expect stdout ' from IN, and no point of IN further than that from OUT$'
run 2 plain.off out.off --both-ways
awk 'BEGIN {
  n = 12
  print "ply\nformat ascii 1.0\nelement vertex", (n + 1) ^ 2
  print "property double x\nproperty double y\nproperty double z\nproperty float allowed"
  print "element face", 2 * n ^ 2, "\nproperty list uchar int vertex_indices\nend_header"
  for (j = 0; j <= n; ++j)
    for (i = 0; i <= n; ++i)
      print i, j, (7 * i + 5 * j + i * j) % 4 * 0.1, i < 6 ? 0.01 : 1
  for (j = 0; j < n; ++j)
    for (i = 0; i < n; ++i) {
      v = j * (n + 1) + i
      print 3, v, v + 1, v + n + 2
      print 3, v, v + n + 2, v + n + 1
    }
}' >field.ply
run 0 field.ply out.off --tolerance allowed --verify --report report.json
expect stdout 'verified: distance of the input from the result, beyond its tolerances: 0 promised, 0 measured; '
expect report.json '"tolerance": "allowed"'
expect stdout ', and no point of IN further than that from OUT, [0-9.]+ % of allowed used$'
awk 'NF == 3 && !/[a-z]/ && $1 < 5.5 { ++strict } NF == 3 && !/[a-z]/ && $1 > 6.5 { ++loose }
  END { exit !(strict >= 70 && loose < 30) }' out.off || fail "the tolerances are not those of the vertices"
run 2 field.ply out.ply --tolerance missing
expect stderr 'no scalar .missing.; they have .allowed.'
run 2 field.ply out.ply --tolerance allowed --error 1
run 2 plain.off out.off --report missing/report.json
expect stderr '^missing/report.json: '
run 0 --verbose plain.off out.off
expect stdout '^out.off: 800 -> .* contractions, stopped: target met'
run 0 --version
expect stdout '^[0-9]+\.[0-9]+\.[0-9]+$'

# An arrow where the character set has one
if locale -a 2>/dev/null | grep -qx C.utf8; then
  LC_ALL=C.UTF-8 "$program" plain.off out.off >stdout 2>stderr
  expect stdout '^plain.off: 800 → [0-9]+ faces'
fi

# Ctrl-C while it works: a file is as it was, unless what is there shall be kept
awk 'BEGIN {
  n = 400
  print "OFF\n" (n + 1) * (n + 1), n * n, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, sin(i * j / 9)
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j
    print 4, v, v + 1, v + n + 2, v + n + 1
  }
}' >large.off
interrupt() { # arguments...
  arguments=$*
  # In the foreground it sends one signal, else a second one to all that it has started.
  timeout --foreground --preserve-status --signal=INT 1 "$program" "$@" >stdout 2>stderr
  status=$?
}
cp plain.off out.off
interrupt large.off out.off --cost memoryless --faces 1000
if [ $status -eq 0 ]; then
  echo "skipped: the machine is too fast to be interrupted"
else
  [ $status -eq 130 ] || fail "exit status $status instead of 130"
  expect stderr '^interrupted: out.off is as it was$'
  expect_nothing stdout
  cmp -s out.off plain.off || fail "out.off has changed"
  interrupt large.off out.off --cost memoryless --faces 1000 --keep-partial
  [ $status -eq 1 ] || fail "exit status $status instead of 1"
  expect stderr '^out.off: the target was not reached: cancelled$'
  cmp -s out.off plain.off && fail "nothing is kept"
  run 0 out.off again.off --ratio 1
fi
# SIGTERM while it verifies, which takes eight times as long there as all before: it ends soon
cp plain.off out.off
arguments="large.off out.off --verify, ended"
timeout --foreground --preserve-status --signal=TERM --kill-after=5 0.8 \
  "$program" large.off out.off --keep 100% --error 1% --both-ways --verify >stdout 2>stderr
status=$?
if [ $status -eq 0 ]; then
  echo "skipped: the machine is too fast to be interrupted"
else
  [ $status -eq 143 ] || fail "exit status $status instead of 143"
  expect stderr '^interrupted: out.off is as it was$'
  cmp -s out.off plain.off || fail "out.off has changed"
fi
if command -v script >/dev/null; then # a terminal has a line that tells how far it is
  script -qec "'$program' large.off out.off --cost memoryless --keep 20%" /dev/null >terminal </dev/null
  grep -q 'simplifying: [0-9,]* faces left' terminal || fail "no line of progress on a terminal"
fi
rm -f large.off

# glTF
write_sheet sheet.gltf
run 0 sheet.gltf out.glb --normals 60 --verify
expect stdout '^sheet.gltf: 128 -> 6[34] faces'
expect stdout 'verified: degrees between normals: [0-9.]+ promised, [0-9.]+ measured; .* without a face in the input: 0 promised, 0 measured$'
expect stderr '^sheet.gltf: the buffers of IN have 708 bytes, those of OUT 712: a promise needs floats, and the positions of IN were integers$'
run 0 out.glb out.gltf --ratio 1
expect stdout '^out.glb: 6[34] -> 6[34] faces'
expect out.gltf '"VENDOR_any":{"x":\[1,null\]}'
expect out.gltf '"materials":\[{"name":"plain"}\]'
run 0 sheet.gltf out.gltf --faces 40
expect stdout '^sheet.gltf: 128 -> 40 faces'
run 0 sheet.gltf - --format glb
head -c 4 stdout | grep -q '^glTF' || fail "no GLB on standard output"
# What it cannot know, or is wrong, is told. Meshes of the same accessors go on sharing what they have.
sed 's/"asset"/"extensionsRequired": ["FOO_bar", "KHR_materials_unlit"], "images": [{"uri": "none.png"}], "asset"/' sheet.gltf >told.gltf
run 0 told.gltf out.gltf
expect stderr "^told.gltf: IN requires the extension 'FOO_bar', which Quadrille does not know"
expect stderr "^told.gltf: the image 'none.png' is not there$"
[ "$(wc -l <stderr)" -eq 2 ] || fail "other remarks"
sed -e 's/"meshes": \[{\(.*\)}\],$/"meshes": [{\1}, {"name": "twin", \1}, {"primitives": [{"attributes": {"POSITION": 2}, "indices": 1}]}],/' \
  -e 's/"nodes": \[{"mesh": 0}\]/"nodes": [{"mesh": 0}, {"mesh": 1, "translation": [200, 0, 0]}, {"mesh": 2}]/' \
  -e 's/"count": 384}\]/"count": 384}, {"componentType": 5126, "type": "VEC3", "count": 81, "min": [0, 0, 0], "max": [0, 0, 0]}]/' sheet.gltf >twins.gltf
run 0 twins.gltf out.gltf
expect stdout '^twins.gltf: 128 -> 6[34] faces'
expect stderr '^twins.gltf: triangles left out \(two equal corners, or duplicates of another one\): 128$' # those of zeros
grep -q '{"componentType":5126,"type":"VEC3","count":1,"min":\[0.0,0.0,0.0\],"max":\[0.0,0.0,0.0\]}' out.gltf || fail "zeros have bytes"
expect out.gltf '"meshes":\[{("primitives":\[{"attributes":{"POSITION":[0-9]+},"indices":[0-9]+,"material":0}\])},{"name":"twin",\1}'
if [ -n "${QUADRILLE_CASES-}" ]; then # read, or a sentence that says what decodes it
  for file in draco_ball meshopt_ball meshopt_vase; do
    "$program" "$QUADRILLE_CASES/files/$file.glb" out.glb >stdout 2>stderr
    case $? in
    0) grep -qa '_compression' out.glb && fail "$file.glb is compressed yet" ;;
    *) expect stderr '[A-Z]*_(draco_mesh|meshopt)_compression: it is compressed, .* decompress it first: ' ;;
    esac
  done
fi
run 0 twins.gltf out.gltf --levels 50%,25%
expect out.gltf '("attributes":{"POSITION":[0-9]+},"indices":[0-9]+),"material":0}\]},.*"name":"twin_LOD1","primitives":\[{\1,'
[ "$(grep -o '"bufferView":' out.gltf | wc -l)" -eq 6 ] || fail "levels of twins do not share what they have"
# Compressed, or a sentence that says by what else; again, if it was.
for how in meshopt draco; do
  "$program" sheet.gltf packed.glb --compress $how --keep 100% >stdout 2>stderr
  case $? in
  0)
    expect packed.glb "\"extensionsRequired\":\[\"[A-Z]*_${how}_[a-z_]*\"\]"
    run 0 packed.glb unpacked.glb
    expect stdout '^packed.glb: 128 -> 6[34] faces'
    expect stderr "^packed.glb: IN is compressed, OUT is not: --compress $how compresses it again$"
    run 0 packed.glb repacked.glb --compress $how
    expect_nothing stderr
    ;;
  *) expect stderr '^this program was built without lib.*, which this compression needs; compress OUT with another tool: ' ;;
  esac
done
run 2 sheet.gltf out.off --compress draco
expect stderr '^out.off: --compress needs an OUT that is .glb or .gltf$'
run 2 sheet.gltf unpacked.glb --compress zip
expect stderr '^--compress: .zip. is not one of meshopt, draco$'
run 0 sheet.gltf out.off --keep 50%
expect_ratio out.off 64
expect stderr '^sheet.gltf: not kept: .*properties of materials'
# Images go into a document, from another format too, unless they shall stay files.
mkdir images other
printf '\211PNG\r\n\032\nanything' >'images/a b.png'
printf 'newmtl red\nKd 1 0 0\nmap_Kd a b.png\n' >images/one.mtl
awk 'BEGIN { print "mtllib one.mtl\nusemtl red\no sheet" } NR > 2 && NF == 3 { print "v", $0 }
     NF == 4 { print "f", $2 + 1 "/1", $3 + 1 "/1", $4 + 1 "/1" } END { print "vt 0.25 0.25" }' out.off >images/one.obj
for end in glb gltf; do
  run 0 images/one.obj other/one.$end --keep 50%
  expect_nothing stderr
done
expect other/one.glb '"images":\[{"name":"a b.png","mimeType":"image/png","bufferView":[0-9]*}\]'
expect other/one.glb '"baseColorTexture":{"index":0}'
grep -q anything other/one.glb || fail "no image in a GLB"
run 0 images/one.obj images/named.gltf --external-images
expect images/named.gltf '"images":\[{"uri":"a%20b.png"}\]'
run 0 images/named.gltf images/out.gltf --keep 50%
expect images/out.gltf '"images":\[{"uri":"a%20b.png"}\]'
run 0 images/named.gltf other/out.gltf --keep 50%
expect other/out.gltf '"images":\[{"uri":"data:image/png;base64,iVBORw0K'
run 0 images/named.gltf other/out.glb --keep 50%
grep -q anything other/out.glb || fail "no image in a GLB"
run 0 images/named.gltf other/out.glb --keep 50% --external-images
expect stderr 'the images of IN are files, to which OUT refers by the same names, but from another folder: 1$'
rm 'images/a b.png'
run 0 images/named.gltf other/out.glb --keep 50%
expect stderr "the image 'a%20b.png' is not there$"
run 0 images/one.obj other/out.glb --keep 50%
expect stderr "the image 'a b.png' is missing, or is not an image$"
run 2 --cost color sheet.gltf out.glb
expect stderr '^sheet.gltf: it has no colours for --cost color$'
run 0 sheet.gltf levels.gltf --levels 50%,40
[ "$(grep -c '^sheet.gltf: 128 -> ' stdout)" -eq 2 ] || fail "no line for each level"
expect levels.gltf '"nodes":\[{"mesh":0,"extensions":{"MSFT_lod":{"ids":\[1,2\]}},"extras":{"MSFT_screencoverage":\[0\.(5|492)[0-9]*,0\.3125,0\]}},{"mesh":1},{"mesh":2}\]'
expect levels.gltf '"extensionsUsed":\["MSFT_lod"\]'
run 0 sheet.gltf - --format glb --levels 50%,40
head -c 4 stdout | grep -q '^glTF' || fail "no GLB on standard output"
run 2 levels.gltf out.gltf --levels 50%
expect stderr '^levels.gltf: its nodes already have levels of detail \(MSFT_lod\)$'
run 2 sheet.gltf out.gltf --levels 50%,64
expect stderr '^--levels: 64 is not coarser than 50% before it \(IN has 128 faces\)$'
run 1 sheet.gltf levels.glb --levels 50%,0
expect stderr '^levels.glb, level 0: the target was not reached: '
run 2 sheet.gltf out.gltf --labels _PART,_LAYER
expect stderr "^sheet.gltf: there is no integer attribute named '_LAYER'$"
run 2 roof.off out.off --labels _PART
expect stderr '^roof.off: --labels is for glTF'
run 2 sheet.gltf out.gltf --record record.qlv
expect stderr '^sheet.gltf: --record does not go with glTF$'
head -c 900 out.glb >cut.glb
echo old >old.glb
run 2 cut.glb old.glb
expect stderr '^cut.glb: the file is cut off: it has 900 of the [0-9]+ bytes that its header declares$'
[ "$(cat old.glb)" = old ] || fail "the output has changed"

# Both sides of a sheet stay, each with its material and wound as it was; of faces doubled the same
# way round one is left, which is told, and shares are of what counts.
write_sides() { # material of the back, factor: 1 turns it round, 0 does not
  awk -v back="$1" -v turns="$2" 'BEGIN {
    n = 20
    for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print "v", i, j, 2 * sin(i / 5) * cos(j / 5)
    for (side = 0; side < 2; ++side) {
      print "usemtl", side ? back : "A"
      for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
        v = i * (n + 1) + j + 1
        if (side && turns) print "f", v + n + 2, v + n + 1, v "\nf", v + 1, v + n + 2, v
        else print "f", v, v + n + 1, v + n + 2 "\nf", v, v + n + 2, v + 1
      }
    }
  }'
}
count_sides() { # file.obj: faces of A and of B that look up, and that look down
  awk '$1 == "v" { x[++n] = $2; y[n] = $3 }
    $1 == "usemtl" { material = $2 }
    $1 == "f" { a = $2 + 0; b = $3 + 0; c = $4 + 0
      ++count[material, (x[b] - x[a]) * (y[c] - y[a]) > (y[b] - y[a]) * (x[c] - x[a])] }
    END { print 0 + count["A", 1], 0 + count["A", 0], 0 + count["B", 1], 0 + count["B", 0] }' "$1"
}
write_sides B 1 >sides.obj
for part in 50 10 3; do
  run 0 sides.obj out.obj --keep $part%
  expect stdout '^sides.obj: 1,600 -> [0-9]+ faces \([0-9.]+ %\)'
  expect_nothing stderr
  set -- $(count_sides out.obj)
  [ "$1" = 0 ] || set -- "$2" "$1" "$4" "$3"
  [ "$1 $4" = "0 0" ] && [ "$2" = "$3" ] && [ $((200 * $2)) -gt $((1600 * part - 800)) ] &&
    [ $((200 * $2)) -le $((1600 * part)) ] || fail "sides of $* faces at $part %"
done
write_sides A 1 >same.obj
run 0 same.obj out.obj --keep 50%
set -- $(count_sides out.obj)
[ "$1" = "$2" ] && [ "$1" -gt 390 ] || fail "sides of $* faces"
write_sides A 0 >doubled.obj
run 0 doubled.obj out.obj --keep 10% --report report.json
expect stdout '^doubled.obj: 1,600 -> (80|79) faces \([0-9.]+ % of the 800 to be simplified\)'
expect stderr '^doubled.obj: duplicate faces left out \(same corners, same winding\): 800$'
expect report.json '"counted_faces": 800'
expect report.json '"doubled_faces": 800'
run 0 doubled.obj out.obj --keep 10% --quiet
expect_nothing stderr

# Files by parts
run 0 plain.off whole.ply --keep 100%
run 0 whole.ply out.ply --faces 100 --out-of-core scratch --memory 128M --report report.json
expect stdout '^whole.ply: 800 -> 100 faces \(12 %\), .*, in 1 chunk in 1 phase, 0?\.[0-9]+ GB of memory$'
expect report.json '"count_exact": true'
expect report.json '"peak_memory": [0-9]+'
[ ! -e scratch ] || fail "the folder is still there"
run 0 out.ply out.off --keep 100%
expect_faces out.off 100
cp out.ply expected.ply
by_steps='whole.ply out.ply --faces 100 --out-of-core scratch --memory 128M --step'
rm out.ply
for step in cut 0 0 close; do
  # shellcheck disable=SC2086
  run 0 $by_steps $step
  expect_nothing stderr
  if [ $step = close ]; then expect stdout '^0$'; else expect stdout '^1$'; fi
done
expect_same out.ply expected.ply
# The same by make, which goes on where it was interrupted.
if command -v make >/dev/null; then
  rm out.ply
  # shellcheck disable=SC2086
  run 0 $by_steps cut
  make -s -j 2 -f "$parts_mk" RUN="$program ${by_steps% --step}" >stdout 2>stderr || fail "make: status $?"
  expect_nothing stderr
  expect_same out.ply expected.ply
  [ ! -e scratch ] || fail "the folder is still there after make"
fi
# shellcheck disable=SC2086
run 0 $by_steps cut
# shellcheck disable=SC2086
run 2 $by_steps 1
expect stderr '^--step 1: the phase has 1 chunks, numbered from 0$'
run 2 whole.ply out.ply --faces 100 --out-of-core scratch --memory 128M
expect stderr '^scratch/quadrille-job: has a job in it: '
run 2 whole.ply out.ply --faces 90 --out-of-core scratch --memory 128M --restart
expect stderr '^scratch/quadrille-job: has chunks of another file, or for another target, '
expect_same out.ply expected.ply
for option in '' '--cost memoryless' '--cost thin-features' '--cost length' '--placement endpoint' '--topology free'; do
  rm -rf scratch
  # shellcheck disable=SC2086
  run 0 whole.ply out.ply --keep 10% $option --out-of-core scratch
  run 0 out.ply out.off --keep 100%
  expect_ratio out.off 80
done
mkdir tiles
cp whole.ply tiles/a.ply
cp whole.ply tiles/b.ply
run 0 'tiles/*.ply' out.ply --faces 400 --out-of-core scratch
expect stdout '^tiles/\*.ply: 1,?600 -> 400 faces '
run 0 'tiles/*.ply' fewer/ --faces 400 --out-of-core scratch
[ "$(ls fewer)" = "$(printf 'a.ply\nb.ply')" ] || fail "not the same tiles"
mkdir folder.ply
run 2 whole.ply folder.ply --faces 400 --out-of-core scratch # one file is no tile
[ -z "$(ls folder.ply)" ] || fail "written into a folder"
run 2 'tiles/*.stl' out.ply --faces 400 --out-of-core scratch
expect stderr '^tiles/\*.stl: no file matches this pattern$'
for option in '--boundary lock' '--boundary 0' '--boundary 1000' --drop-parts; do
  # shellcheck disable=SC2086
  run 0 whole.ply out.ply $option --faces 300 --out-of-core scratch
done
# A ball of two halves becomes one, as in memory.
awk 'NR == 2 { print "ply\nformat ascii 1.0\nelement vertex " $1 "\nproperty double x\nproperty double y\nproperty double z"
  print "element face " $2 "\nproperty list uchar int vertex_indices\nend_header" } NR > 2' halves.off >halves.ply
run 0 halves.ply out.ply --weld --faces 100 --out-of-core scratch
run 0 halves.ply in_memory.ply --weld --faces 100
[ "$(sed '1,/end_header/d' out.ply | od -c)" = "$(sed '1,/end_header/d' in_memory.ply | od -c)" ] ||
  fail "welded otherwise by parts"
for limit in '--error 0.01' '--error 1%' '--error 1% --both-ways' '--error 1% --faces 200'; do
  # shellcheck disable=SC2086
  run 0 whole.ply out.ply $limit --out-of-core scratch
  expect stdout '^whole.ply: 800 -> [0-9]+ faces .* from IN'
done
# What is measured by parts is what is measured in memory.
run 0 whole.ply out.ply --error 1% --both-ways --measure --verify --out-of-core scratch --report report.json
expect stdout '^whole.ply: .* and no point of IN further than that from OUT, in 1 chunk .*, measured [0-9.]+ % of the diagonal apart, [0-9.]+ % of the diagonal RMS$'
expect stdout '^out.ply: verified: distance of the result from the input: [0-9.e-]+ promised, [0-9.e-]+ measured; distance of the input '
expect report.json '"held": true'
measured=$(sed -n 's/.*\("greatest[a-z_]*": [0-9.]\{6\}\).*/\1/p' report.json)
run 0 whole.ply out.ply --error 1% --both-ways --measure --verify --report report.json
[ "$measured" = "$(sed -n 's/.*\("greatest[a-z_]*": [0-9.]\{6\}\).*/\1/p' report.json)" ] || fail "measured otherwise by parts"
[ ! -e scratch ] || fail "the scratch folder is there"
run 0 field.ply out.ply --tolerance allowed --verify --out-of-core scratch
expect stdout '^field.ply: .*, and no point of IN further than that from OUT, [0-9.]+ % of allowed used, in 1 chunk '
expect stdout '^out.ply: verified: distance of the input from the result, beyond its tolerances: 0 promised, 0 measured; '
run 2 whole.ply out.ply --tolerance size --out-of-core scratch
expect stderr '^whole.ply: its vertices have no scalar size for tolerances; they have none at all'
run 2 whole.ply ./whole.ply --measure --out-of-core scratch
expect stderr '^whole.ply: is both IN and OUT, '
run 2 whole.ply out.ply --measure --verify --out-of-core scratch
expect stderr '^--verify needs a promise to check: '
for option in '--error 1% --both-ways --calibrated' '--weld 1' --orient '--pairs 1' --solid \
  --no-self-intersection '--normals 30' '--levels 50%' '--record a.qlv' '--vertices 9' '--order relaxed' '--region a' \
  '--labels a' '--seams soft' '--importance a' '--lines 1' '--noise 1' '--crease 9' --keep-partial; do
  # shellcheck disable=SC2086
  run 2 whole.ply out.ply $option --out-of-core scratch
  expect stderr '^--[a-z-]+: does not go with --out-of-core: [a-z]'
  [ ! -e scratch ] || fail "the scratch folder is there"
done
run 0 sheet.off coloured.ply --keep 100%
run 0 coloured.ply out.ply --keep 50% --out-of-core scratch
grep -a -q '^property uchar red$' out.ply || fail "colours do not go along"
run 0 coloured.ply out.ply --out-of-core scratch --positions-only
expect stderr '^coloured.ply: left out: property [a-z]+ of vertices$'
for bad in 'plain.off out.ply' 'whole.ply out.off' 'whole.ply -' 'whole.ply out.ply --cost color' \
  'whole.ply out.ply --memory 1k' 'whole.ply out.ply --memory x' \
  'whole.ply out.ply --step x' 'whole.ply out.ply --faces 1 --keep 1%'; do
  # shellcheck disable=SC2086
  run 2 $bad --out-of-core scratch
  expect stderr .
done
run 2 whole.ply out.ply --memory 1G
expect stderr '.*--out-of-core'
awk 'BEGIN { printf "ply\nformat binary_little_endian 1.0\nelement vertex 1500000\nproperty float x\nproperty float y\n" \
  "property float z\nelement face 3000000\nproperty list uchar int vertex_indices\nend_header\n" }' >short.ply
truncate -s 22000000 short.ply
if (ulimit -v 500000 && "$program" --version) >stdout 2>&1; then # with a sanitizer it takes more
  (ulimit -v 500000 && "$program" short.ply out.ply) >stdout 2>stderr
  expect stderr '^short.ply: its 3,000,000 faces need about 0.75 GB of memory, more than is available: --out-of-core'
fi
rm short.ply

# How far a run by parts is, where there is no terminal: what it will take, and a line for each phase
run 0 whole.ply out.ply --faces 100 --out-of-core scratch --progress progress.json
expect stderr '^whole.ply: about [0-9.]+ m?s, 0?\.[0-9]+ GB of memory and [0-9.e-]+ GB in the scratch folder$'
expect stderr '^whole.ply: simplify, phase 1 of [0-9], 0 of 1 chunks$'
expect progress.json '^{"seconds":[0-9.e-]+,"stage":"survey",.*"input":"whole.ply","output":"out.ply","estimate":{"faces":800,'
expect progress.json '^{"seconds":[0-9.e-]+,"stage":"simplify","phase":1,'
expect progress.json '^{"seconds":[0-9.e-]+,"stage":"done","faces":100}$'
run 0 whole.ply out.ply --faces 100 --out-of-core scratch --quiet
expect_nothing stderr
run 2 missing.ply out.ply --out-of-core scratch --progress progress.json
expect progress.json '^{"seconds":[0-9.e-]+,"stage":"failed","message":"missing.ply: cannot be opened'
run 2 whole.ply out.ply --out-of-core scratch --progress missing/progress.json
expect stderr '^missing/progress.json: cannot be written$'
run 2 whole.ply out.ply --progress progress.json
expect stderr '.*--out-of-core'

# A job that does not fit onto a disk is refused before its file is read, which is a hole here.
memory_disk=/dev/shm
if free=$(df -Pk $memory_disk 2>/dev/null | awk 'NR == 2 && $1 == "tmpfs" { print $4 }') && [ "${free:-0}" -gt 60000 ] &&
  [ "$free" -lt 60000000 ]; then
  faces=$((free * 60))
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' \
    $((faces / 2)) >large.ply
  printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' $faces >>large.ply
  truncate -s $((faces * 19 + $(wc -c <large.ply))) large.ply
  run 2 large.ply out.ply --keep 1% --out-of-core $memory_disk/quadrille-$$/scratch --memory 16G
  expect stderr '^/dev/shm/quadrille-[0-9]*/scratch: only [0-9.]+ GB are free there, and the job needs about [0-9.]+ GB$'
  [ ! -e $memory_disk/quadrille-$$ ] || fail "the scratch folder is left"
  run 2 large.ply $memory_disk/quadrille-$$.ply --keep 100% --out-of-core scratch --memory 16G
  expect stderr '^/dev/shm/quadrille-[0-9]*\.ply: only [0-9.]+ GB are free there, and the rest of the surface needs about '
  rm large.ply
fi

# Faces that nobody sees: a cube in a cube
awk 'BEGIN {
  print "OFF\n16 24 0"
  for (s = 2; s >= 1; --s) for (i = 0; i < 8; ++i) print s * (i % 2 * 2 - 1), s * (int(i / 2) % 2 * 2 - 1), s * (int(i / 4) * 2 - 1)
  n = split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", v, " ")
  for (k = 0; k < 16; k += 8) for (i = 1; i <= n; i += 3) print 3, v[i] + k, v[i + 1] + k, v[i + 2] + k
}' >nested.off
run 0 nested.off out.off --keep 100% --hidden drop --report report.json
expect stderr '^nested.off: hidden faces: 12 of 24, 20 % of the area, dropped$'
expect stderr '^nested.off:   inner component: 12 faces, area 24, volume 8, diagonal 3\.5$'
expect report.json '"kind": "inner component"'
expect report.json '"hidden": 12'
expect_faces out.off 12
run 0 nested.off out.off --keep 100% --hidden report
expect stderr '^nested.off: hidden faces: 12 of 24, 20 % of the area$'
expect_faces out.off 24
run 0 nested.off out.off --keep 100% --hidden weight
expect_nothing stderr
expect_faces out.off 24
run 0 plain.off out.off --keep 100% --hidden drop=0.2%
expect stderr '^plain.off: hidden faces: 0 of 800, 0 % of the area$'
expect_faces out.off 800
for bad in x weight=1% drop=100% drop= drop=-1; do
  run 2 nested.off out.off --hidden $bad
  expect stderr '^--hidden: '
done
run 2 nested.off out.off --hidden drop --solid
expect stderr '^--hidden drop does not go with --both-ways, --tolerance or --solid'
run 2 whole.ply out.ply --out-of-core scratch --hidden drop
expect stderr '.*--hidden'

# A plate with a tunnel of one square and one of five, with a texture in six charts and two materials
awk 'function full(x, y, z) {
  return x >= 0 && x < 18 && y >= 0 && y < 10 && z >= 0 && z < 3 && !(x == 3 && y == 4) && !(x >= 8 && x < 13 && y >= 2 && y < 7)
}
BEGIN {
  print "mtllib plate.mtl"
  for (x = 0; x < 18; ++x) for (y = 0; y < 10; ++y) for (z = 0; z < 3; ++z) if (full(x, y, z))
    for (side = 0; side < 6; ++side) {
      axis = int(side / 2); beyond = side % 2
      d[0] = d[1] = d[2] = 0; d[axis] = beyond ? 1 : -1
      if (full(x + d[0], y + d[1], z + d[2])) continue
      print "usemtl " (x < 8 ? "first" : "second")
      for (k = 0; k < 4; ++k) {
        i = k == 1 || k == 2; j = k >= 2
        o[axis] = beyond; o[(axis + 1) % 3] = i; o[(axis + 2) % 3] = j
        p[0] = x + o[0]; p[1] = y + o[1]; p[2] = z + o[2]
        print "v", p[0], p[1], p[2]
        print "vt", (side + 0.1 + p[(axis + 1) % 3] / 20) / 6, 0.1 + p[(axis + 2) % 3] / 20
      }
      n += 4
      if (beyond) print "f", n-3 "/" n-3, n-2 "/" n-2, n-1 "/" n-1, n "/" n
      else print "f", n "/" n, n-1 "/" n-1, n-2 "/" n-2, n-3 "/" n-3
    }
}' >plate.obj
printf 'newmtl first\nmap_Kd plate.png\nnewmtl second\n' >plate.mtl
run 0 plate.obj plate.glb --keep 100%
expect stderr 'all faces lie along the axes, with edges of one length: for voxels, --preset voxels$'
for in in plate.obj plate.glb; do
  run 0 $in out.${in##*.} --faces 200 --cut-handles 1.5 --report report.json
  expect stdout '200 faces .*, 1 handle cut, closed within [0-9.]+ % of the diagonal of IN$'
  expect report.json '"cut_distance": 0.5'
  expect report.json '"cut_handles": 1'
  run 0 $in out.${in##*.} --error 0.3 --both-ways --cut-handles 1.5 --normals 80 --no-self-intersection --verify
  expect stdout 'no point of OUT is further than .* from IN with its cuts, and no point of IN further than that from OUT'
  expect stdout ': verified: .* promised'
  run 0 $in out.${in##*.} --error 0.3 --both-ways --calibrated --cut-handles 1.5 --verify
  run 0 $in out.${in##*.} --faces 200 --preset generated -v
  expect stderr '^plate\.(obj|glb): --preset generated: simplified_topology 3 \* edge$'
  expect stdout ', 2 handles cut' # a wall between both tunnels, too
done
run 0 plate.glb out.obj --faces 200 --cut-handles 1.5
grep -q '^usemtl second' out.obj || fail "a material is gone"
run 0 plate.obj out.off --faces 200 --cut-handles 1.5 --record plate.qlv
run 0 out2.off --from plate.qlv --keep 100%
whole=$(sed -n 2p out2.off | cut -d' ' -f2)
[ "$whole" -eq $(($(grep -c '^f' plate.obj) * 2 + 8)) ] || fail "the record begins with $whole faces"
run 2 plate.obj out.off --cut-handles 1.5 --solid
expect stderr '^--cut-handles does not go with --solid: both sides of a cut may touch, which a solid does not$'
for asked in --manifold '--preset generated' '--cut-handles 1'; do
  run 2 whole.ply out.ply --out-of-core scratch $asked
  expect stderr "^${asked%% *}: does not go with --out-of-core: .*simplify out of core to what fits into memory first, and then OUT with ${asked%% *}"
done

# Two cubes with an edge in common, and colours with a seam
awk 'BEGIN {
  print "ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z"
  print "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 12\nproperty list uchar int vertex_indices\nend_header"
  for (c = 0; c < 2; ++c) for (i = 0; i < 8; ++i) print i % 2 + c, int(i / 2) % 2 + c, int(i / 4), 250 * c, 0, 9
  for (k = 0; k < 16; k += 8) {
    m = split("0 2 3 1,4 5 7 6,0 1 5 4,2 6 7 3,0 4 6 2,1 3 7 5", q, ",")
    for (i = 1; i <= m; ++i) { split(q[i], v, " "); print 4, v[1] + k, v[2] + k, v[3] + k, v[4] + k }
  }
}' >cubes.ply
run 0 cubes.ply out.ply --keep 100% --weld --manifold
expect stdout ', made manifold: 2 vertices split, 0 edges split in their middle: '

# Surfaces that look like those of a preset
awk 'BEGIN {
  n = 30; print "OFF\n" (n + 1) * (n + 1), 2 * n * n, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, 2 * sin(i / 4) * cos(j / 5)
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) { v = i * (n + 1) + j; print 3, v, v + n + 1, v + n + 2; print 3, v, v + n + 2, v + 1 }
}' >terrain.off
run 0 terrain.off out.off
expect stderr '^terrain.off: it shows one side only along the z axis: for terrain, --preset terrain$'
run 0 terrain.off out.off --preset terrain
expect_nothing stderr
run 0 plate.obj out.off --faces 200 --voxel-size 1
grep -q 'for voxels' stderr && fail "a hint to what was asked for"

# The input may be the output
run 0 plain.off plain.off
expect_ratio plain.off 400

echo "$failures failures"
[ $failures -eq 0 ]
