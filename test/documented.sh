#!/bin/sh
# Holds the documents against the code and against each other.
#   sh documented.sh CHECK REPOSITORY [ARGUMENT...]    a CHECK is one of the functions below
set -eu
check=$1
sheet=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)/sheet_gltf.sh
cd -- "$2"
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The calls that documents show compile: every block of C++ that is no file of its own, as `code` has it,
# becomes a scope of documented_calls.cpp.
#   calls COMPILER FLAG...
calls() {
  find README.md doc -name '*.md' | sort | while read -r document; do
    awk -v document="$document" '
      /^<!-- (file|part): .* -->$/ { is_file = 1; next }
      /^```cpp$/ && !is_file     { print "{\n#line " FNR + 1 " \"" document "\""; inside = 1; next }
      /^```$/ && inside          { print "}"; inside = 0 }
      inside                     { print }
                                 { is_file = 0 }' "$document"
  done >"$folder/documented_calls.inc"

  calls=$(grep -c simplify "$folder/documented_calls.inc") || calls=0
  echo "$calls calls"
  [ "$calls" -gt 0 ]
  "$@" "-I$folder" test/documented_calls.cpp
}

# The code that documents show is compiled code: a block that follows the line
#   <!-- file: PATH -->   or   <!-- part: PATH -->
# equals that file byte for byte, or consecutive lines of it.
code() {
  # Writes the blocks as block.1, block.2, ... and a line "BLOCK KIND PATH DOCUMENT:LINE" for each.
  find README.md doc -name '*.md' | sort | while read -r document; do
    awk -v block="$folder/$(echo "$document" | tr / .)" '
      /^<!-- (file|part): .* -->$/ { kind = $2; path = $3; next }
      path != "" && /^```/  { name = block "." ++n; printf "" > name
                              print name, kind, path, FILENAME ":" FNR; path = ""; inside = 1; next }
      path != ""            { print "-", kind, path, FILENAME ":" FNR; path = "" }
      inside && /^```$/     { inside = 0; close(name) }
      inside                { print > name }' "$document"
  done > "$folder/list"

  # is_part BLOCK FILE: are the lines of the block consecutive lines of the file?
  is_part() {
    awk 'function slurp(file,    line, text) {
           text = "\n"
           while ((getline line < file) > 0)
             text = text line "\n"
           return text
         }
         BEGIN { block = slurp(ARGV[1]); exit !(length(block) > 1 && index(slurp(ARGV[2]), block)) }' "$1" "$2"
  }

  status=0
  while read -r block kind path place; do
    if [ "$kind" = part: ]; then
      is_part "$block" "$path" || { echo "$place: the block is no part of $path"; status=1; }
    elif ! cmp -s "$block" "$path"; then
      echo "$place: the block is not the same as $path"
      diff "$block" "$path" || true
      status=1
    fi
  done < "$folder/list"
  echo "$(wc -l < "$folder/list") blocks compared"
  exit $status
}

# The relative links of all documents lead to files that are there, and to headings that are in them. A
# heading is named as on GitHub: in lower case, without punctuation, with hyphens.
links() {
  links=$folder/links
  # Writes a line "DOCUMENT:LINE TARGET" for each link that is not in code.
  documents=$(find . -name '*.md' ! -path './.git/*' ! -path './build*' ! -path '*/node_modules/*' | sort)
  for document in $documents; do
    awk -v document="${document#./}" '
      /^ *```/ { code = !code; next }
      code     { next }
               { gsub(/`[^`]*`/, "")
                 while (match($0, /\]\([^)]*\)/)) {
                   print document ":" FNR, substr($0, RSTART + 2, RLENGTH - 3)
                   $0 = substr($0, RSTART + RLENGTH) } }' "$document"
  done > "$links"

  # headings DOCUMENT: their names.
  headings() {
    awk '/^ *```/ { code = !code; next }
         !code && /^#+ / { sub(/^#+ /, ""); print }' "$1" |
      tr '[:upper:]' '[:lower:]' | sed -e 's/[]!-,./:;<=>?@[\^`{|}~]//g' -e 's/ /-/g'
  }

  status=0
  while read -r place target; do
    case $target in *://* | mailto:*) continue ;; esac
    path=${target%%#*}
    [ -n "$path" ] && path=$(dirname "$place")/$path || path=${place%:*}
    if [ ! -e "$path" ]; then
      echo "$place: there is no $path"
      status=1
    elif [ "$target" != "${target#*#}" ] && ! headings "$path" | grep -qxF -e "${target#*#}"; then
      echo "$place: there is no heading ${target#*#} in $path"
      status=1
    fi
  done < "$links"
  echo "$(wc -l < "$links") links"
  [ -s "$links" ] || status=1
  exit $status
}

