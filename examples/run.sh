#!/bin/sh
# Builds the examples and runs one of them. Debian packages that are missing are installed first.
#   sh examples/run.sh               simplifies the models of the papers and prints a table
#   sh examples/run.sh --figures [NUMBER...]
#                                    computes the papers' figures (doc/figures.md)
#   sh examples/run.sh ARGUMENT...   runs the program quadrille (--help lists its arguments)
# Exit status: that of the program, or 3 if it cannot be built.
set -u

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$root/build/examples
log=$build/build.log
case $#,${1-} in
  0,*)         target=papers_models; set -- "$build/data/meshes" "$build/results" ;;
  *,--figures) target=figures; shift; set -- "$build/data/meshes" "$build/figures" "$@" ;;
  *)           target=quadrille_program ;;
esac
case $target in
  quadrille_program) program=$build/examples/products/program/quadrille ;;
  *)                 program=$build/examples/$target ;;
esac

# Pages take three.js, which npm fetches. An npm from elsewhere does, and does not go together with Debian's.
npm=
case $* in
  *.html*) command -v npm >/dev/null || npm=npm ;;
esac

# Standard error is kept as 3, for what is told of the first run while all else goes to the log.
is_first=
[ -x "$program" ] || is_first=1
tell() {
  [ -z "$is_first" ] || echo "$*" >&3
}

prepare() {
  tell "1 of 3: installing what is missing of the Debian packages"
  sh "$root/.ci/install_packages.sh" \
    cmake g++ make libcgal-dev libcgal-demo libboost-dev libeigen3-dev libcli11-dev nlohmann-json3-dev \
    libnanoflann-dev libzstd-dev libtbb-dev $npm &&
  tell "2 of 3: configuring with CMake" &&
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DQUADRILLE_BUILD_TESTS=OFF &&
  tell "3 of 3: building $target" &&
  cmake --build "$build" --target "$target" --parallel "$(nproc)"
}

# Tells the last line of the log now and then, where it is another one: a package, or a part in per cent.
follow() {
  told=
  while sleep 20 >/dev/null 2>&1 3>&-; do
    line=$(tail -n 1 "$log" | cut -c 1-100)
    [ "$line" = "$told" ] || tell "        $line"
    told=$line
  done
}

mkdir -p "$build" || exit 3
exec 3>&2
tell "The first run installs what is missing and builds $program;" \
  "this takes some minutes, up to 2.7 GB of memory for one source. All that is said is in $log"
: >"$log"
follower=
if [ -n "$is_first" ]; then
  follow &
  follower=$!
  trap 'kill "$follower" 2>/dev/null' EXIT
  trap 'exit 3' HUP INT TERM
fi
prepare >"$log" 2>&1
status=$?
[ -z "$follower" ] || kill "$follower" 2>/dev/null
trap - EXIT HUP INT TERM
exec 3>&-
if [ "$status" -ne 0 ]; then
  cat "$log" >&2
  echo "The program $target could not be built; what is above is in $log" >&2
  exit 3
fi

exec "$program" "$@"
