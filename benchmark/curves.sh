#!/bin/sh
# Error against the number of faces, as a table and a plot; takes what benchmark/run.sh has built.
#   sh benchmark/curves.sh
# curves.csv and curves.png go to build/benchmark/results.
set -eu
export LC_ALL=C

cd -- "$(dirname -- "$0")/../build/benchmark"
mkdir -p results/curves
for model in cow fandisk_large armadillo bunny00; do
  for faces in 64 125 250 500 1000 2000 4000 8000 16000; do
    [ $model-$faces = cow-4000 ] && break
    benchmark/quadrille_benchmark --runs 1 --faces $faces --out results/curves --only \
      Quadrille 'Quadrille memoryless' 'Quadrille thin features' 'Quadrille relaxed refreshed' \
      'CGAL GH plane' 'CGAL Lindstrom-Turk' -- data/meshes/$model.off >&2
  done
done
# Of each row the model, the number asked for, the contender and the error: no name has a comma.
{
  echo model,faces,contender,rms
  sed -s 1d results/curves/*.csv | sed 's/"\([^"]*\)","[^"]*",/\1,/' | cut -d, -f1,3,4,14 |
    sort -t, -k1,1 -k3,3 -k2,2n
} >results/curves.csv
gnuplot -e "table='results/curves.csv'; plot='results/curves.png'" ../../benchmark/curves.gp
