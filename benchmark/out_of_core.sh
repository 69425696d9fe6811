#!/bin/sh
# Simplifies surfaces by parts that are made by formulas and are never in memory, and prints time and memory of
# each run, as the kernel counts it, and whether the result is closed and of the genus of the input.
#   sh benchmark/out_of_core.sh PROGRAM FOLDER [FACES [MEMORY [THREADS]]]
# FOLDER takes about 55 bytes for each face; 1e7 faces to a tenth in 500 MB take some minutes.
set -eu
export LC_ALL=C
program=$1
folder=$2
faces=${3:-1e7}
memory=${4:-500M}
threads=${5:-1}
source=$(dirname -- "$0")/formula_ply.cpp

mkdir -p "$folder"
${CXX:-c++} -std=c++20 -O2 "$source" -o "$folder/formula_ply"
target=$(awk "BEGIN { print int($faces / 20) * 2 }")
for model in torus plate; do
  "$folder/formula_ply" $model "$faces" "$folder/$model.ply"
  for cost in memoryless quadric; do
    begin=$(date +%s.%N)
    "$program" "$folder/$model.ply" "$folder/out.ply" --faces "$target" --cost $cost --threads "$threads" \
      --out-of-core "$folder/scratch" --memory "$memory" --report "$folder/report.json" --quiet
    awk -v begin="$begin" -v end="$(date +%s.%N)" -v faces="$faces" -v name="$model $cost" \
      '/"peak_memory"/ { peak = $2 + 0 } /"phases"/ { phases = $2 + 0 } /"parts"/ { parts = $2 + 0 }
       END { printf "%s: %.3g faces, %d parts, %d phases, %.1f s, %.2f us a face, %.0f MB\n", name, faces,
             parts, phases, end - begin, 1e6 * (end - begin) / faces, peak / 1e6 }' "$folder/report.json"
    "$folder/formula_ply" check "$folder/out.ply"
  done
  rm -f "$folder/$model.ply" "$folder/out.ply"
done
