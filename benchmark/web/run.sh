#!/bin/sh
# Size, time and error of the package in JavaScript beside the npm package meshoptimizer, on three models.
#   sh benchmark/web/run.sh [FOLDER]
# FOLDER, build/web by default, is where test/web/run.sh has built. npm fetches meshoptimizer into it. Models are those of
# $QUADRILLE_DATA if that is set, else of the configured build.
set -eu
export LC_ALL=C
cd -- "$(dirname -- "$0")/../.."
folder=$(realpath -m -- "${1:-build/web}")
if [ -n "${QUADRILLE_DATA:-}" ]; then
  models="$QUADRILLE_DATA/closed"
  set -- "$models/bunny_70k.off" "$models/armadillo_86k.obj" "$models/nefertiti_100k.obj"
else
  models="${CGAL_DATA_DIR:-$PWD/build/test/data}/meshes"
  set -- "$models/bunny00.off" "$models/refined_elephant.off" "$models/armadillo.off"
fi
cmake --build "$folder/native" --target distance >/dev/null
script=$PWD/benchmark/web/compare.mjs
mkdir -p "$folder/benchmark"
cp benchmark/web/package.json benchmark/web/package-lock.json "$folder/benchmark"
cd "$folder/benchmark"
npm ci --ignore-scripts --no-audit --no-fund --no-update-notifier >npm.log
node "$script" "$folder/package/quadrille" "$folder/native/distance" "$@"
