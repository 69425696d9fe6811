#!/bin/sh
# Holds the manual to the tables of options and presets. Skipped (77) where there is no Python.
#   sh options.sh manual REPOSITORY   doc/manual/options.md has the tables that option_table.py makes
#   sh options.sh presets REPOSITORY  doc/manual/presets.md has the options of each preset, and no others
set -eu
check=$1
cd -- "$2"

manual() {
  command -v python3 >/dev/null || exit 77
  made=$(python3 examples/products/option_table.py manual)
  sed '1,/^<!-- options.def -->$/d' doc/manual/options.md | diff - /dev/fd/3 3<<TABLE || {

${made#?}
TABLE
    echo "behind <!-- options.def -->, doc/manual/options.md is not what this makes: python3 examples/products/option_table.py manual doc/manual/options.md"
    exit 1
  }
}

presets() {
  perl -ne '
    push @{$options{$1}}, "`$2` " . $3 =~ s/.*:://r if /^QUADRILLE_PRESET\((\w+), (\w+), (.*)\)$/;
    END {
      print "| `$_` | .* | ", join(", ", @{$options{$_}}), " |\n" for sort keys %options;
    }' include/quadrille/compiled/presets.def |
    while read -r row; do
      grep -qx -- "$(printf '%s' "$row" | sed 's/[*]/[*]/g; s/\.\[\*\]/.*/')" doc/manual/presets.md || {
        echo "doc/manual/presets.md has no row $row"
        exit 1
      }
    done
}

"$check"
