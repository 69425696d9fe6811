#!/bin/sh
# Makes Debian packages of a build folder and checks what is in them.
#
#   packages.sh CPACK BUILD_FOLDER VERSION
set -eu
cpack=$1 build=$2 version=$3
for tool in dpkg-deb dpkg-shlibdeps; do
  command -v $tool >/dev/null || { echo "skipped: no $tool"; exit 77; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$work" >"$work/log" 2>&1 || {
  cat "$work/log"
  exit 1
}

failures=0
fail() {
  failures=$((failures + 1))
  echo "$1"
}
expect_files() { # package.deb, path...
  dpkg-deb --contents "$1" | awk '{ print $6 }' >"$work/contents"
  shift
  for path in "$@"; do
    grep -qx "\./$path" "$work/contents" || fail "no $path"
  done
}
expect_field() { # package.deb, field, extended regular expression
  dpkg-deb --field "$1" "$2" | grep -qE "$3" || fail "$2 of $1 is $(dpkg-deb --field "$1" "$2")"
}

program=$(echo "$work"/quadrille_"$version"_*.deb)
expect_files "$program" usr/bin/quadrille usr/share/bash-completion/completions/quadrille
! command -v help2man >/dev/null || expect_files "$program" usr/share/man/man1/quadrille.1
expect_field "$program" Depends 'libgmp10.*libstdc\+\+6|libstdc\+\+6.*libgmp10|libstdc\+\+6'
expect_field "$program" Description quadric
library=$work/libquadrille-dev_${version}_all.deb
expect_files "$library" usr/include/quadrille/simplify.h usr/include/quadrille/compiled/quadric.cpp \
  usr/share/cmake/quadrille/quadrilleConfig.cmake
expect_field "$library" Depends libcgal-dev
! grep -q bin/ "$work/contents" || fail "the library's package has a program"

# What is unpacked runs
dpkg-deb --extract "$program" "$work/root"
[ "$("$work/root/usr/bin/quadrille" --version)" = "$version" ] || fail "another version"

echo "$failures failures"
[ $failures -eq 0 ]
