#!/bin/sh
# Draws the pictures of README and documents, doc/*.png (see doc/gallery.md), without a screen. Debian packages
# that are missing are installed first, and the programs built.
#   sh doc/gallery.sh [--built FOLDER] [NAME...]     those of the names, or all
# --built names a build folder of the project, the programs of which are taken as they are. Meshes go to
# build/gallery.
set -eu
export LC_ALL=C PYTHONDONTWRITEBYTECODE=1

cd -- "$(dirname -- "$0")/.."
built=
if [ "${1-}" = --built ]; then
  built=$2
  shift 2
fi
all="front costs placement pairs boundary topology order labels colours texture levels hull foot quadrics importance tolerance walls planar seams generated time"
for name in "$@"; do
  case " $all " in
    *" $name "*) ;;
    *) echo "gallery.sh: no picture $name; there are: $all" >&2; exit 2 ;;
  esac
done

sh .ci/install_packages.sh cmake g++ make libcgal-dev libcgal-demo libboost-dev libcli11-dev libeigen3-dev nlohmann-json3-dev \
  libzstd-dev python3 python3-vtk9 python3-numpy python3-pil fonts-dejavu-core xvfb xauth gnuplot-nox
if [ -z "$built" ]; then
  built=build/examples
  cmake -S . -B $built -DCMAKE_BUILD_TYPE=Release -DQUADRILLE_BUILD_TESTS=OFF -DQUADRILLE_BUILD_BENCHMARKS=ON
  cmake --build $built --target quadrille_program figures levels hulls importance planar_patches quadrille_seams --parallel "$(nproc)"
fi
models=$built/data/meshes
out=build/gallery
mkdir -p $out

# --- What pictures are made of ---------------------------------------------------------------------

# simplified IN OUT OPTION...: by the program, into build/gallery.
simplified() {
  in=$1 target=$out/$2
  shift 2
  "$built/examples/products/program/quadrille" "$in" "$target" --quiet "$@"
}

# made WHAT ARGUMENT...: a model that is not in libcgal-demo.
made() { /usr/bin/python3 doc/gallery/models.py "$@"; }

# drawn PICTURE ARGUMENT...: a PNG, see doc/gallery/draw.py.
drawn() {
  picture=doc/$1
  shift
  xvfb-run -a /usr/bin/python3 doc/gallery/draw.py "$picture" "$@"
}

figures() { "$built/examples/figures" "$models" $out "$@"; }

# The bunny with a texture, and at so many faces.
textured_bunny() {
  [ -f $out/bunny.png ] || made textured "$models/bunny00.off" $out/bunny.obj
  for faces in "$@"; do
    [ -f "$out/bunny_$faces.obj" ] || simplified $out/bunny.obj "bunny_$faces.obj" --faces "$faces"
  done
}

# --- The pictures ----------------------------------------------------------------------------------

draw_front() {
  textured_bunny 15082 3770 1130
  drawn front.png --size 400,350 --colours 120 --cut 0.5 --from -0.3,0.12,1 --up 0,1,0 --texture $out/bunny.png \
    $out/bunny.obj='{} faces|100 %' --edges 0.1 $out/bunny_15082.obj='{} faces|20 %' --edges 0.25 \
    $out/bunny_3770.obj='{} faces|5 %' --edges 0.5 $out/bunny_1130.obj='{} faces|1.5 %' --edges 0.9
}

draw_costs() {
  for cost in quadric memoryless thin-features length; do
    simplified "$models/cow.off" cow_$cost.off --faces 64 --cost $cost
  done
  drawn costs.png --size 320,230 --zoom 0.96 --from 0.4,0.1,1 --up 0,1,0 --edges 0.7 \
    "$models/cow.off"='The cow|{} faces' --edges 0.25 $out/cow_quadric.off='Quadric|{} faces' \
    $out/cow_memoryless.off='MemorylessQuadric|{} faces' $out/cow_thin-features.off='ThinFeatureQuadric|{} faces' \
    $out/cow_length.off='EdgeLength|{} faces'
}

draw_placement() {
  for placement in optimal endpoint midpoint; do
    simplified "$models/fandisk.off" fandisk_$placement.off --faces 150 --placement $placement
  done
  drawn placement.png --size 400,250 --edges 0.7 --from 1,0.6,1 --up 0,1,0 \
    "$models/fandisk.off"='The fandisk|{} faces' --edges 0.15 $out/fandisk_optimal.off='OptimalPlacement|{} faces' \
    $out/fandisk_endpoint.off='EndpointPlacement|{} faces' $out/fandisk_midpoint.off='MidpointPlacement|{} faces'
}