# Documents are plain English, as comments are (repository.sh words): they use no word of words.txt, and no paragraph
# and no item of a list begins with a word such as Of or What, nor a sentence inside them, unless it is a
# question. The same holds for what follows a colon or a semicolon, except in tables. Code and names of files are no words.
words() {
  banned=$(grep -v '^#' test/words.txt | cut -f1 | paste -sd '|')
  # shellcheck disable=SC2046
  awk -v banned=" ($banned) " '
    BEGIN {
      first = "^((Of|What|Who|Whose|Those|Where) |The same( (with|in|as|of|by|for) |,))"
    }
    FNR == 1 { code = inside = ended = 0 }
    /^ *```/ { code = !code; inside = ended = 0; next }
    code { next }
    {
      text = $0
      rest = (ended ? ". " : "") text
      while (match(rest, /[.!?][])*_"]* +(Of|Where|What|Who|Whose|Those) [^.!?]*[.!?]?/)) {
        sentence = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH - 1)
        sub(/^[^OWT]*/, "", sentence)
        if (sentence !~ /\?$/) {
          print FILENAME ":" FNR ": a sentence begins with " substr(sentence, 1, 50)
          wrong = 1
        }
      }
      ended = text ~ /[.!?][])*_"]*$/
      if (is_text && match(text, /[:;][])*_"]* +(of|Of|where|Where) /)) {
        print FILENAME ":" FNR ": a colon or semicolon comes before " substr(text, RSTART + 2, 50)
        wrong = 1
      }
      is_item = sub(/^ *([-*]|[0-9]+\.) +/, "", text)
      is_text = text !~ /^([|#<!]|$)/
      if (is_text && (is_item || !inside) && text ~ first && text !~ /\?/) {
        print FILENAME ":" FNR ": begins with " substr(text, 1, 50)
        wrong = 1
      }
      inside = is_text
      gsub(/`[^`]*`|\]\([^)]*\)/, " - ", text)
      gsub(/[^A-Za-z_]+/, "  ", text)
      while (match(" " tolower(text) " ", banned)) {
        print FILENAME ":" FNR ": says" substr(" " text " ", RSTART, RLENGTH)
        wrong = 1
        text = substr(" " text, RSTART + RLENGTH - 1)
      }
      ++lines
    }
    END { print lines " lines"; exit wrong || lines < 1000 }' $(find README.md doc -name '*.md' | sort)
}

# The names of classes and functions in the documents that tell what is where are names of the library:
# each `Name`, `Name::member` or `name.h` in code is looked up in its headers.
names() {
  documents="doc/architecture.md doc/manual/algorithm.md doc/manual/policies.md doc/manual/units.md doc/manual/guarantees.md $(echo doc/design/*.md)"
  names=$folder/names
  for document in $documents; do
    awk -v document="$document" '
      /^ *```/ { code = !code; next }
      { n = split($0, parts, "`")
        for (i = 2; i <= n; i += 2)
          if (!code && match(parts[i], /^[A-Za-z_:\/]+(\.h)?/) && RLENGTH > 2)
            print document ":" FNR, substr(parts[i], 1, RLENGTH) }' "$document"
  done | grep -E '[: ][A-Z][A-Za-z]*[a-z][A-Za-z]*(::[a-z_]+)?$|\.h$' > "$names"

  status=0
  while read -r place name; do
    case $name in
    CGAL::* | FaceGraph | MutableFaceGraph | FaceListGraph | SurfaceMesh) continue ;;
    *.h) find include examples test -path "*/$name" | grep -q . || { echo "$place: there is no $name" >&2; status=1; } ;;
    *) for part in $(echo "$name" | sed 's/::/ /g'); do
         grep -rqw -e "$part" include examples/products || { echo "$place: there is no $name" >&2; status=1; }
       done ;;
    esac
  done < "$names"
  echo "$(wc -l < "$names") names"
  [ -s "$names" ] || status=1
  exit $status
}

