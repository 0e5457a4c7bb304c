#!/usr/bin/env bash
# compiler_said.sh errors|warnings LOG FILE SHOWN: what the compiler and the linker said in LOG of a learner's
# FILE, in words for a beginner, with SHOWN as the file's name. Errors: the first one. Warnings: the first
# three, of the learner's own lines only.
set -uo pipefail
what=$1 log=$2 file=$3 shown=$4

text=$(cat "$log")
text=${text//"$file"/"$shown"}
first() { grep -a -m1 "$@" <<<"$text"; }
show() { sed -e '/^compilation terminated/d' -e 's/ \[-W[^]]*\]//' -e 's/^/    /'; }
here() { grep -a -F -- "$shown:"; } # lines about the learner's file

if [ "$what" = warnings ]; then
  found=$(grep -a -A2 'warning: ' <<<"$text" | grep -a -v '^--$' | head -n 9)
  here <<<"$found" | grep -q 'warning: ' || exit 0
  printf '  The compiler warns of lines of yours (this is no error, but read it):\n\n'
  show <<<"$found"
  echo
  exit 0
fi

missing=$(first 'undefined reference to\|undefined symbol')
error=$(first -A4 'error: ')
if poison=$(first 'poisoned'); then
  line=${poison#"$shown:"}
  printf '  It does not compile yet:\n\n'
  printf '    %s: a main() of your own: the program has one already, so take it out (or keep it elsewhere)\n' "$shown:${line%%:*}"
elif [ -n "$missing" ]; then
  name=$(sed -e "s/.*undefined [a-z]*[: to]*[\`'\"]*//" -e "s/['\"].*//" -e 's/bounce:://g' <<<"$missing")
  bare=${name%%(*}
  line=$(grep -n -w -m1 -F -- "${bare##*:}" "$file")
  printf '  It does not come together yet:\n\n'
  printf '    %s: %s is declared and used, and nowhere is it said what it does: its body { ... } is missing.\n' \
    "$shown:${line%%:*}" "$name"
elif here <<<"${error%%$'\n'*}" >/dev/null; then
  printf '  It does not compile yet. The first thing that the compiler does not understand:\n\n'
  show <<<"$error"
  if grep -qE "(convert|conversion from) .*(Vector|Eigen::).* to '?double" <<<"$error"; then
    printf '\n    A double holds one number, and this is a vector: write Vector in its place (in a scene: Eigen::Vector3d).\n'
  fi
elif line=$(here <<<"$text" | head -n 1) && [ -n "$line" ]; then
  # A template of the course, or of Eigen, that a line of the learner's uses.
  line=${line##*"$shown:"}
  printf '  It does not compile yet. Something in this line of yours does not fit:\n\n'
  printf '    %s: %s\n' "$shown:${line%%[:,]*}" "$(sed -n '1s/.*error: //p' <<<"$error")"
elif [ -n "$error" ]; then
  printf '  Your file is understood, but the checks ask for something that they do not find in it:\n\n'
  sed -n '1s/.*error: /    /p' <<<"$error"
  printf '\n    Names that the skeleton has (struct, functions, fields) must stay as they are.\n'
else
  printf '%s\n' "$text"
fi
echo
