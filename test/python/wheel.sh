#!/bin/sh
# Makes the wheel of the Python module without a network, installs it in a virtual environment that has
# only numpy beside, tries it there, and uninstalls it. Neither may leave anything in the source tree.
# Needs pip, venv, setuptools, wheel, and git. To compile takes minutes, and CMAKE_BUILD_PARALLEL_LEVEL
# cores, or all.
#   sh wheel.sh [PYTHON]
set -eu
repository=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
python=${1:-/usr/bin/python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' HUP INT TERM
unset PYTHONPATH PYTHONDONTWRITEBYTECODE
export PIP_CONFIG_FILE=/dev/null PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore
fail() {
  echo "wheel.sh: $1" >&2
  exit 1
}

# A copy of the source tree, so that nobody else writes to it.
mkdir "$folder/source" "$folder/elsewhere"
(cd "$repository" && git ls-files -z --cached --others --exclude-standard | tar -c --null -T -) |
  tar -x -C "$folder/source"
(cd "$folder/source" && find . | sort) > "$folder/before"

offline=
! unshare --map-root-user --net true 2>/dev/null || offline="unshare --map-root-user --net"
$offline "$python" -m pip wheel --verbose --no-build-isolation --no-deps --wheel-dir "$folder" \
  "$folder/source" > "$folder/log" 2>&1 || { cat "$folder/log"; fail "no wheel"; }
! grep 'by npm' "$folder/log" || fail "it fetches what it does not need"
(cd "$folder/source" && find . | sort) | diff "$folder/before" - || fail "it leaves files in the source tree"

# All of the package is in it, and the licence.
wheel=$(echo "$folder"/quadrille_mesh-*-py3-none-linux_*.whl)
"$python" -m zipfile --list "$wheel" | awk 'NR > 1 { print $1 }' > "$folder/content"
for file in $(cd "$folder/source/examples/products/python" && find quadrille -type f); do
  grep -qx "$file" "$folder/content" || fail "$file is not in the wheel"
done
grep -qx 'quadrille/libquadrille_python\.so' "$folder/content" || fail "the compiled part is not in the wheel"
for file in LICENSE NOTICE.md; do
  grep -q "\.dist-info/.*$file\$" "$folder/content" || fail "$file is not in the wheel"
done

# An environment with numpy alone.
"$python" -m venv "$folder/venv"
in_venv="$folder/venv/bin/python"
cd "$folder/elsewhere"
numpy=$(dirname "$("$python" -c 'import os, numpy; print(os.path.dirname(numpy.__file__))')")
site=$("$in_venv" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
ln -s "$numpy"/numpy "$numpy"/numpy[-.]* "$site"
"$in_venv" -m pip install --quiet "$wheel"
"$in_venv" -m pip check --quiet

"$in_venv" -c '
import sys
import numpy as np
import quadrille
from importlib.metadata import metadata
assert quadrille.__file__.startswith(sys.argv[1]), quadrille.__file__
told = metadata("quadrille-mesh")
assert told["Version"] == quadrille.__version__, (told["Version"], quadrille.__version__)
assert "LGPL" in told["License"] and " GPL" not in told["License"], told["License"]

# A sphere: each face of an octahedron in four, five times.
signs = np.array([[x, y, z] for x in (1, -1) for y in (1, -1) for z in (1, -1)])
corners = np.array([np.diag(s)[::s.prod()] for s in signs], float)
for _ in range(5):
    a, b, c = np.moveaxis(corners, 1, 0)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    corners = np.concatenate([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
points, faces = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
points, faces = points / np.linalg.norm(points, axis=1, keepdims=True), faces.reshape(-1, 3)

small = quadrille.simplify(points, faces, faces=800)
assert len(faces) == 8192 and len(small.faces) == 800 and len(small.points) == 402, small
a, b, c = np.moveaxis(small.points[small.faces], 1, 0)
volume = (a * np.cross(b, c)).sum() / 6
assert abs(volume - 4 / 3 * np.pi) < 0.05, volume
print("of a sphere of", len(faces), "faces", len(small.faces), "are left, of volume", volume)' "$folder/venv"
for test in test_module.py test_policies.py test_libraries.py test_words.py test_drop_in.py; do
  PYTHONDONTWRITEBYTECODE=1 "$in_venv" -W error::DeprecationWarning "$folder/source/test/python/$test" 2> "$folder/log" ||
    { cat "$folder/log"; fail "$test fails"; }
  tail -n 3 "$folder/log"
done

"$in_venv" -m pip uninstall --quiet --yes quadrille-mesh
! "$in_venv" -c 'import quadrille' 2>/dev/null || fail "it is still there"
[ -z "$(find "$folder/venv" -name '*quadrille*')" ] || fail "files of it are still there"
(cd "$folder/source" && find . | sort) | diff "$folder/before" - || fail "its tests leave files in the source tree"
echo "${wheel##*/}: $(wc -c < "$wheel") bytes, made, installed, tried, uninstalled"
