#!/bin/sh
# Checks that the Python module is installed where python3 looks for modules below a prefix, by its
# component alone, and can be imported from there.
#   sh installation.sh CMAKE BUILD PREFIX PYTHON
set -eu
cmake=$1 build=$2 prefix=$3 python=$4
rm -rf "$prefix"
"$cmake" --install "$build" --component python --prefix "$prefix" >/dev/null
[ "$(ls "$prefix" | tr '\n' ' ')" = "lib share " ] || { ls "$prefix"; exit 1; }

# The folder of this version, and below /usr that of Debian's packages.
folder=$(echo "$prefix"/lib/python3.*/*-packages)
cd "$folder/quadrille"
ls __init__.py py.typed _core.pyi _core.*.so
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
