#!/usr/bin/env bash
# Drives ./course check as a learner would, with the learner's files in a folder of its own.
# usage: course_check_test.sh TOP
set -uo pipefail
top=$1
own=$(mktemp -d)
trap 'rm -rf "$own"' EXIT
export BOUNCE_MINE="$own/Anna [x] Müller" # no ': with it, Ninja before 1.13 builds all anew each time
mkdir "$BOUNCE_MINE"
export LANG=de_DE.UTF-8 LANGUAGE=de # where the compiler speaks it
export BOUNCE_LANG=en # what is said is compared
failures=0

fails() { # fails WHY: about the last output
  printf 'FAILED: %s:\n%s\n' "$1" "$out"
  failures=$((failures + 1))
}
run() { # run CODE ARGS...: ./course ARGS must end with that code; its output is in $out
  local wanted=$1 code=0
  shift
  out=$("$top/course" "$@" 2>&1) || code=$?
  [ "$code" -eq "$wanted" ] && return
  printf 'FAILED: ./course %s ended with %s, not %s:\n%s\n' "$*" "$code" "$wanted" "$out"
  failures=$((failures + 1))
}
shows() { # shows TEXT: the last output has it
  grep -qF -- "$1" <<<"$out" && return
  fails "the output lacks '$1'"
}
same() { # same FILE1 FILE2
  cmp -s "$1" "$2" && return
  printf 'FAILED: %s and %s differ\n' "$1" "$2"
  failures=$((failures + 1))
}

mine="$BOUNCE_MINE/01_free_fall/mine.hpp"
splice() { # splice PIECES OUT: the header of stage 1 with these parts in it
  cmake -DBASE="$top/stages/01_free_fall/free_fall.hpp" -DPIECES="$1" -DOUT="$2" -P "$top/tests/checks/splice.cmake"
}
skeleton="$BOUNCE_MINE/skeleton.hpp"
splice "$top/stages/01_free_fall/gaps.hpp" "$skeleton"
run 1 check # a fresh copy: the first stage, its skeleton, and what to do next
out=$(head -n 3 <<<"$out")
shows "Edit this file:  $mine"
shows "./course check"
shows "docs/01_free_fall.md"
same "$mine" "$skeleton"
out=$(cat "$mine") # what the splicer makes: a head, the stage's file, its three gaps, and no answer
[ "$(head -n 3 <<<"$out")" = "$(head -n 3 "$top/stages/01_free_fall/gaps.hpp")" ] || fails "the head is not on top"
[ "$(grep -c 'YOUR TURN . of 3: ' <<<"$out")" = 3 ] || fails "there are not three gaps"
shows "#pragma once"
shows "State<double> start{5.0, 0.0}"
! grep -qF -- '-mass * gravity;  // downwards' <<<"$out" || fails "the answer is in the skeleton"

for n in 1 2 3 3; do run 0 check --hint; shows "hint $n of 3"; done
run 0 check 1 --hint 1 # a number after a stage: that hint, and on from there
shows "hint 1 of 3"
run 0 check --hint 1 # else it is the stage
shows "hint 2 of 3"
run 2 check 1 --hint 4
shows "there is no hint '4'"

splice "$top/tests/mistakes/01_free_fall/gravity_points_up.hpp" "$mine"
cp "$mine" "$BOUNCE_MINE/before"
run 1 check 1
shows "gravity points up"
shows "not yet"
[ "$(grep -c 'not yet' <<<"$out")" = 1 ] || fails "noise after the first failure"
same "$mine" "$BOUNCE_MINE/before" # nobody touched it
BOUNCE_LANG=ja run 1 check 1 # the same in Japanese
shows "  まだ     力は下向きの重力"
shows "おそらく    重力が上向き"
shows "docs/ja/01_free_fall.md"

echo 'int x = "";' >>"$mine"
run 1 check 1
shows "does not compile yet"
shows "mine.hpp:"

cp "$top/stages/01_free_fall/free_fall.hpp" "$mine"
run 0 check
shows "Speed against error"
shows "Progress [#"
shows "./course play 1 --mine"
shows "with asserts on"
shows "Next: stage 2."

run 1 check # goes on with stage 2
shows "$BOUNCE_MINE/02_spring_floor/mine.hpp"

run 1 check --report "$BOUNCE_MINE/report.json"
out=$(cat "$BOUNCE_MINE/report.json")
shows '"stage": "01_free_fall", "status": "passed"'
shows '"stage": "02_spring_floor", "status": "failed"'
shows '"stage": "03_damping", "status": "not begun"'
shows '"passed": 1, "of":'
run 0 check 1 --report "$BOUNCE_MINE/report.json"

