#!/usr/bin/env bash
# course_cmd.sh: the words of course.cmd, by wine's cmd. It runs after windows.sh. Where course.cmd calls cmake, this
# system's own one answers (course_cmd/on_debian.cpp), with the preset `windows`.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
set -uo pipefail
export WINEDEBUG=-all WINEPREFIX=$PWD/build/wine SDL_VIDEODRIVER=dummy BOUNCE_PRESET=windows
requests=$PWD/build/course_cmd mine=stages/03_damping/mine.hpp failures=0
[ ! -e "$mine" ] || { echo "$mine is there already: this test would change it"; exit 1; }
rm -rf "$requests"
mkdir -p "$requests"
trap 'kill "$server"; rm -f "$mine" "$mine".*' EXIT
for tool in cmake g++ ninja ctest; do
  x86_64-w64-mingw32-g++-posix -std=c++20 -static -DBOUNCE_REQUESTS="\"Z:$requests\"" \
    -o "$requests/$tool.exe" tests/portability/course_cmd/on_debian.cpp || exit 1
done

serve() {
  local words code
  while sleep 0.05; do
    [ -f "$requests/question" ] || continue
    mapfile -t words <"$requests/question"
    rm "$requests/question"
    code=0
    "${words[@]}" >"$requests/answer" 2>&1 || code=$?
    echo "$code" >"$requests/code.new"
    mv "$requests/code.new" "$requests/code"
  done
}
serve & server=$!

run() { # run CODE WORDS...: course.cmd WORDS must end with that code; its output is in $out
  local wanted=$1 code=0; shift
  out=$(WINEPATH="Z:$requests" wine cmd /c course.cmd "$@" 2>&1 </dev/null) || code=$?
  out=${out//$'\r'/}
  [ "$code" -eq "$wanted" ] || fails "course $* ended with $code, not $wanted"
}
fails() { printf 'FAILED: %s:\n%s\n' "$1" "$out"; failures=$((failures + 1)); }
shows() { grep -qF -- "$1" <<<"$out" || fails "the output lacks '$1'"; }
write() { # write PIECES: these lines in the learner's file
  cmake -DBASE=stages/03_damping/damping.hpp -DPIECES="$1" -DOUT="$mine" -P tests/checks/splice.cmake
}

run 0 list; shows "03_damping"; shows "a ball on a floor with spring and damper"
run 0; shows "usage: course play"
run 2 fly; shows "usage: course play"
run 2 play 99; shows "there is no stage '99'"
run 2 reset; shows "reset takes one stage"
for words in 'check 3 --watch' 'check 3 --report all.json' 'check --hint' 'test 3' 'plain 3 --picture a.svg' 'new drag'; do
  # shellcheck disable=SC2086
  run 2 $words; shows "is not known to course.cmd"
done
BOUNCE_LANG=ja run 0 list; shows "Japanese is spoken by ./course alone"; shows "03_damping"
run 2 play 3 --mine; shows "stage 3 has no mine.hpp yet"
run 2 play 3 --headless --set stiffness=-1; shows "stiffness"
run 0 play damping --headless --set stiffness=2000 --csv - --at 0.5; shows "0.5,"
run 0 plain 03; shows "t,y,v"
run 1 check 3; shows "Edit this file:  stages\\03_damping\\mine.hpp"; shows "not yet"; shows "hints.txt"
grep -q 'YOUR TURN' "$mine" || fails "the skeleton is not there"
write tests/mistakes/03_damping/damper_drives.hpp
run 1 check 3; shows "the damper has the wrong sign"
echo 'int main() { return nonsense; }' >>"$mine"
run 1 check 3; shows "It does not compile yet"; shows "mine.hpp"
cp stages/03_damping/damping.hpp "$mine"
run 0 check 3; shows "Speed against error"; shows "then  course check"; shows "course play 03 --mine"
at_half='--headless --csv - --at 0.5'
# shellcheck disable=SC2086
{
  run 0 play 3 $at_half; right=$(grep '^0.5,' <<<"$out")
  run 0 play 3 --mine $at_half; shows "$right"; shows "your force, the course's loop"
  sed -i 's/-mass \* gravity/-2 * mass * gravity/' "$mine"
  run 0 play 3 --mine $at_half; ! grep -qF "$right" <<<"$out" || fails "it does not run on the learner's lines"
  cp stages/03_damping/damping.hpp "$mine"
}
[ -f "$mine.passed" ] || fails "it is not noted that stage 3 is done"
run 0 reset 3; shows "Your old file is kept: stages\\03_damping\\mine.hpp.1"
cmp -s "$mine.1" stages/03_damping/damping.hpp || fails "the old file is another one"
requests=/nowhere run 1 play 3; shows "is missing. Install MSYS2"
[ "$failures" -eq 0 ] && echo "course.cmd: all as it should be"
