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
meaning() { # of an error that beginners often see, in the words of g++ and clang++
  local error; error=$(tr '\n' ' ')
  fits() { grep -aqE -- "$1" <<<"$error"; }
  say() { printf '\n    %s\n' "$1"; }
  local number="'(const )?(int|double)'"
  if fits "(in|of) read-only|discards qualifiers|within const member|a const value|not marked const|for object argument|'operator=' \(operand types are 'const"; then
    say 'A member may not be changed in a function that is marked const, nor may state: make a new variable.'
  elif fits "(convert|conversion|'[-+]?='|operator[-+]?=).*(= |return )\([^()]*(\([^()]*\)[^()]*)*,"; then
    say '(a, b, c) is no vector in C++: write Eigen::Vector3d(a, b, c).'
  elif fits "(conver.* from|value of type|operator=.* and) $number( to |\)).*Eigen"; then
    say 'A vector is wanted here, and this is a number: write Eigen::Vector3d(a, b, c).'
  elif fits "(operator[-+<>]|invalid operands|'[-+]=').*($number.*Eigen|Eigen.*$number)"; then
    say 'A number and a vector cannot be added, subtracted or compared: take one part of the vector, for instance .y().'
  elif fits "INVALID_VECTOR_VECTOR_PRODUCT|conver.*'(const )?(Eigen::)?Product<"; then
    say 'Two vectors cannot be multiplied with *. Their dot product is dot(a, b).'
  elif fits "(convert|conversion from) .*(Vector|Eigen::).* to '?(const )?double|to 'double' from incompatible type '.*Eigen"; then
    say 'A double holds one number, and this is a vector: write Vector in its place (in a scene: Eigen::Vector3d).'
  fi
}

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
  meaning <<<"$error"
elif line=$(here <<<"$text" | grep -vE '^(In file included)? *from |warning: ' | head -n 1) && [ -n "$line" ]; then
  # A template of the course, or of Eigen, that a line of the learner's uses.
  line=${line##*"$shown:"}
  printf '  It does not compile yet. Something in this line of yours does not fit:\n\n'
  line=${line%%[:,]*}
  printf '    %s: %s\n    %s | %s\n' "$shown:$line" "$(sed -n '1s/.*error: //p' <<<"$error")" "$line" "$(sed -n "${line}p" "$file")"
  meaning <<<"$error"
elif [ -n "$error" ]; then
  printf '  Your file is understood, but the checks ask for something that they do not find in it:\n\n'
  sed -n '1s/.*error: /    /p' <<<"$error"
  printf '\n    Names that the skeleton has (struct, functions, fields) must stay as they are.\n'
else
  printf '%s\n' "$text"
fi
echo