# The tables of what others call it, in coming_from.md, name what is there: in the column "library" each
# name in code is one of the headers, in "program" each option one of the program, in "Python" each
# argument one of the module, and in "CGAL 5.5" or "CGAL 6" each name one of that CGAL, if it is here. The
# tables of units.md, algorithm.md and tool.md are looked at by `units`, `folders` and `options`.
#   tables [FOLDER OF CGAL'S HEADERS]
tables() {
  cgal=${1:-/usr/include/CGAL}
  names=$folder/names

  # A line "LINE COLUMN CODE" for each piece of code in a table, with _ for blanks in the column's name.
  awk -F '|' '
    !/^\|/ { delete column; next }
    !(2 in column) { for (i = 2; i < NF; ++i) { gsub(/^ +| +$/, "", $i); gsub(/ /, "_", $i); column[i] = $i }; next }
    { for (i = 2; i < NF; ++i) { n = split($i, parts, "`"); for (k = 2; k <= n; k += 2) print NR, column[i], parts[k] } }
  ' doc/manual/coming_from.md > "$names"

  # The names of C++ in a piece of code, with at least four letters and a capital or an underscore.
  cpp_names() {
    printf '%s\n' "$1" | sed 's/"[^"]*"//g' | grep -oE '[A-Za-z_]{4,}' | grep -E '[A-Z_]' || true
  }

  version=$(sed -n 's/^#define CGAL_VERSION \([0-9.]*\).*/\1/p' "$cgal/version.h" 2>/dev/null || true)
  status=0 count=0
  missing() {
    echo "doc/manual/coming_from.md:$1: there is no $2" >&2
    status=1
  }
  while read -r line column code; do
    case $column in
    library)
      for name in $(cpp_names "$code"); do
        [ "$name" = FILE ] || grep -rqw -e "$name" include || missing "$line" "$name"
        count=$((count + 1))
      done ;;
    program)
      for option in $(printf '%s\n' "$code" | grep -oE -e '--[a-z-]+' || true); do
        options_of_program | grep -qx -e "$option" || missing "$line" "$option"
        count=$((count + 1))
      done ;;
    Python)
      for argument in $(printf '%s\n' "$code" | grep -oE '\b[a-z_]+=' | tr -d = || true); do
        grep -rqE "^ +$argument:|^QUADRILLE_(CHANNEL_|JOB_)?OPTION\([a-z_]+, $argument, .*Python" \
          examples/products/python/quadrille include/quadrille/compiled/options.def || missing "$line" "$argument="
        count=$((count + 1))
      done ;;
    CGAL_5.5 | CGAL_6)
      case CGAL_$version in
      "$column"*)
        for name in $(cpp_names "$code"); do
          grep -rqw -e "$name" "$cgal/Surface_mesh_simplification" "$cgal/boost/graph" "$cgal/STL_Extension" \
            "$cgal/Named_function_parameters.h" || missing "$line" "$name"
          count=$((count + 1))
        done ;;
      esac ;;
    esac
  done < "$names"
  echo "$count names"
  [ "$count" -gt 100 ] || status=1
  failed=$status # each of these sets its own status
  units || failed=1
  folders || failed=1
  options || failed=1
  exit $failed
}

# units.md has each public class that rejects numbers, with the defaults of the headers: a row whose first
# name is `Class::member` and whose fourth column is a number has the number with which the member begins.
units() {
  table=doc/manual/units.md
  status=0
  for header in include/quadrille/*.h; do
    awk '/^namespace internal/          { internal = 1 }
         /^} \/\/ namespace internal/    { internal = 0 }
         /^(struct|class) [A-Z]/         { name = $2; sub(/[:;{].*/, "", name) }
         /hrows std::invalid_argument/ && name && !internal { print name }
         /^};/                           { name = "" }' "$header"
  done | sort -u > "$folder/checked"
  while read -r name; do
    case $name in MatrixRows | VertexAttribute | PartitionedSimplifier) continue ;; esac # no numbers of a policy
    grep -qE "^\|.*\`$name\b" "$table" || { echo "$table: there is no $name" >&2; status=1; }
  done < "$folder/checked"

  awk -F '|' '/^\| `[A-Z][A-Za-z]*::[a-z_]+`/ { gsub(/[` ]/, "", $2); sub(/,.*/, "", $2); gsub(/ /, "", $5)
              if ($5 ~ /^[0-9.]+$/) { split($2, name, "::"); print name[1], name[2], $5 } }' "$table" > "$folder/defaults"
  while read -r class member number; do
    cat include/quadrille/*.h | sed -n "/^struct $class\b/,/^};/p;/^class $class\b/,/^};/p" |
      grep -qE "\b$member = $number[;,]" || { echo "$table: $class::$member is not $number" >&2; status=1; }
  done < "$folder/defaults"
  echo "$(wc -l < "$folder/checked") checked classes, $(wc -l < "$folder/defaults") defaults"
  [ -s "$folder/checked" ] && [ -s "$folder/defaults" ] || status=1
  return $status
}

# algorithm.md says where each name is: `Name`, `Other` (PLACE) with a header of include/quadrille or a folder of
# include/quadrille/internal, one of whose files has the name.
folders() {
  table=doc/manual/algorithm.md
  status=0
  grep -oE '`[^|()]*` \([a-z_/]+(/|\.h)\)' "$table" > "$folder/places"
  while read -r line; do
    place=$(printf '%s\n' "$line" | sed 's/.*(\(.*\))/\1/')
    case $place in */) path=include/quadrille/internal/$place ;; *) path=include/quadrille/$place ;; esac
    for name in $(printf '%s\n' "$line" | sed 's/^.*), //' | grep -oE '`[A-Za-z_:]+`' | tr -d '`'); do
      grep -rqsE "\b${name##*::}\b" "$path" || { echo "$table: $place has no $name" >&2; status=1; }
      case $place in
      *.h) ;;
      *) grep -rqsE "^ *(class|struct) ${name%%::*}\b" "$path" || { echo "$table: $place has no class $name" >&2; status=1; } ;;
      esac
    done
  done < "$folder/places"
  echo "$(wc -l < "$folder/places") places"
  [ -s "$folder/places" ] || status=1
  return $status
}

