#!/bin/sh
# Installs those of the named Debian packages that are missing; if none is, nothing is fetched.
#   sh .ci/install_packages.sh PACKAGE...
set -eu

fail() {
  echo "Missing Debian packages:$missing. $1" >&2
  exit 1
}

missing=
for package in "$@"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

command -v apt-get >/dev/null || fail "There is no apt-get here: install them, or build with CMake by hand."
if [ "$(id -u)" -eq 0 ]; then
  as_root=
elif command -v sudo >/dev/null; then
  as_root=sudo
else
  fail "Install them as root, or install sudo."
fi

echo "Installing:$missing"
# A broken third-party source does not matter as long as the packages themselves can be had.
$as_root apt-get update -qq || echo "apt-get update failed; going on with the lists at hand" >&2
# Slim images leave out documentation files, and with them CGAL's models.
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends \
  -o Dpkg::Use-Pty=0 -o Dpkg::Options::='--path-include=/usr/share/doc/libcgal-dev/data.tar.gz' $missing ||
  fail "apt-get could not install them."
