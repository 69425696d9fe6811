#!/bin/sh
# Holds documents and packages to the table of options, include/quadrille/compiled/options.def.
#   sh options.sh table REPOSITORY    prints the tables of doc/manual/options.md
#   sh options.sh manual REPOSITORY   the manual has these tables
#   sh options.sh presets REPOSITORY  doc/manual/presets.md has the options of each preset, and no others
#   sh options.sh program REPOSITORY  the program has the options of the program, by their names and short forms
#   sh options.sh web REPOSITORY      the npm package has the options of the web, with their words and defaults
set -eu
check=$1
cd -- "$2"

# Prints the rows, fields separated by tabs: the macro, then its arguments.
rows() {
  perl -0777 -ne '
    while (/^QUADRILLE_((?:JOB_|CHANNEL_)?(?:OPTION|WORD))\((.*?)\)\n(?=\n|QUADRILLE|\/\/)/msg) {
      my ($macro, $text) = ($1, $2);
      my @fields;
      push @fields, defined $1 ? $1 : $2 while $text =~ /\G\s*(?:"((?:[^"\\]|\\.)*)"|(\w+))\s*(?:,|$)/g;
      print join("\t", $macro, @fields), "\n";
    }' include/quadrille/compiled/options.def
}

table() {
  rows | perl -ne '
    chomp;
    my ($macro, @f) = split /\t/, $_, -1;
    if ($macro =~ /WORD/) { push @{$words{$last}}, "`$f[1]` ($f[2])"; next }
    $last = $macro =~ /CHANNEL/ ? "channel $f[1]" : $f[1];
    my ($kind, $name, $range, $fallback, $unit, $places, $short, $sentence) = @f;
    push @{$macro =~ /CHANNEL/ ? \@channel : \@call}, [$last, $name, $kind, $range, $fallback, $unit, $places, $short, $sentence];
    END {
      my %kinds = (count => "integer", number => "number", flag => "true or false", word => "word", numbers => "numbers",
        point_numbers => "number for each point", point_flags => "flag for each point", face_flags => "flag for each triangle");
      for my $list (\@call, \@channel) {
        print "\n## Options of a channel of attributes\n\n" if $list == \@channel;
        print "| option | value | default | what it is | where |\n|---|---|---|---|---|\n";
        for (@$list) {
          my ($key, $name, $kind, $range, $fallback, $unit, $places, $short, $sentence) = @$_;
          my $value = $kinds{$kind};
          $value .= " in $range" if $range ne "";
          $value .= ", $unit" if $unit ne "" && $unit ne "factor" && $unit ne "weight";
          $sentence .= ": " . join(", ", @{$words{$key}}) if $words{$key};
          $sentence .= ". Short form in the program: `--$short`" if $short ne "";
          $places =~ s/ /, /g;
          print "| `$name` | $value | ", $fallback eq "" ? "" : "`$fallback`", " | $sentence | $places |\n";
        }
      }
    }'
}

manual() {
  sed '1,/^<!-- options.def -->$/d' doc/manual/options.md | diff - /dev/fd/3 3<<TABLE || {

$(table)
TABLE
    echo "behind <!-- options.def -->, doc/manual/options.md is not: sh test/options.sh table ."
    exit 1
  }
}

program() {
  rows | perl -ne '
    BEGIN { $sources = join "", map { local (@ARGV, $/) = $_; <> } glob "examples/products/program/{command_line,policy_options}.h" }
    chomp;
    my ($macro, @f) = split /\t/, $_, -1;
    next if $macro =~ /WORD/;
    (my $name = $f[1]) =~ tr/_/-/;
    my ($is_in, $short) = ($f[5] =~ /\bprogram\b/, $f[6]);
    my $has_name = is_defined($name);
    my $has_short = $short ne "" && is_defined($short);
    next if $macro =~ /CHANNEL/ && !$is_in;
    next if $name eq "weighting" && $has_short; # a flag is all that the program has of it
    wrong("the program has " . ($is_in ? "no" : "the") . " option $name") if $has_name != $is_in;
    wrong("the program has no short form $short of $name") if $short ne "" && !$has_short;
    sub is_defined { $sources =~ /"(?:--?[\w-]+,)*--$_[0](?:,--?[\w-]+)*"/ }
    sub wrong { print "$_[0]\n"; $wrong = 1 }
    END { $? = $wrong ? 1 : 0 }'
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

web() {
  rows | perl -ne '
    BEGIN {
      local $/;
      open my $types, "<", "examples/products/web/package/index.d.ts" or die;
      $types = <$types>;
      open my $names, "<", "examples/products/web/package/options.js" or die;
      $names = <$names>;
      ($options) = $types =~ /export interface Options \{(.*?)\n\}/s or die "no Options";
      ($lists) = $names =~ /(const counts.*?const all)/s or die "no lists";
    }
    chomp;
    my ($macro, @f) = split /\t/, $_, -1;
    next if $macro =~ /CHANNEL/;
    (my $name = $f[$macro =~ /WORD/ ? 0 : 1]) =~ s/_(\w)/uc $1/ge;
    if ($macro =~ /WORD/) {
      next if !$in_web;
      my ($type) = $options =~ /\b$name\?: (.*);/;
      wrong("$name has no \"$f[1]\"") if $type !~ /"$f[1]"/;
      next;
    }
    $in_web = $f[5] =~ /\bweb\b/;
    my $has_type = $options =~ /^  $name\?:/m;
    my $has_name = $lists =~ /"$name"/;
    wrong("$name is " . ($has_type ? "" : "not ") . "in index.d.ts") if $has_type != $in_web;
    wrong("$name is " . ($has_name ? "" : "not ") . "in options.js") if $has_name != $in_web;
    sub wrong { print "$_[0]\n"; $wrong = 1 }
    END { $? = $wrong ? 1 : 0 }'
}

"$check"