# Prints the options of the program: those of the table of options, and those that its sources add.
options_of_program() {
  {
    find examples/products/program -name '*.h' -o -name '*.cpp' | sort | xargs cat | tr '\n' ' ' |
      grep -oE '(\.add_[a-z_]+(<[a-z:]+>)?|\badd)\( *"(-[a-z],)?--[a-z,-]+"' | grep -oE -e '--[a-z-]+'
    perl -ne '/^QUADRILLE_(?:CHANNEL_|JOB_)?OPTION\(\w+, (\w+), (?:".*?", ){3}".*?program.*?", "(.*?)"/ or next;
      for ($1, $2) { print "--", tr/_/-/r, "\n" if $_ ne "" }' include/quadrille/compiled/options.def
  } | sort -u | grep -vxE -e '--(help|version)'
}

# tool.md has each option of the program, and it and formats.md no other one.
options() {
  status=0
  options_of_program > "$folder/registered"
  grep -ohE -e '--[a-z][a-z-]+' doc/manual/tool.md doc/manual/formats.md | sort -u | grep -vx -e --help > "$folder/written"
  for option in $(comm -23 "$folder/registered" "$folder/written"); do
    echo "doc/manual/tool.md: there is no $option" >&2
    status=1
  done
  for option in $(comm -13 "$folder/registered" "$folder/written"); do
    echo "doc/manual/tool.md: the program has no $option" >&2
    status=1
  done
  count=$(wc -l < "$folder/registered")
  echo "$count options"
  [ "$count" -gt 40 ] || status=1
  return $status
}

