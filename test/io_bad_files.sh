#!/bin/sh
# Runs the program over a folder of broken and odd files and checks that each ends as it must.
#
#   io_bad_files.sh DATA_DIR PROGRAM
#
# DATA_DIR holds bad/EXPECT.tsv, or EXPECT.tsv itself: a line for each file with its name, what is
# expected of it and why. Without that file the test is skipped (exit status 77).
# MEMORY_KB limits the address space, 2 GB unless set; "unlimited" for sanitizers, which map more.

data=$1
program=$2
memory_kb=${MEMORY_KB:-2097152}

if [ $# -ne 2 ] || [ ! -x "$program" ]; then
  echo "usage: $0 DATA_DIR PROGRAM" >&2
  exit 2
fi
[ -f "$data/bad/EXPECT.tsv" ] && data=$data/bad
if [ ! -f "$data/EXPECT.tsv" ]; then
  echo "skipped: no EXPECT.tsv in $data"
  exit 77
fi

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
output=$work/out/result.off # as text, so that it can be searched
checked=0
mismatches=0

run() { # file
  rm -rf "$work/out"
  mkdir "$work/out"
  (
    [ "$memory_kb" = unlimited ] || ulimit -v "$memory_kb"
    exec timeout 20 "$program" "$data/$1" "$output"
  ) >"$work/stdout" 2>"$work/stderr"
  status=$?
}

complain() { # message
  mismatches=$((mismatches + 1))
  failed=1
  echo "$file (expected: $expected, status $status): $1"
  sed 's/^/    /' "$work/stderr" | head -n 3
}

# A mesh of finite numbers, and nothing else beside it.
check_output() {
  failed=0
  if [ ! -f "$output" ]; then
    complain "no output"
  elif grep -qiE 'nan|inf' "$output"; then
    complain "the output has numbers that are not finite"
  elif [ "$(ls -A "$work/out")" != result.off ]; then
    complain "there is more than the output"
  elif ! "$program" --quiet --ratio 1 "$output" "$work/again.off" 2>"$work/stderr"; then
    complain "the output does not read back"
  fi
  return $failed
}

check_ok() {
  case $status in
    0 | 1) check_output ;;
    *) complain "it must load" ;;
  esac
}

check_empty() {
  if [ "$status" -ne 0 ]; then
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
  run "$file"
  checked=$((checked + 1))
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
