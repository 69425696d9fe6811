# The modules of the library: which public headers are the doors of each, and which modules it stands on.
# All that is behind the doors of a module is in include/quadrille/internal/MODULE; a public header that is
# not in a list is the core's. test/repository.sh reads these lists, too.
set(attributes_headers channels.h texture_deviation.h)
set(guards_headers distance_limits.h guards.h hull.h)
set(levels_headers level_maps.h level_splits.h level_steps.h levels.h levels_file.h levels_file_options.h)
set(cluster_headers cluster.h)
set(planar_headers planar_patches.h boundaries.h keep_planes.h)
set(visibility_headers hidden.h)
set(gaps_headers join_gaps.h)
set(verify_headers bounded_hausdorff.h calibrated.h distance.h verdict.h verify.h)
set(file_headers file.h file_distance.h file_report.h mpi.h)
set(compiled_headers compiled.h)
set(c_headers quadrille.h)

set(core_needs)
set(attributes_needs core)
set(guards_needs core)
set(levels_needs core)
set(cluster_needs core)
set(planar_needs core attributes guards)
set(visibility_needs core)
set(gaps_needs core guards)
set(verify_needs core guards)
set(file_needs core attributes guards verify)
set(compiled_needs core attributes guards planar gaps)
set(c_needs core attributes guards planar gaps levels verify compiled)

set(quadrille_modules core attributes guards levels cluster planar visibility gaps verify file compiled c)
