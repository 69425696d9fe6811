# What doxygen sees of a document: pages and headings get the names by which links find them, links
# between documents become references, and those to other files lead to copies of these, of which
# the paths are written to the file that the variable QUADRILLE_DOC_SOURCES names.
BEGIN {
  path = ARGV[1]
  sub("^" ENVIRON["QUADRILLE_DOC_ROOT"] "/", "", path)
  folder = path
  if (!sub(/\/[^\/]*$/, "", folder))
    folder = "."
  find_names()
  lists_pages = path == "doc/manual/README.md" || path == "doc/design/README.md"
}

# page("doc/manual/levels.md") is "manual_levels".
function page(path) {
  sub(/^doc\//, "", path)
  sub(/\.md$/, "", path)
  if (path == "README")
    return "index"
  sub(/\/README$/, "", path)
  gsub(/[\/-]/, "_", path)
  return "page_" path
}

# slug("How it works") is "how-it-works", as on GitHub.
function slug(heading) {
  heading = tolower(heading)
  gsub(/[]!-,.\/:;<=>?@[\\^`{|}~]/, "", heading)
  gsub(/ /, "-", heading)
  return heading
}

# normal("doc/manual/../x.md") is "doc/x.md".
function normal(path) {
  while (sub(/(^|\/)\.\//, "/", path)) ;
  while (sub(/[^\/.]+\/\.\.\//, "", path)) ;
  sub(/^\//, "", path)
  return path
}

# The target of a link as doxygen finds it.
function target_of(target,    file, anchor) {
  if (target ~ /^[a-z]+:/)
    return target
  file = target
  sub(/#.*/, "", file)
  anchor = index(target, "#") ? "_" substr(target, index(target, "#") + 1) : ""
  file = file == "" ? path : normal(folder "/" file)
  if (file ~ /\.md$/)
    return "@ref " page(file) anchor
  if (file ~ /\.png$/) {
    sub(/.*\//, "", file)
    return file
  }
  if (file ~ /^include\/quadrille\/[^\/]*\.h$/) {
    sub(/^include\//, "", file)
    return "@ref " file
  }
  print file >> ENVIRON["QUADRILLE_DOC_SOURCES"]
  return "source/" file ".txt"
}

# A line with its links rewritten, but for those in code, and public names in code made links, but for
# those in links.
function linked(line,    result, n, parts, i) {
  n = split(line, parts, "`")
  result = linked_part(parts[1])
  for (i = 2; i <= n; ++i)
    if (i % 2 == 1)
      result = result linked_part(parts[i])
    else if (i < n && parts[i - 1] ~ /\[$/ && parts[i + 1] ~ /^\]\(/)
      result = result parts[i] # doxygen shows the marks of code in the text of a link
    else if (i < n && parts[i] in kind && parts[i - 1] !~ /\[[^]]*$/)
      result = result "<code>@ref quadrille::" parts[i] " \"" parts[i] "\"</code>"
    else
      result = result "`" parts[i] (i < n ? "`" : "")
  return result
}
function linked_part(part,    result, source, target, text) {
  while (match(part, /\]\([^)]*\)/)) {
    source = substr(part, RSTART + 2, RLENGTH - 3)
    target = target_of(source)
    text = substr(part, 1, RSTART - 1)
    part = substr(part, RSTART + RLENGTH)
    if (lists_pages && source !~ /\// && target ~ /^@ref page_/ && match(text, /\[[^\[]*$/))
      result = result substr(text, 1, RSTART - 1) "@sub" "page " substr(target, 6) " \"" substr(text, RSTART + 1) "\""
    else
      result = result text "](" target ")"
  }
  return result part
}

# doxygen wants the text of a link on one line: what begins at the end of a line goes to the next one.
!code {
  while (match($0, /\[[^]\[`]*$/)) {
    before = substr($0, 1, RSTART - 1)
    open = substr($0, RSTART)
    if ((getline following) <= 0)
      break
    if (following !~ /^[^\[]*\]\(/) {
      print linked($0)
      $0 = following
      continue
    }
    print linked(before)
    match(following, /^ */)
    $0 = substr(following, 1, RLENGTH) open " " substr(following, RLENGTH + 1)
  }
}
/^ *```/ { code = !code }
code || /^ *```/ { print; next }
/^<!-- .* -->$/ { print ""; next }
/^# / && !titled { titled = 1; print $0 " {#" (path == "README.md" ? "mainpage" : page(path)) "}"; next }
/^##+ / { heading = $0; sub(/^#+ /, "", heading); print $0 " {#" page(path) "_" slug(heading) "}"; next }
{ print linked($0) }
