#!/usr/bin/env bash
# ./course plain N prints the rows of stage N's one page, and --picture draws these rows, for every stage.
# usage: course_plain_test.sh TOP BIN
set -uo pipefail
top=$1 bin=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export BOUNCE_LANG=en # what is said is compared
failures=0
fails() { printf 'FAILED: %s\n' "$1"; cat "$folder/said"; failures=$((failures + 1)); }

# The ends of the first line in a picture, by the numbers at its axis: height at the start, and at the end.
ends='/text-anchor=.end/ { gsub(/<[^>]*>/, ""); if (!ticks++) low = $0; high = $0 }
  /^<path stroke=/ && !done++ { n = split($0, at, /[ ML\047]+/); first = at[6]; last = at[n - 1]; points = n }
  END { scale = (high - low) / 385
    print low + (435 - first) * scale, low + (435 - last) * scale, scale, (points > 50) }'
# The same of the rows: of the ball, or of the first one.
of_rows='NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
  "ball" in column && $column["ball"] != 0 { next }
  { last = $column["y"]; if (first == "") first = last }
  END { print first, last }'
stages=0
for page in "$top"/stages/0[1-8]_*/plain.cpp; do
  stage=$(basename "$(dirname "$page")")
  stages=$((stages + 1))
  "$top/course" plain "$stage" >"$folder/rows" 2>"$folder/said" || fails "$stage does not run"
  "$bin/${stage}_plain" >"$folder/own"
  [ "$(wc -l <"$folder/rows")" -gt 1000 ] && cmp -s "$folder/rows" "$folder/own" || fails "$stage prints other rows"
  "$top/course" plain "$stage" --picture "$folder/it.svg" >"$folder/printed" 2>"$folder/said" || fails "$stage is not drawn"
  [ ! -s "$folder/printed" ] || fails "$stage: with a picture it prints its rows, too"
  [ "$(tail -n 1 "$folder/it.svg")" = '</svg>' ] || fails "$stage: no whole picture"
  drawn=$(awk "$ends" "$folder/it.svg") rows=$(awk -F, "$of_rows" "$folder/rows")
  awk -v a="$drawn" -v b="$rows" 'function near(p, q) { return (p - q) ^ 2 <= (0.06 * x[3]) ^ 2 } # a tenth of a pixel is drawn
    BEGIN { split(a, x, " "); split(b, y, " "); exit !(near(x[1], y[1]) && near(x[2], y[2]) && x[4]) }' ||
    fails "$stage: from and to is drawn as $drawn, and is $rows"
done
[ "$stages" -eq 8 ] || fails "$stages stages, not 8"

refuses() { # refuses SENTENCE WORDS...
  local says=$1 code=0; shift
  "$top/course" plain "$@" >"$folder/printed" 2>"$folder/said" || code=$?
  [ "$code" -eq 2 ] && [ ! -s "$folder/printed" ] && grep -qF -- "$says" "$folder/said" || fails "plain $*: ended with $code"
}
refuses "plain needs a stage"
refuses "there is no stage '77'" 77
refuses "plain has no option '--pictures'" 1 --pictures
refuses "--picture '' is not allowed" 1 --picture
refuses "must be a file, FILE.svg" 1 --picture "$folder/it.png"
refuses "cannot be written" 1 --picture "$folder/nowhere/it.svg"

[ "$failures" -eq 0 ] && echo "8 pages run, and are drawn"
exit "$((failures > 0))"
