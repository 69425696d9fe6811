#!/bin/sh
# Runs programs of examples/ on files, and checks what must hold of what they write.
#   sh files.sh CHECK ARGUMENT...    a CHECK is one of the functions below
check=$1
shift
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM

# The program ends as it must on each of a folder of broken and odd files: on a file that loads also with
# targets down to no face at all.
#   bad_files DATA_DIR PROGRAM
# DATA_DIR holds bad/EXPECT.tsv, or EXPECT.tsv itself, or lies beside a folder `bad` that does: a line
# for each file with its name, what is expected of it and why. If it is empty, it is what the
# environment variable QUADRILLE_DATA says. Without EXPECT.tsv the test is skipped (exit status 77).
# MEMORY_KB limits the address space, 2 GB unless set; "unlimited" for sanitizers, which map more.
bad_files() {
  data=${1:-${QUADRILLE_DATA-}}
  program=$2
  memory_kb=${MEMORY_KB:-2097152}

  if [ $# -ne 2 ] || [ ! -x "$program" ]; then
    echo "usage: $0 bad_files DATA_DIR PROGRAM" >&2
    exit 2
  fi
  for folder in "$data" "$data/bad" "$data/../bad"; do
    [ -n "$data" ] && [ -f "$folder/EXPECT.tsv" ] && break
    folder=
  done
  if [ -z "$folder" ]; then
    echo "skipped: no EXPECT.tsv in '$data', in a folder bad there or in one beside it"
    exit 77
  fi
  data=$folder

  output=$work/out/result.off # as text, so that it can be searched
  checked=0
  mismatches=0

  run() { # option...
    options=$*
    rm -rf "$work/out"
    mkdir "$work/out"
    (
      [ "$memory_kb" = unlimited ] || ulimit -v "$memory_kb"
      exec timeout 20 "$program" "$@" "$data/$file" "$output"
    ) >"$work/stdout" 2>"$work/stderr"
    status=$?
  }

  complain() { # message
    mismatches=$((mismatches + 1))
    failed=1
    echo "$file $options (expected: $expected, status $status): $1"
    sed 's/^/    /' "$work/stderr" | head -n 3
  }

  # Complains about an OFF file: coordinates that are not finite, indices out of range, faces with two
  # equal corners, and faces of the same three corners.
  check_mesh='
    function complain(message) { print "line " NR ": " message; is_bad = 1; exit }
    NR == 1 { next }
    NR == 2 { vertices = $1; faces = $2; next }
    NR <= 2 + vertices {
      for (i = 1; i <= 3; ++i)
        if ($i !~ /^-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/)
          complain("the coordinate \"" $i "\" is no finite number")
      next
    }
    {
      if ($1 != "3")
        complain("not a triangle")
      for (i = 2; i <= 4; ++i)
        if ($i !~ /^[0-9]+$/ || $i + 0 >= vertices)
          complain("the index \"" $i "\" is out of range")
      a = $2 + 0; b = $3 + 0; c = $4 + 0
      if (a == b || b == c || c == a)
        complain("two equal corners")
      low = a < b ? (a < c ? a : c) : (b < c ? b : c)
      next_to_low = low == a ? b : low == b ? c : a # the other way round it is a back
      if (seen[low, next_to_low, a + b + c - low - next_to_low]++)
        complain("a doubled face")
    }
    END { if (!is_bad && NR != 2 + vertices + faces) print "not as many lines as vertices and faces" }'

  # A sound mesh, and nothing else beside it.
  check_output() {
    failed=0
    if [ ! -f "$output" ]; then
      complain "no output"
    elif grep -qiE 'nan|inf' "$output"; then
      complain "the output has numbers that are not finite"
    elif wrong=$(awk "$check_mesh" "$output") && [ -n "$wrong" ]; then
      complain "the output is no sound mesh: $wrong"
    elif [ "$(ls -A "$work/out")" != result.off ]; then
      complain "there is more than the output"
    elif [ -z "$options" ] && ! "$program" --quiet --ratio 1 "$output" "$work/again.off" 2>"$work/stderr"; then
      complain "the output does not read back"
    fi
    return $failed
  }

  # With the default target, half of the faces, and beyond.
  check_ok() {
    check_loaded
    for target in "--ratio 0.1" "--faces 0" "--ratio 0.1 --topology free" "--faces 0 --topology free"; do
      # shellcheck disable=SC2086 # these are several words
      run $target
      check_loaded
    done
  }

  check_loaded() {
    case $status in
      0 | 1) check_output ;;
      *) complain "it must load" ;;
    esac
  }

  # A file of nothing at all is simplified to itself; one of vertices only is refused.
  check_empty() {
    if [ "$status" -eq 2 ]; then
      check_reject
      grep -qF "nothing to simplify" "$work/stderr" || complain "it must load"
    elif [ "$status" -ne 0 ]; then
      complain "it must load"
    elif ! check_output; then
      :
    elif [ "$(tail -n 1 "$output")" != "0 0 0" ]; then
      complain "the output must be empty"
    fi
  }

  check_reject() {
    if [ "$status" -ne 2 ]; then
      complain "it must be refused with exit status 2"
    elif [ "$(wc -l <"$work/stderr")" -ne 1 ]; then
      complain "the message must be one line"
    elif ! grep -qF "$file" "$work/stderr"; then
      complain "the message must name the file"
    elif [ -n "$(ls -A "$work/out")" ]; then
      complain "there must be no output"
    fi
  }

  tab=$(printf '\t')
  while IFS=$tab read -r file expected _; do
    case $file in file | '#'* | '') continue ;; esac
    run
    checked=$((checked + 1))
    # Corners that name texture coordinates which are not there are read without them.
    [ "$file" = uv_index_out_of_range.obj ] && expected=ok
    case $expected in
      ok) check_ok ;;
      reject) check_reject ;;
      empty-mesh) check_empty ;;
      ok-or-* | reject-or-*)
        if [ "$status" -eq 2 ]; then check_reject; else check_ok; fi
        ;;
      *) complain "the test does not know what this means" ;;
    esac
  done <"$data/EXPECT.tsv"

  echo "$checked files, $mismatches mismatches"
  [ "$checked" -gt 0 ] && [ "$mismatches" -eq 0 ]
}

