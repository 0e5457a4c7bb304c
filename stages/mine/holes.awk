# The functions in the gaps of a stage.
#   awk -f holes.awk gaps.hpp                declared, without their bodies: parts for tests/checks/splice.cmake
#   awk -v scene=NAME -f holes.awk gaps.hpp  C++ that lets a compiler emit them all; NAME is the stage's scene
# So a stage can be compiled before somebody fills its gaps.
BEGIN { if (scene == "") print "// The gaps are holes: what a learner writes is linked in.\n" }
/^ *\/\/ \[[a-z_]+\]$/ { inside = !inside; if (scene == "") print; next }
!inside || /^ *\/\// { next }
body { if ($0 == indent "}") body = 0; next }
head == "" { match($0, /^ */); indent = substr($0, 1, RLENGTH) }
{ head = head $0 "\n" }
/\{$/ {
  sub(/ *\{\n$/, ";\n", head)
  sub(/inline /, "", head)
  match(head, /[A-Za-z_][A-Za-z_0-9:]*\(/)
  name = substr(head, RSTART, RLENGTH - 1)
  if (scene == "") { if (name !~ /::/) printf "%s", head } # of BallCollision:: there is a declaration already
  else if (head !~ /template/)
    printf "[[gnu::used]] static const auto line_%d = &bounce::%s%s;\n", ++count, indent == "" ? "" : scene "::", name
  head = ""
  body = 1
}
