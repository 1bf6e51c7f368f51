# Numbers the figures of a manual in the order of \cgalFigureBegin, in their captions and in \cgalFigureRef, as the
# post-processing of CGAL's documentation does.
function name_of(line) {
  sub(/.*\\cgalFigureBegin{ */, "", line)
  sub(/[ ,].*/, "", line)
  return line
}
BEGIN {
  file = ARGV[1]
  while ((getline line < file) > 0)
    if (line ~ /\\cgalFigureBegin{/)
      number[name_of(line)] = ++figures
  close(file)
}
/\\cgalFigureBegin{/ {
  print $0 " <b>Figure " number[name_of($0)] ".</b>"
  next
}
{
  for (name in number)
    gsub("\\\\cgalFigureRef{" name "}", "\\ref fig__" name " \"Figure " number[name] "\"")
  print
}