# What must hold of small files on which results of the program were wrong does, of those that are there.
#   small_files FOLDER PROGRAM
# If FOLDER is empty, it is what the environment variable QUADRILLE_CASES says. Without it the test is
# skipped (exit status 77).
small_files() {
  folder=${1:-${QUADRILLE_CASES-}}
  program=$2
  if [ $# -ne 2 ] || [ ! -x "$program" ]; then
    echo "usage: $0 small_files FOLDER PROGRAM" >&2
    exit 2
  fi
  if [ -z "$folder" ] || [ ! -d "$folder" ]; then
    echo "skipped: no folder '$folder'"
    exit 77
  fi

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
    expect_remark 'values above 1'
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
    grep -q 'vertices merged with another one at the same place: 196' "$work/stderr" || fail "no remark on what was welded"
    if grep -q 'cracks may open' "$work/stderr"; then fail "a seam is left"; fi
  fi
  for name in split_seam.off; do
    has $name || continue
    run out.off
    grep -q 'vertices merged with another one at the same place: 117' "$work/stderr" || fail "the seam and the poles are not sewn"
    if grep -q 'cracks may open' "$work/stderr"; then fail "a remark on a seam that is none"; fi
    run again.off
    [ $status -eq 0 ] || fail "exit status $status"
  done

  echo "$checked runs, $failures failures"
  [ "$checked" -gt 0 ] && [ "$failures" -eq 0 ]
}

# The example textured_obj keeps two charts and two materials of a sheet, which meet at the same line.
#   textured_obj PROGRAM
textured_obj() {
  set -eu
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
}

"$check" "$@"
