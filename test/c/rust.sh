#!/bin/sh
# The example in Rust is compiled without any crate, and runs.
#   sh rust.sh RUSTC SOURCE LIBRARY FOLDER    LIBRARY is libquadrille.so; the program goes to FOLDER
set -eu
folder=$(dirname -- "$3")
mkdir -p "$4"
"$1" --edition 2021 -D warnings -L "$folder" -l dylib=quadrille -o "$4/c_interface" "$2"
LD_LIBRARY_PATH="$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" "$4/c_interface"
