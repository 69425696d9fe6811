#!/bin/sh
# Checks that a file is simplified to the same bytes over any number of ranks, and that what a rank
# throws ends all of them; exits with 77 where MPI does not run.
#   sh ranks.sh RANKS QUADRILLE MODEL.off MPIEXEC
set -eu
ranks=$1 quadrille=$2 model=$3 mpiexec=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# In a container, and as its only user; of one computer.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_btl=self,vader
over() { # number, argument...
  number=$1
  shift
  timeout 120 "$mpiexec" -n "$number" "$@"
}
over 2 true 2>/dev/null || { echo "skipped: $mpiexec does not run"; exit 77; }

"$quadrille" "$model" "$work/whole.ply" --keep 100% --quiet
for number in 1 2 3; do
  over $number "$ranks" "$work/whole.ply" "$work/$number.ply" 600 "$work/scratch" 1000000000 600
  [ ! -e "$work/scratch" ] || { echo "the scratch folder is left"; exit 1; }
  cmp "$work/1.ply" "$work/$number.ply"
done
grep -a -q 'element face 600$' "$work/1.ply"

! over 3 "$ranks" "$work/missing.ply" "$work/none.ply" 600 "$work/scratch" 2>"$work/errors"
grep -q 'missing.ply' "$work/errors"
[ "$(grep -c 'another rank has failed' "$work/errors")" -eq 2 ]
[ ! -e "$work/none.ply" ]
