#!/bin/sh
# What programs that are compiled rely on: the symbols of the library of quadrille.h, and the layout of its
# types. What is added belongs into abi.txt; what is changed or removed needs another QUADRILLE_C_VERSION.
#   sh abi.sh NM LIBRARY PROGRAM    PROGRAM is that of abi.c
set -eu
{
  "$3"
  "$1" -D --defined-only "$2" | awk '{ print $3 }' | sort
} | diff "$(dirname -- "$0")/abi.txt" -
