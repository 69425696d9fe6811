#!/bin/sh
# Time against size at vertices of very many faces, as a table and a plot; takes what
# benchmark/run.sh has built.
#   sh benchmark/high_valence.sh
# high_valence.csv and high_valence.png go to build/benchmark/results.
set -eu
export LC_ALL=C

cd -- "$(dirname -- "$0")/../build/benchmark"
mkdir -p results
benchmark/quadrille_high_valence_benchmark 80000 >results/high_valence.csv
gnuplot -e "table='results/high_valence.csv'; plot='results/high_valence.png'" ../../benchmark/high_valence.gp
