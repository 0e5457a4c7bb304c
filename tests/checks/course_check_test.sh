#!/usr/bin/env bash
# Drives ./course check as a learner would, with the learner's files in a folder of its own.
# usage: course_check_test.sh TOP
set -uo pipefail
top=$1
BOUNCE_MINE=$(mktemp -d)
export BOUNCE_MINE
trap 'rm -rf "$BOUNCE_MINE"' EXIT
failures=0

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
  printf 'FAILED: the output lacks "%s":\n%s\n' "$1" "$out"
  failures=$((failures + 1))
}
same() { # same FILE1 FILE2
  cmp -s "$1" "$2" && return
  printf 'FAILED: %s and %s differ\n' "$1" "$2"
  failures=$((failures + 1))
}

mine="$BOUNCE_MINE/01_free_fall/mine.hpp"
run 1 check # a fresh copy: the first stage, its skeleton, and what to do next
out=$(head -n 3 <<<"$out")
shows "Edit this file:  $mine"
shows "./course check"
shows "docs/01_free_fall.md"
same "$mine" "$top/stages/01_free_fall/exercise.hpp"

for n in 1 2 3 3; do run 0 check --hint; shows "hint $n of 3"; done

cp "$top/tests/mistakes/01_free_fall/gravity_points_up.hpp" "$BOUNCE_MINE/pieces.hpp"
cmake -DBASE="$top/stages/01_free_fall/free_fall.hpp" -DPIECES="$BOUNCE_MINE/pieces.hpp" -DOUT="$mine" \
  -P "$top/tests/mistakes/splice.cmake"
cp "$mine" "$BOUNCE_MINE/before"
run 1 check 1
shows "gravity points up"
shows "not yet"
[ "$(grep -c 'not yet' <<<"$out")" = 1 ] || { echo "FAILED: noise after the first failure"; failures=$((failures + 1)); }
same "$mine" "$BOUNCE_MINE/before" # nobody touched it

echo 'int x = "";' >>"$mine"
run 1 check 1
shows "does not compile yet"
shows "mine.hpp:"

cp "$top/stages/01_free_fall/free_fall.hpp" "$mine"
run 0 check
shows "Speed against error"
shows "Progress [#"
shows "./course play 1 --mine"
shows "Next: stage 2"

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
  -DOUT="$mine" -P "$top/tests/mistakes/splice.cmake"
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
same "$mine" "$top/stages/01_free_fall/exercise.hpp"
run 0 reset 1
same "$mine.2" "$top/stages/01_free_fall/exercise.hpp"

run 2 check 99
run 2 check 1 2
run 2 check --hunt
shows "--hint"
run 2 reset

[ "$failures" -eq 0 ] && echo "all as a learner would expect"
exit "$((failures > 0))"