draw_pairs() {
  figures 2 9
  drawn pairs.png --size 520,330 --colours 160 --zoom 2.2 --at -0.66,0.12 --from 0,1,0.4 --edges 0.7 \
    $out/2_bones.off='{} faces, 26 parts|edges red, other pairs closer than 0.318 green' --edges 0 \
    --lines $out/9_bones_edges.obj,205,45,45,0.8 --lines $out/9_bones_pairs.obj,40,150,60,0.8 \
    $out/2_bones_edges.off='EdgePairs|{} faces, 18 parts' $out/2_bones_pairs.off='ThresholdPairs{0.318}|{} faces, 1 part'
}

draw_boundary() {
  made sheet $out/sheet.off
  for boundary in 0 100 lock; do
    simplified $out/sheet.off sheet_$boundary.off --faces 300 --boundary $boundary
  done
  drawn boundary.png --size 400,330 --edges 0.6 --from 0,-1,1.6 \
    $out/sheet.off='A dome|{} faces' --edges 0.12 $out/sheet_0.off='boundary_weight = 0|{} faces' \
    $out/sheet_100.off='boundary_weight = 100, the default|{} faces' $out/sheet_lock.off='locked|{} faces'
}

draw_topology() {
  made debris "$models/cheese.off" $out/debris.off
  simplified $out/debris.off debris_kept.off --faces 1600 --topology kept
  simplified $out/debris.off debris_free.off --faces 1600 --topology free
  simplified $out/debris.off debris_dropped.off --faces 1600 --drop-parts
  drawn topology.png --size 400,370 --edges 0.6 --from 0.5,0.5,1 --up 0,1,0 \
    $out/debris.off='{} faces, 41 parts|with 133 tunnels' --edges 0.1 $out/debris_kept.off='Topology::kept|{} faces' \
    $out/debris_free.off='Topology::free|{} faces' $out/debris_dropped.off='Topology::components_may_vanish|{} faces'
}

# The generator is among the cases of the benchmark generated.py.
draw_generated() {
  [ -n "${QUADRILLE_CASES-}" ] || { echo "generated.png needs the folder QUADRILLE_CASES" >&2; return; }
  python3 "$QUADRILLE_CASES/wild/gen_shell.py" $out/shell.ply 200
  for faces in 20000 2000; do
    simplified $out/shell.ply shell_$faces.ply --faces $faces --preset generated
  done
  drawn generated.png --size 300,270 --edges 0.5 --from 1,-2,1 --zoom 1.2 $out/shell.ply='{} faces|a generated shell' \
    $out/shell_20000.ply='{} faces|--preset generated' $out/shell_2000.ply='{} faces|--preset generated'
}

draw_order() {
  for order in greedy relaxed; do
    simplified "$models/bunny00.off" order_$order.off --faces 1500 --order $order
  done
  drawn order.png --size 400,350 --edges 0.7 --from -0.3,0.12,1 --up 0,1,0 \
    "$models/bunny00.off"='The bunny|{} faces' --edges 0.1 $out/order_greedy.off='GreedyOrder|{} faces' \
    $out/order_relaxed.off='RelaxedOrder|{} faces'
}

# Integers of faces are labels but for those by the name of flags: see doc/manual/tool.md.
draw_labels() {
  made regions "$models/bear.off" $out/regions.ply
  made regions "$models/bear.off" $out/flags.ply flags
  simplified $out/regions.ply regions_kept.ply --faces 250
  simplified $out/flags.ply flags_250.ply --faces 250
  made painted $out/flags_250.ply $out/regions_lost.ply flags
  drawn labels.png --size 400,420 --colours 256 --edges 0.6 --from 0.2,0.1,1 --up 0,1,0 \
    $out/regions.ply='A bear of eight regions|{} faces' --edges 0.12 $out/regions_lost.ply='without labels|{} faces' \
    $out/regions_kept.ply='Labels{regions}|{} faces'
}

draw_colours() {
  figures 5
  drawn colours.png --size 400,300 --colours 0 --unlit --inside 5.7,0.3,2.1,2.2,3,0.9,62 \
    $out/5_room.ply='The room|{} faces' $out/5_room_3000_quadric.ply='Quadric|{} faces, colours looked up' \
    $out/5_room_3000_color_quadric.ply='ColorQuadric|{} faces'
}

draw_texture() {
  textured_bunny 7540 1000 300
  drawn texture.png --size 400,330 --colours 160 --zoom 1.8 --at -0.32,0.3 --from -0.3,0.12,1 --up 0,1,0 \
    --texture $out/bunny.png $out/bunny.obj='{} faces' $out/bunny_7540.obj='{} faces' $out/bunny_1000.obj='{} faces' \
    $out/bunny_300.obj='{} faces'
}

draw_levels() {
  "$built/examples/levels" "$models/cow.off" $out/cow
  drawn levels.png --size 230,160 --from 0.2,0.3,1 --up 0,1,0 --edges 0.7 "$models/cow.off"='{} faces' --edges 0.25 \
    $out/cow-994.off='{}' --edges 0.4 $out/cow-532.off='{}' $out/cow-248.off='{}' $out/cow-64.off='{}'
}

