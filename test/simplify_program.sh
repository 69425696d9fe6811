#!/bin/sh
# Runs the program simplify over small meshes that it writes itself, and checks exit status, output
# and messages.
#
#   simplify_program.sh PROGRAM

program=$1
if [ $# -ne 1 ] || [ ! -x "$program" ]; then
  echo "usage: $0 PROGRAM" >&2
  exit 2
fi
case $program in /*) ;; *) program=$PWD/$program ;; esac

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
cd "$work" || exit 2
failures=0

fail() { # message
  failures=$((failures + 1))
  echo "simplify $arguments: $1"
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
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n' >nan.off
awk 'NR == 1 { print "OFF"; next } NF == 8 { print $1, $2, $3; next } { print }' sheet.off >plain.off

# Targets
run 0 plain.off out.off
expect stdout '^800 -> 400 faces, .* stopped: target met'
expect_nothing stderr
expect_faces out.off 400
run 0 plain.off out.off --faces 100
expect_faces out.off 100
run 0 plain.off out.off --ratio 0.25
expect_faces out.off 200
run 0 plain.off out.off --vertices 50
[ "$(sed -n 2p out.off | cut -d' ' -f1)" -le 50 ] || fail "more than 50 vertices"
run 0 plain.off out.off --ratio 1
expect_faces out.off 800
run 0 plain.off out.off --error 0.05
expect stdout 'stopped: target met, .* within 0\.0[0-4][0-9]* of the input'
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

# An empty mesh
for format in off obj ply stl ts; do
  run 0 point.off out.$format
  run 0 out.$format empty.off
  expect_faces empty.off 0
done

printf 'OFF\n0 0 0\n' >none.off
for options in '' '--pairs-closer-than 1' '--cost memoryless' '--cost length' '--weld'; do
  # shellcheck disable=SC2086
  run 0 $options none.off out.off
  expect_faces out.off 0
done

# Costs, placements, topology, pairs
for cost in quadric memoryless thin-features color texture length; do
  run 0 --cost $cost --ratio 0.2 sheet.off out.off
  expect out.off '^STCOFF'
  expect_faces out.off 160
  # colour and texture coordinate still are those of the place, within the size of a face
  awk 'NF == 9 { d = ($4 - 10 * $1) ^ 2 + ($5 - 10 * $2) ^ 2; t = ($8 - $1 / 20) ^ 2
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
run 0 --pairs-closer-than 1.2 --boundary-weight 0 plain.off out.off
run 0 --weld plain.off out.off
run 0 --cost length --placement endpoint plain.off out.off

# Bad usage
cp plain.off out.off
for bad in '' 'plain.off' 'plain.off out.off more' '--faces 1 --ratio 1 plain.off out.off' \
  '--faces -1 plain.off out.off' '--faces 1.5 plain.off out.off' '--vertices x plain.off out.off' \
  '--error -1 plain.off out.off' '--ratio 1.5 plain.off out.off' '--ratio nan plain.off out.off' '--cost gold plain.off out.off' \
  '--boundary-weight -1 plain.off out.off' '--pairs-closer-than inf plain.off out.off' \
  '--placement optimal --cost length plain.off out.off' '--cost color plain.off out.off' \
  '--cost texture plain.off out.off' '--unknown plain.off out.off'; do
  # shellcheck disable=SC2086
  run 2 $bad
  expect_nothing stdout
  expect stderr .
  cmp -s plain.off out.off || fail "out.off has changed"
done
run 0 --help
expect stdout '--ratio'

# Bad files
run 2 nan.off out.off
expect stderr '^nan.off: vertex 2, counted from 0, is not finite$'
cmp -s plain.off out.off || fail "out.off has changed"
run 2 missing.off out.off
expect stderr '^missing.off: no such file$'
run 2 plain.off out.xyz
expect stderr "^out.xyz: the extension '.xyz' is none of"
run 2 plain.off missing/out.off
expect stderr '^missing/out.off: cannot be opened for writing$'
run 2 plain.off .
if ls ./*.part* >/dev/null 2>&1; then fail "temporary files are left"; fi

# The input may be the output
run 0 plain.off plain.off
expect_faces plain.off 400

echo "$failures failures"
[ $failures -eq 0 ]
