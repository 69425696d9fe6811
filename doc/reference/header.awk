# What doxygen sees of a public header: each belongs to the module that modules.dox names for it;
# private classes are not there, and neither the inline namespace of `simplify` nor deduction guides are
# names of their own. No line is added or taken away, so that warnings have the right numbers.
BEGIN {
  header = ARGV[1]
  sub(/.*\//, "", header)
  while ((getline line < "doc/reference/modules.dox") > 0)
    if (split(line, words, " ") > 1 && words[1] == "headers")
      for (i = 3; i in words; ++i)
        module[words[i]] = words[2]
  find_names()
  if (!(header in module)) {
    print "doc/reference/modules.dox: names no module for " header > "/dev/stderr"
    print "/** \\ref there_is_no_module_for_" header " */"
  }
}

FNR == 1                        { $0 = "/** \\file */ " $0 }
/^namespace quadrille(::[a-z]+)? \{$/ && module[header] != "" && !opened {
  opened = closing = 1
  print $0 " /** \\addtogroup " module[header]
  getline
  print "@{ */" $0
  next
}
/^} \/\/ namespace quadrille/ && closing { closing = 0; $0 = "/** @} */ " $0 }
/^inline namespace /            { $0 = "" }
/^} \/\/ namespace QUADRILLE_/  { $0 = "" }
/^private:/                     { is_private = 1 }
/^(public:|};)/                 { is_private = 0 }
/^  };/ && is_hidden            { is_hidden = 0; print ""; next }
is_hidden                       { print ""; next }
# A template's head, and behind it a deduction guide or a private class.
/^ *template </ && pending == "" { pending = $0; next }
{
  is_hidden = is_private && /^  (struct|class) .*{$/
  is_guide = /^[A-Z][A-Za-z]*\(.*\) -> /
  if (pending != "")
    print is_hidden || is_guide ? "" : pending
  pending = ""
  if (/^ *\/\/\/ ```/)
    is_code = !is_code
  comment = index($0, "///")
  print is_hidden || is_guide ? "" : comment && !is_code ? substr($0, 1, comment - 1) named(substr($0, comment)) : $0
}

# A comment with references where doxygen makes none: to concepts, and from them.
function named(line,    result, word) {
  while (match(line, /[A-Za-z_:`]+/)) {
    word = substr(line, RSTART, RLENGTH)
    result = result substr(line, 1, RSTART - 1)
    line = substr(line, RSTART + RLENGTH)
    if (kind[word] == "concept" || (kind[word] != "" && header == "concepts.h"))
      word = "@ref quadrille::" word " \"" word "\""
    result = result word
  }
  return result line
}
END { if (pending != "") print pending }
