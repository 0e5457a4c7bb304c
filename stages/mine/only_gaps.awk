# awk -f only_gaps.awk gaps.hpp FILE: what of FILE stands outside the gaps, without comments and without system
# headers, and of each gap the heads of its functions, up to their parameters. "more" where a gap has anything
# else in it. Two files of which this says the same differ only in what those functions do.
function refuse() { print "more"; exit }
match($0, /\/\/ \[[a-z_]+\]$/) {
  name = substr($0, RSTART, RLENGTH)
  if (FNR == NR) { gap[name] = 1; next }
  if (name in gap) {
    if (inside && depth != 0) refuse()
    inside = !inside
    depth = round = 0
    head = ""
    print name
    next
  }
}
FNR == NR { next }
inside && (/R"/ || /^[ \t]*#/ || /\\$/) { refuse() }
inside { # a brace in a text is none
  gsub(/"([^"\\]|\\.)*"/, "")
  gsub(/'([^'\\]|\\.)*'/, "")
  gsub(/\/\*[^*]*\*\//, "")
}
!/"/ {
  sub(/\/\/.*/, "")
  gsub(/[ \t\r]+/, " ")
  sub(/ $/, "")
}
!inside { if ($0 != "" && $0 !~ /^#include </) print; next }
/\/\*|\*\/|"/ { refuse() }
{
  for (i = 1; i <= length($0); ++i) {
    c = substr($0, i, 1)
    if (depth > 0) { depth += (c == "{") - (c == "}"); continue }
    if (c == ";" || c == "}" || c == "=") refuse()
    if (c == "(" && round++ == 0) {
      gsub(/ +/, " ", head)
      sub(/^ /, "", head)
      sub(/inline /, "", head)
      print head
    }
    if (c == ")") --round
    if (c == "{") { depth = 1; head = ""; continue }
    head = head c
  }
  head = head " "
}
END { if (inside) print "more" }