# The commands that documents show are right: each block of shell is parsed, and where the program is
# there each command `quadrille ...` runs, in the order of its document, in a folder of their own; a mesh
# that is not there is made first.
#   commands [PROGRAM MESH.off]
commands() {
  program=${1:-}
  mesh=${2:-}

  # Writes the blocks of shell of a document to a file, without their indentation.
  blocks() {
    awk '/^ *```sh$/ { inside = 1; indentation = index($0, "`"); next }
         /^ *```$/   { inside = 0 }
         inside      { print substr($0, indentation) }' "$1"
  }

  # shellcheck source=sheet_gltf.sh
  . "$sheet"

  # The mesh as a PLY file whose vertices have the scalar NAME: write_scalar NAME FILE
  write_scalar() {
    "$program" "$mesh" plain.off --keep 100% --quiet --force
    awk -v name="$1" '
      NF == 0 || /^#/ || /OFF/ { next }
      !faces { vertices = $1; faces = $2
               print "ply\nformat ascii 1.0\nelement vertex", vertices
               print "property double x\nproperty double y\nproperty double z\nproperty double", name
               print "element face", faces "\nproperty list uchar int vertex_indices\nend_header"; next }
      n++ < vertices { print $1, $2, $3, 1 + ($1 > 0); next }
      { print }' plain.off > "$2"
  }

  # Makes the first mesh that a command names, with a scalar that it asks for; all with --into.
  make_input() {
    scalar=
    previous=
    several=
    for word in "$@"; do
      [ "$word" != --into ] || several=yes
      case $previous in --tolerance | --importance) scalar=$word ;; esac
      previous=$word
    done
    for word in "$@"; do
      [ -z "$scalar" ] || case $word in *.ply) write_scalar "$scalar" "$word"; return 0 ;; esac
      case $word in
      -*) ;;
      *.gltf | *.glb) [ -e "$word" ] || "$program" sheet.gltf "$word" --keep 100% --quiet; return 0 ;;
      *.off | *.obj | *.ply | *.stl)
        [ -e "$word" ] || "$program" "$mesh" "$word" --keep 100% --quiet
        [ -n "$several" ] || return 0
        ;;
      esac
    done
  }

  status=0
  count=0
  [ -z "$program" ] || (cd "$folder" && write_sheet sheet.gltf)
  for document in $(find README.md doc benchmark -name '*.md' | sort); do
    blocks "$document" > "$folder/commands"
    [ -s "$folder/commands" ] || continue
    sh -n "$folder/commands" || { echo "$document: its shell does not parse" >&2; status=1; }
    [ -n "$program" ] || continue
    grep '^quadrille ' "$folder/commands" > "$folder/runs" || continue
    while read -r command; do
      count=$((count + 1))
      if ! (cd "$folder" && set -f && eval "set -- ${command%%#*}" && shift && make_input "$@" &&
            "$program" "$@" < /dev/null > output 2>&1) &&
          ! grep -q 'built without the viewer of pages' "$folder/output"; then
        echo "$document: $command: fails:" >&2
        cat "$folder/output" >&2
        status=1
      fi
    done < "$folder/runs"
  done
  [ -z "$program" ] || echo "$count commands were run"
  [ -z "$program" ] || [ "$count" -gt 0 ] || status=1
  exit $status
}

# The reference builds without a warning, every relative link in its HTML leads to a page and a place in
# it, and neither a public name without a comment nor a header without a module goes unnoticed. Skipped
# (77) where there is no doxygen.
reference() {
  command -v doxygen >/dev/null || { echo "skipped: doxygen is not there"; exit 77; }
  mkdir "$folder/copy"
  cp -R README.md doc benchmark examples include test .ci CMakeLists.txt LICENSE NOTICE.md "$folder/copy"
  cd "$folder/copy"

  fail() { echo "$1" >&2; exit 1; }
  sh doc/build.sh "$folder/html" 2>&1 | tee "$folder/warnings"
  [ ! -s "$folder/warnings" ] && [ -s "$folder/html/index.html" ] || fail "the reference does not build silently"

  cd "$folder/html"
  find . -type f | sed 's|^\./||' | sort > "$folder/files"
  find . -name '*.html' ! -path './search/*' | sed 's|^\./||' | sort | xargs awk -v files="$folder/files" '
    BEGIN { while ((getline name < files) > 0) is_file[name] = 1 }
    { line = $0
      while (match(line, /[ "](id|name)="[^"]*"/)) {
        place = substr(line, RSTART + 1, RLENGTH - 2)
        sub(/^[^"]*"/, "", place)
        is_place[FILENAME "#" place] = 1
        line = substr(line, RSTART + RLENGTH)
      }
      line = $0
      while (match(line, /(href|src)="[^"]*"/)) {
        target = substr(line, RSTART, RLENGTH - 1)
        line = substr(line, RSTART + RLENGTH)
        sub(/^[^"]*"/, "", target)
        if (target !~ /^([a-z]+:|#?$)/)
          from[target ~ /^#/ ? FILENAME target : target] = FILENAME
      } }
    END {
      for (target in from) {
        ++links
        file = target
        sub(/#.*/, "", file)
        if (!(file in is_file) || (target ~ /\.html#/ && !(target in is_place))) {
          print from[target] ": there is no " target
          ++wrong
        }
      }
      print links + 0 " links"
      exit wrong > 0 || links < 1000
    }' || fail "links of the HTML lead nowhere"

  cd "$folder/copy"
  sed -i 's|^struct MidpointPlacement {|&\n  int without_comment();|' include/quadrille/placement.h
  ! sh doc/build.sh "$folder/undocumented" > "$folder/warnings" 2>&1 || fail "a name without a comment goes unnoticed"
  grep -q 'placement.h:.*without_comment.*not documented' "$folder/warnings" || fail "not the name without a comment is refused"
  cp include/quadrille/pairs.h include/quadrille/elsewhere.h
  sed -i '/without_comment/d' include/quadrille/placement.h
  ! sh doc/build.sh "$folder/module" > "$folder/warnings" 2>&1 || fail "a header without a module goes unnoticed"
  grep -q 'names no module for elsewhere.h' "$folder/warnings" || fail "not the header without a module is refused"
}

"$check" "$@"
