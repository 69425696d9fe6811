# kind[NAME] is "struct", "class", "concept", "enum" or "using" for each public name on the outermost level.
function find_names(    list, file, line, words) {
  list = "ls include/quadrille/*.h"
  while ((list | getline file) > 0) {
    while ((getline line < file) > 0)
      if (match(line, /^(struct|class|concept|enum class|using) [A-Z][A-Za-z]*/)) {
        line = substr(line, RSTART, RLENGTH)
        sub(/^enum class/, "enum", line)
        split(line, words, " ")
        kind[words[2]] = words[1]
      }
    close(file)
  }
  close(list)
}
