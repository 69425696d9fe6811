#!/bin/sh
# Time against size at vertices of very many faces, as a table and a plot; takes what
# benchmark/run.sh has built.
#   sh benchmark/hubs.sh
# hubs.csv and hubs.png go to build/benchmark/results.
set -eu
export LC_ALL=C

cd -- "$(dirname -- "$0")/../build/benchmark"
mkdir -p results
benchmark/quadrille_hub_benchmark 80000 >results/hubs.csv
gnuplot -e "table='results/hubs.csv'; plot='results/hubs.png'" ../../benchmark/hubs.gp
