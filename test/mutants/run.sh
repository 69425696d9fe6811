#!/bin/sh
# Puts the bugs of mutants.tsv, one at a time, into a copy of the sources, and looks whether the
# tests named beside each notice. Prints one line for each; fails if one survives.
#   sh test/mutants/run.sh [FIRST [LAST]]   lines of mutants.tsv, all of them by default
#   sh test/mutants/run.sh --check          compiles nothing: does each line fit the sources as they are?
#
# A line of mutants.tsv: file, by its path from include/quadrille, code, what replaces its first
# occurrence, tests (quadric_form stands for cost/test_quadric_form.cpp); between tabs, \n for the end of
# a line. The tests must pass without a bug, on the models of a configured build: CGAL_DATA_DIR, or that
# of `cmake --preset test`.
set -u
export LC_ALL=C

cd -- "$(dirname -- "$0")/../.."

# Prints what is wrong with lines of mutants.tsv; fails if anything.
check_lines() {
  perl -lne '
    sub wrong { print "test/mutants/mutants.tsv:$line: @_"; ++$wrong }
    sub content { open my $file, "<", "include/quadrille/@_" or return; local $/; <$file> }
    ++$line;
    my ($header, $code, $replacement, $tests, @more) = split /\t/, $_, -1;
    defined $tests && !@more or wrong("not four fields"), next;
    $code ne $replacement or wrong("the code is replaced by itself");
    my $text = $texts{$header} //= content($header) // "";
    index($text, $code =~ s/\\n/\n/gr) >= 0 or wrong("$header does not hold: $code");
    $tests =~ /\S/ or wrong("names no test");
    for my $test (split / /, $tests) {
      my @found = glob "test/*/test_$test.cpp";
      @found or wrong("there is no test_$test.cpp");
    }
    END { print "$line lines"; $? = $wrong > 0 || !$line }' test/mutants/mutants.tsv
}
if [ "${1:-}" = --check ]; then
  check_lines
  exit
fi

first=${1:-1}
last=${2:-$(wc -l <test/mutants/mutants.tsv)}
folder=build/mutants
export CGAL_DATA_DIR="${CGAL_DATA_DIR:-$PWD/build/test/data}"
[ -d "$CGAL_DATA_DIR/meshes" ] || {
  echo "no models in $CGAL_DATA_DIR: configure a build first, cmake --preset test" >&2
  exit 2
}
compile="${CXX:-g++} -std=c++20 -O0 -w"

mkdir -p "$folder"
[ "$folder/prelude.h.gch" -nt test/mutants/prelude.h ] || {
  cp test/mutants/prelude.h "$folder/prelude.h"
  $compile -x c++-header "$folder/prelude.h" -o "$folder/prelude.h.gch" || exit 2
}
mkdir -p "$folder/support"
for source in test/main.cpp test/support/*.cpp; do # what all tests link
  object=$folder/support/$(basename "$source" .cpp).o
  [ "$object" -nt "$source" ] || $compile -O1 -Iinclude -c "$source" -o "$object" || exit 2
done

# compiled_library: quadrille::compiled, for the tests that link it
compiled_library() {
  rm -rf "$folder/compiled" "$folder/compiled.a" && mkdir "$folder/compiled" || return
  for source in include/quadrille/compiled/*.cpp; do
    $compile -Iinclude -c "$source" -o "$folder/compiled/$(basename "$source" .cpp).o" || return
  done
  ar rc "$folder/compiled.a" "$folder"/compiled/*.o
}
[ -e "$folder/compiled.a" ] && [ -z "$(find include -newer "$folder/compiled.a")" ] ||
  compiled_library || exit 2

# passes TEST: sets the verdict if it does not.
passes() {
  options= sources= prelude="-include $folder/prelude.h" libraries="-lOpenMeshCore -lmpfr -lgmp" # of the kinds of meshes
  case $1 in # without bugs in what is compiled into it
    compiled* | gltf* | mesh_attributes | page) libraries="$folder/compiled.a $libraries" ;;
  esac
  case $1 in
    gltf* | mesh_io | public_data) sources="$folder/examples/products/mesh_io/*.cpp $folder/examples/products/mesh_io/gltf/*.cpp" ;; # quadrille_mesh_io
    interface) # with the sources of the interface, where the bugs are
      options=-DQUADRILLE_WITH_COMPILED sources="$folder/include/quadrille/c/*.cpp" libraries="$folder/compiled.a $libraries" ;;
    eigen) options=$(pkg-config --cflags eigen3) ;;
    gaps | handles) prelude= ;; # with which g++ 12 takes more than 20 GB
    keep_planes | voxel_size) sources="$folder/include/quadrille/compiled/*.cpp" ;; # where the bugs are
    any_order) options="-O1 -I$folder/test/any_order" ;;
    parallel*) options=-DQUADRILLE_WITH_TBB libraries="$libraries -ltbb" ;;
    distance_limit | float_precision | hausdorff_limit | tolerance_limit | targets | thin_features) options=-O1 ;; # take minutes without
  esac
  $compile $prelude $options -I"$folder/include" -I"$folder/test" \
    -I"$folder/test/support" "$folder"/test/*/"test_$1.cpp" $sources "$folder"/support/*.o $libraries \
    -o "$folder/test_$1" 2>"$folder/log" || {
    verdict="DOES NOT COMPILE"
    return 1
  }
  timeout 300 "$folder/test_$1" --abort >"$folder/log" 2>&1 || {
    verdict="killed by test_$1"
    return 1
  }
}

# selected: the chosen lines of mutants.tsv
selected() { sed -n "$first,${last}p" test/mutants/mutants.tsv; }

copy_sources() {
  rm -rf "$folder/include" "$folder/examples" "$folder/test"
  cp -r include examples test "$folder"
}

copy_sources
for test in $(selected | cut -f 4 | tr ' ' '\n' | sort -u); do
  passes "$test" || {
    printf '%s\n' "test_$test without a bug: $verdict"
    exit 2
  }
done

survivors=0
line=$((first - 1))
while IFS="$(printf '\t')" read -r header code replacement tests; do
  line=$((line + 1))
  copy_sources
  CODE=$code REPLACEMENT=$replacement perl -0777 -pi -e '
    my ($code, $replacement) = map { s/\\n/\n/gr } @ENV{"CODE", "REPLACEMENT"};
    my $at = index($_, $code);
    die "no such code\n" if $at < 0;
    substr($_, $at, length $code) = $replacement' "$folder/include/quadrille/$header" || {
    printf '%s\n' "$line: $header does not hold: $code"
    survivors=$((survivors + 1))
    continue
  }
  verdict=SURVIVED
  [ -n "$tests" ] || verdict="NAMES NO TEST" # as where nothing stands between two tabs
  for test in $tests; do
    passes "$test" || break
  done
  case $verdict in killed*) ;; *) survivors=$((survivors + 1)) ;; esac
  printf '%s\n' "$line: $header: $verdict: $code -> $replacement"
done <<TSV
$(selected)
TSV
echo "$survivors survived"
[ "$survivors" -eq 0 ]
