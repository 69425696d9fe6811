#!/bin/sh
# Looks at what a build folder installs and packs.
#   sh installed.sh CHECK ARGUMENT...    a CHECK is one of the functions below
set -eu
check=$1
shift

# Debian packages of a build folder have in them what they should. Skipped (77) where there is no dpkg.
#   packages CPACK BUILD_FOLDER VERSION
packages() {
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
}

# The Python module is installed where python3 looks for modules below a prefix, by its component alone,
# and can be imported from there.
#   python CMAKE BUILD PREFIX PYTHON
python() {
  cmake=$1 build=$2 prefix=$3 python=$4
  rm -rf "$prefix"
  "$cmake" --install "$build" --component python --prefix "$prefix" >/dev/null
  [ "$(ls "$prefix" | tr '\n' ' ')" = "lib share " ] || { ls "$prefix"; exit 1; }

  # The folder of this version, and below /usr that of Debian's packages.
  folder=$(echo "$prefix"/lib/python3.*/*-packages)
  cd "$folder/quadrille"
  ls __init__.py py.typed _core.pyi _library.py drop_in/pyfqmr.py libquadrille_python.so
  cd /
  PYTHONPATH=$folder PYTHONDONTWRITEBYTECODE=1 "$python" -c '
import quadrille, sys
print(quadrille.__version__, quadrille.__file__)
assert quadrille.__file__.startswith(sys.argv[1])
points, faces = quadrille.simplify([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
assert faces.shape[1] == 3' "$folder"
  [ ! -e /etc/debian_version ] || [ ! -w / ] || {
    DESTDIR=$prefix/root "$cmake" --install "$build" --component python --prefix /usr >/dev/null
    ls "$prefix/root/usr/lib/python3/dist-packages/quadrille/__init__.py"
  }
}

"$check" "$@"
