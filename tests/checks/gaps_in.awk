# A skeleton with its statements in another language: awk -f gaps_in.awk gaps_ja.txt mine.hpp
# The comments on top, and those after each `// [name]` are those of the first file; all
# code is that of the second.
{ mark = match($0, /\/\/ \[[a-z_]+\]/) ? substr($0, RSTART, RLENGTH) : "" }
FNR == NR {
  if (!told && $0 != "") { head = head $0 "\n"; next }
  told = 1
  if (mark != "") part = part == mark ? "" : mark
  else if (part != "") says[part] = says[part] $0 "\n"
  next
}
FNR == 1 { printf "%s", head; on_top = 1 }
on_top && /^\/\// { next }
{ on_top = 0 }
replaced && /^ *\/\// { next }
{ replaced = 0; print }
mark in says { printf "%s", says[mark]; delete says[mark]; replaced = 1 }
