#!/usr/bin/env bash
# What ./course check says in Japanese, and what a learner's file says: nothing is built.
# usage: in_japanese_test.sh TOP
set -uo pipefail
top=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
wrong() { printf 'FAILED: %s\n' "$1"; failures=$((failures + 1)); }

says() { # says ENGLISH JAPANESE
  local said
  said=$(printf '%s\n' "$1" | LC_ALL=C awk -f "$top/tests/checks/in_japanese.awk" "$top/tests/checks/japanese.txt" -)
  [ "$said" = "$2" ] || wrong "'$1' is said as '$said', not '$2'"
}
# A sentence, a pattern with a sentence in it, and what has no Japanese.
says '  All stages are done.' '  すべてのステージが終わりました。'
says '  ok       the force is the weight, downwards' '  合格     力は下向きの重力'
says '    got       F = 12.3 N' '    あなたの値  F = 12.3 N'
says '    likely    gravity points up: y is up and gravity pulls downwards.' \
  '    おそらく    重力が上向き：y は上向きで、重力は下向きに引きます。'
says '    mine.hpp:3:5: error: gravity and more: the mass' '    mine.hpp:3:5: error: gravity and more: the mass'
# Lists, in any depth.
says '    seen      right in the air, exactly at the touch and in contact at rest; wrong elsewhere' \
  '    様子        正しい：空中、ちょうど触れたところ、接触中（静止）；ほかではすべて間違い'
says '    seen      where it is wrong: g, without the mass in place of the weight m g and the damper has the wrong sign' \
  '    様子        間違っているところでは、重力 m g の代わりに質量のない g があります、ダンパの力の符号が逆です'
says '    seen      in contact on the way in: the spring is taken 2 times and the damper is missing' \
  '    様子        接触中（沈み込むとき）：ばねの力が 2 倍になっています、ダンパの力がありません'
says '    seen      beside the disc, near its rim: r1 is taken 2 times and r2 is missing' \
  '    様子        円板の横、縁の近く：r1 が 2 倍になっています、r2 がありません'
says '    seen      wrong in every case; the whole push, along y, in place of the spring and the damper' \
  '    様子        どの場合も間違い；ばねの力、ダンパの力の代わりに y 方向の押す力全体があります'
says '    seen      wrong in the air; too much: minus the radius' '    様子        間違い：空中；余計なもの：マイナスの半径'
says '    look at   in meet: d is 0 there, and 0 / 0 is no direction.' \
  '    見るところ  meet()：そこでは d が0で、0 / 0 は向きになりません。'
says '    seen      wrong in every case; too much: the radius and the whole push, along x' '    様子        どの場合も間違い；余計なもの：半径、x 方向の押す力全体'
says '    seen      wrong in every case; too much: the whole push, along x' '    様子        どの場合も間違い；余計なもの：x 方向の押す力全体'
# A lesson leads to its Japanese page where there is one.
says '    lesson    docs/03_damping.md, "The idea"' '    レッスン    docs/ja/03_damping.md「考え方」'
says '    lesson    docs/09_drag.md, "The idea"' '    レッスン    docs/09_drag.md「考え方」'
says '    lesson    docs/deeper/01_free_fall.md, "How accurate and how fast"' \
  '    レッスン    docs/deeper/01_free_fall.md, "How accurate and how fast"（英語）'

# The code of a skeleton is the same in both languages: only comments differ.
code() { sed '/^ *\/\//d' "$1"; }
for gaps in "$top"/stages/*/gaps.hpp "$top"/stages/02_spring_floor/own_method/my_method.hpp; do
  says="$(dirname "$gaps")/gaps_ja.txt"
  [ -f "$says" ] || continue
  LC_ALL=C awk -f "$top/tests/checks/gaps_in.awk" "$says" "$gaps" >"$folder/mine.hpp"
  [ "$(code "$gaps")" = "$(code "$folder/mine.hpp")" ] || wrong "$says changes code"
  # Each gap has its statement, with the same numbers of gaps, units and names in it.
  [ "$(grep -c 'YOUR TURN' "$gaps")" = "$(grep -c 'YOUR TURN' "$folder/mine.hpp")" ] || wrong "$says: a gap has none"
  names() { grep '^ *//' "$1" | grep -oE '[0-9] of [0-9]|\[[A-Za-z/^0-9 ]+[],、]|[A-Za-z]+_[A-Za-z_]+|[A-Za-z]+(\.|::)[A-Za-z_]+' |
    tr -d '],、' | grep -vE 'hpp|docs|deeper' | sort -u; }
  for name in $(names "$gaps" | tr ' ' '~'); do
    names "$folder/mine.hpp" | tr ' ' '~' | grep -qxF -- "$name" || wrong "$says lacks $name"
  done
done

# The language is that of BOUNCE_LANG, or else of the locale. Three hints in each.
export BOUNCE_MINE="$folder"
unset BOUNCE_LANG
export LC_ALL='' LC_MESSAGES='' LANG=''
hint() { "$top/course" check "$1" --hint >"$folder/hint"; }
shows() { grep -qE -- "$1" "$folder/hint"; }
for stage in 1 2 3 4 5 6 7 8 loop; do
  for n in 1 2 3; do
    BOUNCE_LANG=ja hint $stage
    shows "ヒント $n/3" && ! shows '^  [A-Z][a-z]+ [a-z]+ [a-z]+' || wrong "stage $stage, hint $n: $(cat "$folder/hint")"
  done
done
LANG=ja_JP.UTF-8 hint 1; shows 'ヒント 3/3' || wrong 'the locale is Japanese'
LANG=ja_JP.UTF-8 LC_ALL=C hint 1; shows 'hint 3 of 3' || wrong 'LC_ALL comes before LANG'
BOUNCE_LANG=en LANG=ja_JP.UTF-8 hint 1; shows 'hint 3 of 3' || wrong 'BOUNCE_LANG comes first'
LANG=de_DE.UTF-8 hint 1; shows 'hint 3 of 3' || wrong 'other languages have English'
grep -q '使えるもの' "$folder/01_free_fall/mine.hpp" || wrong 'the skeleton is in English'
grep -q '^#pragma once' "$folder/01_free_fall/mine.hpp" || wrong 'the skeleton has lost its first line'
code=0
BOUNCE_LANG=ja "$top/course" check 99 2>"$folder/err" || code=$?
[ $code -eq 2 ] || wrong "a stage that is not there: exit code $code"
grep -q "^course: ここに '99' というステージはありません" "$folder/err" || wrong 'an error is in English'
code=0
BOUNCE_LANG=ja "$top/course" check plan "$top/stages/new/plan.md" >"$folder/out" || code=$?
[ $code -eq 1 ] && grep -q 'がありません' "$folder/out" || wrong "a plan that is empty: exit code $code"

[ $failures -eq 0 ] && echo 'all said'
exit $((failures > 0))
