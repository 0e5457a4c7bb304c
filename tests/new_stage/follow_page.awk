# Does to the files of a project what a page says: after a line "In `FILE`:", each block ```diff changes FILE.
# Lines with a space or a - in front must stand there, one after the other, just once; those with a space or a
# + take their place.  usage: awk -f follow_page.awk page.md, in the project's folder; exit code 1: a block does not fit.
/^In `[^`]*`:$/ { split($0, parts, "`"); file = parts[2] }
/^```diff$/ { inside = 1; old = ""; new = ""; next }
/^```$/ && inside { inside = 0; change(); next }
inside {
  line = substr($0, 2) "\n"
  if ($0 !~ /^\+/) old = old line
  if ($0 !~ /^-/) new = new line
}
function change(   text, line, at) {
  text = ""
  while ((getline line <file) > 0) text = text line "\n"
  close(file)
  at = index("\n" text, "\n" old)
  if (!at || index(substr("\n" text, at + 1), "\n" old)) {
    printf "%s:%d: not there, or more than once, in %s:\n%s", FILENAME, FNR, file, old
    failed = 1
    return
  }
  printf "%s%s%s", substr(text, 1, at - 1), new, substr(text, at + length(old)) >file
  close(file)
  changes++
}
END {
  if (!changes) print FILENAME ": there is no block ```diff after a line \"In `FILE`:\""
  exit failed || !changes
}
