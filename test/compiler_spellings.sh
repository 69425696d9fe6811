#!/bin/sh
# Checks that what each compiler spells in its own way is in the two headers that hide it, and that no
# header calls min or max, which may be macros where windows.h is included: (std::min)(a, b).
#   sh compiler_spellings.sh REPOSITORY
set -eu
! grep -rnE 'gnu::|msvc::|__attribute__|__builtin_|__forceinline|\[\[no_unique_address' "$1/include" |
  grep -v -e '/internal/base/compiler\.h:' -e '/internal/base/lanes\.h:'
! grep -rn '' "$1/include" | sed 's|//.*||' | grep -E '\b(min|max) *\('
