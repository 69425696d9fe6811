#!/bin/sh
# Checks that a file is simplified to the same bytes over any number of ranks, also where one of them
# is killed, and that what a rank throws ends all of them; and that the program is such ranks where it
# was built with MPI, and says that it is not where it was not. Exits with 77 where MPI does not run.
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

# A rank is lost as soon as a part is done: MPI ends the others, and two ranks go on.
over 3 "$ranks" "$work/whole.ply" "$work/torn.ply" 600 "$work/scratch" 1000000000 600 >/dev/null 2>&1 &
torn=$!
while kill -0 $torn 2>/dev/null && ! find "$work/scratch" -name 'left-*' 2>/dev/null | grep -q .; do :; done
for process in $(pgrep -f "^$ranks $work/whole.ply" | tail -n 1); do kill -9 "$process" || :; done
wait $torn || :
[ -e "$work/torn.ply" ] ||
  over 2 "$ranks" "$work/whole.ply" "$work/torn.ply" 600 "$work/scratch" 1000000000 600
cmp "$work/1.ply" "$work/torn.ply"
[ ! -e "$work/scratch" ] || { echo "the scratch folder is left"; exit 1; }

! over 3 "$ranks" "$work/missing.ply" "$work/none.ply" 600 "$work/scratch" 2>"$work/errors"
grep -q '^rank 0: [^ ]*missing.ply: cannot be opened' "$work/errors"
[ "$(grep -c '^rank [12]: rank 0: [^ ]*missing.ply: cannot be opened' "$work/errors")" -eq 2 ]
[ ! -e "$work/none.ply" ]

# The program: one sentence, of the first rank, or of each where they do not know each other.
"$quadrille" "$work/whole.ply" "$work/program.ply" --faces 600 --out-of-core "$work/scratch" --quiet
if ldd "$quadrille" | grep -q libmpi; then
  over 3 "$quadrille" "$work/whole.ply" "$work/3.ply" --faces 600 --out-of-core "$work/scratch" >"$work/said"
  [ "$(grep -c 'whole.ply: ' "$work/said")" -eq 1 ]
  cmp "$work/program.ply" "$work/3.ply"
  ! over 3 "$quadrille" "$work/missing.ply" "$work/none.ply" --out-of-core "$work/scratch" 2>"$work/errors"
  [ "$(grep -c 'missing.ply: cannot be opened' "$work/errors")" -eq 1 ]
fi
# As if mpirun of another MPI had started it, or of any if it has none.
size=PMI_SIZE
if ldd "$quadrille" | grep -q libmpich; then size=OMPI_COMM_WORLD_SIZE; fi
! env $size=4 "$quadrille" "$work/whole.ply" "$work/none.ply" \
  --out-of-core "$work/scratch" 2>"$work/errors"
grep -q '^--out-of-core: 4 processes of this program were started together' "$work/errors"
[ ! -e "$work/none.ply" ] && [ ! -e "$work/scratch" ]