# Whatever one file does, each stage has its row.
cmake -DBASE="$top/stages/01_free_fall/free_fall.hpp" -DPIECES="$top/tests/mistakes/endings/vector_without_end.hpp" \
  -DOUT="$mine" -P "$top/tests/checks/splice.cmake"
echo 'int x = "";' >>"$BOUNCE_MINE/02_spring_floor/mine.hpp"
run 1 check --report "$BOUNCE_MINE/report.json"
out=$(cat "$BOUNCE_MINE/report.json")
shows '"stage": "01_free_fall", "status": "crashed"'
shows 'a vector that grows without end'
shows '"stage": "02_spring_floor", "status": "does not compile"'
shows '"stage": "08_racket_game", "status": "not begun"'
cp "$top/stages/01_free_fall/free_fall.hpp" "$mine"

run 0 reset 1
same "$mine.1" "$top/stages/01_free_fall/free_fall.hpp"
same "$mine" "$skeleton"
run 0 reset 1
same "$mine.2" "$skeleton"

# A better loop: an exercise of its own.
loop="$BOUNCE_MINE/02_spring_floor/mine_method.hpp"
own_method="$top/stages/02_spring_floor/own_method/my_method.hpp"
run 1 check loop
shows "Edit this file:  $loop"
shows "if this gap is still empty"
same "$loop" "$own_method"
run 0 check loop --hint
shows "hint 1 of 3"
cmake -DBASE="$own_method" -DPIECES="$top/tests/mistakes/right_loops/velocity_verlet.hpp" -DOUT="$loop" -P "$top/tests/checks/splice.cmake"
run 0 check loop
shows "it is velocity Verlet, or its twin"
shows "./course play 2 --mine"
run 0 check loop --report "$BOUNCE_MINE/report.json"
out=$(cat "$BOUNCE_MINE/report.json")
shows '"verdict": "Your method is of order 2.00'
run 0 reset loop
same "$loop" "$own_method"

run 2 check 99
run 2 check 1 2
run 2 check --hunt
shows "--hint"
run 2 reset

# A learner's file that passes can be played, whatever its style: no `inline`, no `#pragma once`, a header of
# its own beside it.
five="$BOUNCE_MINE/05_ball_collision/mine.hpp"
mkdir "$BOUNCE_MINE/05_ball_collision"
{
  echo '#include "my_helpers.h"'
  sed -e 's/^inline //' -e '/^#pragma once/d' "$top/stages/05_ball_collision/ball_collision.hpp"
} >"$five"
echo 'double twice(double x) { return x + x; }' >"$BOUNCE_MINE/05_ball_collision/my_helpers.h"
run 0 check 5
shows "Next: stage 1 (not done yet)"
run 0 play 5 --mine --headless --duration 0.01
shows "05_ball_collision: method=semi-implicit-euler"

play1() { # play1 TEXT: stage 1 on its own solution with this line at the end must not be played
  cp "$top/stages/01_free_fall/free_fall.hpp" "$mine"
  printf '%s\n' "$1" >>"$mine"
  touch -r "$top/LICENSE" "$mine" # older than the program, and yet not what that was built from
  run 1 play 1 --mine --headless --duration 1
  lines=$(wc -l <"$mine")
  shows "$mine:$lines:"
  ! grep -qE 'ninja|collect2|FAILED|method=' <<<"$out" || fails "that is not for a learner"
}
cp "$top/stages/01_free_fall/free_fall.hpp" "$mine"
run 0 play 1 --mine --headless --duration 1
shows "01_free_fall: method=mine"
play1 'int x = "";'
shows "error: "
play1 'double nowhere(double x); static const double at_start = nowhere(2);'
shows "nowhere(double) is declared and used, and nowhere is it said what it does"
play1 'int main() { return 0; }'
shows "a main() of your own"
run 1 check 1
shows "$mine:$lines: a main() of your own"

# However the command is called.
ln -s "$top/course" "$own/my course"
out=$(cd "$own" && TERM='' "./my course" list) || fails "by a link: ended with $?"
shows "free_fall"
out=$(cd "$top/.." && CDPATH=.:/ bash "$(basename "$top")/course" list) || fails "with CDPATH: ended with $?"
shows "free_fall"

[ "$failures" -eq 0 ] && echo "all as a learner would expect"
exit "$((failures > 0))"
