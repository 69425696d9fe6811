#!/bin/sh
# Checks that no file mentions a path of a developer's machine.
#   sh developer_paths.sh REPOSITORY
cd "$1" || exit 2
# The brackets keep this file from finding itself.
! grep -rInE --exclude=.git --exclude-dir=.git --exclude-dir='build*' '/[w]ork/|/tmp/[w]t|/[h]ome/[a-z]|/[U]sers/' .
