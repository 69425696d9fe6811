#!/bin/sh
# The package in JavaScript: builds it with emscripten, and the program that it is compared with; then it
# gives the same bytes as that in node, refuses what it has to, and works in headless Chromium, as does the page simplify.html. The programs
# of its manual run, and its types are those of TypeScript where npm finds that. It takes about ten minutes the
# first time, half a minute if nothing has changed.
#   sh test/web/run.sh [FOLDER]
# builds in FOLDER, build/web by default. Models are those of a configured build: CGAL_DATA_DIR, or that of
# `cmake --preset test`.
set -eu
export LC_ALL=C
cd -- "$(dirname -- "$0")/../.."
folder=$(realpath -m -- "${1:-build/web}")
export CGAL_DATA_DIR="${CGAL_DATA_DIR:-$PWD/build/test/data}"
[ -f "$CGAL_DATA_DIR/meshes/elephant.off" ] || {
  echo "no models in $CGAL_DATA_DIR: configure a build first, cmake --preset test" >&2
  exit 2
}

# Emscripten of Debian needs its node-acorn, which a node from elsewhere does not look for.
export NODE_PATH="${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs"
# The compiler of emscripten has no launcher of CMake's.
if command -v ccache >/dev/null; then
  export EM_COMPILER_WRAPPER="${EM_COMPILER_WRAPPER:-$(command -v ccache)}"
fi
env -u CMAKE_CXX_COMPILER_LAUNCHER emcmake cmake -S examples/products/web -B "$folder/package" >/dev/null
cmake --build "$folder/package"
unset EM_COMPILER_WRAPPER
cmake -S test/web -B "$folder/native" >/dev/null
cmake --build "$folder/native" --target native

export PACKAGE="$folder/package/quadrille" PAGE="$folder/package/simplify.html" NATIVE="$folder/native/native" WORK="$folder"
[ -d "$folder/node_modules/typescript" ] || {
  cp test/web/package.json test/web/package-lock.json "$folder"
  (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund --no-update-notifier >npm.log 2>&1) ||
    echo "TypeScript is left out: see $folder/npm.log"
}
node --test --test-concurrency=1 test/web/*.test.mjs
