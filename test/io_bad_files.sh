#!/bin/sh
# Runs the program over a folder of broken and odd files and checks that each ends as it must: a file
# that loads, also with targets down to no face at all.
#
#   io_bad_files.sh DATA_DIR PROGRAM
#
# DATA_DIR holds bad/EXPECT.tsv, or EXPECT.tsv itself, or lies beside a folder `bad` that does: a line
# for each file with its name, what is expected of it and why. If it is empty, it is what the
# environment variable QUADRILLE_DATA says. Without EXPECT.tsv the test is skipped (exit status 77).
# MEMORY_KB limits the address space, 2 GB unless set; "unlimited" for sanitizers, which map more.

data=${1:-${QUADRILLE_DATA-}}
program=$2
memory_kb=${MEMORY_KB:-2097152}

if [ $# -ne 2 ] || [ ! -x "$program" ]; then
  echo "usage: $0 DATA_DIR PROGRAM" >&2
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

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
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
