#!/usr/bin/env bash
# compiler_said.sh errors|warnings LOG: what the compiler and the linker said of a learner's mine.hpp, in
# words for a beginner. Errors: the first one. Warnings: the first three, of the learner's own lines only.
set -uo pipefail
what=$1 log=$2

of_mine() { sed -e 's|^[^ ]*/\([a-z_0-9]*\.hpp:[0-9]\)|\1|' -e 's/ \[-W[^]]*\]//' -e 's/^/    /'; }

if [ "$what" = warnings ]; then
  found=$(grep -A2 '/mine\.hpp:[0-9:]* warning:' "$log" | grep -v '^--$' | head -n 9)
  [ -n "$found" ] || exit 0
  printf '  The compiler warns of lines of yours (this is no error, but read it):\n\n'
  of_mine <<<"$found"
  echo
  exit 0
fi

missing=$(grep -m1 'undefined reference to\|undefined symbol' "$log")
first=$(grep -m1 -A4 'error:' "$log")
if [ -n "$missing" ]; then
  name=$(sed -e "s/.*undefined [a-z]*[: to]*[\`'\"]*//" -e "s/['\"].*//" -e 's/bounce:://g' <<<"$missing")
  line=$(sed -n 's/.*mine\.hpp:\([0-9][0-9]*\).*/mine.hpp, line \1: /p' <<<"$missing")
  printf '  It does not come together yet:\n\n'
  printf '    %s%s is declared and used, and nowhere is it said what it does: its body { ... } is missing.\n' \
    "$line" "$name"
elif grep -q '^[^ ]*/mine\.hpp:' <<<"$first"; then
  printf '  It does not compile yet. The first thing that the compiler does not understand:\n\n'
  of_mine <<<"$first"
elif grep -q 'mine\.hpp:[0-9]' "$log"; then
  # A template of the course, or of Eigen, that a line of the learner's uses.
  printf '  It does not compile yet. Something in this line of yours does not fit:\n\n'
  grep -m1 'mine\.hpp:[0-9]*:[0-9]*' "$log" | sed -e 's/.*\(mine\.hpp:[0-9]*\).*/    \1/'
  sed -n '1s/.*error: /    /p' <<<"$first"
else
  printf '  Your file is understood, but the checks ask for something that they do not find in it:\n\n'
  sed -n '1s/.*error: /    /p' <<<"$first"
  printf '\n    Names that the skeleton has (struct, functions, fields) must stay as they are.\n'
fi
echo