draw_hull() {
  "$built/examples/hulls" "$models/cow.off" $out/cow
  drawn hull.png --size 430,300 --colours 160 --from 0.4,0.35,1 --up 0,1,0 "$models/cow.off"='The cow|{} faces' \
    $out/cow-inner.off='InnerHull|{} faces' --edges 0.6 "$models/cow.off"='OuterHull|the cow in its hull of 400 faces' \
    --around $out/cow-outer.off
}

draw_importance() {
  "$built/examples/importance" "$models/bunny00.off" $out/bunny
  drawn importance.png --size 320,300 --from -0.3,0.12,1 --up 0,1,0 --edges 0.7 $out/bunny-alike.off='Alike|{} faces' \
    $out/bunny-curvature.off='By curvature|{} faces' $out/bunny-view.off='Seen from the left|{} faces' \
    $out/bunny-painted.off='Painted head|{} faces'
}

draw_foot() {
  figures 2
  drawn foot.png --columns 2 --size 480,240 --from 0,1,0.4 --edges 0.7 \
    $out/2_bones.off='{} faces|26 parts' --edges 0.4 $out/2_bones_cells.off='{} faces|11 × 4 × 4 cells' \
    $out/2_bones_edges.off='{} faces|by edges' $out/2_bones_pairs.off='{} faces|by pairs'
}

draw_quadrics() {
  figures 8
  drawn quadrics.png --size 560,480 --from 0,0.1,1 --up 0,1,0 \
    $out/8_bunny_1000.off='{} faces and their quadrics' --with $out/8_bunny_1000_ellipsoids.off
}

draw_tolerance() {
  made tolerance "$models/bunny00.off" $out/field.ply
  simplified $out/field.ply field_simplified.ply --tolerance allowed
  for error in 0.02% 2%; do
    simplified "$models/bunny00.off" within_$error.off --error $error --both-ways
  done
  drawn tolerance.png --size 320,300 --colours 160 --from -0.3,0.12,1 --up 0,1,0 --edges 0.5 \
    $out/field.ply='Tolerances|0.02 % red, 2 % white' --edges 0.05 $out/field_simplified.ply='ToleranceLimit|{} faces' \
    $out/within_0.02%.off='0.02 % everywhere|{} faces' --edges 0.25 $out/within_2%.off='2 % everywhere|{} faces'
}

draw_seams() {
  simplified "$models/bunny00.off" bunny00.ply --keep 100%
  "$built/benchmark/quadrille_seams" $out/bunny00.ply 7540 10 memoryless $out/parts.ply $out/borders
  drawn seams.png --size 420,400 --colours 160 --from -0.3,0.12,1 --up 0,1,0 --edges 0.35 \
    $out/parts.ply='In 16 parts|borders of phase 1 red, of phase 2 blue' --lines $out/borders-1.obj,205,45,45,1.6 \
    --lines $out/borders-2.obj,40,80,200,1.6 $out/parts.ply='The same|{} faces' $out/borders-one.ply='In one part|{} faces'
}

draw_walls() {
  made spiral $out/spiral.off
  simplified $out/spiral.off spiral_250.off --cost memoryless --faces 250
  simplified $out/spiral.off spiral_apart.off --cost memoryless --faces 250 --no-self-intersection
  pairs=$(made crossing $out/spiral_250.off $out/spiral_250.ply)
  drawn walls.png --size 420,400 --colours 120 --from 0.1,-0.35,1 --up 0,1,0 --edges 0 $out/spiral.off='{} faces' \
    --edges 0.8 $out/spiral_250.ply="{} faces|$pairs pairs of them pass through each other" \
    $out/spiral_apart.off='NoSelfIntersection|{} faces, of which none do'
}

draw_planar() {
  made houses $out/houses.off
  "$built/examples/planar_patches" $out/houses.off $out/houses_planar.off 1e-9
  drawn planar.png --size 560,330 --colours 120 --from 0.5,-0.8,0.9 --edges 0.4 $out/houses.off='Voxels|{} faces' \
    --edges 0.9 $out/houses_planar.off='Planar patches|{} faces, the same surface'
}

# Of the first table of doc/benchmarks.md.
draw_time() {
  awk -F ' *[|] *' '/^[|] contender/      { inside = 1; next }
                    inside && /^[|][-:|]+$/ { next }
                    inside && /^$/          { exit }
                    inside                  { print $2 "," $3 "," $5 }' doc/benchmarks.md >$out/time.csv
  gnuplot -e "table='$out/time.csv'; plot='doc/time.png'" doc/gallery/time.gp
}

for name in ${*:-$all}; do
  echo "doc/$name.png"
  "draw_$name"
done
