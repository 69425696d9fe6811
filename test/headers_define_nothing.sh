#!/bin/sh
# Checks that an object file of headers alone defines nothing that another one may not define as well.
#   sh headers_define_nothing.sh NM OBJECT
set -eu
"$1" --extern-only --defined-only "$2" >/dev/null # fails if it is no object file
if "$1" -C --extern-only --defined-only "$2" | grep ' [ABCDGRST] '; then
  echo "defined in each unit that has the headers: inline is missing"
  exit 1
fi
